#include "engine/form/roundness_uncertainty.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/form/linear_minimax.h"
#include "engine/signal/hampel.h"

namespace lathelier {
namespace {

using Eigen::Vector2d;

constexpr std::size_t leastPoints = 32;
constexpr std::uint64_t seed = 12181;  ///< any; always the same
constexpr double reach_sigma = 12;     ///< points further inside the zone than this touch it in no draw

/// So many draws that the work stays about the same.
std::size_t drawsFor(std::size_t points)
{
    return std::clamp<std::size_t>(800000 / points, 24, 200);
}

/// The zone about the circle found, linear in the step of the centre.
struct Zone {
    std::vector<double> distance_mm;  ///< of all points
    std::vector<Vector2d> direction;
    std::vector<std::size_t> near;  ///< points that may touch in a draw
};

Zone zoneAbout(const std::vector<Vector2d>& points, const AngularSampling& sampling, const FittedCircle& circle,
               double noise_mm)
{
    Zone zone;
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const Vector2d& point : points) {
        const Vector2d ray = point - circle.centre_mm;
        const double distance = ray.norm();
        zone.distance_mm.push_back(distance);
        zone.direction.push_back(ray / distance);
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    // On an arc the centre is loose and any point may come to touch.
    const bool arc = sampling.largest_gap_rad > std::numbers::pi / 2;
    const double reach = arc ? std::numeric_limits<double>::infinity() : reach_sigma * noise_mm;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (zone.distance_mm[i] >= farthest - reach || zone.distance_mm[i] <= nearest + reach) zone.near.push_back(i);
    return zone;
}

/// The centre's step that least squares takes for the changes `noise`.
Vector2d leastSquaresStep(const Zone& zone, const std::vector<double>& noise)
{
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < noise.size(); ++i) {
        const Eigen::Vector3d row(zone.direction[i].x(), zone.direction[i].y(), 1);
        normal.noalias() += row * row.transpose();
        right += row * noise[i];
    }
    const Eigen::Matrix3d inverse = normal.inverse();
    return (inverse * right).head<2>();
}

/// RONt of one draw, in mm.
double drawnDeviation(const Zone& zone, const std::vector<double>& noise, ReferenceCircle which, double half)
{
    LinearDistances distances;
    const bool largest = which == ReferenceCircle::MCCI;  // the largest distance is minus the smallest of the negatives
    for (const std::size_t i : zone.near) {
        const double distance = zone.distance_mm[i] + noise[i];
        if (largest)
            distances.push(-distance, -zone.direction[i]);
        else
            distances.push(distance, zone.direction[i]);
    }
    Vector2d step = Vector2d::Zero();
    if (which == ReferenceCircle::LSCI)
        step = leastSquaresStep(zone, noise);
    else
        step =
            minimax(distances, which == ReferenceCircle::MZCI ? MinimaxGoal::Width : MinimaxGoal::Nearest, half).step;
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for (const std::size_t i : zone.near) {
        const double distance = zone.distance_mm[i] + noise[i] - zone.direction[i].dot(step);
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    return farthest - nearest;
}

}  // namespace

double pointNoise_um(const PreparedProfile& prepared)
{
    const std::vector<double>& d = prepared.distance_mm;
    if (d.size() < leastPoints) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> third;
    for (std::size_t i = 0; i + 3 < d.size(); ++i)
        third.push_back(std::abs(d[i + 3] - 3 * d[i + 2] + 3 * d[i + 1] - d[i]));
    return 1000 * 1.4826 * median(std::move(third)) / std::sqrt(20.0);
}

double expandedUncertainty_um(const PreparedProfile& prepared, const std::vector<Vector2d>& evaluated_mm,
                              const ProfileBand& band, ReferenceCircle which, const FittedCircle& circle,
                              double noise_um, const Progress& progress)
{
    if (!std::isfinite(noise_um)) return noise_um;
    if (noise_um == 0) return 0;
    const std::size_t n = evaluated_mm.size();
    const double noise_mm = noise_um / 1000;
    const Zone zone = zoneAbout(evaluated_mm, prepared.sampling, circle, noise_mm);
    const double half = circle.outer_radius_mm / 2;
    const std::size_t draws = drawsFor(n);
    const auto part = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t draw = begin; draw < end; ++draw) {
            std::vector<double> noise(n, 0.0);
            const bool all = !band.isAll() || which == ReferenceCircle::LSCI;
            const auto fill = [&](std::size_t i) { noise[i] = noise_mm * randomNormal(seed, draw, i); };
            if (all)
                for (std::size_t i = 0; i < n; ++i) fill(i);
            else
                for (const std::size_t i : zone.near) fill(i);
            // Nearly even spacing is enough for the filter of noise.
            noise = filterClosed(noise, band);
            const double change = drawnDeviation(zone, noise, which, half) - circle.RONt_um / 1000;
            sum += change * change;
        }
        return sum;
    };
    const double sum = parallelReduce(draws, 4, progress, 0.0, part, [](double a, double b) { return a + b; });
    return 2000 * std::sqrt(sum / static_cast<double>(draws));
}

}  // namespace lathelier
