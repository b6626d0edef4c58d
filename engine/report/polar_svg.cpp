#include "engine/report/polar_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/units.h"
#include "engine/report/plot_frame.h"
#include "engine/report/ring_labels.h"

namespace lathelier::report {
namespace {

constexpr double sheetHeight = 640;
constexpr double centreX = 330;
constexpr double centreY = 340;
constexpr double rimPx = 270;  ///< outer radius of the drawing
constexpr double corePx = 75;  ///< inner radius of the drawing
constexpr double legendX = 650;

constexpr std::string_view baseColour = "#9aa5b1";
constexpr std::string_view markColour = "#1f2933";
constexpr std::string_view polarDashes = "7 4";
constexpr double ringOpacity = 0.16;

std::string strokeOf(const ChartColour& colour, std::size_t position)
{
    return hex(colourOf(colour, position));
}

/// Reference circle as deviation from the base circle's centre.
double deviationAt(const PolarPlot::ReferenceLine& circle, double angle_rad)
{
    return circle.deviation_um + circle.x_um * std::cos(angle_rad) + circle.y_um * std::sin(angle_rad);
}

/// Largest outward and inward deviations of the plot.
Interval reachOf(const PolarPlot& plot)
{
    Interval reach{0, 0};
    const auto add = [&reach](double deviation) {
        if (!isDrawable(deviation)) return;
        reach.from = std::min(reach.from, deviation);
        reach.to = std::max(reach.to, deviation);
    };
    for (const PolarPlot::Trace& trace : plot.traces)
        std::for_each(trace.deviation_um.begin(), trace.deviation_um.end(), add);
    for (const PolarPlot::ReferenceLine& circle : plot.circles) {
        if (!circle.asked.empty()) continue;
        const double off = std::hypot(circle.x_um, circle.y_um);
        add(circle.deviation_um + off);
        add(circle.deviation_um - off);
    }
    for (const PolarPlot::Mark& mark : plot.contacts) add(mark.deviation_um);
    return reach;
}

/// Radius of the base circle on the sheet; one-sided deviations use the space of both sides.
double basePx(const PolarPlot& plot)
{
    const Interval reach = reachOf(plot);
    if (reach.to > -2 * reach.from) return 140;
    return -reach.from > 2 * reach.to ? 225 : 195;
}

/// Mapping from deviations to the sheet.
class Polar {
public:
    Polar(double base_px, double px_per_um) : base_px_(base_px), px_per_um_(px_per_um) {}

