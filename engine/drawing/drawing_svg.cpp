#include "engine/drawing/drawing_svg.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string_view>

#include "engine/report/svg.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

/// Three decimals at most, never "-0".
std::string number(double value)
{
    std::string result = fmt::format("{:.3f}", value);
    result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.') result.pop_back();
    return result == "-0" ? "0" : result;
}

/// The font's sign for a diameter is no taller than a small letter.
std::string withTallDiameters(std::string text)
{
    constexpr std::string_view diameterSign = "⌀", tallDiameterSign = "Ø";
    for (std::size_t at = 0; (at = text.find(diameterSign, at)) != std::string::npos; at += tallDiameterSign.size())
        text.replace(at, diameterSign.size(), tallDiameterSign);
    return text;
}

class Writer {
public:
    explicit Writer(const Drawing& drawing) : height_mm_(sheetBox(drawing.sheet).height_mm())
    {
        const double width_mm = sheetBox(drawing.sheet).width_mm();
        out_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" "
            "role=\"img\" aria-label=\"{2}\" font-family=\"'DejaVu Sans',Verdana,Arial,sans-serif\" fill=\"none\" "
            "stroke=\"#000000\" stroke-linecap=\"round\">\n"
            "<rect x=\"0\" y=\"0\" width=\"{0}\" height=\"{1}\" fill=\"#ffffff\" stroke=\"none\"/>\n",
            number(width_mm), number(height_mm_), report::escaped(drawing.title));
        for (const Line& line : drawing.lines) add(line);
        for (const Arc& arc : drawing.arcs) add(arc);
        for (const Arrow& arrow : drawing.arrows) add(arrow);
        for (const Label& label : drawing.labels) add(label);
        out_ += "</svg>\n";
    }

    std::string text() const { return out_; }

private:
    std::string x(double value) const { return number(value); }
    std::string y(double value) const { return number(height_mm_ - value); }
    std::string point(const Vector2d& at) const { return x(at.x()) + " " + y(at.y()); }

    void add(const Line& line)
    {
        out_ +=
            fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke-width=\"{}\"{}/>\n", x(line.from_mm.x()),
                        y(line.from_mm.y()), x(line.to_mm.x()), y(line.to_mm.y()), number(line.width_mm),
                        line.type == LineType::DashDot  ? " stroke-dasharray=\"6 1.2 0.4 1.2\""
                        : line.type == LineType::Dashed ? " stroke-dasharray=\"2.5 1\""
                                                        : "");
    }

    void add(const Arc& arc)
    {
        if (arc.end_deg - arc.start_deg >= 360) {
            out_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" stroke-width=\"{}\"/>\n", x(arc.centre_mm.x()),
                                y(arc.centre_mm.y()), number(arc.radius_mm), number(arc.width_mm));
            return;
        }
        const auto on = [&](double angle_deg) -> Vector2d {
            const double angle = angle_deg * std::numbers::pi / 180;
            return arc.centre_mm + arc.radius_mm * Vector2d(std::cos(angle), std::sin(angle));
        };
        out_ += fmt::format("<path d=\"M{} A{} {} 0 {} 0 {}\" stroke-width=\"{}\"/>\n", point(on(arc.start_deg)),
                            number(arc.radius_mm), number(arc.radius_mm), arc.end_deg - arc.start_deg > 180 ? 1 : 0,
                            point(on(arc.end_deg)), number(arc.width_mm));
    }

    void add(const Arrow& arrow)
    {
        const Vector2d base = arrow.tip_mm - arrow.length_mm * arrow.direction;
        const Vector2d side = arrow.length_mm / 6 * Vector2d(-arrow.direction.y(), arrow.direction.x());
        out_ += fmt::format("<path d=\"M{} L{} L{} Z\" fill=\"#000000\" stroke=\"none\"/>\n", point(arrow.tip_mm),
                            point(base + side), point(base - side));
    }

    void add(const Label& label)
    {
        const char* const anchor = label.anchor == Anchor::Start    ? "start"
                                   : label.anchor == Anchor::Middle ? "middle"
                                                                    : "end";
        const std::string place = label.angle_deg == 0
                                      ? fmt::format("x=\"{}\" y=\"{}\"", x(label.at_mm.x()), y(label.at_mm.y()))
                                      : fmt::format("transform=\"translate({},{}) rotate({})\"", x(label.at_mm.x()),
                                                    y(label.at_mm.y()), number(-label.angle_deg));
        out_ +=
            fmt::format("<text {} text-anchor=\"{}\" font-size=\"{}\"{} fill=\"#000000\" stroke=\"none\">{}</text>\n",
                        place, anchor, number(label.height_mm * fontSizeOverHeight),
                        label.italic ? " font-style=\"italic\"" : "", report::escaped(withTallDiameters(label.text)));
    }

    double height_mm_;
    std::string out_;
};

}  // namespace

std::string toSvg(const Drawing& drawing)
{
    return Writer(drawing).text();
}

}  // namespace lathelier::drawing
