#include "engine/surface/surface_plots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/report/png.h"
#include "engine/surface/preparation.h"

namespace lathelier::surface {
namespace {

constexpr int widestPicture = 900;
constexpr int mostNamed = 4;  // labelled lines of comb and lattice

Grid atMost(const Grid& grid, int columns)
{
    return grid.columns > columns ? reduced(grid, double(grid.columns) / columns) : grid;
}

/// Colour map with flipped rows (y upward).
report::ColourMap mapOf(const Grid& grid, double width, double height)
{
    report::ColourMap map;
    map.columns = grid.columns;
    map.rows = grid.rows;
    for (int y = grid.rows - 1; y >= 0; --y)
        map.values.insert(map.values.end(), grid.row(y), grid.row(y) + grid.columns);
    map.x_to = width;
    map.y_to = height;
    return map;
}

void lift(report::Curve& curve)
{
    curve.x.push_back(NAN);
    curve.y.push_back(NAN);
}

void ring(report::Curve& curve, Vector centre, double radius)
{
    constexpr int corners = 24;
    for (int i = 0; i <= corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        curve.x.push_back(centre.x + radius * std::cos(angle));
        curve.y.push_back(centre.y + radius * std::sin(angle));
    }
    lift(curve);
}

/// Labels the first lines of comb and lattice in the half plane with positive fx.
void nameStrongest(report::Plot& plot, const ImageMarks& image, double pixel, double edge)
{
    int feed = 0, chatter = 0;
    for (const NamedLine& line : image.view.lines) {
        if ((line.is_feed ? feed : chatter)++ >= mostNamed) continue;
        const double sign = line.frequency.x < 0 ? -1 : 1;
        const double x = sign * line.frequency.x / pixel, y = -sign * line.frequency.y / pixel;
        if (std::abs(x) < edge && std::abs(y) < edge) plot.marks.push_back({x, y, nameOf(line)});
    }
}

}  // namespace

std::string nameOf(const NamedLine& line)
{
    const auto times = [](int count, const char* letter) {
        return (std::abs(count) == 1 ? std::string() : std::to_string(std::abs(count)) + " ") + letter;
    };
    if (line.is_feed) return times(line.multiple, "f");
    std::string name = times(line.multiple, "c");
    if (line.order != 0) name += (line.order > 0 ? " + " : " \u2212 ") + times(line.order, "f");
    return name;
}

int lineAt(const ImageMarks& image, double x, double y)
{
    const SurfaceView& view = image.view;
    const double pixel = view.px_per_px * image.mm_per_px.value_or(1);
    const Vector place{x * pixel, -y * pixel};
    double nearest = 0.04 * view.spectrum_edge;
    int found = -1;
    for (std::size_t i = 0; i < view.lines.size(); ++i)
        for (const double sign : {1.0, -1.0}) {
            const double away = length(place - sign * view.lines[i].frequency);
            if (away >= nearest) continue;
            nearest = away;
            found = static_cast<int>(i);
        }
    return found;
}

report::Plot linesOverNoise(const ImageMarks& image)
{
    const double pixel = image.view.px_per_px * image.mm_per_px.value_or(1);
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Lines over the noise");
    plot.x = {LT_TEXT("Engine", "Lines in a length"),
              image.mm_per_px ? LT_TEXT("Engine", "1/mm") : LT_TEXT("Engine", "1/px")};
    plot.y = {LT_TEXT("Engine", "Power over the noise, S"), {}, report::Axis::Scale::Logarithmic};
    report::Curve feed, chatter;
    feed.name = LT_TEXT("Engine", "feed marks");
    chatter.name = LT_TEXT("Engine", "chatter marks");
    double largest = image.threshold, right = 0;
    int named = 0;
    for (const NamedLine& line : image.view.lines) {
        if (!line.significance || !(*line.significance > 0)) continue;
        report::Curve& curve = line.is_feed ? feed : chatter;
        curve.style = report::Curve::Style::Points;
        curve.x.push_back(length(line.frequency) / pixel);
        curve.y.push_back(*line.significance);
        largest = std::max(largest, *line.significance);
        right = std::max(right, curve.x.back());
        if (line.is_feed || named++ < mostNamed) plot.marks.push_back({curve.x.back(), curve.y.back(), nameOf(line)});
    }
    for (report::Curve* curve : {&feed, &chatter})
        if (!curve->x.empty()) plot.curves.push_back(std::move(*curve));
    if (plot.curves.empty()) {  // scale from the strongest line
        plot.limits.push_back({report::Limit::Direction::Horizontal, std::max(1e-3, image.largest_significance),
                               LT_TEXT("Engine", "strongest line")});
        right = 0.5 / pixel;
    }
    plot.limits.push_back({report::Limit::Direction::Horizontal, image.threshold, LT_TEXT("Engine", "threshold, T")});
    plot.x.range = Interval{0, 1.15 * right};
    plot.y.range = Interval{1, 3 * largest};
    return plot;
}

report::Plot ringedSpectrum(const ImageMarks& image)
{
    const SurfaceView& view = image.view;
    const double pixel = view.px_per_px * image.mm_per_px.value_or(1);
    const double edge = view.spectrum_edge / pixel;
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Spectrum");
    const Text unit = image.mm_per_px ? LT_TEXT("Engine", "1/mm") : LT_TEXT("Engine", "1/px");
    plot.x = {LT_TEXT("Engine", "Frequency to the right"), unit};
    plot.y = {LT_TEXT("Engine", "Frequency upward"), unit};
    plot.equal_scales = true;
    report::ColourMap map = mapOf(view.spectrum, 0, 0);
    map.x_from = map.y_from = -edge;
    map.x_to = map.y_to = edge;
    map.value = {LT_TEXT("Engine", "Decades over the surroundings"), {}};
    map.limit = 5;
    plot.ground = std::move(map);
    report::Curve feed, chatter;
    feed.name = LT_TEXT("Engine", "feed marks");
    chatter.name = LT_TEXT("Engine", "chatter marks");
    for (const NamedLine& line : view.lines)
        for (const double sign : {1.0, -1.0}) {
            const Vector place{sign * line.frequency.x / pixel, -sign * line.frequency.y / pixel};
            if (std::abs(place.x) >= edge || std::abs(place.y) >= edge) continue;
            ring(line.is_feed ? feed : chatter, place, 0.02 * edge);
        }
    nameStrongest(plot, image, pixel, edge);
    for (report::Curve* curve : {&feed, &chatter})
        if (!curve->x.empty()) plot.curves.push_back(std::move(*curve));
    return plot;
}

std::uint8_t levelOf(float value, double low, double high)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp((double(value) - low) / (high - low), 0.0, 1.0)));
}

report::GreyImage greyOf(const Grid& grid, double low, double high)
{
    report::GreyImage grey{grid.columns, grid.rows, 8, {}, {}};
    grey.samples.reserve(grid.values.size());
    for (const float value : grid.values) grey.samples.push_back(levelOf(value, low, high));
    return grey;
}

std::string picturePng(const ImageMarks& image)
{
    return report::encodePng(greyOf(atMost(image.view.picture, widestPicture), 0, 1));
}

}  // namespace lathelier::surface
