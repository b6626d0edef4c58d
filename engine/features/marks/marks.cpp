#include "engine/features/marks/marks.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/marks/mark_limits.h"
#include "engine/features/marks/off_regions.h"
#include "engine/features/marks/periodic_mark.h"
#include "engine/features/marks/slot.h"
#include "engine/features/structure/mark_proof.h"

namespace lathelier::features {
namespace {

using Eigen::Vector2d;

/// a·x + b·y = 1: the plane at the distance 1/√(a² + b²) from the axis.
struct FloorPlane {
    Vector2d normal{0, 0};
    std::vector<char> use;  ///< points within the plane; the others are the walls of a slot
    double rms_mm = 0;      ///< distance of the used points
    double used = 0;        ///< number of the used points

    double distance_mm() const { return 1 / std::max(1e-9, normal.norm()); }
};

FloorPlane floorThrough(const std::vector<Vector2d>& places, double sigma_mm)
{
    FloorPlane plane;
    plane.use.assign(places.size(), 1);
    for (int round = 0; round < markLimits.plane_rounds; ++round) {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Vector2d right = Vector2d::Zero();
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!plane.use[i]) continue;
            normal += places[i] * places[i].transpose();
            right += places[i];
        }
        plane.normal = normal.ldlt().solve(right);
        const double distance = plane.distance_mm();
        std::vector<double> off;
        off.reserve(places.size());
        for (const Vector2d& p : places) off.push_back(std::abs((plane.normal.dot(p) - 1) * distance));
        double limit = markLimits.plane_outlier_sigmas * sigma_mm;
        if (round < markLimits.robust_rounds) {
            std::vector<double> sorted = off;
            limit = std::max(limit, markLimits.robust_outlier_medians * lowerQuantileInPlace(sorted, 0.5));
        }
        plane.rms_mm = plane.used = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            plane.use[i] = off[i] < limit;
            if (!plane.use[i]) continue;
            plane.rms_mm += off[i] * off[i];
            plane.used += 1;
        }
        plane.rms_mm = std::sqrt(plane.rms_mm / std::max(1.0, plane.used));
    }
    return plane;
}

/// The used points on the floor.
std::vector<FloorPoint> pointsOf(const FloorPlane& plane, const std::vector<Vector2d>& places,
                                 const std::vector<double>& heights_mm)
{
    const double distance = plane.distance_mm();
    const Vector2d along(-plane.normal.y() * distance, plane.normal.x() * distance);
    std::vector<FloorPoint> points;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (plane.use[i])
            points.push_back({heights_mm[i], along.dot(places[i]), (plane.normal.dot(places[i]) - 1) * distance});
    return points;
}

double widthOf_mm(const std::vector<FloorPoint>& floor)
{
    std::vector<double> across;
    across.reserve(floor.size());
    for (const FloorPoint& point : floor) across.push_back(point.across_mm);
    const double high = lowerQuantileInPlace(across, 1 - markLimits.tail_share);
    return high - lowerQuantileInPlace(across, markLimits.tail_share);
}

/// U of the plane's distance and of its direction.
void setUncertainties(ShaftMark& mark, const FloorPlane& plane, const std::vector<FloorPoint>& floor, double width_mm)
{
    const auto n = static_cast<double>(floor.size());
    double squares = 0, sum = 0;
    for (const FloorPoint& point : floor) {
        sum += point.across_mm;
        squares += point.across_mm * point.across_mm;
    }
    const double variance = markLimits.dependent_points * plane.rms_mm * plane.rms_mm / n;
    const double spread = squares / n - (sum / n) * (sum / n), form = markLimits.floor_form_mm;
    if (!(spread > 0) || !(width_mm > 0)) return;
    const double u_mm = 2 * std::sqrt(variance + form * form);
    (mark.kind == MarkKind::Flat ? mark.uncertainty_mm : mark.depth_uncertainty_mm) = u_mm;
    mark.angle_uncertainty_deg = 2 * deg_per_rad * std::hypot(std::sqrt(variance / spread), form / width_mm);
}

