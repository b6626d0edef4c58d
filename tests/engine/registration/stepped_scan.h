// Scans of stepped shafts: sampled evenly over the surface, or by a rotary scanner whose range is the mean over its
// spot.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "engine/core/scan.h"

namespace lathelier::testing_steps {

/// A cylinder of the shaft, from where the one before it ends.
struct Step {
    double length_mm = 0;
    double radius_mm = 0;
};
using Steps = std::vector<Step>;

inline double lengthOf(const Steps& shaft)
{
    double length = 0;
    for (const Step& step : shaft) length += step.length_mm;
    return length;
}

/// Points of sides, shoulders and end faces, as many on each mm², with noise in all directions. What lies before
/// `from_mm` or beyond `to_mm` is lost.
inline Scan scanEvenly(const Steps& shaft, std::size_t count, double sigma_mm, double from_mm, double to_mm,
                       const Eigen::Isometry3d& scan_T_part, std::uint64_t seed)
{
    struct Ring {
        double area, z_from, z_to, inner, outer;
    };
    std::vector<Ring> rings;
    double area = 0;
    const auto add = [&](double own, double z_from, double z_to, double inner, double outer) {
        area += own;
        rings.push_back({area, z_from, z_to, inner, outer});
    };
    double z = 0;
    double before = 0;
    for (std::size_t k = 0; k <= shaft.size(); ++k) {
        const double radius = k < shaft.size() ? shaft[k].radius_mm : 0;
        const auto [inner, outer] = std::minmax(before, radius);
        add(std::numbers::pi * (outer * outer - inner * inner), z, z, inner, outer);
        if (k == shaft.size()) break;
        add(2 * std::numbers::pi * radius * shaft[k].length_mm, z, z + shaft[k].length_mm, radius, radius);
        z += shaft[k].length_mm;
        before = radius;
    }
    Scan scan;
    for (std::uint64_t k = 0; scan.points_mm.size() < count; ++k) {
        const auto uniform = [&](std::uint64_t stream) { return randomUniform(seed, stream, k); };
        const double place = area * uniform(1);
        const auto ring = std::find_if(rings.begin(), rings.end(), [&](const Ring& r) { return place <= r.area; });
        const double u = uniform(2);
        const double r =
            std::sqrt(ring->inner * ring->inner + u * (ring->outer * ring->outer - ring->inner * ring->inner));
        const double turn = 2 * std::numbers::pi * uniform(3);
        const Eigen::Vector3d noise(randomNormal(seed, 4, k), randomNormal(seed, 5, k), randomNormal(seed, 6, k));
        const Eigen::Vector3d point =
            Eigen::Vector3d(r * std::cos(turn), r * std::sin(turn), ring->z_from + u * (ring->z_to - ring->z_from)) +
            sigma_mm * noise;
        if (point.z() >= from_mm && point.z() <= to_mm) scan.points_mm.emplace_back(scan_T_part * point);
    }
    return scan;
}

/// Any position within 9 mm, any direction within 0.1 rad of the z axis, and any turn about the part.
inline Eigen::Isometry3d poseOf(std::uint64_t seed)
{
    std::uint64_t drawn = 0;
    const auto draw = [&] { return 2 * randomUniform(seed, 61, drawn++) - 1; };
    const Eigen::Vector3d shift(9 * draw(), 9 * draw(), 9 * draw());
    const Eigen::Vector3d about = Eigen::Vector3d(draw(), draw(), 0.1).normalized();
    return Eigen::Translation3d(shift) * Eigen::AngleAxisd(0.1 * draw(), about) *
           Eigen::AngleAxisd(std::numbers::pi * draw(), Eigen::Vector3d::UnitZ());
}

/// Raises a disc `across_mm` wide on one of the sides, anywhere but within 4 mm of its edges.
inline void addPlateau(Scan& scan, const Eigen::Isometry3d& scan_T_part, const Steps& shaft, double height_mm,
                       double across_mm, std::uint64_t seed)
{
    constexpr double margin_mm = 4;
    const auto k = static_cast<std::size_t>(randomUniform(seed, 66, 0) * static_cast<double>(shaft.size()));
    double z = margin_mm + (shaft[k].length_mm - 2 * margin_mm) * randomUniform(seed, 66, 1);
    for (std::size_t i = 0; i < k; ++i) z += shaft[i].length_mm;
    const double angle = 2 * std::numbers::pi * randomUniform(seed, 66, 2);
    const Eigen::Isometry3d part_T_scan = scan_T_part.inverse();
    for (Eigen::Vector3d& point : scan.points_mm) {
        Eigen::Vector3d p = part_T_scan * point;
        const double turn = std::remainder(std::atan2(p.y(), p.x()) - angle, 2 * std::numbers::pi);
        if (std::hypot(p.z() - z, shaft[k].radius_mm * turn) > across_mm / 2) continue;
        p.head<2>() += height_mm * p.head<2>().normalized();
        point = scan_T_part * p;
    }
}

struct StepScans {
    Scan reference, copy;
};

/// A shaft of three steps twice, the copy with a plateau `height_mm` high and 4 mm across; 0: none.
inline StepScans stepsTwice(std::size_t count, double sigma_mm, double height_mm, std::uint64_t seed)
{
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const Steps shaft{{25, 15}, {20, 19}, {30, 13}};
    const auto scan = [&](std::uint64_t stream) {
        return scanEvenly(shaft, count, sigma_mm, -everywhere, everywhere, poseOf(stream), stream);
    };
    const std::uint64_t stream = 9001 + 2 * seed;
    StepScans scans{scan(stream - 1), scan(stream)};
    if (height_mm > 0) addPlateau(scans.copy, poseOf(stream), shaft, height_mm, 4, seed);
    return scans;
}

/// A scanner as sample::ScannerModel, but its range is the mean over the height of the spot.
struct MeanSpotScanner {
    double row_pitch_mm = 0.1;
    double angle_step_deg = 3.6;
    double spot_mm = 0.15;
    double sigma_mm = 0.05;
    double z_from_mm = -std::numeric_limits<double>::infinity();  ///< of the rows, in the scanner's frame
    double z_to_mm = std::numeric_limits<double>::infinity();
    std::uint64_t seed = 1;
};

/// Distance from `origin` along `direction`, both in the part's frame, to the sides and shoulders; infinite: a miss.
inline double rangeOn(const Steps& shaft, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction)
{
    double nearest = std::numeric_limits<double>::infinity();
    const double a = direction.head<2>().squaredNorm();
    const double b = origin.head<2>().dot(direction.head<2>());
    double z = 0;
    for (std::size_t k = 0; k < shaft.size(); ++k) {
        const double c = origin.head<2>().squaredNorm() - shaft[k].radius_mm * shaft[k].radius_mm;
        const double end = z + shaft[k].length_mm;
        if (b * b >= a * c) {
            const double t = (-b - std::sqrt(b * b - a * c)) / a;
            const double at = origin.z() + t * direction.z();
            if (at >= z && at <= end) nearest = std::min(nearest, t);
        }
        if (k + 1 < shaft.size() && direction.z() != 0) {
            const double t = (end - origin.z()) / direction.z();
            const double r = (origin + t * direction).head<2>().norm();
            const auto [inner, outer] = std::minmax(shaft[k].radius_mm, shaft[k + 1].radius_mm);
            if (t > 0 && r >= inner && r <= outer) nearest = std::min(nearest, t);
        }
        z = end;
    }
    return nearest;
}

inline Scan scanByMeanSpot(const Steps& shaft, const MeanSpotScanner& scanner, const Eigen::Isometry3d& scan_T_part)
{
    constexpr int spotPlaces = 9;
    constexpr double away_mm = 200;
    const Eigen::Isometry3d part_T_scan = scan_T_part.inverse();
    const double end1 = scan_T_part.translation().z();
    const double end2 = (scan_T_part * Eigen::Vector3d(0, 0, lengthOf(shaft))).z();
    const double from = std::max(scanner.z_from_mm, std::min(end1, end2) - 5);
    const double to = std::min(scanner.z_to_mm, std::max(end1, end2) + 5);
    const int columns = static_cast<int>(std::lround(360 / scanner.angle_step_deg));
    const double phase = randomUniform(scanner.seed, 1, 0);
    Scan scan;
    std::uint64_t ray = 0;
    for (double height = from + phase * scanner.row_pitch_mm; height <= to; height += scanner.row_pitch_mm)
        for (int column = 0; column < columns; ++column, ++ray) {
            const double angle = 2 * std::numbers::pi * (column + phase) / columns;
            const Eigen::Vector3d direction(-std::cos(angle), -std::sin(angle), 0);
            const Eigen::Vector3d origin = Eigen::Vector3d(0, 0, height) - away_mm * direction;
            double range = 0;
            for (int k = 0; k < spotPlaces; ++k) {
                const double place = scanner.spot_mm * ((k + 0.5) / spotPlaces - 0.5);
                range += rangeOn(shaft, part_T_scan * (origin + Eigen::Vector3d(0, 0, place)),
                                 part_T_scan.linear() * direction) /
                         spotPlaces;
            }
            if (!std::isfinite(range)) continue;
            scan.points_mm.emplace_back(origin +
                                        (range + scanner.sigma_mm * randomNormal(scanner.seed, 2, ray)) * direction);
        }
    return scan;
}

}  // namespace lathelier::testing_steps
