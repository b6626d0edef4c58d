#include "engine/form/roundness/roundness_report.h"
#include "engine/core/units.h"
#include "engine/form/roundness/roundness_plots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/form/form_codes.h"
#include "engine/form/roundness/roundness_quantities.h"
#include "engine/form/verify/form_verification.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::form {
namespace {

Text fullName(ReferenceCircle circle)
{
    switch (circle) {
        case ReferenceCircle::LSCI: return LT_TEXT("Engine", "least squares (LSCI)");
        case ReferenceCircle::MZCI: return LT_TEXT("Engine", "minimum zone (MZCI)");
        case ReferenceCircle::MICI: return LT_TEXT("Engine", "maximum inscribed (MICI)");
        case ReferenceCircle::MCCI: return LT_TEXT("Engine", "minimum circumscribed (MCCI)");
    }
    return {};
}

report::QuantityTable leastSquaresTable(const RoundnessResult& result)
{
    return report::quantityTable(LT_TEXT("Engine", "About the least-squares circle"), result.circles.LSCI,
                                 {"RONp_um", "RONv_um", "RONq_um", "radius_mm"});
}

report::QuantityTable verdictTable(const RoundnessResult& result)
{
    report::QuantityTable table{LT_TEXT("Engine", "Verdict"), {}};
    const RoundnessParameters& asked = result.parameters;
    if (result.verdict)
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), name(*result.verdict), {}});
    else
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), LT_TEXT("Engine", "none: no tolerance was given"), {}});
    const auto add = [&](std::initializer_list<const char*> keys) {
        for (report::Quantity& row : report::quantityRows(result, keys)) table.rows.push_back(std::move(row));
    };
    if (asked.tolerance_um) add({"tolerance_um"});
    add({"RONt_expanded_uncertainty_um"});
    table.rows.push_back({LT_TEXT("Engine", "Decision rule"), name(asked.decision), {}});
    add({"points_used", "points_left_out"});
    return table;
}

report::QuantityTable sizesTable(const RoundnessResult& result)
{
    return report::quantityTable(
        LT_TEXT("Engine", "Sizes across the section"), result.two_point,
        {"largest_mm", "smallest_mm", "range_um", "half_range_um", "caliper_largest_mm", "caliper_smallest_mm"});
}

report::QuantityTable paperTable(const RoundnessResult& result)
{
    return report::quantityTable(
        LT_TEXT("Engine", "As in the source paper, about the origin of the coordinates; not roundness"), result.paper,
        {"run_out_um", "limacon_centre_x_um", "limacon_centre_y_um"});
}

report::QuantityTable certaintyTable(const RoundnessResult& result)
{
    report::QuantityTable table = report::quantityTable(LT_TEXT("Engine", "Uncertainty"), result,
                                                        {"RONt_um", "RONt_expanded_uncertainty_um", "point_noise_um"});
    table.rows.front().name = "RONt(" + std::string(name(result.parameters.circle)) + ")";
    return table;
}

report::Table overviewTable(const std::vector<RoundnessResult>& results, const Language& language)
{
    report::Table table = report::listTable<RoundnessResult>(
        LT_TEXT("Engine", "All profiles"), results,
        {"name", "RONt_MZCI_um", "RONt_LSCI_um", "RONt_MICI_um", "RONt_MCCI_um", "RONt_expanded_uncertainty_um"});
    table.columns.insert(table.columns.begin() + 1, LT_TEXT("Engine", "filter"));
    table.decimals.insert(table.decimals.begin() + 1, 0);
    table.columns.emplace_back(LT_TEXT("Engine", "verdict"));
    for (std::size_t i = 0; i < results.size(); ++i) {
        std::vector<Value>& row = table.rows[i];
        row.insert(row.begin() + 1, filterName(bandOf(results[i].parameters), language));
        row.push_back(results[i].verdict ? Value(name(*results[i].verdict)) : Value());
    }
    return table;
}

