#include "engine/gcode/toolpath_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "engine/core/texts.h"

namespace lathelier::gcode {
namespace {

/// The numbers of a move by name, in the order of the columns.
struct Column {
    const char* name;
    double Move::*member;
};
constexpr std::array firstColumns{Column{"x_mm", &Move::x_mm}, Column{"z_mm", &Move::z_mm},
                                  Column{"centre_x_mm", &Move::centre_x_mm}, Column{"centre_z_mm", &Move::centre_z_mm}};
constexpr std::array lastColumns{Column{"feed_mm_rev", &Move::feed_mm_rev},
                                 Column{"feed_mm_min", &Move::feed_mm_min},
                                 Column{"speed_rpm", &Move::speed_rpm},
                                 Column{"cutting_speed_m_min", &Move::cutting_speed_m_min},
                                 Column{"speed_limit_rpm", &Move::speed_limit_rpm},
                                 Column{"dwell_s", &Move::dwell_s}};

Json moveJson(const Move& move)
{
    Json json;
    json["line"] = move.line;
    json["kind"] = key(move.kind);
    for (const Column& column : firstColumns) json[column.name] = number(move.*column.member);
    json["clockwise"] = move.kind == MoveKind::Arc ? Json(move.clockwise) : Json();
    for (const Column& column : lastColumns) json[column.name] = number(move.*column.member);
    json["tool"] = move.tool > 0 ? Json(move.tool) : Json();
    return json;
}

void addNumber(std::string& line, double value)
{
    if (isKnown(value)) fmt::format_to(std::back_inserter(line), "{}", value);
    line += ',';
}

}  // namespace

const std::vector<QuantityOf<Diagnostic>>& quantitiesOf(const Diagnostic*)
{
    using D = Diagnostic;
    static const auto all = describedBy<D>(
        quantity<D>("line", &D::line), quantity<D>("column", &D::column), quantity<D>("severity", severityKey),
        quantity<D>("code", &D::code), quantity<D>("text", sentence), quantity<D>("block", &D::block),
        quantity<D>("path", [](const D& d) { return d.path.empty() ? Value() : Value(d.path); }));
    return all;
}

Rows diagnosticRows(const std::vector<Diagnostic>& diagnostics)
{
    return listed(diagnostics);
}

Json toJson(const Toolpath& path)
{
    Json json;
    json["dialect"] = path.parameters.dialect;
    if (!path.has_errors) {
        json["moves"] = Json::array();
        for (const Move& move : path.moves) json["moves"].push_back(moveJson(move));
    }
    json["words"] = path.words;
    json["words_understood"] = path.words_understood;
    json["diagnostics"] = lathelier::toJson(Value(diagnosticRows(path.diagnostics)));
    return json;
}

void writeMoves(const Toolpath& path, const std::function<void(std::string_view)>& append)
{
    constexpr std::size_t step = 1 << 16;
    std::string text = "line,kind";
    for (const Column& column : firstColumns) text.append(",").append(column.name);
    text += ",clockwise";
    for (const Column& column : lastColumns) text.append(",").append(column.name);
    text += ",tool\n";
    for (const Move& move : path.moves) {
        fmt::format_to(std::back_inserter(text), "{},{},", move.line, key(move.kind));
        for (const Column& column : firstColumns) addNumber(text, move.*column.member);
        if (move.kind == MoveKind::Arc) text += move.clockwise ? "true" : "false";
        text += ',';
        for (const Column& column : lastColumns) addNumber(text, move.*column.member);
        if (move.tool > 0) text += std::to_string(move.tool);
        text += '\n';
        if (text.size() < step) continue;
        append(text);
        text.clear();
    }
    append(text);
}

report::Table diagnosticTable(const std::vector<Diagnostic>& diagnostics, const Language& language)
{
    report::Table table{LT_TEXT("Engine", "Remarks"),
                        {LT_TEXT("Engine", "Line"), LT_TEXT("Engine", "Column"), LT_TEXT("Engine", "Severity"),
                         LT_TEXT("Engine", "Remark"), LT_TEXT("Engine", "Block")},
                        {},
                        {0, 0}};
    for (const Diagnostic& remark : diagnostics) {
        if (table.rows.size() >= mostTabled) break;
        table.rows.push_back({remark.order, remark.column,
                              remark.is_error ? LT_TEXT("Engine", "error") : LT_TEXT("Engine", "warning"),
                              fill(text(remark.pattern, language), remark.values, language), remark.block});
    }
    return table;
}

report::Section toolpathSummary(const Toolpath& path, const Language& language)
{
    const auto count = [&path](MoveKind kind) -> Value {
        return static_cast<std::int64_t>(std::count_if(path.moves.begin(), path.moves.end(),
                                                       [kind](const Move& move) { return move.kind == kind; }));
    };
    report::QuantityTable table{LT_TEXT("Engine", "Program"),
                                {{LT_TEXT("Engine", "Dialect"), path.parameters.dialect, {}},
                                 {LT_TEXT("Engine", "Blocks"), static_cast<std::int64_t>(path.blocks.size()), {}},
                                 {LT_TEXT("Engine", "Words"), path.words, {}},
                                 {LT_TEXT("Engine", "Words understood"), path.words_understood, {}},
                                 {LT_TEXT("Engine", "Moves"), static_cast<std::int64_t>(path.moves.size()), {}},
                                 {LT_TEXT("Engine", "Rapid moves"), count(MoveKind::Rapid), {}},
                                 {LT_TEXT("Engine", "Feed moves"), count(MoveKind::Feed), {}},
                                 {LT_TEXT("Engine", "Arcs"), count(MoveKind::Arc), {}},
                                 {LT_TEXT("Engine", "Threads"), count(MoveKind::Thread), {}}}};
    report::Section section{LT_TEXT("Engine", "NC program"), {}};
    section.blocks.push_back(std::move(table));
    if (!path.diagnostics.empty()) section.blocks.push_back(diagnosticTable(path.diagnostics, language));
    return section;
}

report::Document toolpathReport(const Toolpath& path, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "NC program");
    document.sections = {toolpathSummary(path, language)};
    return document;
}

}  // namespace lathelier::gcode
