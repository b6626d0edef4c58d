#include "engine/deflection/compensation.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/influences.h"

namespace lathelier::deflection {
namespace {

constexpr double acceptedShare =
    0.97;  ///< share of the tolerance accepted at the nodes, as the error between them is slightly larger
constexpr int mostTrials = 6;  ///< each with a smaller contour tolerance

/// Runs that generate part of the final contour.
std::vector<bool> finishing(const WorkPlan& plan, const TurningSetup& setup)
{
    TurningWork work(plan, setup);
    std::vector<std::size_t> owner(2 * plan.pieces(), plan.cuts.size());
    std::vector<Station> stations;
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
        work.take(plan.cuts[i], CutTask::Predict, stations);
        for (const Station& s : stations) owner[2 * (plan.cuts[i].first + s.piece) + (s.at_start ? 0 : 1)] = i;
    }
    std::vector<bool> result(plan.cuts.size() + 1, false);
    for (const std::size_t i : owner) result[i] = true;
    return result;
}

/// Largest error by what is allowed there.
double shareOff(const CutPlan& asked, const WrittenRun& written, std::span<const Station> stations,
                const CompensationParameters& parameters, const TurningSetup& setup)
{
    double largest = 0;
    for (const Station& s : stations) {
        const CutPiece& piece = asked.pieces[s.piece];
        const double target_mm = judgedTarget_mm(piece, s, setup);
        const double allowed_um =
            written.is_coarse[s.piece] ? residualOfArcs_um(parameters) : residualOfLines_um(parameters);
        largest = std::max(largest, um_per_mm_of_diameter * std::abs(s.radius_mm - target_mm) / allowed_um);
    }
    return largest;
}

/// Corrects one run and removes it from the workpiece.
WrittenRun correct(const WorkPlan& plan, const CutPlan& cut, std::span<const Station> ideal,
                   const CompensationParameters& parameters, const TurningSetup& setup, TurningWork& work)
{
    ArcLimits limits;
    limits.grid_mm = writtenGrid_um(parameters) / um_per_mm_of_diameter;
    limits.centre_grid_mm = 2 * limits.grid_mm;
    limits.coarse_mm = acceptedShare * residualOfArcs_um(parameters) / um_per_mm_of_diameter;
    const double least_mm = limits.grid_mm / 2 * (1 + 1e-6);
    limits.tolerance_mm = acceptedShare * residualOfLines_um(parameters) / um_per_mm_of_diameter;
    if (!(limits.tolerance_mm > least_mm)) limits.tolerance_mm = least_mm;
    std::vector<Station> stations;
    for (int trial = 1;; ++trial) {
        WrittenRun written = writtenRun(plan, work, cut, ideal, limits);
        TurningWork tried = work;
        tried.take(written.cut, CutTask::Predict, stations);
        const double off = shareOff(cut, written, stations, parameters, setup);
        if (off <= acceptedShare || trial == mostTrials || limits.tolerance_mm == least_mm) {
            work.take(written.cut, CutTask::Predict, stations);
            return written;
        }
        const double less = std::min(0.95, 1 / off);
        limits.tolerance_mm = std::max(least_mm, limits.tolerance_mm * less);
        limits.coarse_mm = std::max(limits.tolerance_mm, limits.coarse_mm * less);
    }
}

/// Largest error of the corrected runs, each against its own target; lines that were kept are left out.
double largestOff_um(const ComparedPlans& plans, const CompensationResult& result)
{
    const TurningSetup& setup = result.before.setup;
    TurningWork work(plans.after, setup);
    std::vector<Station> stations;
    double largest_um = 0;
    auto corrected = result.runs.begin();
    for (std::size_t i = 0; i < plans.after.cuts.size(); ++i) {
        const CutPlan& cut = plans.after.cuts[i];
        const CutPlan& asked = plans.before.cuts[i];
        work.take(cut, CutTask::Predict, stations);
        while (corrected != result.runs.end() && corrected->run < i) ++corrected;
        if (corrected == result.runs.end() || corrected->run != i) continue;
        for (const Station& s : stations) {
            const std::size_t node = cut.first + s.piece;
            if (node < asked.first || node - asked.first >= asked.pieces.size()) continue;
            const CutPiece& piece = asked.pieces[node - asked.first];
            if (isKept(result.parameters, piece.line)) continue;
            const double target_mm = judgedTarget_mm(piece, s, setup);
            largest_um = std::max(largest_um, um_per_mm_of_diameter * std::abs(s.radius_mm - target_mm));
        }
    }
    return largest_um;
}

void count(const CorrectedRun& run, const CompensationParameters& parameters, CompensationResult& result)
{
    for (const CorrectedNode& node : run.nodes) {
        const double correction_um = node.correction_um();
        if (std::abs(correction_um) > parameters.largest_correction_um)
            throw Error(errors::correctionTooLarge, {{"z_mm", node.z_mm},
                                                     {"correction_um", correction_um},
                                                     {"maximum_um", parameters.largest_correction_um},
                                                     {"line", node.line}});
        if (node.added)
            ++result.blocks_added;
        else if (std::abs(correction_um) > 1e-9)
            ++result.blocks_changed;
        if (std::abs(correction_um) > std::abs(result.largest_correction_um))
            result.largest_correction_um = correction_um;
    }
}

}  // namespace

