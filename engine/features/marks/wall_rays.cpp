#include "engine/features/marks/wall_rays.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/marks/mark_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;
using registration::ScannerAxis;

/// Limits of the columns of rays; chosen on scans with known truth.
struct ColumnLimits {
    double gap_medians = 8, least_step_rad = 1e-3;  ///< larger gaps between sorted angles lie between two columns
    std::size_t least_columns = 6;
    double least_covered = 0.6;    ///< share of the span that the gaps between columns must make up
    double step_scatter = 0.25;    ///< of the step: quartiles of the gaps lie within
    double column_share = 0.12;    ///< of the step: rms of the columns about their places
    double missing_pitches = 1.5;  ///< a larger gap along a column holds rays that passed
    double window_pitches = 0.75;  ///< of the ends of a window: nearer to them no ray is missed
    double least_pitch_mm = 1e-4;
    std::size_t most_missing = 200000;  ///< rays in a window: bounds the memory
    int hit_rounds = 4;                 ///< of the place where a ray meets the wall
};
constexpr ColumnLimits columnLimits{};

/// A point of the wall as the scanner has it: angle and height about its axis.
struct ColumnPoint {
    double angle_rad = 0, height_mm = 0;
};

/// Coordinates about the axis of a scanner, angles from that of a window.
class ScannerFrame {
public:
    ScannerFrame(const ScannerAxis& axis, double angle_rad) : axis_(axis)
    {
        const Vector3d there(std::cos(angle_rad), std::sin(angle_rad), 0);
        out_ = (there - axis.direction * axis.direction.dot(there)).normalized();
        across_ = axis.direction.cross(out_);
    }

    ColumnPoint of(const Vector3d& point) const
    {
        const Vector3d arm = point - axis_.point_mm;
        return {std::atan2(across_.dot(arm), out_.dot(arm)), axis_.direction.dot(arm)};
    }

    /// Where the ray meets the wall.
    Vector3d hit(const ColumnPoint& ray, const Run& run, double radius_mm) const
    {
        const Vector3d origin = axis_.point_mm + axis_.direction * ray.height_mm,
                       along = out_ * std::cos(ray.angle_rad) + across_ * std::sin(ray.angle_rad);
        double far = radius_mm;
        Vector3d place = origin + along * far;
        for (int round = 0; round < columnLimits.hit_rounds; ++round) {
            const double r = std::hypot(place.x(), place.y());
            const double cosine = (along.x() * place.x() + along.y() * place.y()) / std::max(1e-9, r);
            far += (radiusAt_mm(run, place.z()) - r) / std::max(0.2, cosine);
            place = origin + along * far;
        }
        return place;
    }

private:
    ScannerAxis axis_;
    Vector3d out_, across_;
};

RimRay rayAt(const Vector3d& place, double angle_rad, bool on_wall)
{
    return {place.z(), place.y() * std::cos(angle_rad) - place.x() * std::sin(angle_rad), on_wall};
}

bool isInWindow(const Vector3d& place, const WallWindow& window, double margin_mm)
{
    if (place.z() < window.from_mm + margin_mm || place.z() > window.to_mm - margin_mm) return false;
    return std::abs(std::remainder(std::atan2(place.y(), place.x()) - window.angle_rad, turn_rad)) < window.half_rad;
}

/// Heights of the columns with points, in order, by the number of the column.
using ColumnHeights = std::map<std::ptrdiff_t, std::vector<double>>;

double pitchOf_mm(const ColumnHeights& columns)
{
    std::vector<double> steps;
    for (const auto& [number, heights] : columns)
        for (std::size_t i = 0; i + 1 < heights.size(); ++i)
            if (const double step = heights[i + 1] - heights[i]; step > columnLimits.least_pitch_mm)
                steps.push_back(step);
    return steps.empty() ? 0 : upperMedianInPlace(steps);
}

/// Heights of the rays of a column that are no points of the wall, from `low_mm` to `high_mm`.
std::vector<double> missedHeights(const std::vector<double>& heights, double pitch_mm, double low_mm, double high_mm)
{
    std::vector<double> missed;
    double last = heights.empty() ? low_mm : heights.front();
    if (!heights.empty())
        for (double h = heights.front() - pitch_mm; h > low_mm; h -= pitch_mm) missed.push_back(h);
    for (std::size_t i = 1; i <= heights.size(); ++i) {
        const double next = i < heights.size() ? heights[i] : high_mm;
        const auto count = static_cast<int>(std::lround(std::min((next - last) / pitch_mm, 1e5))) - 1;
        if (next - last > columnLimits.missing_pitches * pitch_mm)
            for (int k = 1; k <= count; ++k) missed.push_back(last + (next - last) * k / (count + 1));
        last = next;
    }
    if (heights.empty())
        for (double h = low_mm; h < high_mm; h += pitch_mm) missed.push_back(h);
    return missed;
}

