#include "engine/form/roundness_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/form/form_verification.h"
#include "engine/form/roundness_quantities.h"
#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::form {
namespace {

const Text mm = LT_TEXT("Engine", "mm");
const Text um = LT_TEXT("Engine", "µm");
constexpr std::array<ReferenceCircle, 4> allCircles{ReferenceCircle::MZCI, ReferenceCircle::LSCI, ReferenceCircle::MICI,
                                                    ReferenceCircle::MCCI};

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

Table circlesTable(const RoundnessResult& result)
{
    std::vector<FittedCircle> circles;
    for (const ReferenceCircle which : allCircles) circles.push_back(result.circles.of(which));
    Table table = listTable<FittedCircle>(
        LT_TEXT("Engine", "Roundness deviation by reference circle"), circles,
        {"RONt_um", "centre_x_mm", "centre_y_mm", "inner_radius_mm", "outer_radius_mm", "certified_gap_um"});
    table.columns.insert(table.columns.begin(), LT_TEXT("Engine", "circle"));
    table.decimals.insert(table.decimals.begin(), 0);
    for (std::size_t i = 0; i < allCircles.size(); ++i)
        table.rows[i].insert(table.rows[i].begin(), fullName(allCircles[i]));
    return table;
}

QuantityTable leastSquaresTable(const RoundnessResult& result)
{
    return quantityTable(LT_TEXT("Engine", "About the least-squares circle"), result.circles.LSCI,
                         {"RONp_um", "RONv_um", "RONq_um", "radius_mm"});
}

QuantityTable verdictTable(const RoundnessResult& result)
{
    QuantityTable table{LT_TEXT("Engine", "Verdict"), {}};
    const RoundnessParameters& asked = result.parameters;
    if (result.verdict)
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), name(*result.verdict), {}});
    else
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), LT_TEXT("Engine", "none: no tolerance was given"), {}});
    const auto add = [&](std::initializer_list<const char*> keys) {
        for (Quantity& row : quantityRows(result, keys)) table.rows.push_back(std::move(row));
    };
    if (asked.tolerance_um) add({"tolerance_um"});
    add({"RONt_expanded_uncertainty_um"});
    table.rows.push_back({LT_TEXT("Engine", "Decision rule"), name(asked.decision), {}});
    add({"points_used", "points_left_out"});
    return table;
}

QuantityTable sizesTable(const RoundnessResult& result)
{
    return quantityTable(
        LT_TEXT("Engine", "Sizes across the section"), result.two_point,
        {"largest_mm", "smallest_mm", "range_um", "half_range_um", "caliper_largest_mm", "caliper_smallest_mm"});
}

QuantityTable paperTable(const RoundnessResult& result)
{
    return quantityTable(
        LT_TEXT("Engine", "As in the source paper, about the origin of the coordinates; not roundness"), result.paper,
        {"run_out_um", "limacon_centre_x_um", "limacon_centre_y_um"});
}

QuantityTable certaintyTable(const RoundnessResult& result)
{
    QuantityTable table = quantityTable(LT_TEXT("Engine", "Uncertainty"), result,
                                        {"RONt_um", "RONt_expanded_uncertainty_um", "point_noise_um"});
    table.rows.front().name = "RONt(" + std::string(name(result.parameters.circle)) + ")";
    return table;
}

Table overviewTable(const std::vector<RoundnessResult>& results, const Language& language)
{
    Table table = listTable<RoundnessResult>(
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

void addSections(const RoundnessResult& result, bool several, const Language& language, Document& document)
{
    Section summary = roundnessSummary(result, language);
    if (several) summary.title = result.name;
    document.sections.push_back(std::move(summary));
    document.sections.push_back({LT_TEXT("Engine", "Roundness plot"), {roundnessPolarPlot(result, language)}});
    Section spectrum{LT_TEXT("Engine", "Harmonic content"), {}};
    if (!result.harmonics.empty()) {
        spectrum.blocks.push_back(spectrumPlot(result, language));
        spectrum.blocks.push_back(harmonicsTable(result));
    }
    spectrum.blocks.push_back(paperTable(result));
    document.sections.push_back(std::move(spectrum));
    document.sections.push_back(
        {LT_TEXT("Engine", "Measurement uncertainty"),
         {certaintyTable(result), leastSquaresTable(result),
          Paragraph{LT_TEXT("Engine",
                            "The uncertainty is half of an interval about the value that holds the deviation without "
                            "noise in 95 of 100 measurements (JCGM 101): the noise of the points is drawn anew, "
                            "filtered and fitted. The table shows what other methods would say of the same points."),
                    {}},
          methodTable(result, language)}});
}

}  // namespace

int decimalsFor(double uncertainty_um)
{
    if (!(uncertainty_um > 0)) return uncertainty_um == 0 ? 3 : 2;
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(uncertainty_um))), 1, 3);
}

std::string filterName(const signal::ProfileBand& band, const Language& language)
{
    if (band.isAll()) return text(LT_TEXT("Engine", "no filter"), language);
    const auto number = [&](double value) { return text(Value(value), language); };
    if (!band.high_upr) return "G > " + number(*band.low_upr) + " UPR";
    return "G " + number(band.low_upr.value_or(1)) + "-" + number(*band.high_upr) + " UPR";
}

Headline headline(const RoundnessResult& result, const Language& language)
{
    const double uncertainty = result.RONt_expanded_uncertainty_um;
    const int decimals = decimalsFor(uncertainty);
    Headline answer;
    std::string& line = answer.text;
    line = "RONt(" + std::string(name(result.parameters.circle)) + ") " +
           fixed(headlineDeviation_um(result), decimals, language) + " µm · " +
           filterName(bandOf(result.parameters), language);
    if (result.verdict) {
        const Values values{{"tolerance", *result.parameters.tolerance_um},
                            {"uncertainty", fixed(uncertainty, decimals, language)}};
        const auto add = [&](Text words) { line += " · " + fill(text(words, language), values, language); };
        switch (*result.verdict) {
            case Verdict::Pass: add(LT_TEXT("Engine", "within {tolerance} µm")); break;
            case Verdict::Fail: add(LT_TEXT("Engine", "above {tolerance} µm")); break;
            case Verdict::Undecided:
                add(LT_TEXT("Engine", "? not decided: {tolerance} µm is within the uncertainty of {uncertainty} µm"));
                break;
        }
        answer.verdict = passed(result.verdict);
    }
    line = keptTogether(line);
    return answer;
}

Section roundnessSummary(const RoundnessResult& result, const Language& language)
{
    Section section{LT_TEXT("Engine", "Result"),
                    {headline(result, language), circlesTable(result), verdictTable(result), sizesTable(result)}};
    for (const RoundnessHint& hint : result.hints)
        section.blocks.push_back(Paragraph{LT_TEXT("Engine", "{upr} UPR, {amplitude} µm: {meaning}."),
                                           {{"upr", std::int64_t{hint.upr}},
                                            {"amplitude", fixed(hint.amplitude_um, 2, language)},
                                            {"meaning", hint.meaning}}});
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

Document roundnessReport(const std::vector<RoundnessResult>& results, const std::vector<InputFile>& inputs,
                         const Language& language)
{
    Document document;
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
             {Paragraph{LT_TEXT("Engine",
                                "ISO 12181: RONt is the largest minus the smallest distance of the profile from the "
                                "centre of the reference circle. Filter: Gaussian, ISO 16610-21. The minimum zone and "
                                "the inscribed circle are proved by branch and bound."),
                        {}},
              parametersTable(results.front().parameters, language)}});
    return document;
}

}  // namespace lathelier::form
