#include "engine/stock/program_check.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/gcode/toolpath_files.h"
#include "engine/report/quantity_table.h"
#include "engine/stock/stock_codes.h"
#include "engine/stock/stock_quantities.h"

namespace lathelier::stock {
namespace {

constexpr std::size_t mostReportedFindings = 3;
constexpr double s_per_min = 60;
constexpr int paper_px = 2000;  ///< resolution of printed drawings

report::Finding findingOf(const gcode::Diagnostic& remark, const Language& language)
{
    report::Place place;
    place.line = remark.order;
    report::Finding finding{
        LT_TEXT("Engine", "Line {line}: {remark}"),
        {{"line", remark.order}, {"remark", fill(text(remark.pattern, language), remark.values, language)}},
        remark.is_error ? std::optional<Verdict>(Verdict::Fail) : std::nullopt,
        place};
    return finding;
}

report::Finding findingOf(const StockFinding& found)
{
    report::Place place;
    place.line = found.line;
    place.z_mm = Interval{found.z_mm, found.z_mm};
    return {LT_TEXT("Engine", "Line {line}: {kind} at z = {z_mm:1} mm, {depth_mm:2} mm deep"),
            {{"line", found.line}, {"kind", nameOf(found.kind)}, {"z_mm", found.z_mm}, {"depth_mm", found.depth_mm}},
            Verdict::Fail,
            place};
}

std::int64_t countErrors(const gcode::Toolpath& path)
{
    return std::count_if(path.diagnostics.begin(), path.diagnostics.end(),
                         [](const gcode::Diagnostic& remark) { return remark.is_error; });
}

/// Initial view: stock and feed moves, without distant retract positions.
void showCuts(report::Plot& plot, const ProgramCheck& check)
{
    constexpr double air = 0.06;
    Interval z{0, check.stock->length_mm}, x{0, 0};
    for (const double radius : check.stock->before.x_mm) x.to = std::fmax(x.to, radius);
    for (std::size_t i = 0; i < check.drawn.corners(); ++i) {
        if (!check.drawn.isPiece(i) || check.drawn.isRapid(i)) continue;
        const Corner& corner = check.drawn.corner(i);
        z = {std::min(z.from, corner.z_mm), std::max(z.to, corner.z_mm)};
        x = {std::min(x.from, corner.x_mm), std::max(x.to, corner.x_mm)};
    }
    const double z_air = air * (z.to - z.from), x_air = 2 * air * (x.to - x.from);
    plot.x.range = Interval{z.from - z_air, z.to + z_air};
    plot.y.range = Interval{x.from - x_air, x.to + x_air};
}

}  // namespace

ProgramCheck checkProgram(std::string text, const gcode::ToolpathParameters& parameters,
                          const std::optional<CheckedStock>& stock, const gcode::ToolTable& tools,
                          const Progress& progress)
{
    ProgramCheck check;
    check.program =
        gcode::readProgram(std::move(text), controlOf(parameters), progress.part(0, 0.3, LT_TEXT("Engine", "Reading")),
                           parameters.file_name, partsOf(parameters));
    check.path = gcode::findToolpath(check.program, parameters, tools,
                                     progress.part(0.3, 0.5, LT_TEXT("Engine", "Running the program")));
    const gcode::RapidRates rates =
        stock ? gcode::RapidRates{stock->parameters.rapid_x_m_min, stock->parameters.rapid_z_m_min}
              : gcode::RapidRates{};
    check.times = gcode::timesOf(check.path.moves, rates);
    if (stock) check.z_zero_mm = stock->parameters.z_zero_mm;
    check.drawn = DrawnPath(check.path.moves, check.z_zero_mm, check.program.blocks.size(), progress.part(0.5, 0.6));
    if (stock && !check.path.has_errors) {
        check.stock = simulateStock(stock->shaft, check.path.moves, stock->parameters,
                                    progress.part(0.6, 1, LT_TEXT("Engine", "Checking against the stock")));
        check.notes = check.stock->notes;
    }
    if (check.times.all.moves_without_time > 0)
        check.notes.push_back({notes::programTimeIncomplete, {{"count", check.times.all.moves_without_time}}});
    progress.report(1);
    return check;
}

report::Answer answer(const ProgramCheck& check, const Language& language)
{
    report::Answer answer;
    const std::int64_t errors = countErrors(check.path);
    answer.quantity = LT_TEXT("Engine", "Time of the program");
    if (!check.path.has_errors && !check.path.moves.empty()) answer.value = check.times.all.time_s() / s_per_min;
    answer.unit = LT_TEXT("Engine", "min");
    answer.decimals = 2;
    if (check.path.has_errors) {
        answer.verdict = Verdict::Fail;
        answer.verdict_words = LT_TEXT("Engine", "✗ errors in the program");
    } else if (check.stock) {
        answer.verdict = check.stock->findings.empty() ? Verdict::Pass : Verdict::Fail;
        answer.verdict_words = check.stock->findings.empty() ? LT_TEXT("Engine", "✓ the tool meets nothing it must not")
                                                             : LT_TEXT("Engine", "✗ the tool meets what it must not");
    } else {
        answer.verdict_words = LT_TEXT("Engine", "not checked against stock");
    }
    answer.sentence =
        LT_TEXT("Engine",
                "errors: {errors} · remarks: {remarks} · {understood} of {words} words understood · in feed "
                "{feed} min over {way} mm");
    answer.values = {{"errors", errors},
                     {"remarks", static_cast<std::int64_t>(check.path.diagnostics.size()) - errors},
                     {"understood", check.path.words_understood},
                     {"words", check.path.words},
                     {"feed", fixed(check.times.all.feed_time_s / s_per_min, 2, language)},
                     {"way", fixed(check.times.all.feed_length_mm, 0, language)}};
    for (const bool wanted : {true, false}) {
        for (const gcode::Diagnostic& remark : check.path.diagnostics)
            if (remark.is_error == wanted && answer.findings.size() < mostReportedFindings)
                answer.findings.push_back(findingOf(remark, language));
        if (!wanted || !check.stock) continue;
        for (const StockFinding& found : check.stock->findings)
            if (answer.findings.size() < mostReportedFindings) answer.findings.push_back(findingOf(found));
    }
    return answer;
}

report::Plot meridianPlot(const ProgramCheck& check, StockPlotParts parts, const Language& language)
{
    parts.path = &check.drawn;
    if (check.stock) {
        report::Plot plot = stockPlot(*check.stock, parts, language);
        plot.title = LT_TEXT("Engine", "Path of the tool and stock");
        // No legend: passes and findings are listed in tables.
        for (report::Curve& curve : plot.curves)
            if (std::holds_alternative<std::string>(curve.name)) curve.name = std::string();
        for (std::size_t k = 0; k < plot.marks.size(); ++k)
            plot.marks[k].name = fill(text(LT_TEXT("Engine", "line {line}"), language),
                                      {{"line", check.stock->findings[k].line}}, language);
        showCuts(plot, check);
        return plot;
    }
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Path of the tool");
    plot.x = {LT_TEXT("Engine", "z, from the program's zero toward the chuck"), unit::mm};
    plot.y = {LT_TEXT("Engine", "Radius"), unit::mm};
    plot.curves = check.drawn.curves(parts.window);
    return plot;
}

std::vector<Remark> remarksOf(const ProgramCheck& check, const Language& language)
{
    std::vector<Remark> remarks;
    for (const gcode::Diagnostic& found : check.path.diagnostics)
        remarks.push_back({found.order, found.column, found.is_error,
                           fill(text(found.pattern, language), found.values, language), found.block});
    if (check.stock)
        for (const StockFinding& found : check.stock->findings) {
            const gcode::Block& block = check.program.blocks.at(static_cast<std::size_t>(found.line - 1));
            remarks.push_back({found.line, 0, true, report::findingText(findingOf(found), language),
                               gcode::shown(check.program, check.program.textOf(block))});
        }
    std::stable_sort(remarks.begin(), remarks.end(), [](const Remark& a, const Remark& b) { return a.line < b.line; });
    return remarks;
}

report::Table passTable(const ProgramCheck& check)
{
    const std::vector<StockPass> none;
    return report::listTable<StockPass>(LT_TEXT("Engine", "Passes"), check.stock ? check.stock->passes : none,
                                        {"line", "tool", "removed_mm3"});
}

report::Table toolTable(const ProgramCheck& check)
{
    return report::listTable<gcode::ToolTime>(
        LT_TEXT("Engine", "Tools"), check.times.tools,
        {"tool", "line", "moves", "time_s", "feed_time_s", "rapid_time_s", "feed_length_mm", "rapid_length_mm"});
}

Json toJson(const ProgramCheck& check)
{
    Json json = gcode::toJson(check.path);
    json["times"] = nestedJson(describedValues(check.times));
    if (check.stock)
        json.update(nestedJson(describedValues(*check.stock)));
    else
        json["findings"] = Json();
    return json;
}

report::Document programReport(const ProgramCheck& check, const Notes& notes, const Language& language)
{
    report::Document document = gcode::toolpathReport(check.path, language);
    report::Section& first = document.sections.front();
    first.blocks.insert(first.blocks.begin(), answer(check, language));
    if (!notes.empty()) first.blocks.emplace_back(notes);
    StockPlotParts parts;
    parts.window = check.drawn.whole(paper_px);
    report::Section path{LT_TEXT("Engine", "Path of the tool"),
                         {meridianPlot(check, parts, language), toolTable(check)}};
    if (check.stock) {
        path.blocks.push_back(passTable(check));
        path.blocks.push_back(report::listTable<StockFinding>(LT_TEXT("Engine", "What the tool meets"),
                                                              check.stock->findings,
                                                              {"line", "kind_name", "z_mm", "x_mm", "depth_mm"}));
    }
    document.sections.push_back(std::move(path));
    return document;
}

}  // namespace lathelier::stock