void addSections(const RoundnessResult& result, bool several, const Language& language, report::Document& document)
{
    report::Section summary = roundnessSummary(result, language);
    if (several) summary.title = result.name;
    document.sections.push_back(std::move(summary));
    document.sections.push_back({LT_TEXT("Engine", "Roundness plot"), {roundnessPolarPlot(result, language)}});
    report::Section spectrum{LT_TEXT("Engine", "Harmonic content"), {}};
    if (!result.harmonics.empty()) {
        spectrum.blocks.push_back(spectrumPlot(result, language));
        spectrum.blocks.push_back(harmonicsTable(result));
    }
    spectrum.blocks.push_back(paperTable(result));
    document.sections.push_back(std::move(spectrum));
    document.sections.push_back(
        {LT_TEXT("Engine", "Measurement uncertainty"),
         {certaintyTable(result), leastSquaresTable(result),
          report::Paragraph{
              LT_TEXT("Engine",
                      "The uncertainty is half of an interval about the value that holds the deviation without "
                      "noise in 95 of 100 measurements (JCGM 101): the noise of the points is drawn anew, "
                      "filtered and fitted. The table shows what other methods would say of the same points."),
              {}},
          methodTable(result, language)}});
}

}  // namespace

report::Table circlesTable(const RoundnessResult& result)
{
    std::vector<FittedCircle> circles;
    circles.reserve(circlesOfTable.size());
    for (const ReferenceCircle which : circlesOfTable) circles.push_back(result.circles.of(which));
    report::Table table = report::listTable<FittedCircle>(
        LT_TEXT("Engine", "Roundness deviation by reference circle"), circles,
        {"RONt_um", "centre_x_mm", "centre_y_mm", "inner_radius_mm", "outer_radius_mm", "certified_gap_um"});
    table.columns.insert(table.columns.begin(), LT_TEXT("Engine", "circle"));
    table.decimals.insert(table.decimals.begin(), 0);
    for (std::size_t i = 0; i < circlesOfTable.size(); ++i)
        table.rows[i].insert(table.rows[i].begin(), fullName(circlesOfTable[i]));
    return table;
}

int decimalsFor(double uncertainty_um)
{
    if (!(uncertainty_um > 0)) return uncertainty_um == 0 ? 3 : 2;
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(uncertainty_um))), 1, 3);
}

std::string filterName(const signal::TransmissionBand& band, const Language& language)
{
    if (band.isAll()) return text(LT_TEXT("Engine", "no filter"), language);
    const auto number = [&](double value) { return text(Value(value), language); };
    if (!band.high_upr) return "G > " + number(*band.low_upr) + " UPR";
    return "G " + number(band.low_upr.value_or(1)) + "-" + number(*band.high_upr) + " UPR";
}

namespace {

/// Verdict by the method table: how many of the methods resolved by the sampling meet the limit, and the range of their
/// values.
struct MethodsSay {
    std::int64_t count = 0;
    std::int64_t within = 0;
    double least_um = HUGE_VAL;
    double most_um = 0;
};

MethodsSay methodsOf(const RoundnessResult& result)
{
    MethodsSay say;
    for (const MethodRow& row : result.methods) {
        if (row.undersampled) continue;
        for (const double value_um : row.RONt_um) {
            if (!std::isfinite(value_um)) continue;
            ++say.count;
            say.within += result.parameters.tolerance_um && value_um <= *result.parameters.tolerance_um;
            say.least_um = std::min(say.least_um, value_um);
            say.most_um = std::max(say.most_um, value_um);
        }
    }
    return say;
}

/// Pattern of the sentence: the filter, and whether other methods lead to the same verdict.
Text sentenceOf(const RoundnessResult& result, const MethodsSay& methods)
{
    if (methods.count == 0) return LT_TEXT("Engine", "{filter}");
    if (!result.verdict) return LT_TEXT("Engine", "{filter} · other methods say {least_um:1} to {most_um:1} µm");
    if (*result.verdict == Verdict::Undecided)
        return LT_TEXT("Engine",
                       "{filter} · the limit lies within the uncertainty; {within} of {count} methods keep it");
    if (methods.within == methods.count) return LT_TEXT("Engine", "{filter} · within by all {count} methods");
    if (methods.within == 0) return LT_TEXT("Engine", "{filter} · above by all {count} methods");
    return LT_TEXT("Engine", "{filter} · within by {within} of {count} methods: look at the filter");
}

/// RONt by the same circle and filter with outliers removed; NaN when it was not computed.
double withoutOutliers_um(const RoundnessResult& result)
{
    if (result.parameters.outliers != OutlierRule::None) return notANumber;
    for (const MethodRow& row : result.methods)
        if (row.outliers != OutlierRule::None && row.band == bandOf(result.parameters))
            return row.RONt_um[static_cast<std::size_t>(result.parameters.circle)];
    return notANumber;
}

/// What the value would be with the usual filter, where none was chosen.
void offerFilter(const RoundnessResult& result, report::Answer& answer)
{
    constexpr double usual_upr = 50;  // not fixed by ISO 12181-2; the usual choice when a drawing states none
    if (!bandOf(result.parameters).isAll()) return;
    const MethodRow* best = nullptr;  // nearest filter resolved by the sampling
    for (const MethodRow& row : result.methods) {
        const bool offers = row.outliers == result.parameters.outliers && !row.undersampled && !row.band.low_upr &&
                            row.band.high_upr && *row.band.high_upr <= usual_upr;
        if (offers && (!best || *row.band.high_upr > *best->band.high_upr)) best = &row;
    }
    const double filtered_um = best ? best->RONt_um[static_cast<std::size_t>(result.parameters.circle)] : std::nan("");
    if (!std::isfinite(filtered_um)) return;
    answer.findings.push_back(
        {LT_TEXT("Engine", "No filter was chosen: with 1-{upr} UPR {value_um:2} µm"),
         {{"upr", static_cast<std::int64_t>(std::lround(*best->band.high_upr))}, {"value_um", filtered_um}},
         {},
         {},
         {{"cutoff_upr", *best->band.high_upr}}});
}

}  // namespace

