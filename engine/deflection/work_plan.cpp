#include "engine/deflection/work_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/beam/beam_codes.h"
#include "engine/beam/segment_contour.h"
#include "engine/beam/uniform_segments.h"
#include "engine/cutting/cutting_codes.h"
#include "engine/deflection/deflection_codes.h"

namespace lathelier::deflection {
namespace {

constexpr std::size_t mostPieces = 200000;
constexpr double coarseEnough_mm = 0.01;  ///< smallest step that may be moved onto the grid
constexpr double arcChord_mm = 5e-5;

double reachOf(const ToolRun& run)
{
    return std::max(run.points.front().z_mm, run.points.back().z_mm);
}

/// Places along arcs, on the grid of the program, whose chords leave them by arcChord_mm at most.
void addPlacesOnArcs(const ToolRun& run, double z_zero_mm, double z_grid_mm, std::vector<double>& places)
{
    const std::vector<PathPoint>& points = run.points;
    const auto off_mm = [&](std::size_t from, std::size_t to) {
        const double dz = points[to].z_mm - points[from].z_mm, dx = points[to].x_mm - points[from].x_mm;
        const double length = std::max(1e-12, std::hypot(dz, dx));
        double largest = 0;
        for (std::size_t i = from + 1; i < to; ++i)
            largest = std::max(largest, std::abs(dz * (points[i].x_mm - points[from].x_mm) -
                                                 dx * (points[i].z_mm - points[from].z_mm)) /
                                            length);
        return largest;
    };
    std::size_t from = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i > from + 1 && off_mm(from, i) > arcChord_mm) {
            from = i - 1;
            places.push_back(z_zero_mm - std::round((z_zero_mm - points[from].z_mm) / z_grid_mm) * z_grid_mm);
        }
        if (points[i].is_block_end) from = i;
    }
}

/// Ends of segments, rests, and of the blocks of the runs: positions that need a node.
std::vector<double> fixedPlaces(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                                double length_mm, double z_grid_mm)
{
    std::vector<double> places{0, length_mm};
    double z_mm = 0;
    for (const ShaftSegment& segment : stock.segments) places.push_back(z_mm += segment.length_mm);
    for (const SteadyRest& rest : setup.steady_rests) {
        if (!(rest.z_mm >= 0 && rest.z_mm <= length_mm))
            throw Error(errors::placeOutsideShaft, {{"z_mm", rest.z_mm}, {"length_mm", length_mm}});
        places.push_back(rest.z_mm);
    }
    for (const ToolRun& run : runs)
        for (const PathPoint& point : run.points)
            if (point.is_block_end) places.push_back(point.z_mm);
    for (const ToolRun& run : runs) addPlacesOnArcs(run, setup.z_zero_mm, z_grid_mm, places);
    std::erase_if(places, [&](double place_mm) { return place_mm < 0 || place_mm > length_mm; });
    std::sort(places.begin(), places.end());
    const auto is_same = [](double a, double b) { return b - a < samePlanPlace_mm; };
    places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
    places.back() = length_mm;
    return places;
}

std::vector<double> nodesOf(const std::vector<double>& places, const TurningSetup& setup, double z_grid_mm)
{
    double count = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
        count += std::ceil((places[i] - places[i - 1]) / setup.step_mm - 1e-9);
    if (count > static_cast<double>(mostPieces))
        throw Error(errors::tooManySteps, {{"found", count}, {"maximum", static_cast<std::int64_t>(mostPieces)}});
    std::vector<double> nodes{places.front()};
    nodes.reserve(static_cast<std::size_t>(count) + 1);
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double from_mm = places[i - 1], width_mm = places[i] - places[i - 1];
        const double steps = std::max(1.0, std::ceil(width_mm / setup.step_mm - 1e-9));
        for (double k = 1; k < steps; ++k) {
            const double z_mm = from_mm + width_mm * k / steps;
            const double on_grid_mm = setup.z_zero_mm - std::round((setup.z_zero_mm - z_mm) / z_grid_mm) * z_grid_mm;
            nodes.push_back(width_mm / steps >= coarseEnough_mm ? on_grid_mm : z_mm);
        }
        nodes.push_back(places[i]);
    }
    return nodes;
}

void addStock(const Shaft& stock, WorkPlan& plan)
{
    const std::size_t n = plan.z_mm.size() - 1;
    plan.outer_start_mm.reserve(n);
    plan.outer_end_mm.reserve(n);
    plan.bore_mm.reserve(n);
    std::size_t piece = 0;
    double start_mm = 0;
    for (const ShaftSegment& segment : stock.segments) {
        const beam::SegmentContour contour(segment);
        const double end_mm = start_mm + segment.length_mm;
        const auto radiusAt = [&](double z_mm) {
            return contour.radiusAt_mm(std::clamp(z_mm - start_mm, 0.0, segment.length_mm));
        };
        for (; piece < n && (plan.z_mm[piece] + plan.z_mm[piece + 1]) / 2 < end_mm; ++piece) {
            plan.outer_start_mm.push_back(radiusAt(plan.z_mm[piece]));
            plan.outer_end_mm.push_back(radiusAt(plan.z_mm[piece + 1]));
            plan.bore_mm.push_back(segment.bore_diameter_mm / 2);
        }
        start_mm = end_mm;
    }
}