/// Adds the rays that passed the wall; false where the points form no columns.
bool addMissed(const std::vector<Vector3d>& on_wall, const Run& run, const WallWindow& window,
               const ScannerAxis& scanner, RimView& view, const Progress& progress)
{
    const ScannerFrame frame(scanner, window.angle_rad);
    std::vector<ColumnPoint> points;
    std::vector<double> angles;
    double low = 1e9, high = -1e9;
    for (const Vector3d& place : on_wall) {
        points.push_back(frame.of(place));
        angles.push_back(points.back().angle_rad);
        low = std::min(low, points.back().height_mm);
        high = std::max(high, points.back().height_mm);
    }
    const std::optional<Columns> columns = columnsOf(angles);
    if (!columns) return false;
    ColumnHeights heights;
    for (const ColumnPoint& point : points) {
        const double number = (point.angle_rad - columns->first_rad) / columns->step_rad;
        heights[static_cast<std::ptrdiff_t>(std::lround(number))].push_back(point.height_mm);
    }
    const std::ptrdiff_t first = heights.begin()->first, last = heights.rbegin()->first;
    for (std::ptrdiff_t number = first; number <= last; ++number)
        std::sort(heights[number].begin(), heights[number].end());
    const double pitch = pitchOf_mm(heights);
    if (!(pitch > 0)) return false;
    const double rays = (high - low) / pitch * static_cast<double>(last - first + 1);
    if (rays > static_cast<double>(columnLimits.most_missing)) return false;
    for (const auto& [number, own] : heights) {
        progress.check();
        const double angle = columns->first_rad + static_cast<double>(number) * columns->step_rad;
        for (const double height : missedHeights(own, pitch, low, high)) {
            const Vector3d place = frame.hit({angle, height}, run, view.radius_mm);
            if (isInWindow(place, window, columnLimits.window_pitches * pitch))
                view.rays.push_back(rayAt(place, window.angle_rad, false));
        }
    }
    view.has_misses = true;
    return true;
}

}  // namespace

double wallLimit_mm(const Model& model)
{
    return markLimits.off_sigmas * model.sigma_mm + markLimits.off_mm;
}

WallWindow withinRun(const Run& run, WallWindow window)
{
    window.from_mm = std::max(window.from_mm, run.nodes_mm.front() + markLimits.edge_margin_mm);
    window.to_mm = std::min(window.to_mm, run.nodes_mm.back() - markLimits.edge_margin_mm);
    return window;
}

std::optional<Columns> columnsOf(std::vector<double> angles_rad)
{
    std::sort(angles_rad.begin(), angles_rad.end());
    std::vector<double> gaps;
    for (std::size_t i = 0; i + 1 < angles_rad.size(); ++i) gaps.push_back(angles_rad[i + 1] - angles_rad[i]);
    if (gaps.size() < columnLimits.least_columns) return std::nullopt;
    std::vector<double> sorted = gaps;
    const double large = std::max(columnLimits.least_step_rad, columnLimits.gap_medians * upperMedianInPlace(sorted));
    std::vector<double> steps;
    for (const double gap : gaps)
        if (gap > large) steps.push_back(gap);
    if (steps.size() < columnLimits.least_columns) return std::nullopt;
    const double low = lowerQuantileInPlace(steps, 0.25), high = lowerQuantileInPlace(steps, 0.75),
                 step = lowerQuantileInPlace(steps, 0.5);
    if (high - low > columnLimits.step_scatter * step) return std::nullopt;
    // Columns: means of the angles between large gaps, numbered by the step; a line through them.
    double count = 0, covered = 0, number = 0, sn = 0, sa = 0, snn = 0, sna = 0, saa = 0;
    std::size_t begin = 0;
    double before = angles_rad.front();
    for (std::size_t i = 0; i < angles_rad.size(); ++i) {
        if (i + 1 < angles_rad.size() && gaps[i] <= step / 2) continue;
        double mean = 0;
        for (std::size_t k = begin; k <= i; ++k) mean += angles_rad[k] / static_cast<double>(i + 1 - begin);
        const double gone = mean - before, steps_gone = begin == 0 ? 0 : std::max(1.0, std::round(gone / step));
        if (begin > 0 && steps_gone == 1) covered += gone;
        number += steps_gone;
        before = mean;
        begin = i + 1;
        count += 1;
        sn += number;
        sa += mean;
        snn += number * number;
        sna += number * mean;
        saa += mean * mean;
    }
    const double vn = snn - sn * sn / count, vna = sna - sn * sa / count, va = saa - sa * sa / count;
    if (count < static_cast<double>(columnLimits.least_columns) || !(vn > 0)) return std::nullopt;
    Columns found{0, vna / vn};
    found.first_rad = (sa - found.step_rad * sn) / count;
    const double rms = std::sqrt(std::max(0.0, va - found.step_rad * vna) / count);
    if (rms > columnLimits.column_share * found.step_rad ||
        covered < columnLimits.least_covered * (angles_rad.back() - angles_rad.front()))
        return std::nullopt;
    return found;
}

RimView raysAt(const WallScan& scan, const Run& run, const WallWindow& window, const Progress& progress)
{
    RimView view;
    view.from_mm = window.from_mm;
    view.to_mm = window.to_mm;
    view.radius_mm = radiusAt_mm(run, (window.from_mm + window.to_mm) / 2);
    const double limit = wallLimit_mm(scan.model);
    std::vector<Vector3d> on_wall;
    for (std::size_t i = 0; i < scan.cloud.z_mm.size(); ++i) {
        const auto z = static_cast<double>(scan.cloud.z_mm[i]);
        if (z < window.from_mm || z > window.to_mm) continue;
        const double angle = turn_rad * static_cast<double>(scan.cloud.turn[i]),
                     r = static_cast<double>(scan.cloud.r_mm[i]);
        if (std::abs(std::remainder(angle - window.angle_rad, turn_rad)) > window.half_rad) continue;
        if (std::abs(r - radiusAt_mm(run, z)) > limit) continue;
        on_wall.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        view.rays.push_back(rayAt(on_wall.back(), window.angle_rad, true));
    }
    if (scan.surface_scan || on_wall.empty()) return view;
    progress.check();
    // An axis that the file does not show is near that of the part, or the columns do not appear.
    if (scan.scanner && addMissed(on_wall, run, window, *scan.scanner, view, progress)) return view;
    addMissed(on_wall, run, window, {}, view, progress);
    return view;
}

}  // namespace lathelier::features
