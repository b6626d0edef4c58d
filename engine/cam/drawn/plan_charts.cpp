#include "engine/cam/drawn/plan_charts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/cam/check/check_report.h"
#include "engine/cam/drawn/rest_places.h"
#include "engine/cam/plan_quantities.h"
#include "engine/cam/plan_report.h"
#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/report/result_json.h"
#include "engine/stability/stability_plots.h"
#include "engine/stock/stock_plots.h"

namespace lathelier::cam {
namespace {

/// Height of the drawing over a stretch, for the number of what stays there.
double radiusAt(const ClampingOutcome& clamping, const Interval& z_mm)
{
    double radius = 0;
    for (std::size_t i = 0; i < clamping.drawing_z_mm.size(); ++i)
        if (clamping.drawing_z_mm[i] >= z_mm.from - 1 && clamping.drawing_z_mm[i] <= z_mm.to + 1)
            radius = std::max(radius, clamping.drawing_x_mm[i]);
    return radius;
}

std::string restName(std::size_t number, const cam::RestInterval& rest, const Language& language)
{
    return fill(
        text(LT_TEXT("Engine", "{number}: {left_mm:3} mm, {cause}"), language),
        {{"number", static_cast<std::int64_t>(number)}, {"left_mm", rest.left_mm}, {"cause", cam::nameOf(rest.cause)}},
        language);
}

/// What stays there of the part that this clamping finishes, hatched, with number and cause.
void addRest(report::Plot& plot, const TurningOutcome& outcome, std::size_t setup, const Language& language)
{
    const auto& all = outcome.plan->rest;
    bool is_named = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (placeOf(outcome, i).clamping != setup) continue;
        report::Region area = areaOf(outcome, i, setup);
        if (!is_named) area.name = LT_TEXT("Engine", "material stays");
        is_named = true;
        plot.regions.push_back(std::move(area));
        const Interval at = inStock(outcome, setup, {all[i].z_start_mm, all[i].z_end_mm});
        plot.marks.push_back(
            {(at.from + at.to) / 2, radiusAt(outcome.clampings[setup], at), restName(i + 1, all[i], language)});
    }
}

/// The speeds of a block, by its line.
struct BlockSpeed {
    double speed_rpm = notANumber, cutting_speed_m_min = notANumber, limit_rpm = notANumber;

    double rpmAt(double radius_mm) const
    {
        if (!std::isnan(speed_rpm)) return speed_rpm;
        if (std::isnan(cutting_speed_m_min)) return notANumber;
        const double rpm = 1000 * cutting_speed_m_min / (2 * std::numbers::pi * std::max(radius_mm, 1e-3));
        return std::isnan(limit_rpm) ? rpm : std::min(rpm, limit_rpm);
    }
};

/// Lines of the finishing operations: from the first one up to the next operation, or of a cycle's contour.
bool isFinish(const cam::SetupPlan& setup, std::int64_t line, int tool)
{
    const cam::PlannedOperation* in = nullptr;
    for (const cam::PlannedOperation& operation : setup.operations) {
        if (operation.first_line <= line) in = &operation;
        const bool is_contour = line >= operation.contour_first_line && line <= operation.contour_last_line;
        if (operation.tool == tool && operation.contour_first_line > 0 && is_contour) return true;
    }
    return in && in->tool == tool &&
           (in->kind == cam::OperationKind::Finish || in->kind == cam::OperationKind::FinishBack);
}

report::Curve speedCurve(const TurningOutcome& outcome, std::size_t setup, bool is_cutting_speed)
{
    const cam::SetupPlan& plan = outcome.plan->setups.at(setup);
    const stock::DrawnPath& drawn = outcome.clampings.at(setup).drawn;
    std::map<std::int64_t, BlockSpeed> speeds;
    for (const gcode::Move& move : plan.check.path.moves)
        speeds[move.line] = {move.speed_rpm, move.cutting_speed_m_min, move.speed_limit_rpm};
    report::Curve curve;
    constexpr int steps = 6;
    for (std::size_t i = 1; i < drawn.corners(); ++i) {
        const std::int64_t line = drawn.lineOf(i);
        if (!drawn.isPiece(i) || drawn.isRapid(i) || !isFinish(plan, line, drawn.toolOf(i))) {
            if (!curve.x.empty() && !std::isnan(curve.y.back())) {
                curve.x.push_back(curve.x.back());
                curve.y.push_back(notANumber);
            }
            continue;
        }
        const BlockSpeed& speed = speeds[line];
        const stock::Corner &a = drawn.corner(i - 1), &b = drawn.corner(i);
        for (int k = 0; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps, x = std::lerp(a.x_mm, b.x_mm, share);
            const double rpm = speed.rpmAt(x);
            curve.x.push_back(std::lerp(a.z_mm, b.z_mm, share));
            curve.y.push_back(is_cutting_speed ? rpm * 2 * std::numbers::pi * std::max(x, 0.0) / 1000 : rpm);
        }
    }
    return curve;
}

/// A step for each section of this clamping.
template <class Get>
report::Curve sectionCurve(const TurningOutcome& outcome, std::size_t setup, Get get)
{
    report::Curve curve;
    for (const cam::SectionSpeed& section : outcome.plan->sections) {
        if (section.setup != static_cast<int>(setup) + 1) continue;
        const std::optional<double> value = get(section);
        if (!value || !std::isfinite(*value)) continue;
        const Interval at = inStock(outcome, setup, {section.z_start_mm, section.z_end_mm});
        curve.x.insert(curve.x.end(), {at.from, at.to, at.to});
        curve.y.insert(curve.y.end(), {*value, *value, notANumber});
    }
    return curve;
}

report::Document withSheets(report::Document document, const TurningOutcome& outcome)
{
    for (std::size_t i = 0; i < outcome.plan->setups.size(); ++i)
        for (report::Section& section : document.sections)
            if (section.title == report::Caption(LT_TEXT("Engine", "Set-up sheet")))
                section.blocks.emplace_back(sheetOf(outcome, i));
    return document;
}

}  // namespace