double between(const PathPoint& a, const PathPoint& b, double z_mm)
{
    const double width_mm = b.z_mm - a.z_mm;
    if (std::abs(width_mm) < 1e-12) return b.x_mm;
    return a.x_mm + (b.x_mm - a.x_mm) * std::clamp((z_mm - a.z_mm) / width_mm, 0.0, 1.0);
}

/// Points ordered toward the chuck; each keeps the attributes of the stretch toward smaller z.
std::vector<PathPoint> ascending(const ToolRun& run)
{
    std::vector<PathPoint> points = run.points;
    if (run.kind != ToolRun::Kind::TowardFreeEnd) return points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        points[i].feed_mm_rev = points[i + 1].feed_mm_rev;
        points[i].line = points[i + 1].line;
        points[i].arc = points[i + 1].arc;
    }
    std::reverse(points.begin(), points.end());
    return points;
}

std::size_t nodeAt(const std::vector<double>& z_mm, double place_mm)
{
    const auto after = std::lower_bound(z_mm.begin(), z_mm.end(), place_mm - samePlanPlace_mm);
    return static_cast<std::size_t>(std::min(after, z_mm.end() - 1) - z_mm.begin());
}

void requireStockAtEnd(const WorkPlan& plan, const std::vector<PathPoint>& points)
{
    const double length_mm = plan.length_mm();
    const PathPoint& end = points.back();
    if (end.z_mm <= length_mm + samePlanPlace_mm) return;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i - 1].z_mm <= length_mm && points[i].z_mm > length_mm &&
            between(points[i - 1], points[i], length_mm) < plan.outer_end_mm.back() - samePlanPlace_mm)
            throw Error(errors::stockTooShort,
                        {{"z_mm", end.z_mm}, {"length_mm", length_mm}, {"line", points[i].line}});
}

/// Precondition: the run reaches the stock.
CutPlan onNodes(const WorkPlan& plan, const ToolRun& run)
{
    const std::vector<PathPoint> points = ascending(run);
    if (run.kind == ToolRun::Kind::TowardChuck) requireStockAtEnd(plan, points);
    CutPlan cut;
    cut.kind = run.kind;
    cut.run = run;
    cut.first = nodeAt(plan.z_mm, std::max(0.0, points.front().z_mm));
    if (run.kind == ToolRun::Kind::Plunge) return cut;
    const std::size_t last = nodeAt(plan.z_mm, std::min(plan.length_mm(), points.back().z_mm));
    cut.pieces.reserve(last - cut.first);
    cut.block_ends.assign(last - cut.first + 1, false);
    std::size_t k = 0;  // stretch k lies between points k and k + 1
    const auto beyond = [&](std::size_t stretch, double z_mm) { return points[stretch + 1].z_mm <= z_mm; };
    for (std::size_t node = cut.first; node < last; ++node) {
        const double from_mm = plan.z_mm[node], to_mm = plan.z_mm[node + 1];
        while (k + 2 < points.size() && beyond(k, from_mm + samePlanPlace_mm)) ++k;
        std::size_t m = k;
        while (m + 2 < points.size() && beyond(m, to_mm - samePlanPlace_mm)) ++m;
        CutPiece piece{between(points[k], points[k + 1], from_mm), between(points[m], points[m + 1], to_mm)};
        const PathPoint& cause = points[k + 1];
        if (!(cause.feed_mm_rev > 0))
            throw Error(errors::feedMissing, {{"feed_mm_rev", cause.feed_mm_rev}, {"line", cause.line}});
        piece.feed_mm_rev = cause.feed_mm_rev;
        piece.line = cause.line;
        piece.slope_rad = std::atan2(piece.end_mm - piece.start_mm, to_mm - from_mm);
        piece.arc = cause.arc;
        cut.pieces.push_back(piece);
    }
    for (const PathPoint& point : points) {
        if (!point.is_block_end || point.z_mm < -samePlanPlace_mm || point.z_mm > plan.length_mm() + samePlanPlace_mm)
            continue;
        const std::size_t node = nodeAt(plan.z_mm, point.z_mm);
        if (node >= cut.first && node <= last) cut.block_ends[node - cut.first] = true;
    }
    return cut;
}

}  // namespace

WorkPlan workPlan(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup, double z_grid_mm)
{
    beam::uniformSegments(stock);  // throws for invalid shafts
    WorkPlan plan;
    const double length_mm = stock.length_mm();
    plan.z_mm = nodesOf(fixedPlaces(stock, runs, setup, length_mm, z_grid_mm), setup, z_grid_mm);
    if (plan.z_mm.size() < 2) return plan;  // a stock without length: nothing of it can be cut
    addStock(stock, plan);
    plan.rest_nodes.reserve(setup.steady_rests.size());
    for (const SteadyRest& rest : setup.steady_rests) plan.rest_nodes.push_back(nodeAt(plan.z_mm, rest.z_mm));
    for (const ToolRun& run : runs) {
        const double begin_mm = std::min(run.points.front().z_mm, run.points.back().z_mm);
        const bool is_plunge = run.kind == ToolRun::Kind::Plunge;
        if (begin_mm > length_mm || reachOf(run) < (is_plunge ? 0 : samePlanPlace_mm)) continue;
        if (!is_plunge && begin_mm > length_mm - samePlanPlace_mm) continue;
        CutPlan cut = onNodes(plan, run);
        if (is_plunge || !cut.pieces.empty()) plan.cuts.push_back(std::move(cut));
    }
    return plan;
}

}  // namespace lathelier::deflection
