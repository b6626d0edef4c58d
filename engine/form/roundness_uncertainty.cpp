#include "engine/form/roundness_uncertainty.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/form/linear_minimax.h"
#include "engine/signal/hampel.h"
#include "engine/signal/nonuniform_fourier.h"

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

/// The form without its noise: the harmonics that stand out of it, filtered. A second measurement of the measured
/// points would lay noise on noise, and the maxima of the second tell too little of what the first have added. On an
/// arc, where there are no harmonics, the points as they are.
std::vector<Vector2d> quietPoints(const PreparedProfile& prepared, const std::vector<Vector2d>& evaluated_mm,
                                  const std::vector<Harmonic>& harmonics, const ProfileBand& band, double noise_um,
                                  const Progress& progress)
{
    if (harmonics.empty()) return evaluated_mm;
    const double floor_um = noiseFloor_um(noise_um, evaluated_mm.size());
    std::vector<std::complex<double>> coefficients(harmonics.size() + 1);
    for (const Harmonic& h : harmonics)
        if (h.amplitude > floor_um)
            coefficients[static_cast<std::size_t>(h.upr)] =
                std::polar(h.amplitude / 2000 * band.transmission(h.upr), -h.phase_rad);
    const std::vector<double>& angle = prepared.sampling.angle_rad;
    const std::vector<double> deviation = fourierSeries(coefficients, angle, progress);
    std::vector<Vector2d> points;
    for (std::size_t i = 0; i < angle.size(); ++i)
        points.push_back(prepared.centre_mm +
                         (prepared.radius_mm + deviation[i]) * Vector2d(std::cos(angle[i]), std::sin(angle[i])));
    return points;
}

/// The zone about the circle found, linear in the step of the centre.
struct Zone {
    std::vector<double> distance_mm;  ///< of all points
    std::vector<Vector2d> direction;
    std::vector<std::size_t> near;  ///< points that may touch in a draw
    bool fixed = false;             ///< the centre is held by the region allowed, not by points
};

Zone zoneAbout(const std::vector<Vector2d>& points, const AngularSampling& sampling, const FittedCircle& circle,
               double noise_mm)
{
    Zone zone;
    zone.fixed = circle.held;
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const Vector2d& point : points) {
        const Vector2d ray = point - circle.centre_mm;
        const double distance = ray.norm();
        zone.distance_mm.push_back(distance);
        zone.direction.push_back(ray / distance);
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    // The circle of the points with noise is off the one of those without, by less than this.
    const double off = circle.RONt_um / 1000 - (farthest - nearest);
    // On an arc the centre is loose and any point may come to touch.
    const bool arc = sampling.largest_gap_rad > std::numbers::pi / 2;
    const double reach = arc ? std::numeric_limits<double>::infinity() : reach_sigma * noise_mm + 2 * std::abs(off);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (zone.distance_mm[i] >= farthest - reach || zone.distance_mm[i] <= nearest + reach) zone.near.push_back(i);
    return zone;
}

/// The centre's step that least squares takes.
Vector2d leastSquaresStep(const Zone& zone, const std::vector<double>& noise)
{
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < noise.size(); ++i) {
        const Eigen::Vector3d row(zone.direction[i].x(), zone.direction[i].y(), 1);
        normal.noalias() += row * row.transpose();
        right += row * (zone.distance_mm[i] - zone.distance_mm[0] + noise[i]);
    }
    const Eigen::Matrix3d inverse = normal.inverse();
    return (inverse * right).head<2>();
}

/// RONt of one draw (or of the quiet form, without noise), in mm.
double drawnDeviation(const Zone& zone, const std::vector<double>& noise, ReferenceCircle which, double half)
{
    Vector2d step = Vector2d::Zero();
    if (which == ReferenceCircle::LSCI) {
        step = leastSquaresStep(zone, noise);
    } else if (!zone.fixed) {
        LinearDistances<2> distances;
        for (const std::size_t i : zone.near) distances.push(zone.distance_mm[i] + noise[i], zone.direction[i]);
        const MinimaxGoal goal = which == ReferenceCircle::MZCI   ? MinimaxGoal::Width
                                 : which == ReferenceCircle::MICI ? MinimaxGoal::Nearest
                                                                  : MinimaxGoal::Farthest;
        step = minimax(distances, goal, half).step;
    }
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

double noiseFloor_um(double noise_um, std::size_t points)
{
    return std::isfinite(noise_um) ? 4 * noise_um * std::sqrt(2 / static_cast<double>(points)) : 0;
}

double expandedUncertainty_um(const PreparedProfile& prepared, const std::vector<Vector2d>& evaluated_mm,
                              const std::vector<Harmonic>& harmonics, const ProfileBand& band, ReferenceCircle which,
                              const FittedCircle& circle, double noise_um, const Progress& progress)
{
    if (!std::isfinite(noise_um)) return noise_um;
    if (noise_um == 0) return 0;
    const std::size_t n = evaluated_mm.size();
    const double noise_mm = noise_um / 1000;
    const Zone zone = zoneAbout(quietPoints(prepared, evaluated_mm, harmonics, band, noise_um, progress),
                                prepared.sampling, circle, noise_mm);
    const double half = circle.outer_radius_mm / 2;
    const double quiet = drawnDeviation(zone, std::vector<double>(n, 0.0), which, half);
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
            const double change = drawnDeviation(zone, filterClosed(noise, band), which, half) - quiet;
            sum += change * change;
        }
        return sum;
    };
    const double sum = parallelReduce(draws, 4, progress, 0.0, part, [](double a, double b) { return a + b; });
    return 2000 * std::sqrt(sum / static_cast<double>(draws));
}

}  // namespace lathelier
