#include "engine/deflection/turning_study.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/units.h"
#include "engine/core/verdict_json.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/deflection_quantities.h"
#include "engine/report/quantity_table.h"
#include "engine/stock/stock_plots.h"
#include "engine/stock/stock_quantities.h"

namespace lathelier::deflection {
namespace {

constexpr std::size_t mostReportedFindings = 3;

void append(const Notes& more, Notes& notes)
{
    for (const Note& note : more)
        if (!contains(notes, note.code)) notes.push_back(note);
}

std::size_t countSought(const IdentificationParameters& p, const TurningSetup& setup)
{
    const auto is_sought = [&](bool wanted, Influence influence) { return wanted && hasInfluence(setup, influence); };
    return static_cast<std::size_t>(is_sought(p.tailstock, Influence::Tailstock) +
                                    is_sought(p.chuck_radial, Influence::ChuckRadial) +
                                    is_sought(p.chuck_tilt, Influence::ChuckTilt) + p.forces);
}

Json jsonOf(const DeflectionMap& map)
{
    return nestedJson(
        {{"depth_mm", map.depth_mm}, {"feed_mm_rev", map.feed_mm_rev}, {"max_um", map.max_um}, {"time_s", map.time_s}});
}

/// Adds the result of the stock check; notes on single moves remain in its own list.
void checkStock(const TurningJob& job, TurningStudy& study, const Progress& progress)
{
    const stock::StockParameters parameters = stockParameters(job.setup);
    study.stock = stock::simulateStock(job.stock, job.path.moves, parameters, progress.part(0, 0.5));
    append(study.stock->notes, study.notes);
    if (!study.stock->findings.empty())
        study.notes.push_back({notes::toolMeets,
                               {{"count", static_cast<std::int64_t>(study.stock->findings.size())},
                                {"line", study.stock->findings.front().line}}});
    if (!study.corrected) return;
    const stock::StockResult written =
        stock::simulateStock(job.stock, study.corrected->moves, parameters, progress.part(0.5, 1));
    if (written.findings.size() > study.stock->findings.size())
        study.notes.push_back(
            {notes::correctedMeets,
             {{"count", static_cast<std::int64_t>(written.findings.size())}, {"line", written.findings.front().line}}});
}

report::Finding findingOf(const stock::StockFinding& found)
{
    return {
        LT_TEXT("Engine", "Line {line}: {kind} at z = {z_mm:1} mm, {depth_mm:2} mm deep"),
        {{"line", found.line}, {"kind", stock::nameOf(found.kind)}, {"z_mm", found.z_mm}, {"depth_mm", found.depth_mm}},
        Verdict::Fail,
        {Interval{found.z_mm, found.z_mm}, {}, {}}};
}

report::Finding largestError(const FinalContour& contour, const std::optional<Verdict>& verdict)
{
    const std::vector<double>& errors = contour.diameter_error_um;
    const auto at = static_cast<std::size_t>(
        std::max_element(errors.begin(), errors.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
        errors.begin());
    return {LT_TEXT("Engine", "Largest at z = {z_mm:1} mm: {error:+1} µm on diameter"),
            {{"z_mm", contour.z_mm[at]}, {"error", errors[at]}},
            verdict,
            {Interval{contour.z_mm[at], contour.z_mm[at]}, {}, {}}};
}

}  // namespace

stock::StockParameters stockParameters(const TurningSetup& setup)
{
    stock::StockParameters parameters;
    parameters.z_zero_mm = setup.z_zero_mm;
    parameters.tools = {setup.tool};
    parameters.chuck.emplace();
    if (setup.tailstock) parameters.tailstock.emplace();
    return parameters;
}

const std::vector<Field<StudyParameters>>& fieldsOf(const StudyParameters*)
{
    using P = StudyParameters;
    static const auto all = described<P>(
        field("tolerance_um", &P::tolerance_um, {1e-3, 1e5},
              Label{LT_TEXT("Engine", "Tolerance"), LT_TEXT("Engine", "Of the diameter error, to both sides."),
                    unit::um}),
        field("check_stock", &P::check_stock,
              Label{LT_TEXT("Engine", "Check against the stock"),
                    LT_TEXT("Engine", "Find rapid moves through stock, and where the tool meets chuck or tailstock."),
                    {},
                    true}),
        field("band", &P::band,
              Label{LT_TEXT("Engine", "Uncertainty"),
                    LT_TEXT("Engine",
                            "Repeat the prediction with springs, forces and modulus drawn at random; 95 % of "
                            "the answers make a band.")}),
        field("sensitivities", &P::sensitivities,
              Label{LT_TEXT("Engine", "Sensitivities"), LT_TEXT("Engine", "What 10 % of each influence change.")}),
        field("feed", &P::feed,
              Label{LT_TEXT("Engine", "Feed along z"),
                    LT_TEXT("Engine",
                            "The feed that keeps the last pass within the tolerance, for those who may not "
                            "change X.")}),
        field(
            "map", &P::map,
            Label{LT_TEXT("Engine", "Map"), LT_TEXT("Engine", "Largest error over depth and feed of the last pass.")}),
        rows("measured", &P::measured, Range{0, 1000},
             Label{LT_TEXT("Engine", "Measured diameters"),
                   LT_TEXT("Engine", "On the finished part: place, diameter, standard uncertainty.")}));
    return all;
}

TurningStudy studyTurning(const TurningJob& job, const StudyParameters& parameters, const StudyDetails& details,
                          const Progress& progress)
{
    TurningStudy study;
    study.parameters = parameters;
    study.prediction = predictJob(job, progress.part(0, 0.2, LT_TEXT("Engine", "Predicting")));
    append(study.prediction.notes, study.notes);
    if (parameters.tolerance_um)
        study.verdict = study.prediction.summary.max_um <= *parameters.tolerance_um ? Verdict::Pass : Verdict::Fail;
    if (study.verdict && job.bore_line) study.verdict = Verdict::Undecided;
    study.compliance = staticCompliance(job.stock, job.setup);
    if (parameters.band)
        study.band =
            errorBand(job.plan, job.setup, details.band, progress.part(0.2, 0.4, LT_TEXT("Engine", "Drawing samples")));
    if (parameters.sensitivities) study.swings = sensitivities(job.plan, job.setup);
    if (parameters.map) {
        MapParameters wanted = details.map;
        if (!wanted.tolerance_um) wanted.tolerance_um = parameters.tolerance_um;
        study.map = deflectionMap(job.plan, job.setup, wanted, progress.part(0.4, 0.6, LT_TEXT("Engine", "Map")));
    }
    if (parameters.feed && parameters.tolerance_um) {
        FeedParameters wanted = details.feed;
        wanted.tolerance_um = *parameters.tolerance_um;
        study.feed = feedForTolerance(job.plan, job.setup, wanted);
        append(study.feed->notes, study.notes);
    }
    if (parameters.measured.size() >= 2) study.triage = triage(job.stock, job.runs, job.setup, parameters.measured);
    if (const std::size_t sought = countSought(details.identification, job.setup); !parameters.measured.empty()) {
        if (parameters.measured.size() < sought || sought == 0)
            study.notes.push_back({notes::tooFewForStiffness,
                                   {{"found", static_cast<std::int64_t>(parameters.measured.size())},
                                    {"expected", static_cast<std::int64_t>(sought)}}});
        else
            study.identified = identify(job.stock, job.runs, job.setup, parameters.measured, details.identification,
                                        progress.part(0.6, 0.7, LT_TEXT("Engine", "Fitting")));
        if (study.identified) append(study.identified->notes, study.notes);
    }
    if (parameters.correction) {
        study.corrected =
            correctProgram(job, details.compensation, progress.part(0.7, 0.85, LT_TEXT("Engine", "Correcting")));
        append(study.corrected->compensation.notes, study.notes);
    }
    if (parameters.check_stock)
        checkStock(job, study, progress.part(0.85, 1, LT_TEXT("Engine", "Checking against the stock")));
    progress.report(1);
    return study;
}

Json toJson(const TurningStudy& study)
{
    Json json = nestedJson(describedValues(study.prediction));
    json["verdict"] = verdictJson(study.verdict);
    json["static_compliance"] = nestedJson(describedValues(study.compliance));
    if (study.stock)
        json.update(nestedJson(describedValues(*study.stock)));
    else
        json["findings"] = Json();
    json["band"] = study.band ? nestedJson(describedValues(*study.band)) : Json();
    json["sensitivities"] = nestedJson({{"rows", study.swings ? Value(listed(*study.swings)) : Value()}})["rows"];
    json["map"] = study.map ? jsonOf(*study.map) : Json();
    json["feed_adjustment"] = study.feed ? nestedJson(describedValues(*study.feed)) : Json();
    json["identification"] = study.identified ? nestedJson(describedValues(*study.identified)) : Json();
    json["triage"] = study.triage ? nestedJson(describedValues(*study.triage)) : Json();
    if (study.corrected) json.update(nestedJson(describedValues(*study.corrected)));
    return json;
}

report::Answer answer(const TurningStudy& study, const Language& language)
{
    report::Answer made = answer(study.prediction, study.parameters.tolerance_um, language);
    if (study.band) made.expanded_uncertainty = (study.band->max_high_um - study.band->max_low_um) / 2;
    if (study.stock && !study.stock->findings.empty())
        made.findings.push_back(findingOf(study.stock->findings.front()));
    made.findings.push_back(largestError(study.prediction.final, study.verdict));
    if (study.swings && !study.swings->empty()) {
        const Sensitivity& first = study.swings->front();
        made.findings.push_back({LT_TEXT("Engine", "Hangs most on: {influence} (±10 % change it by {swing:1} µm)"),
                                 {{"influence", first.name}, {"swing", std::abs(first.swing_um())}},
                                 {},
                                 {}});
    }
    if (study.corrected) {
        const CompensationResult& c = study.corrected->compensation;
        made.findings.push_back(
            {LT_TEXT("Engine", "Corrected program: {residual:2} µm left, {changed} blocks changed, {added} added"),
             {{"residual", c.residual.max_um}, {"changed", c.blocks_changed}, {"added", c.blocks_added}},
             {},
             {}});
    } else if (study.triage) {
        made.findings.push_back({LT_TEXT("Engine", "What was measured looks like: {cause}"),
                                 {{"cause", nameOf(study.triage->cause)}},
                                 {},
                                 {}});
    }
    if (made.findings.size() > mostReportedFindings) made.findings.resize(mostReportedFindings);
    return made;
}

report::Answer correctionAnswer(const TurningStudy& study, const Language& language)
{
    return answer(study.corrected->compensation, study.parameters.tolerance_um, study.band ? &*study.band : nullptr,
                  language);
}

report::Table findingsTable(const stock::StockResult& result)
{
    return report::listTable<stock::StockFinding>(LT_TEXT("Engine", "What the tool meets"), result.findings,
                                                  {"line", "kind_name", "z_mm", "x_mm", "depth_mm"});
}

report::Section studySummary(const TurningStudy& study, const Language& language)
{
    report::Section section = deflectionSummary(study.prediction, study.parameters.tolerance_um, language);
    section.blocks.front() = answer(study, language);
    if (!section.blocks.empty() && std::holds_alternative<Notes>(section.blocks.back())) section.blocks.pop_back();
    if (study.corrected) section.blocks.push_back(correctionAnswer(study, language));
    if (study.triage)
        section.blocks.push_back(report::listTable<CauseFit>(LT_TEXT("Engine", "What the measured diameters look like"),
                                                             study.triage->alone, {"cause_name", "size", "rms_um"}));
    if (!study.notes.empty()) section.blocks.push_back(study.notes);
    return section;
}

report::Document studyReport(const TurningStudy& study, const Language& language)
{
    ReportParts parts;
    parts.corrected = study.corrected ? &*study.corrected : nullptr;
    parts.band = study.band ? &*study.band : nullptr;
    parts.sensitivities = study.swings ? &*study.swings : nullptr;
    parts.map = study.map ? &*study.map : nullptr;
    parts.identified = study.identified ? &*study.identified : nullptr;
    parts.tolerance_um = study.parameters.tolerance_um;
    report::Document document = deflectionReport(study.prediction, parts, language);
    document.sections.front() = studySummary(study, language);
    document.sections[1].blocks.emplace_back(compliancePlot(study.compliance));
    if (study.feed) document.sections[1].blocks.emplace_back(feedPlot(*study.feed));
    if (study.stock)
        document.sections.insert(
            document.sections.begin() + 2,
            {LT_TEXT("Engine", "Stock"), {stock::stockPlot(*study.stock, {}, language), findingsTable(*study.stock)}});
    return document;
}

}  // namespace lathelier::deflection