report::Answer answer(const RoundnessResult& result, const Language& language)
{
    const RoundnessParameters& asked = result.parameters;
    report::Answer answer;
    answer.quantity = "RONt(" + std::string(name(asked.circle)) + ")";
    answer.value = headlineDeviation_um(result);
    answer.expanded_uncertainty = result.RONt_expanded_uncertainty_um;
    answer.unit = unit::um;
    answer.decimals = decimalsFor(result.RONt_expanded_uncertainty_um);
    answer.upper_limit = asked.tolerance_um;
    answer.verdict = result.verdict;
    const MethodsSay methods = methodsOf(result);
    answer.sentence = sentenceOf(result, methods);
    answer.values = {{"filter", filterName(bandOf(asked), language)},
                     {"count", methods.count},
                     {"within", methods.within},
                     {"least_um", methods.least_um},
                     {"most_um", methods.most_um}};
    for (const Note& note : result.notes) {
        if (note.code != notes::spikesCounted) continue;
        const double without_um = withoutOutliers_um(result);
        if (!std::isfinite(without_um)) continue;
        answer.findings.push_back({LT_TEXT("Engine", "Points that stand out: {count}; without them {value_um:2} µm"),
                                   {{"count", *find(note.values, "count")}, {"value_um", without_um}},
                                   {},
                                   {},
                                   {{"outliers", std::string("hampel")}}});
    }
    offerFilter(result, answer);
    for (const RoundnessHint& hint : result.hints) {
        if (hint.upr <= 1 || answer.findings.size() >= 3) continue;
        report::Place place;
        place.upr = hint.upr;
        answer.findings.push_back(
            {LT_TEXT("Engine", "{upr} UPR, {amplitude_um:2} µm: {meaning}."),
             {{"upr", std::int64_t{hint.upr}}, {"amplitude_um", hint.amplitude_um}, {"meaning", hint.meaning}},
             {},
             place});
    }
    return answer;
}

report::Section roundnessSummary(const RoundnessResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"),
                            {answer(result, language), circlesTable(result), verdictTable(result), sizesTable(result)}};
    for (const RoundnessHint& hint : result.hints)
        section.blocks.push_back(report::Paragraph{
            LT_TEXT("Engine", "{upr} UPR, {amplitude_um:2} µm: {meaning}."),
            {{"upr", std::int64_t{hint.upr}}, {"amplitude_um", hint.amplitude_um}, {"meaning", hint.meaning}}});
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document roundnessReport(const std::vector<RoundnessResult>& results, const std::vector<InputFile>& inputs,
                                 const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Roundness");
    document.verification = {&formVerification()};
    document.inputs = inputs;
    const bool several = results.size() > 1;
    if (several) document.sections.push_back({LT_TEXT("Engine", "Overview"), {overviewTable(results, language)}});
    for (const RoundnessResult& result : results) {
        document.synthetic |= contains(result.notes, notes::syntheticData);
        addSections(result, several, language, document);
    }
    if (!results.empty())
        document.sections.push_back(
            {LT_TEXT("Engine", "Method and parameters"),
             {report::Paragraph{
                  LT_TEXT("Engine",
                          "ISO 12181: RONt is the largest minus the smallest distance of the profile from the "
                          "centre of the reference circle. Filter: Gaussian, ISO 16610-21. The minimum zone and "
                          "the inscribed circle are proved by branch and bound."),
                  {}},
              report::parametersTable(results.front().parameters, language)}});
    return document;
}

}  // namespace lathelier::form