/// The flat or keyway whose floor the points of a region prove.
std::optional<ShaftMark> markOf(const WallScan& scan, const OffRegion& region)
{
    const MeridianCloud& cloud = scan.cloud;
    const Model& model = scan.model;
    std::vector<Vector2d> places;
    std::vector<double> heights;
    double worst = 0;
    for (const std::uint32_t i : region.points) {
        const double angle = turn_rad * static_cast<double>(cloud.turn[i]), r = static_cast<double>(cloud.r_mm[i]),
                     z = static_cast<double>(cloud.z_mm[i]);
        places.emplace_back(r * std::cos(angle), r * std::sin(angle));
        heights.push_back(z);
        const Run* const run = smoothRunAt(model, z);
        const double off = run ? r - radiusAt_mm(*run, z) : 0;
        if (std::abs(off) > std::abs(worst)) worst = off;
    }
    const FloorPlane plane = floorThrough(places, model.sigma_mm);
    const std::vector<FloorPoint> points = pointsOf(plane, places, heights);
    ShaftMark mark;
    mark.z_start_mm = lowerQuantileInPlace(heights, markLimits.tail_share);
    mark.z_end_mm = lowerQuantileInPlace(heights, 1 - markLimits.tail_share);
    const double angle = std::atan2(plane.normal.y(), plane.normal.x()) * deg_per_rad;
    mark.angle_deg = angle < 0 ? angle + 360 : angle;
    const bool flat_floor = worst < 0 &&
                            plane.used > markLimits.least_plane_share * static_cast<double>(places.size()) &&
                            plane.rms_mm < markLimits.largest_plane_sigmas * model.sigma_mm;
    const bool is_long = *mark.z_end_mm - *mark.z_start_mm >= proofThresholds.least_length_mm;
    if (!flat_floor || !is_long || !isPlane(points, model.sigma_mm)) return std::nullopt;
    const double floor = plane.distance_mm(), width = widthOf_mm(points);
    const double middle = (*mark.z_start_mm + *mark.z_end_mm) / 2;
    const Run* const run = smoothRunAt(model, middle);
    const double radius = run ? radiusAt_mm(*run, middle) : floor;
    switch (floorShape(radius, floor, width, markLimits.off_sigmas * model.sigma_mm + markLimits.off_mm)) {
        case FloorShape::Flat:
            mark.kind = MarkKind::Flat;
            mark.distance_mm = floor;
            break;
        case FloorShape::Keyway:
            mark.kind = MarkKind::Keyway;
            mark.floor_mm = floor;
            break;
        case FloorShape::Neither: return std::nullopt;
    }
    mark.width_mm = width;
    setUncertainties(mark, plane, points, width);
    return mark;
}

/// More equal keyways over one stretch than a shaft has are the gaps of teeth.
void dropTeeth(std::vector<ShaftMark>& marks)
{
    const auto alike = [&](const ShaftMark& mark) {
        return static_cast<std::size_t>(std::count_if(marks.begin(), marks.end(), [&](const ShaftMark& other) {
            return other.kind == mark.kind && *other.z_start_mm<*mark.z_end_mm&& * other.z_end_mm> * mark.z_start_mm;
        }));
    };
    std::vector<ShaftMark> kept;
    for (const ShaftMark& mark : marks)
        if (mark.kind != MarkKind::Keyway || alike(mark) <= proofThresholds.most_alike) kept.push_back(mark);
    marks = std::move(kept);
}