    double radius(double deviation_um) const
    {
        return std::clamp(base_px_ + deviation_um * px_per_um_, corePx, rimPx + 12);
    }
    PolarPlace place(double angle_rad, double deviation_um) const
    {
        return {radius(deviation_um) * std::cos(angle_rad), radius(deviation_um) * std::sin(angle_rad)};
    }
    static std::string at(double angle_rad, double radius_px)
    {
        return fmt::format("{} {}", coordinate(centreX + radius_px * std::cos(angle_rad)),
                           coordinate(centreY - radius_px * std::sin(angle_rad)));
    }
    std::string point(double angle_rad, double deviation_um) const { return at(angle_rad, radius(deviation_um)); }

private:
    double base_px_;
    double px_per_um_;
};

std::string circlePath(double radius)
{
    return fmt::format("M{0} {1}a{2} {2} 0 1 0 {3} 0a{2} {2} 0 1 0 -{3} 0Z", coordinate(centreX - radius),
                       coordinate(centreY), coordinate(radius), coordinate(2 * radius));
}

/// Decimated: of each quarter degree the first, smallest, largest and last value.
std::string tracePath(const Polar& polar, const PolarPlot::Trace& trace)
{
    const std::size_t count = std::min(trace.angle_deg.size(), trace.deviation_um.size());
    std::string data;
    bool open = false;
    for (std::size_t begin = 0; begin < count;) {
        if (!isDrawable(trace.deviation_um[begin]) || !isDrawable(trace.angle_deg[begin])) {
            open = false;
            ++begin;
            continue;
        }
        std::size_t end = begin, low = begin, high = begin;
        const double bin = std::floor(4 * trace.angle_deg[begin]);
        for (; end < count && std::floor(4 * trace.angle_deg[end]) == bin && isDrawable(trace.deviation_um[end]);
             ++end) {
            if (trace.deviation_um[end] < trace.deviation_um[low]) low = end;
            if (trace.deviation_um[end] > trace.deviation_um[high]) high = end;
        }
        std::array<std::size_t, 4> kept{begin, std::min(low, high), std::max(low, high), end - 1};
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (i > 0 && kept[i] == kept[i - 1]) continue;
            data += open ? 'L' : 'M';
            data += polar.point(trace.angle_deg[kept[i]] * rad_per_deg, trace.deviation_um[kept[i]]);
            open = true;
        }
        begin = end;
    }
    return data;
}

std::string referencePath(const Polar& polar, const PolarPlot::ReferenceLine& circle)
{
    std::string data;
    for (int angle = 0; angle < 360; angle += 2)
        data += (angle ? 'L' : 'M') + polar.point(angle * rad_per_deg, deviationAt(circle, angle * rad_per_deg));
    return data + "Z";
}

/// Closed path between the two circles of a ring, for filling.
std::string ringPath(const Polar& polar, const PolarPlot::Ring& ring)
{
    const auto way = [&](double deviation_um, bool back) {
        std::string data;
        for (int step = 0; step < 360; step += 2) {
            const int angle = back ? 358 - step : step;
            data += (step ? 'L' : 'M') +
                    polar.point(angle * rad_per_deg,
                                deviationAt({{}, ring.x_um, ring.y_um, deviation_um}, angle * rad_per_deg));
        }
        return data + "Z";
    };
    return way(ring.outer_um, false) + way(ring.inner_um, true);  // opposite senses: the middle is not filled
}

/// The label of a contact: outside the profile at an outer one, else inside.
void nameContact(Svg& svg, const Polar& polar, const PolarPlot::Mark& mark, const std::string& words)
{
    if (words.empty()) return;
    const double a = mark.angle_deg * rad_per_deg;
    const double radius = polar.radius(mark.deviation_um) + (mark.outer ? 22 : -22);
    const double half = textWidth(words, 11) / 2;
    const double x = centreX + radius * std::cos(a) + (mark.outer ? half : -half) * std::cos(a);
    svg.text(x, centreY - radius * std::sin(a) + 4, Svg::Anchor::Middle, 11, words, true);
}

/// A triangle whose tip touches the profile, from outside or from inside.
std::string markPath(double angle_rad, double radius_px, bool outer)
{
    const double back = radius_px + (outer ? 13 : -13);
    const double half = 5.5 / back;
    return fmt::format("M{}L{}L{}Z", Polar::at(angle_rad, radius_px), Polar::at(angle_rad - half, back),
                       Polar::at(angle_rad + half, back));
}

void drawGrid(Svg& svg, const Polar& polar, const Ticks& divisions, const Language& language)
{
    for (int angle = 0; angle < 360; angle += 30) {
        const double a = angle * rad_per_deg;
        svg.path(fmt::format("M{}L{}", Polar::at(a, corePx), Polar::at(a, rimPx)), gridColour, 1);
        svg.text(centreX + (rimPx + 22) * std::cos(a), centreY - (rimPx + 22) * std::sin(a) + 4, Svg::Anchor::Middle,
                 tickSize, fixed(angle, 0, language) + "°");
    }
    svg.path(circlePath(rimPx), gridColour, 1);
    for (const double value : divisions.values) {
        const double radius = polar.radius(value);
        if (radius > corePx && radius < rimPx)
            svg.path(circlePath(radius), value == 0 ? baseColour : gridColour, value == 0 ? 1.4 : 1);
    }
}

/// Drawn elements that the labels of the scale should avoid.
std::vector<PolarPlace> drawnPlaces(const Polar& polar, const PolarPlot& plot)
{
    std::vector<PolarPlace> places;
    for (const PolarPlot::Trace& trace : plot.traces) {
        const std::size_t count = std::min(trace.angle_deg.size(), trace.deviation_um.size());
        const std::size_t step = std::max<std::size_t>(1, count / 1440);
        for (std::size_t i = 0; i < count; i += step)
            if (isDrawable(trace.angle_deg[i]) && isDrawable(trace.deviation_um[i]))
                places.push_back(polar.place(trace.angle_deg[i] * rad_per_deg, trace.deviation_um[i]));
    }
    for (const PolarPlot::ReferenceLine& circle : plot.circles)
        for (int angle = 0; angle < 360 && circle.asked.empty(); ++angle)
            places.push_back(polar.place(angle * rad_per_deg, deviationAt(circle, angle * rad_per_deg)));
    for (const PolarPlot::Mark& mark : plot.contacts)
        if (isDrawable(mark.deviation_um) && isDrawable(mark.angle_deg))
            places.push_back(polar.place(mark.angle_deg * rad_per_deg, mark.deviation_um));
    return places;
}

/// Drawn below the data, so that a label never covers a curve.
void drawRingScale(Svg& svg, const Polar& polar, const PolarPlot& plot, const Ticks& divisions,
                   const Language& language)
{
    std::vector<RingLabel> labels;
    std::vector<std::string> words;
    std::vector<double> values = divisions.values;  // 0 first, so that it gets the best position
    std::stable_partition(values.begin(), values.end(), [](double value) { return value == 0; });
    for (const double value : values) {
        const double radius = polar.radius(value);
        if (radius <= corePx + 6 || radius >= rimPx - 8) continue;
        std::string number = fmt::format("{}{}", value > 0 ? "+" : "", tickLabel(value, divisions, language));
        if (value == 0) number.append(1, ' ').append(text(shownUnit(unit::um, language).unit, language));
        words.push_back(std::move(number));
        labels.push_back({radius, textWidth(words.back(), 11) + 4, 14});
    }
    placeRingLabels(labels, drawnPlaces(polar, plot), rimPx);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!labels[i].place) continue;
        const double x = centreX + labels[i].place->x_px, y = centreY - labels[i].place->y_px;
        svg.rect(x - labels[i].width_px / 2, y - 7, labels[i].width_px, 14, "#ffffff");
        svg.text(x, y + 4, Svg::Anchor::Middle, 11, words[i]);
    }
}