StockShown stockAt(const TurningOutcome& outcome, std::size_t setup, std::int64_t line, bool is_cutting)
{
    StockShown shown{false, std::nullopt};
    const auto& stock = outcome.plan->setups.at(setup).check.stock;
    if (!stock) return shown;
    std::size_t begun = 0;
    while (begun < stock->passes.size() && stock->passes[begun].line <= line) ++begun;
    const std::size_t done = is_cutting && begun > 0 ? begun - 1 : begun;
    for (std::size_t i = done; i > 0; --i)
        if (stock->passes[i - 1].is_kept) {
            shown.pass = i - 1;
            break;
        }
    return shown;
}

report::Plot contourPlot(const TurningOutcome& outcome, std::size_t setup, const StockShown& shown, int pixels,
                         const Language& language)
{
    const ClampingOutcome& clamping = outcome.clampings.at(setup);
    const cam::CheckResult& check = outcome.plan->setups.at(setup).check;
    report::Plot plot;
    if (check.stock && clamping.bare) {
        stock::StockPlotParts parts;
        parts.pass = shown.pass;
        const bool is_bare = !shown.is_whole && !shown.pass;
        plot = stock::stockPlot(is_bare ? *clamping.bare : *check.stock, parts, language);
        // The scrubber shows the stock pass by pass: earlier ones would only fill chart and legend.
        std::erase_if(plot.curves, [](const report::Curve& curve) { return curve.thin; });
        for (report::Curve& curve : plot.curves) curve.name = std::string();
    }
    if (!check.stock) plot.y = {LT_TEXT("Engine", "Radius"), unit::mm};  // the program is not checked, or has errors
    for (report::Curve& curve : clamping.drawn.curves(clamping.drawn.whole(pixels)))
        plot.curves.push_back(std::move(curve));
    const bool is_one = outcome.clampings.size() == 1;
    plot.title = is_one       ? LT_TEXT("Engine", "Drawing, stock and tool")
                 : setup == 0 ? LT_TEXT("Engine", "Drawing, stock and tool, first clamping")
                              : LT_TEXT("Engine", "Drawing, stock and tool, second clamping");
    plot.x = {LT_TEXT("Engine", "z from the raw end"), unit::mm};
    report::Curve drawing{LT_TEXT("Engine", "drawing"), clamping.drawing_z_mm, clamping.drawing_x_mm};
    drawing.has_readout = false;
    plot.curves.push_back(std::move(drawing));
    if (!is_one)
        plot.limits.push_back({report::Limit::Direction::Vertical,
                               outcome.plan->setups[setup].clamping.finished_to_mm + clamping.part_zero_mm,
                               LT_TEXT("Engine", "finished up to here")});
    addRest(plot, outcome, setup, language);
    for (const cam::CheckFinding& found : check.findings)
        if (found.kind == cam::CheckKind::InsertBelowDrawing)
            plot.marks.push_back({found.z_mm + clamping.part_zero_mm, found.x_mm,
                                  fill(text(LT_TEXT("Engine", "line {line}: {finding}"), language),
                                       {{"line", found.line}, {"finding", cam::nameOf(found.kind)}}, language)});
    return plot;
}

