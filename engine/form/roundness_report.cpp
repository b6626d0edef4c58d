#include "engine/form/roundness_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/io/io_codes.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"

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
    Table table{LT_TEXT("Engine", "Roundness deviation by reference circle"),
                {LT_TEXT("Engine", "circle"), LT_TEXT("Engine", "RONt (µm)"), LT_TEXT("Engine", "centre x (mm)"),
                 LT_TEXT("Engine", "centre y (mm)"), LT_TEXT("Engine", "inner radius (mm)"),
                 LT_TEXT("Engine", "outer radius (mm)"), LT_TEXT("Engine", "proved to (µm)")},
                {},
                {0, 3, 5, 5, 5, 5, 7}};
    for (const ReferenceCircle which : allCircles) {
        const FittedCircle& circle = result.circles.of(which);
        table.rows.push_back({fullName(which), circle.RONt_um, circle.centre_mm.x(), circle.centre_mm.y(),
                              circle.inner_radius_mm, circle.outer_radius_mm,
                              circle.certified_gap_um ? Value(*circle.certified_gap_um) : Value()});
    }
    return table;
}

QuantityTable leastSquaresTable(const RoundnessResult& result)
{
    const FittedCircle& circle = result.circles.LSCI;
    return {LT_TEXT("Engine", "About the least-squares circle"),
            {{LT_TEXT("Engine", "Peak to reference RONp"), circle.RONp_um, um},
             {LT_TEXT("Engine", "Reference to valley RONv"), circle.RONv_um, um},
             {LT_TEXT("Engine", "Root mean square RONq"), circle.RONq_um, um},
             {LT_TEXT("Engine", "Radius"), circle.radius_mm, mm, 5}}};
}

QuantityTable verdictTable(const RoundnessResult& result)
{
    QuantityTable table{LT_TEXT("Engine", "Verdict"), {}};
    const RoundnessParameters& asked = result.parameters;
    if (result.verdict)
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), verdictName(*result.verdict), {}});
    else
        table.rows.push_back({LT_TEXT("Engine", "Verdict"), LT_TEXT("Engine", "none: no tolerance was given"), {}});
    if (asked.tolerance_um) table.rows.push_back({LT_TEXT("Engine", "Tolerance"), *asked.tolerance_um, um});
    table.rows.push_back({LT_TEXT("Engine", "Expanded uncertainty (95 %)"), result.RONt_expanded_uncertainty_um, um});
    table.rows.push_back({LT_TEXT("Engine", "Decision rule"),
                          asked.decision == DecisionRule::Guarded
                              ? LT_TEXT("Engine", "ISO 14253-1: only what is sure passes or fails")
                              : LT_TEXT("Engine", "simple: the value alone is compared"),
                          {}});
    table.rows.push_back(
        {LT_TEXT("Engine", "Points used"), static_cast<std::int64_t>(result.evaluated_index.size()), {}});
    table.rows.push_back(
        {LT_TEXT("Engine", "Points left out"),
         static_cast<std::int64_t>(std::count(result.used.begin(), result.used.end(), std::uint8_t{0})),
         {}});
    return table;
}

QuantityTable sizesTable(const RoundnessResult& result)
{
    const TwoPointSize& size = result.two_point;
    return {LT_TEXT("Engine", "Sizes across the section"),
            {{LT_TEXT("Engine", "Two-point size, largest"), size.largest_mm, mm, 5},
             {LT_TEXT("Engine", "Two-point size, smallest"), size.smallest_mm, mm, 5},
             {LT_TEXT("Engine", "Two-point size range"), size.range_um, um},
             {LT_TEXT("Engine", "Half of it: ovality by GOST 24642"), size.half_range_um, um},
             {LT_TEXT("Engine", "Width between jaws, largest"), size.caliper_largest_mm, mm, 5},
             {LT_TEXT("Engine", "Width between jaws, smallest"), size.caliper_smallest_mm, mm, 5}}};
}