/// Pieces of one floor are one keyway: cells with few points part it.
void joinKeyways(std::vector<ShaftMark>& marks)
{
    std::stable_sort(marks.begin(), marks.end(),
                     [](const ShaftMark& a, const ShaftMark& b) { return a.z_start_mm < b.z_start_mm; });
    std::vector<ShaftMark> joined;
    for (const ShaftMark& mark : marks) {
        const auto before = std::find_if(joined.begin(), joined.end(), [&](const ShaftMark& one) {
            return one.kind == MarkKind::Keyway && mark.kind == MarkKind::Keyway &&
                   *mark.z_start_mm - *one.z_end_mm < markLimits.floor_gap_mm &&
                   std::abs(*mark.floor_mm - *one.floor_mm) < markLimits.same_floor_mm &&
                   std::abs(std::remainder(*mark.angle_deg - *one.angle_deg, 360)) < markLimits.same_floor_deg;
        });
        if (before == joined.end()) {
            joined.push_back(mark);
            continue;
        }
        before->z_end_mm = std::max(*before->z_end_mm, *mark.z_end_mm);
        before->width_mm = std::max(*before->width_mm, *mark.width_mm);
    }
    marks = std::move(joined);
}

/// Zones of one thread, which a groove or noise divides, are one mark.
void joinThreads(std::vector<ShaftMark>& marks)
{
    std::vector<ShaftMark> joined;
    for (const ShaftMark& mark : marks) {
        const auto continues = [&](const ShaftMark& last) {
            return last.kind == MarkKind::Thread && mark.kind == MarkKind::Thread && last.starts == mark.starts &&
                   last.hand == mark.hand &&
                   std::abs(*last.pitch_mm - *mark.pitch_mm) < markLimits.same_pitch_share * *mark.pitch_mm &&
                   std::abs(*last.major_mm - *mark.major_mm) < markLimits.same_major_mm &&
                   *mark.z_start_mm - *last.z_end_mm < markLimits.thread_gap_pitches * *mark.pitch_mm;
        };
        const auto last = std::find_if(joined.rbegin(), joined.rend(), continues);
        if (last == joined.rend()) {
            joined.push_back(mark);
            continue;
        }
        // Sizes are those of the longer zone.
        const double start = std::min(*last->z_start_mm, *mark.z_start_mm),
                     end = std::max(*last->z_end_mm, *mark.z_end_mm);
        if (*mark.z_end_mm - *mark.z_start_mm > *last->z_end_mm - *last->z_start_mm) *last = mark;
        last->z_start_mm = start;
        last->z_end_mm = end;
    }
    marks = std::move(joined);
}

}  // namespace

std::vector<ShaftMark> findMarks(const MeridianCloud& cloud, const Outline& outline, const Outline* bore,
                                 const std::optional<registration::ScannerAxis>& scanner, const Progress& progress)
{
    const Model& model = outline.model;
    const WallScan scan{cloud, model, scanner, outline.surface_scan};
    std::vector<ShaftMark> marks;
    for (const OffRegion& region : offRegions(cloud, model, bore)) {
        progress.check();
        if (auto mark = markOf(scan, region)) marks.push_back(*std::move(mark));
    }
    joinKeyways(marks);
    dropTeeth(marks);
    for (ShaftMark& mark : marks)
        if (mark.kind == MarkKind::Keyway) measureSlot(scan, mark, progress);
    joinKeyways(marks);  // pieces that were too unlike are alike now that each was measured over the whole slot
    for (const RoughZone& zone : outline.rough) {
        if (zone.eccentric_mm > 0) continue;
        double about = 0;
        for (const Run& run : model.runs)
            if (run.elements.front().rough && run.nodes_mm.front() < (zone.z_start_mm + zone.z_end_mm) / 2)
                about = run.elements.front().level_mm;
        if (const auto mark = periodicMark(cloud, zone.z_start_mm, zone.z_end_mm, about, model.sigma_mm, progress))
            marks.push_back(*mark);
    }
    std::sort(marks.begin(), marks.end(),
              [](const ShaftMark& a, const ShaftMark& b) { return a.z_start_mm < b.z_start_mm; });
    joinThreads(marks);
    return marks;
}

}  // namespace lathelier::features
