#include "engine/report/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "engine/core/utf8.h"
#include "engine/core/visible.h"
#include "engine/report/png.h"

namespace lathelier::report {
namespace {

constexpr std::string_view ink = "#1f2933";

const char* anchorName(Svg::Anchor anchor)
{
    switch (anchor) {
        case Svg::Anchor::Start: return "start";
        case Svg::Anchor::Middle: return "middle";
        case Svg::Anchor::End: return "end";
    }
    return "start";
}

}  // namespace

std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : visible(text, true)) {
        switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            case '\'': result += "&#39;"; break;
            default: result += c;
        }
    }
    return result;
}

std::string hex(const Rgb& colour)
{
    return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

std::string coordinate(double value)
{
    std::string result = fmt::format("{:.2f}", value);
    result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.') result.pop_back();
    return result == "-0" ? "0" : result;
}

double textWidth(std::string_view text, double size)
{
    double width = 0;
    for (const char c : text) {
        if (!beginsCharacter(c)) continue;
        if (std::string_view("iljtfrI.,:;'|()[]- ").find(c) != std::string_view::npos)
            width += 0.36;
        else if (std::string_view("mwMW@%").find(c) != std::string_view::npos)
            width += 0.95;
        else
            width += 0.63;
    }
    return width * size;
}

Svg::Svg(double width, double height, const std::string& label)
{
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 {} {}\" "
        "role=\"img\" aria-label=\"{}\" font-family=\"'DejaVu Sans',Verdana,Arial,sans-serif\">\n",
        coordinate(width), coordinate(height), escaped(label));
}

void Svg::line(double x1, double y1, double x2, double y2, std::string_view stroke, double width,
               std::string_view dashes)
{
    out_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\"",
                        coordinate(x1), coordinate(y1), coordinate(x2), coordinate(y2), stroke, coordinate(width));
    if (!dashes.empty()) out_ += fmt::format(" stroke-dasharray=\"{}\"", dashes);
    out_ += "/>\n";
}

void Svg::rect(double x, double y, double width, double height, std::string_view fill, std::string_view stroke)
{
    out_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n",
                        coordinate(x), coordinate(y), coordinate(width), coordinate(height), fill, stroke);
}

void Svg::path(std::string_view data, std::string_view stroke, double width, std::string_view fill, double opacity,
               std::string_view dashes)
{
    out_ += fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"", data,
                        fill, stroke, coordinate(width));
    if (opacity < 1) out_ += fmt::format(" fill-opacity=\"{}\"", coordinate(opacity));
    if (!dashes.empty()) out_ += fmt::format(" stroke-dasharray=\"{}\"", dashes);
    out_ += "/>\n";
}

void Svg::text(double x, double y, Anchor anchor, double size, std::string_view content, bool bold)
{
    out_ += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n",
                        coordinate(x), coordinate(y), anchorName(anchor), coordinate(size), ink,
                        bold ? " font-weight=\"bold\"" : "", escaped(content));
}

void Svg::verticalText(double x, double y, double size, std::string_view content)
{
    out_ += fmt::format(
        "<text transform=\"translate({},{}) rotate(-90)\" text-anchor=\"middle\" font-size=\"{}\" "
        "fill=\"{}\">{}</text>\n",
        coordinate(x), coordinate(y), coordinate(size), ink, escaped(content));
}

void Svg::png(double x, double y, double width, double height, std::string_view bytes)
{
    out_ += fmt::format(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
        "image-rendering=\"pixelated\" "
        "xlink:href=\"data:image/png;base64,{}\"/>\n",
        coordinate(x), coordinate(y), coordinate(width), coordinate(height), base64(bytes));
}

std::string Svg::finish()
{
    return out_ + "</svg>\n";
}

}  // namespace lathelier::report
