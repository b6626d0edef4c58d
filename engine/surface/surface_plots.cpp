#include "engine/surface/surface_plots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/report/png.h"
#include "engine/surface/preparation.h"

namespace lathelier::surface {
namespace {

constexpr int widestMap = 600;
constexpr int widestPicture = 900;

Grid atMost(const Grid& grid, int columns)
{
    return grid.columns > columns ? reduced(grid, double(grid.columns) / columns) : grid;
}

/// A map with rows upward.
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

/// Lines `pitch` apart along the marks, about the middle; `direction`: across the marks, upward positive.
report::Curve ruler(report::Caption name, Vector middle, Vector direction, double pitch, double length_of, double shift)
{
    report::Curve curve;
    curve.name = std::move(name);
    const Vector along{-direction.y, direction.x};
    for (int i = -5; i <= 5; ++i) {
        const Vector foot = middle + (i * pitch) * direction + (shift * length_of) * along;
        const Vector top = foot + length_of * along;
        curve.x.insert(curve.x.end(), {foot.x, top.x});
        curve.y.insert(curve.y.end(), {foot.y, top.y});
        lift(curve);
    }
    return curve;
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

}  // namespace

report::Plot markedPicture(const ImageMarks& image, const SurfaceParameters& parameters)
{
    const SurfaceView& view = image.view;
    const double pixel = view.px_per_px * image.mm_per_px.value_or(1);
    const double width = view.flat.columns * pixel, height = view.flat.rows * pixel;
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Picture without its uneven light");
    const Text unit = image.mm_per_px ? LT_TEXT("Engine", "mm") : LT_TEXT("Engine", "px");
    plot.x = {LT_TEXT("Engine", "To the right"), unit};
    plot.y = {LT_TEXT("Engine", "Upward"), unit};
    plot.equal_scales = true;
    report::ColourMap map = mapOf(atMost(view.flat, widestMap), width, height);
    map.value = {LT_TEXT("Engine", "Brightness over its surroundings"), {}};
    map.limit = 3;
    plot.ground = std::move(map);
    if (!image.feed_marks) return plot;
    const double angle = (image.feed_marks->direction_deg - view.turned_deg) * std::numbers::pi / 180;
    const Vector direction{std::cos(angle), -std::sin(angle)}, middle{0.5 * width, 0.5 * height};
    const double pitch = image.feed_marks->pitch_px * image.mm_per_px.value_or(1);
    plot.curves.push_back(ruler(LT_TEXT("Engine", "marks found"), middle, direction, pitch, 0.15 * height, 0));
    if (parameters.feed_mm_rev && image.mm_per_px)
        plot.curves.push_back(
            ruler(LT_TEXT("Engine", "feed"), middle, direction, *parameters.feed_mm_rev, 0.15 * height, -1));
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
            if (std::abs(place.x) < edge && std::abs(place.y) < edge)
                ring(line.is_feed ? feed : chatter, place, 0.02 * edge);
        }
    for (report::Curve* curve : {&feed, &chatter})
        if (!curve->x.empty()) plot.curves.push_back(std::move(*curve));
    return plot;
}

std::string picturePng(const ImageMarks& image)
{
    const Grid picture = atMost(image.view.picture, widestPicture);
    report::GreyImage grey{picture.columns, picture.rows, 8, {}, {}};
    for (const float value : picture.values)
        grey.samples.push_back(static_cast<std::uint16_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F))));
    return report::encodePng(grey);
}

}  // namespace lathelier::surface
