#include "engine/cad/dxf_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/utf8.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;

struct Layer {
    std::string name;
    int colour;
    const char* line_type;
};

constexpr double arrowWidth = 1.0 / 3;  ///< width of an arrow head over its length

class Writer {
public:
    void pair(int code, std::string_view value) { text_ += fmt::format("{}\n{}\n", code, value); }
    void pair(int code, int value) { text_ += fmt::format("{}\n{}\n", code, value); }

    void number(int code, double value)
    {
        std::string digits = fmt::format("{:.9f}", value);
        if (digits == "-0.000000000") digits.erase(0, 1);
        pair(code, digits);
    }

    void point(int code, const Vector2d& point)
    {
        number(code, point.x());
        number(code + 10, point.y());
    }

    void entity(std::string_view kind, const std::string& layer)
    {
        pair(0, kind);
        pair(8, layer);
    }

    void section(std::string_view name)
    {
        pair(0, "SECTION");
        pair(2, name);
    }

    void table(std::string_view name, std::size_t count)
    {
        pair(0, "TABLE");
        pair(2, name);
        pair(70, static_cast<int>(count));
    }

    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

std::string asciiText(std::string_view utf8)
{
    std::string text;
    for (std::size_t at = 0; at < utf8.size();) {
        const Utf8Character character = utf8At(utf8, at);
        at += std::max<std::size_t>(1, character.length);
        const char32_t code = character.length == 0 ? U'?' : character.code;
        if (code == U'⌀' || code == U'Ø')
            text += "%%c";
        else if (code == U'°')
            text += "%%d";
        else if (code == U'±')
            text += "%%p";
        else if (code == U'−')
            text += '-';
        else if (code < 0x20 || code == 0x7F)
            text += ' ';
        else if (code < 0x7F)
            text += static_cast<char>(code);
        else if (code <= 0xFFFF)
            text += fmt::format("\\U+{:04X}", static_cast<std::uint32_t>(code));
        else
            text += '?';
    }
    return text;
}

/// Names of R12: capitals, digits, $ - _, at most 31.
std::string layerName(const std::string& name)
{
    std::string result;
    for (const char c : name) {
        const bool small = c >= 'a' && c <= 'z', kept = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        result += small ? static_cast<char>(c - 'a' + 'A') : kept || c == '$' || c == '-' ? c : '_';
    }
    result.resize(std::min<std::size_t>(result.size(), 31));
    return result.empty() ? "0" : result;
}

std::vector<Layer> layersOf(const DxfDrawing& drawing)
{
    std::vector<Layer> all{{"0", 7, "CONTINUOUS"},           {layers::contour, 7, "CONTINUOUS"},
                           {layers::axis, 1, "CENTER"},      {layers::dimensions, 3, "CONTINUOUS"},
                           {layers::hatch, 8, "CONTINUOUS"}, {layers::text, 7, "CONTINUOUS"}};
    const auto need = [&](const std::string& stated) {
        const std::string name = layerName(stated);
        if (std::none_of(all.begin(), all.end(), [&](const Layer& layer) { return layer.name == name; }))
            all.push_back({name, 7, "CONTINUOUS"});
    };
    for (const DxfLine& line : drawing.lines) need(line.layer);
    for (const DxfArc& arc : drawing.arcs) need(arc.layer);
    for (const DxfText& text : drawing.texts) need(text.layer);
    for (const DxfArrow& arrow : drawing.arrows) need(arrow.layer);
    return all;
}

void writeHeader(Writer& out, const DxfDrawing& drawing)
{
    Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    const auto add = [&](const Vector2d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    };
    for (const DxfLine& line : drawing.lines) add(line.from_mm), add(line.to_mm);
    for (const DxfArc& arc : drawing.arcs)
        for (const double deg : {arc.start_deg, arc.end_deg}) {
            const double angle = deg * std::numbers::pi / 180;
            add(arc.centre_mm + arc.radius_mm * Vector2d(std::cos(angle), std::sin(angle)));
        }
    for (const DxfText& text : drawing.texts) add(text.at_mm);
    for (const DxfArrow& arrow : drawing.arrows) add(arrow.tip_mm);
    if (!low.allFinite()) low = high = Vector2d::Zero();
    out.section("HEADER");
    out.pair(9, "$ACADVER");
    out.pair(1, "AC1009");
    out.pair(9, "$MEASUREMENT");
    out.pair(70, 1);
    out.pair(9, "$INSUNITS");
    out.pair(70, 4);
    out.pair(9, "$EXTMIN");
    out.point(10, low);
    out.pair(9, "$EXTMAX");
    out.point(10, high);
    out.pair(0, "ENDSEC");
}

void writeTables(Writer& out, const std::vector<Layer>& all)
{
    const auto lineType = [&](const char* name, const char* look, const std::vector<double>& dashes) {
        out.pair(0, "LTYPE");
        out.pair(2, name);
        out.pair(70, 0);
        out.pair(3, look);
        out.pair(72, 65);
        out.pair(73, static_cast<int>(dashes.size()));
        double length = 0;
        for (const double dash : dashes) length += std::abs(dash);
        out.number(40, length);
        for (const double dash : dashes) out.number(49, dash);
    };
    out.section("TABLES");
    out.table("LTYPE", 2);
    lineType("CONTINUOUS", "Solid", {});
    lineType("CENTER", "Center ____ _ ____", {12.5, -2.5, 2.5, -2.5});
    out.pair(0, "ENDTAB");
    out.table("LAYER", all.size());
    for (const Layer& layer : all) {
        out.pair(0, "LAYER");
        out.pair(2, layer.name);
        out.pair(70, 0);
        out.pair(62, layer.colour);
        out.pair(6, layer.line_type);
    }
    out.pair(0, "ENDTAB");
    out.table("STYLE", 1);
    out.pair(0, "STYLE");
    out.pair(2, "STANDARD");
    out.pair(70, 0);
    out.number(40, 0);
    out.number(41, 1);
    out.number(50, 0);
    out.pair(71, 0);
    out.number(42, 2.5);
    out.pair(3, "txt");
    out.pair(4, "");
    out.pair(0, "ENDTAB");
    out.pair(0, "ENDSEC");
}

void write(Writer& out, const DxfText& text)
{
    out.entity("TEXT", layerName(text.layer));
    out.point(10, text.at_mm);
    out.number(40, text.height_mm);
    out.pair(1, asciiText(text.text));
    out.number(50, text.angle_deg);
    if (text.align == DxfText::Align::Left) return;
    out.pair(72, text.align == DxfText::Align::Centre ? 1 : 2);
    out.point(11, text.at_mm);
}

void write(Writer& out, const DxfArrow& arrow)
{
    const Vector2d back = arrow.tip_mm - arrow.length_mm * arrow.direction;
    const Vector2d side = arrow.length_mm * arrowWidth / 2 * Vector2d(-arrow.direction.y(), arrow.direction.x());
    out.entity("SOLID", layerName(arrow.layer));
    out.point(10, arrow.tip_mm);
    out.point(11, back + side);
    out.point(12, back - side);
    out.point(13, back - side);
}

}  // namespace