report::Plot coursePlot(const TurningOutcome& outcome, std::size_t setup, Course course)
{
    report::Plot plot;
    plot.x = {LT_TEXT("Engine", "z from the raw end"), unit::mm};
    report::Curve curve;
    switch (course) {
        case Course::Speed:
            plot.title = LT_TEXT("Engine", "Speed N of the finish");
            plot.y = {unit::newton, unit::rpm};
            curve = speedCurve(outcome, setup, false);
            break;
        case Course::CuttingSpeed:
            plot.title = LT_TEXT("Engine", "Cutting speed v_c of the finish");
            plot.y = {LT_TEXT("Engine", "v_c"), unit::m_min};
            curve = speedCurve(outcome, setup, true);
            break;
        case Course::Frequency:
            plot.title = LT_TEXT("Engine", "Frequency of chatter f_m");
            plot.y = {LT_TEXT("Engine", "f_m"), unit::hz};
            curve = sectionCurve(outcome, setup, [](const cam::SectionSpeed& s) { return s.frequency_hz; });
            break;
        case Course::Roughness:
            plot.title = LT_TEXT("Engine", "Ideal roughness Rz of the finish");
            plot.y = {LT_TEXT("Engine", "Rz"), unit::um};
            curve = sectionCurve(outcome, setup, [](const cam::SectionSpeed& s) { return std::optional(s.Rz_um); });
            break;
    }
    double most = 0;
    for (const double value : curve.y)
        if (std::isfinite(value)) most = std::max(most, value);
    if (most > 0) plot.y.range = Interval{0, 1.15 * most};
    if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
    return plot;
}

report::Plot whyPlot(const TurningOutcome& outcome, std::size_t section, const Language& language)
{
    if (section >= outcome.lobes.size() || !outcome.lobes[section]) return {};
    report::Plot plot = stability::lobesPlot(*outcome.lobes[section], {}, language);
    const SectionSpeed& speed = outcome.plan->sections[section];
    plot.limits.push_back(
        {report::Limit::Direction::Vertical, askedSpeed(*outcome.plan, speed), LT_TEXT("Engine", "selected")});
    if (speed.speed_rpm)
        plot.limits.push_back({report::Limit::Direction::Vertical, *speed.speed_rpm,
                               fill(text(LT_TEXT("Engine", "this speed {speed}"), language),
                                    {{"speed", fixed(*speed.speed_rpm, 0, language)}}, language)});
    plot.title = fill(text(LT_TEXT("Engine", "Why this speed: z {from:1}-{to:1} mm"), language),
                      {{"from", speed.z_start_mm}, {"to", speed.z_end_mm}}, language);
    return plot;
}

std::vector<ListedOperation> listedOperations(const TurningOutcome& outcome, std::size_t setup)
{
    std::vector<ListedOperation> all;
    const int number = static_cast<int>(setup) + 1;
    const auto& operations = outcome.plan->setups.at(setup).operations;
    for (std::size_t i = 0; i < operations.size(); ++i)
        all.push_back({{number, operations[i].kind, operations[i].tool}, i});
    const auto& order = outcome.plan->parameters.order;
    const auto rank = [&](const cam::OperationStep& step) { return std::find(order.begin(), order.end(), step); };
    for (const cam::SkippedOperation& skipped : outcome.plan->parameters.skipped) {
        if (skipped.setup != number) continue;
        const auto later = std::find_if(all.begin(), all.end(), [&](const ListedOperation& operation) {
            if (rank(operation.which) != order.end() && rank(skipped) != order.end())
                return rank(operation.which) > rank(skipped);
            return operation.which.kind > skipped.kind;
        });
        all.insert(later, {skipped, std::nullopt});
    }
    return all;
}

