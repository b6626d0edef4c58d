#include "engine/drawing/meridian_chart.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/drawing/rows.h"
#include "engine/drawing/stations.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::drawing {
namespace {

constexpr const char* shoulderPrefix = "shoulder/";
constexpr double arcStep_rad = 5 * std::numbers::pi / 180;

/// Points of a piece without its end.
void addPiece(const ContourPiece& piece, std::vector<Eigen::Vector2d>& points)
{
    if (!piece.isArc()) {
        points.push_back(piece.from_mm);
        return;
    }
    const auto [start, end] = piece.arcAngles();
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(end - start) / arcStep_rad)));
    const Eigen::Vector2d centre = piece.centre_mm();
    const double radius = std::abs(piece.arc_radius_mm);
    for (int i = 0; i < steps; ++i) {
        const double angle = start + (end - start) * i / steps;
        points.push_back(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
}

std::vector<Eigen::Vector2d> pointsOf(const Contour& contour)
{
    std::vector<Eigen::Vector2d> points;
    for (const ContourPiece& piece : contour) addPiece(piece, points);
    if (!contour.empty()) points.push_back(contour.back().to_mm);
    return points;
}

report::Curve curveOf(const Contour& contour, report::Caption name, report::ChartColour colour)
{
    report::Curve curve;
    curve.name = std::move(name);
    curve.colour = colour;
    const std::vector<Eigen::Vector2d> points = pointsOf(contour);
    for (const double side : {1.0, -1.0}) {
        if (side < 0) {  // the other half is not joined to the first one
            curve.x.push_back(points.empty() ? 0 : points.front().x());
            curve.y.push_back(notANumber);
        }
        for (const Eigen::Vector2d& point : points) {
            curve.x.push_back(point.x());
            curve.y.push_back(side * point.y());
        }
    }
    return curve;
}

}  // namespace

report::Plot meridianChart(const Shaft& shaft)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Meridian");
    plot.x = {LT_TEXT("Engine", "z from the free end"), unit::mm};
    plot.y = {LT_TEXT("Engine", "Radius"), unit::mm};
    plot.equal_scales = true;
    const Shaft stated = withStatedBores(shaft);
    plot.curves.push_back(curveOf(outerContour(stated), {}, report::ChartColour(0)));
    for (std::size_t i = 0; i < stated.bores.size(); ++i)
        plot.curves.push_back(curveOf(boreContour(stated, i), LT_TEXT("Engine", "bore"), report::ChartColour(1)));
    const double length_mm = stated.length_mm();
    for (const Station& station : stationsOf(outerRows(stated))) {
        report::Handle handle;
        handle.key = shoulderPrefix + std::to_string(station.before);
        handle.kind = report::Handle::Kind::Point;
        handle.x = station.z_mm;
        handle.y = station.radius_mm;
        handle.y_range = Interval{station.radius_mm, station.radius_mm};
        handle.x_range = Interval{0, 2 * length_mm};
        plot.handles.push_back(std::move(handle));
    }
    return plot;
}

std::optional<std::size_t> rowOfShoulder(const std::string& key)
{
    const std::string start = shoulderPrefix;
    if (!key.starts_with(start)) return std::nullopt;
    std::size_t row = 0;
    const auto [end, error] = std::from_chars(key.data() + start.size(), key.data() + key.size(), row);
    return error == std::errc() && end == key.data() + key.size() ? std::optional(row) : std::nullopt;
}

std::vector<Eigen::Vector2d> contourOfRow(const Shaft& shaft, std::size_t row)
{
    Contour pieces;
    for (const ContourPiece& piece : outerContour(shaft))
        if (piece.row == static_cast<std::ptrdiff_t>(row)) pieces.push_back(piece);
    return pointsOf(pieces);
}

}  // namespace lathelier::drawing