const std::vector<Field<CompensationParameters>>& fieldsOf(const CompensationParameters*)
{
    using P = CompensationParameters;
    static const auto all = described<P>(
        field("corrected_runs", &P::runs,
              {{"all", LT_TEXT("Engine", "every pass")},
               {"finish", LT_TEXT("Engine", "passes that leave the final contour")}},
              Label{LT_TEXT("Engine", "Corrected passes"), LT_TEXT("Engine", "Which passes are written anew.")}),
        field("grid_um", &P::grid_um, {0.01, 100},
              Label{LT_TEXT("Engine", "Grid of X"), LT_TEXT("Engine", "Digits of the written program, on diameter."),
                    unit::um, true}),
        field("residual_tolerance_um", &P::tolerance_um, {0.01, 1000},
              Label{LT_TEXT("Engine", "Residual allowed"),
                    LT_TEXT("Engine", "What the written program may leave, on diameter."), unit::um, true}),
        field("largest_correction_um", &P::largest_correction_um, {1, 1e5},
              Label{LT_TEXT("Engine", "Largest correction"), LT_TEXT("Engine", "On diameter; more is refused."),
                    unit::um, true}),
        field("kept_lines", &P::kept_lines, Range{1, 1e9},
              Label{LT_TEXT("Engine", "Lines kept"),
                    LT_TEXT("Engine", "Blocks of these lines stay as they are: 12:12, 20:31."),
                    {},
                    true}),
        field("robustness", &P::robustness,
              Label{LT_TEXT("Engine", "Robustness"),
                    LT_TEXT("Engine", "Try the corrected program with other springs and forces."),
                    {},
                    true}));
    return all;
}

double writtenGrid_um(const CompensationParameters& parameters)
{
    constexpr double inchStep = mm_per_inch / 10;  // 0.0001 in by 0.001 mm
    return parameters.grid_um * (parameters.is_inch ? inchStep : 1);
}

double lengthGrid_mm(const CompensationParameters& parameters)
{
    return parameters.is_inch ? mm_per_inch * 1e-4 : metricGrid_mm;
}

double residualOfLines_um(const CompensationParameters& parameters)
{
    return parameters.tolerance_um + (parameters.is_inch ? writtenGrid_um(parameters) / 2 : 0);
}

double residualOfArcs_um(const CompensationParameters& parameters)
{
    return parameters.tolerance_um + writtenGrid_um(parameters) / 2;
}

bool isKept(const CompensationParameters& parameters, std::int64_t line)
{
    const auto number = static_cast<double>(line);
    return std::any_of(parameters.kept_lines.begin(), parameters.kept_lines.end(),
                       [&](const Interval& lines) { return lines.from <= number && number <= lines.to; });
}

ComparedPlans comparedPlans(const Shaft& stock, std::span<const ToolRun> programmed, std::span<const ToolRun> written,
                            TurningSetup setup)
{
    std::vector<ToolRun> all(programmed.begin(), programmed.end());
    all.insert(all.end(), written.begin(), written.end());
    setup.step_mm /= 2;
    const std::size_t count = workPlan(stock, programmed, setup).cuts.size();
    ComparedPlans plans{workPlan(stock, all, setup), {}};
    if (plans.before.cuts.size() != 2 * count)
        throw Error(errors::writtenRunsDiffer,
                    {{"expected", static_cast<std::int64_t>(count)},
                     {"found", static_cast<std::int64_t>(plans.before.cuts.size() - count)}});
    plans.after = plans.before;
    const auto half = static_cast<std::ptrdiff_t>(count);
    plans.before.cuts.erase(plans.before.cuts.begin() + half, plans.before.cuts.end());
    plans.after.cuts.erase(plans.after.cuts.begin(), plans.after.cuts.begin() + half);
    return plans;
}

void evaluateWritten(const Shaft& stock, std::span<const ToolRun> programmed, std::span<const ToolRun> written,
                     CompensationResult& result)
{
    const TurningSetup& setup = result.before.setup;
    const ComparedPlans plans = comparedPlans(stock, programmed, written, setup);
    result.after = finalContour(plans.after, setup, &plans.before.cuts);
    result.residual = summaryOf(result.after);
    result.residual.max_um = std::max(result.residual.max_um, largestOff_um(plans, result));
    std::erase_if(result.notes, [](const Note& note) { return note.code == notes::residualAboveTolerance; });
    const bool has_arcs = std::any_of(result.runs.begin(), result.runs.end(), [](const CorrectedRun& run) {
        return std::any_of(run.nodes.begin(), run.nodes.end(),
                           [](const CorrectedNode& node) { return node.arc.has_value(); });
    });
    const double promised_um = has_arcs ? residualOfArcs_um(result.parameters) : residualOfLines_um(result.parameters);
    if (result.residual.max_um > promised_um)
        result.notes.push_back(
            {notes::residualAboveTolerance, {{"residual_um", result.residual.max_um}, {"tolerance_um", promised_um}}});
    if (result.parameters.robustness) result.robustness = robustnessOf(plans.before, plans.after, setup);
}