std::vector<cam::OperationStep> stepsOf(const TurningOutcome& outcome, std::size_t setup)
{
    std::vector<cam::OperationStep> steps;
    for (const ListedOperation& operation : listedOperations(outcome, setup)) {
        const cam::OperationStep step = stepOf(operation.which, outcome.plan->job);
        if (std::find(steps.begin(), steps.end(), step) == steps.end()) steps.push_back(step);
    }
    return steps;
}

cam::OperationStep stepOf(cam::OperationStep operation, const cam::Job& job)
{
    const cam::JobTool* finish = job.toolFor(cam::ToolUse::Finish);
    if (operation.kind == cam::OperationKind::SemiFinish && finish && operation.tool == finish->number)
        operation.kind = cam::OperationKind::Finish;
    return operation;
}

report::Table operationTable(const TurningOutcome& outcome, std::size_t setup)
{
    report::Table table = cam::operationTable(outcome.plan->setups.at(setup));
    const std::vector<std::vector<Value>> planned = std::move(table.rows);
    table.rows.clear();
    for (const ListedOperation& operation : listedOperations(outcome, setup)) {
        if (operation.planned) {
            table.rows.push_back(planned[*operation.planned]);
            continue;
        }
        std::vector<Value>& row = table.rows.emplace_back(table.columns.size());
        row[0] = cam::nameOf(operation.which.kind);
        row[1] = std::int64_t{operation.which.tool};
    }
    return table;
}

report::QuantityTable sheetOf(const TurningOutcome& outcome, std::size_t setup)
{
    const cam::TurningPlan& plan = *outcome.plan;
    const cam::SetupPlan& shown = plan.setups.at(setup);
    const cam::Clamping& clamping = shown.clamping;
    report::QuantityTable table;
    table.title = setup == 0 ? LT_TEXT("Engine", "First clamping") : LT_TEXT("Engine", "Second clamping");
    const auto add = [&](Text name, Value value, Text unit = {}, int decimals = 2) {
        table.rows.push_back({name, std::move(value), unit, decimals});
    };
    add(LT_TEXT("Engine", "Control"),
        outcome.has_own_post ? Value(plan.post) : Value(cam::labelOfPost(outcome.question.post)));
    add(LT_TEXT("Engine", "Diameter of the bar"), plan.job.stock.diameter_mm, unit::mm, 3);
    if (plan.job.stock.length_mm) add(LT_TEXT("Engine", "Length of the bar"), *plan.job.stock.length_mm, unit::mm);
    add(LT_TEXT("Engine", "Zero of the program"), clamping.is_mirrored
                                                      ? LT_TEXT("Engine", "the face of the other end, finished")
                                                      : LT_TEXT("Engine", "the face of the free end, finished"));
    add(LT_TEXT("Engine", "Allowance of the face"), plan.job.stock.face_allowance_mm, unit::mm);
    add(LT_TEXT("Engine", "z of the chuck face"), clamping.job.setup.chuck_face_z_mm, unit::mm);
    if (clamping.job.setup.jaw_diameter_mm)
        add(LT_TEXT("Engine", "Jaws ⌀"), *clamping.job.setup.jaw_diameter_mm, unit::mm);
    if (clamping.job.setup.grip_length_mm)
        add(LT_TEXT("Engine", "Length of the grip"), *clamping.job.setup.grip_length_mm, unit::mm);
    add(LT_TEXT("Engine", "Tailstock"),
        clamping.job.setup.tailstock ? LT_TEXT("Engine", "yes") : LT_TEXT("Engine", "no"));
    add(LT_TEXT("Engine", "Finished up to z"), clamping.finished_to_mm, unit::mm);
    add(LT_TEXT("Engine", "Time with tool changes"), shown.time_s / 60, LT_TEXT("Engine", "min"), 1);
    add(LT_TEXT("Engine", "Gouge"), shown.check.gouge_um, unit::um);
    add(LT_TEXT("Engine", "Most that is left"), plan.left_max_mm, unit::mm, 4);
    return table;
}

report::Document reportOf(const TurningOutcome& outcome, const Language& language)
{
    return withSheets(documentOf(cam::turnTask(), outcome.asked, outcome.sources,
                                 cam::outcomeOf({std::shared_ptr<const cam::TurnOutcome>(), &outcome}), language),
                      outcome);
}

}  // namespace lathelier::cam