/// Legend at the right: one line for each element, then the scale as text.
class PolarLegend {
public:
    explicit PolarLegend(Svg& svg) : svg_(svg) {}

    void line(const std::string& name, std::string_view colour, double width, std::string_view pattern = {})
    {
        svg_.line(legendX, y_ - 4, legendX + 30, y_ - 4, colour, width, pattern);
        label(name);
    }
    void patch(const std::string& name, std::string_view colour)
    {
        svg_.path(fmt::format("M{} {}h30v12h-30Z", coordinate(legendX), coordinate(y_ - 11)), "none", 0, colour,
                  ringOpacity);
        label(name);
    }
    void mark(const std::string& name, bool outer)
    {
        const double tip = outer ? y_ + 1 : y_ - 10;
        svg_.path(fmt::format("M{} {}l-5.5 {}h11Z", coordinate(legendX + 15), coordinate(tip), outer ? -11 : 11),
                  "none", 0, markColour);
        label(name);
    }
    void words(const std::string& sentence)
    {
        svg_.text(legendX, y_, Svg::Anchor::Start, tickSize, sentence);
        y_ += step;
    }
    void space() { y_ += step / 2; }

private:
    static constexpr double step = 23;
    void label(const std::string& name)
    {
        svg_.text(legendX + 40, y_, Svg::Anchor::Start, tickSize, name);
        y_ += step;
    }
    Svg& svg_;
    double y_ = 92;
};

std::string phrase(Text words, const Values& values, const Language& language)
{
    return fill(text(words, language), values, language);
}

