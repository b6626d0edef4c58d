#include "engine/cam/check/check_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/cam/check/check_quantities.h"
#include "engine/cam/check/drawn_contour.h"
#include "engine/cam/job_bodies.h"
#include "engine/core/units.h"
#include "engine/gcode/toolpath_files.h"
#include "engine/report/quantity_table.h"
#include "engine/stock/stock_plots.h"

namespace lathelier::cam {
namespace {

constexpr std::size_t mostReportedFindings = 3;
constexpr int paper_px = 2000;
constexpr double drawnSpacing_mm = 0.5;

report::Finding findingOf(const CheckFinding& found)
{
    report::Place place;
    place.line = found.line;
    place.z_mm = Interval{found.z_mm, found.z_mm};
    return {LT_TEXT("Engine", "Line {line}: {kind} at z = {z_mm:1} mm, {depth_mm:2} mm deep"),
            {{"line", found.line}, {"kind", nameOf(found.kind)}, {"z_mm", found.z_mm}, {"depth_mm", found.depth_mm}},
            Verdict::Fail,
            place};
}

report::Finding findingOf(const RestInterval& rest)
{
    report::Place place;
    if (rest.line > 0) place.line = rest.line;
    place.z_mm = Interval{rest.z_start_mm, rest.z_end_mm};
    return {
        LT_TEXT("Engine", "Left {left_mm:3} mm · z {from:2}-{to:2} mm · {cause}"),
        {{"left_mm", rest.left_mm}, {"from", rest.z_start_mm}, {"to", rest.z_end_mm}, {"cause", nameOf(rest.cause)}},
        Verdict::Fail,
        place};
}

/// By depth, the largest first.
template <class Item, class Size>
std::vector<const Item*> largestOf(const std::vector<Item>& items, Size size)
{
    std::vector<const Item*> order;
    order.reserve(items.size());
    for (const Item& item : items) order.push_back(&item);
    std::stable_sort(order.begin(), order.end(), [&](const Item* a, const Item* b) { return size(*a) > size(*b); });
    return order;
}

}  // namespace

report::Answer answer(const CheckResult& result, const Language&)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Most that is left on the drawing");
    if (result.path.has_errors) {
        answer.verdict = Verdict::Fail;
        answer.verdict_words = LT_TEXT("Engine", "✗ errors in the program");
        return answer;
    }
    answer.value = result.left_max_mm;
    answer.unit = unit::mm;
    answer.decimals = 4;
    answer.verdict = result.verdict;
    answer.verdict_words = !result.findings.empty()      ? LT_TEXT("Engine", "✗ the tool meets what it must not")
                           : !result.rest.empty()        ? LT_TEXT("Engine", "✗ material stays")
                           : !result.not_checked.empty() ? LT_TEXT("Engine", "? not all that is drawn is checked")
                                                         : LT_TEXT("Engine", "✓ as drawn");
    answer.sentence =
        result.not_checked.empty()
            ? LT_TEXT("Engine", "gouge {gouge_um:2} µm · places with material left: {rest} · findings: {findings}")
            : LT_TEXT("Engine",
                      "gouge {gouge_um:2} µm · places with material left: {rest} · findings: {findings} · drawn, but "
                      "not checked: {not_checked} ({feature})");
    answer.values = {{"gouge_um", result.gouge_um},
                     {"rest", static_cast<std::int64_t>(result.rest.size())},
                     {"findings", static_cast<std::int64_t>(result.findings.size()) + result.findings_not_listed}};
    if (!result.not_checked.empty()) {
        set(answer.values, "not_checked", static_cast<std::int64_t>(result.not_checked.size()));
        set(answer.values, "feature", nameOf(result.not_checked.front()));
    }
    for (const CheckFinding* found : largestOf(result.findings, [](const CheckFinding& f) { return f.depth_mm; }))
        if (answer.findings.size() < mostReportedFindings) answer.findings.push_back(findingOf(*found));
    for (const RestInterval* rest : largestOf(result.rest, [](const RestInterval& r) { return r.left_mm; }))
        if (answer.findings.size() < mostReportedFindings) answer.findings.push_back(findingOf(*rest));
    return answer;
}

report::Plot meridianPlot(const CheckResult& result, const Shaft& part, const Language& language)
{
    const double zero = result.stock_zero_mm + result.parameters.z_zero_mm;
    const stock::DrawnPath path(result.path.moves, zero, result.program.blocks.size());
    stock::StockPlotParts parts;
    parts.path = &path;
    parts.window = path.whole(paper_px);
    report::Plot plot = stock::stockPlot(*result.stock, parts, language);
    plot.title = LT_TEXT("Engine", "Drawing, stock and tool");
    report::Curve curve;
    curve.name = LT_TEXT("Engine", "drawing");
    const DrawnContour drawing(result.parameters.setup == 2 ? mirrored(part) : part, {}, drawnSpacing_mm);
    for (const DrawnPoint& point : drawing.points()) {
        curve.x.push_back(point.at.z_mm + result.stock_zero_mm);
        curve.y.push_back(point.at.x_mm);
    }
    plot.curves.push_back(std::move(curve));
    return plot;
}

report::Table findingTable(const CheckResult& result)
{
    return report::listTable<CheckFinding>(LT_TEXT("Engine", "What the tool meets"), result.findings,
                                           {"line", "kind_name", "z_mm", "x_mm", "depth_mm"});
}

report::Table restTable(const CheckResult& result)
{
    return report::listTable<RestInterval>(LT_TEXT("Engine", "What stays on the drawing"), result.rest,
                                           {"z_start_mm", "z_end_mm", "left_mm", "cause_name", "tool", "line"});
}

report::Section checkSummary(const CheckResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Check of the program"), {answer(result, language)}};
    if (!result.rest.empty()) section.blocks.push_back(restTable(result));
    if (!result.findings.empty()) section.blocks.push_back(findingTable(result));
    return section;
}

report::Document checkReport(const CheckResult& result, const Shaft& part, const Language& language)
{
    report::Document document = gcode::toolpathReport(result.path, language);
    report::Section summary = checkSummary(result, language);
    if (!result.notes.empty()) summary.blocks.emplace_back(result.notes);
    if (result.stock) summary.blocks.push_back(meridianPlot(result, part, language));
    document.sections.insert(document.sections.begin(), std::move(summary));
    document.title = LT_TEXT("Engine", "Check of a turning program");
    return document;
}

Json toJson(const CheckResult& result)
{
    gcode::Toolpath without_moves;
    without_moves.parameters = result.path.parameters;
    without_moves.words = result.path.words;
    without_moves.words_understood = result.path.words_understood;
    without_moves.diagnostics = result.path.diagnostics;
    Json json = gcode::toJson(without_moves);
    json.erase("moves");
    if (result.path.has_errors)
        json.update(Json{{"check", nullptr}, {"rest", nullptr}});
    else
        json.update(nestedJson(describedValues(result)));
    return json;
}

}  // namespace lathelier::cam