std::string dxfText(const DxfDrawing& drawing)
{
    Writer out;
    writeHeader(out, drawing);
    writeTables(out, layersOf(drawing));
    out.section("BLOCKS");
    out.pair(0, "ENDSEC");
    out.section("ENTITIES");
    for (const DxfLine& line : drawing.lines) {
        out.entity("LINE", layerName(line.layer));
        out.point(10, line.from_mm);
        out.point(11, line.to_mm);
    }
    for (const DxfArc& arc : drawing.arcs) {
        out.entity("ARC", layerName(arc.layer));
        out.point(10, arc.centre_mm);
        out.number(40, arc.radius_mm);
        out.number(50, arc.start_deg);
        out.number(51, arc.end_deg);
    }
    for (const DxfText& text : drawing.texts) write(out, text);
    for (const DxfArrow& arrow : drawing.arrows) write(out, arrow);
    out.pair(0, "ENDSEC");
    out.pair(0, "EOF");
    return out.take();
}

DxfDrawing halfContour(const Shaft& shaft)
{
    DxfDrawing drawing;
    const Contour closed = closedContour(shaft);
    for (const ContourPiece& piece : closed) {
        if (!piece.isArc()) {
            drawing.lines.push_back({piece.from_mm, piece.to_mm, layers::contour});
            continue;
        }
        auto [start, end] = piece.arcAngles();
        if (end < start) std::swap(start, end);
        const auto degrees = [](double angle) {
            const double deg = std::fmod(angle * 180 / std::numbers::pi, 360);
            return deg < 0 ? deg + 360 : deg;
        };
        drawing.arcs.push_back(
            {piece.centre_mm(), std::abs(piece.arc_radius_mm), degrees(start), degrees(end), layers::contour});
    }
    // Outlines that begin and end on the axis are closed along it where the contour leaves that out.
    if (!closed.empty() && (closed.back().to_mm - closed.front().from_mm).norm() > 1e-9)
        drawing.lines.push_back({closed.back().to_mm, closed.front().from_mm, layers::contour});
    return drawing;
}

std::string contourDxf(const Shaft& shaft)
{
    checkShaft(shaft);
    return dxfText(halfContour(shaft));
}

}  // namespace lathelier::cad