void drawPolarLegend(Svg& svg, const PolarPlot& plot, double magnification, const Ticks& divisions,
                     const Language& language)
{
    PolarLegend legend(svg);
    for (std::size_t i = 0; i < plot.traces.size(); ++i) {
        const std::string name = captionText(plot.traces[i].name, language);
        if (!name.empty()) legend.line(name, strokeOf(plot.traces[i].colour, i), plot.traces[i].thin ? 1 : 2.2);
    }
    for (std::size_t i = 0; i < plot.circles.size(); ++i) {
        const PolarPlot::ReferenceLine& circle = plot.circles[i];
        const std::string name = circle.asked.empty() ? captionText(circle.name, language) : std::string();
        if (!name.empty()) legend.line(name, strokeOf(circle.colour, i + 1), 1.6, circle.dashed ? polarDashes : "");
    }
    for (std::size_t i = 0; i < plot.rings.size(); ++i) {
        const std::string name = captionText(plot.rings[i].name, language);
        if (!name.empty()) legend.patch(name, strokeOf(plot.rings[i].colour, i));
    }
    for (const bool outer : {true, false})
        if (std::any_of(plot.contacts.begin(), plot.contacts.end(),
                        [&](const auto& mark) { return mark.outer == outer; }))
            legend.mark(text(outer ? LT_TEXT("Engine", "contact point, outer circle")
                                   : LT_TEXT("Engine", "contact point, inner circle"),
                             language),
                        outer);
    legend.space();
    if (divisions.values.size() > 1)
        legend.words(phrase(LT_TEXT("Engine", "1 division = {step_um} µm"),
                            {{"step_um", divisions.values[1] - divisions.values[0]}}, language));
    if (plot.base_radius_mm > 0) {
        legend.words(
            phrase(LT_TEXT("Engine", "Deviations magnified {times} times"), {{"times", magnification}}, language));
        legend.words(phrase(LT_TEXT("Engine", "Base circle: radius {radius_mm:4} mm"),
                            {{"radius_mm", plot.base_radius_mm}}, language));
    }
}

double pxPerUm(const PolarPlot& plot, double magnification)
{
    const double base_um = plot.base_radius_mm > 0 ? plot.base_radius_mm * um_per_mm : 1;
    return magnification * basePx(plot) / base_um;
}

}  // namespace

double fittingMagnification(const PolarPlot& plot)
{
    const Interval reach = reachOf(plot);
    double largest = std::numeric_limits<double>::infinity();  // px per µm
    if (reach.to > 0) largest = std::min(largest, (rimPx - basePx(plot)) / reach.to);
    if (reach.from < 0) largest = std::min(largest, (basePx(plot) - corePx) / -reach.from);
    if (!std::isfinite(largest)) return 1;
    const double wanted = largest / pxPerUm(plot, 1);
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    for (const double step : {5.0, 2.0})
        if (step * decade <= wanted * (1 + 1e-9)) return step * decade;
    return decade;
}

std::string toSvg(const PolarPlot& plot, const Language& language)
{
    const std::string title = captionText(plot.title, language);
    const double magnification = plot.magnification.value_or(fittingMagnification(plot));
    const double scale = pxPerUm(plot, magnification);
    const double base = basePx(plot);
    const Polar polar(base, scale);
    const Ticks divisions = axisTicks(Axis::Scale::Linear, {(corePx - base) / scale, (rimPx - base) / scale}, 8,
                                      shownUnit(unit::um, language).factor);
    Svg svg(sheetWidth, sheetHeight, title);
    svg.text(20, 24, Svg::Anchor::Start, titleSize, title, true);
    drawGrid(svg, polar, divisions, language);
    drawRingScale(svg, polar, plot, divisions, language);
    for (std::size_t i = 0; i < plot.rings.size(); ++i)
        svg.path(ringPath(polar, plot.rings[i]), "none", 0, strokeOf(plot.rings[i].colour, i), ringOpacity);
    for (std::size_t i = 0; i < plot.traces.size(); ++i) {
        const std::string data = tracePath(polar, plot.traces[i]);
        if (!data.empty()) svg.path(data, strokeOf(plot.traces[i].colour, i), plot.traces[i].thin ? 0.5 : 1.6);
    }
    for (std::size_t i = 0; i < plot.circles.size(); ++i)
        if (plot.circles[i].asked.empty())
            svg.path(referencePath(polar, plot.circles[i]), strokeOf(plot.circles[i].colour, i + 1), 1.4, "none", 1,
                     plot.circles[i].dashed ? polarDashes : "");
    for (const PolarPlot::Mark& mark : plot.contacts)
        if (isDrawable(mark.deviation_um) && isDrawable(mark.angle_deg))
            svg.path(markPath(mark.angle_deg * rad_per_deg, polar.radius(mark.deviation_um), mark.outer), "none", 0,
                     markColour);
    for (const PolarPlot::Mark& mark : plot.contacts)
        if (isDrawable(mark.deviation_um) && isDrawable(mark.angle_deg))
            nameContact(svg, polar, mark, captionText(mark.name, language));
    drawPolarLegend(svg, plot, magnification, divisions, language);
    return svg.finish();
}

}  // namespace lathelier::report