QuantityTable paperTable(const RoundnessResult& result)
{
    const PaperValues& paper = result.paper;
    return {LT_TEXT("Engine", "As in the source paper, about the origin of the coordinates; not roundness"),
            {{LT_TEXT("Engine", "Radial run-out about the spindle axis"), paper.run_out_um, um},
             {LT_TEXT("Engine", "Centre by the limaçon formula, x"), paper.limacon_centre_um.x(), um},
             {LT_TEXT("Engine", "Centre by the limaçon formula, y"), paper.limacon_centre_um.y(), um}}};
}

QuantityTable certaintyTable(const RoundnessResult& result)
{
    const std::string which(name(result.parameters.circle));
    return {LT_TEXT("Engine", "Uncertainty"),
            {{"RONt(" + which + ")", headlineDeviation_um(result), um},
             {LT_TEXT("Engine", "Expanded uncertainty (95 %)"), result.RONt_expanded_uncertainty_um, um},
             {LT_TEXT("Engine", "Standard deviation of a point"), result.point_noise_um, um}}};
}

Table overviewTable(const std::vector<RoundnessResult>& results, const Language& language)
{
    Table table{LT_TEXT("Engine", "All profiles"),
                {LT_TEXT("Engine", "profile"), LT_TEXT("Engine", "filter"), LT_TEXT("Engine", "MZCI (µm)"),
                 LT_TEXT("Engine", "LSCI (µm)"), LT_TEXT("Engine", "MICI (µm)"), LT_TEXT("Engine", "MCCI (µm)"),
                 LT_TEXT("Engine", "U, 95 % (µm)"), LT_TEXT("Engine", "verdict")},
                {},
                {0, 0, 3, 3, 3, 3, 3, 0}};
    for (const RoundnessResult& result : results)
        table.rows.push_back({result.name, filterName(bandOf(result.parameters), language), result.circles.MZCI.RONt_um,
                              result.circles.LSCI.RONt_um, result.circles.MICI.RONt_um, result.circles.MCCI.RONt_um,
                              result.RONt_expanded_uncertainty_um,
                              result.verdict ? Value(verdictName(*result.verdict)) : Value()});
    return table;
}

void addSections(const RoundnessResult& result, bool several, const Language& language, Document& document)
{
    Section summary = roundnessSummary(result, language);
    if (several) summary.title = result.name;
    document.sections.push_back(std::move(summary));
    document.sections.push_back({LT_TEXT("Engine", "Where"), {roundnessPolarPlot(result, language)}});
    Section spectrum{LT_TEXT("Engine", "What the form consists of"), {}};
    if (!result.harmonics.empty()) {
        spectrum.blocks.push_back(spectrumPlot(result, language));
        spectrum.blocks.push_back(harmonicsTable(result));
    }
    spectrum.blocks.push_back(paperTable(result));
    document.sections.push_back(std::move(spectrum));
    document.sections.push_back(
        {LT_TEXT("Engine", "How sure"),
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

Text verdictName(FormVerdict verdict)
{
    switch (verdict) {
        case FormVerdict::Pass: return LT_TEXT("Engine", "✓ within tolerance");
        case FormVerdict::Fail: return LT_TEXT("Engine", "✗ out of tolerance");
        case FormVerdict::Undecided: return LT_TEXT("Engine", "? not decided: too near the tolerance");
    }
    return {};
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
            case FormVerdict::Pass: add(LT_TEXT("Engine", "within {tolerance} µm")); break;
            case FormVerdict::Fail: add(LT_TEXT("Engine", "above {tolerance} µm")); break;
            case FormVerdict::Undecided:
                add(LT_TEXT("Engine", "? not decided: {tolerance} µm is within the uncertainty of {uncertainty} µm"));
                break;
        }
        if (*result.verdict != FormVerdict::Undecided) answer.verdict = *result.verdict == FormVerdict::Pass;
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