std::vector<RobustnessRow> robustnessOf(const WorkPlan& before, const WorkPlan& after, const TurningSetup& setup)
{
    struct Plant {
        const char* key;
        Text name;
        TurningSetup setup;
    };
    std::vector<Plant> plants;
    if (setup.tailstock) {
        plants.push_back({"tailstock_plus_20", LT_TEXT("Engine", "Tailstock 20 % stiffer"),
                          scaled(setup, Influence::Tailstock, 1.2)});
        plants.push_back({"tailstock_minus_20", LT_TEXT("Engine", "Tailstock 20 % softer"),
                          scaled(setup, Influence::Tailstock, 0.8)});
    }
    plants.push_back({"springs_plus_20", LT_TEXT("Engine", "All springs 20 % stiffer"), withSpringsScaled(setup, 1.2)});
    plants.push_back({"springs_minus_20", LT_TEXT("Engine", "All springs 20 % softer"), withSpringsScaled(setup, 0.8)});
    plants.push_back(
        {"forces_plus_20", LT_TEXT("Engine", "Forces 20 % larger"), scaled(setup, Influence::Forces, 1.2)});
    plants.push_back(
        {"forces_minus_20", LT_TEXT("Engine", "Forces 20 % smaller"), scaled(setup, Influence::Forces, 0.8)});
    plants.push_back({"forces_plus_20_springs_minus_20", LT_TEXT("Engine", "Forces 20 % larger, springs 20 % softer"),
                      scaled(withSpringsScaled(setup, 0.8), Influence::Forces, 1.2)});
    std::vector<RobustnessRow> rows;
    rows.reserve(plants.size());
    for (const Plant& plant : plants) {
        const ErrorSummary was = summaryOf(finalContour(before, plant.setup));
        const ErrorSummary now = summaryOf(finalContour(after, plant.setup, &before.cuts));
        rows.push_back({plant.key, plant.name, was.mean_abs_um, now.mean_abs_um, now.max_um});
    }
    return rows;
}

CompensationResult compensate(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                              const CompensationParameters& parameters, const Progress& progress)
{
    if (const double grid_um = writtenGrid_um(parameters); residualOfLines_um(parameters) < grid_um / 2)
        throw Error(
            errors::cannotBeWritten,
            {{"grid_um", grid_um}, {"residual_um", grid_um / 2}, {"tolerance_um", residualOfLines_um(parameters)}});
    CompensationResult result;
    result.parameters = parameters;
    const WorkPlan plan = workPlan(stock, runs, setup, lengthGrid_mm(parameters));
    result.before = predictDeflection(plan, setup, progress.part(0, 0.2));
    std::vector<bool> chosen(plan.cuts.size(), true);
    if (parameters.runs == CorrectedRuns::Finish) chosen = finishing(plan, setup);

    TurningWork work(plan, setup);
    std::vector<Station> stations;
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
        progress.part(0.2, 0.7).report(static_cast<double>(i) / static_cast<double>(plan.cuts.size()));
        const CutPlan& cut = plan.cuts[i];
        TurningWork trial = work;
        if (cut.kind == ToolRun::Kind::TowardChuck && chosen[i])
            trial.take(cut, CutTask::Correct, stations);
        else
            stations.clear();
        if (stations.empty()) {
            work.take(cut, CutTask::Predict, stations);
            result.written.push_back(cut.run);
            continue;
        }
        WrittenRun written = correct(plan, cut, stations, parameters, setup, work);
        result.written.push_back(std::move(written.run));
        CorrectedRun run{i, std::move(written.nodes), false};
        count(run, parameters, result);
        run.changed = std::any_of(run.nodes.begin(), run.nodes.end(),
                                  [](const CorrectedNode& node) { return std::abs(node.correction_um()) > 1e-9; });
        result.runs.push_back(std::move(run));
    }
    std::vector<ToolRun> originals;
    originals.reserve(plan.cuts.size());
    for (const CutPlan& cut : plan.cuts) originals.push_back(cut.run);
    progress.report(0.8);
    evaluateWritten(stock, originals, result.written, result);
    if (result.largest_correction_um < 0)
        result.notes.push_back({notes::correctionCutsDeeper, {{"correction_um", -result.largest_correction_um}}});
    progress.report(1);
    return result;
}

}  // namespace lathelier::deflection
