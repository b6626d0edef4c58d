#include "engine/form/roundness/roundness_uncertainty.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <unsupported/Eigen/SpecialFunctions>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/form/linear_minimax.h"
#include "engine/form/roundness/drawn_changes.h"
#include "engine/form/roundness/noise_draws.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;

constexpr double slack_sigma = 3;   ///< assumed inward shift of the zone edges in a draw, in standard deviations
constexpr double reach_sigma = 12;  ///< points further inside the zone are never contacts, in standard deviations

/// Number of draws for a roughly constant total cost.
std::size_t drawsFor(std::size_t points)
{
    return std::clamp<std::size_t>(800000 / points, 10, 200);
}

/// The form without its noise, filtered. Simulating on the measured points would add noise to noise, and its effect on
/// the extremes would be underestimated.
std::vector<Vector2d> quietPoints(const PreparedProfile& prepared, const PointNoise& noise,
                                  const signal::TransmissionBand& band, const Progress& progress)
{
    std::vector<double> filtered;
    if (!band.isAll()) filtered = filterClosedAt(prepared.sampling, noise.form_um, band, progress).values;
    const std::vector<double>& form = band.isAll() ? noise.form_um : filtered;
    std::vector<Vector2d> points;
    points.reserve(form.size());
    for (std::size_t i = 0; i < form.size(); ++i) {
        const Vector2d ray = prepared.points_mm[i] - prepared.centre_mm;
        const double angle = prepared.sampling.angle_rad[i];
        const Vector2d direction = prepared.distance_mm[i] > 0 ? Vector2d(ray / prepared.distance_mm[i])
                                                               : Vector2d(std::cos(angle), std::sin(angle));
        points.push_back(prepared.centre_mm + (prepared.radius_mm + form[i] / 1000) * direction);
    }
    return points;
}

/// The zone about the circle found, linear in the step of the centre.
struct Zone {
    std::vector<double> distance_mm;  ///< distance of each point from the centre
    std::vector<Vector2d> direction;
    std::vector<std::size_t> near;  ///< indices of the points that may become contacts
    std::vector<double> rarity;     ///< for each of these: probability of coming near the zone edges in a draw
    bool fixed = false;             ///< the centre is determined by the feasible region, not by contacts
};

Zone zoneAbout(const std::vector<Vector2d>& points, const signal::AngularSampling& sampling, const FittedCircle& circle,
               const PointNoise& noise)
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
    // Bound on the centre shift caused by noise.
    const double off = circle.RONt_um / 1000 - (farthest - nearest);
    // On an arc the centre is ill-determined and any point may become a contact.
    const bool arc = sampling.largest_gap_rad > std::numbers::pi / 2;
    double spike_um = 0;
    for (const double s : noise.spikes_um) spike_um = std::max(spike_um, std::abs(s));
    const double reach =
        arc ? std::numeric_limits<double>::infinity()
            : (reach_sigma * noise.sigma_um + 2 * (spike_um + noise.resolution_um)) / 1000 + 2 * std::abs(off);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (zone.distance_mm[i] >= farthest - reach || zone.distance_mm[i] <= nearest + reach) {
            zone.near.push_back(i);
            const double depth_mm = std::min(farthest - zone.distance_mm[i], zone.distance_mm[i] - nearest);
            const double needed = arc ? 0 : 1000 * (depth_mm - 2 * std::abs(off)) / noise.sigma_um - slack_sigma;
            zone.rarity.push_back(needed > 0 ? std::exp(-needed * needed / 2) : 1);
        }
    return zone;
}

/// Least-squares step of the centre.
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

struct Extent {
    double nearest_mm = std::numeric_limits<double>::infinity(), farthest_mm = -nearest_mm;
    double width_mm() const { return farthest_mm - nearest_mm; }
};

/// Of the zone about the centre that made `step`.
Extent extentAfter(const Vector2d& step, const Zone& zone, const std::vector<double>& noise,
                   const std::vector<std::size_t>& touching)
{
    Extent extent;
    for (const std::size_t i : touching) {
        const double distance = zone.distance_mm[i] + noise[i] - zone.direction[i].dot(step);
        extent.nearest_mm = std::min(extent.nearest_mm, distance);
        extent.farthest_mm = std::max(extent.farthest_mm, distance);
    }
    return extent;
}

/// Step of the centre for the circles other than LSCI.
Vector2d minimaxStep(const Zone& zone, const std::vector<double>& noise, const std::vector<std::size_t>& touching,
                     ReferenceCircle which, double half)
{
    if (zone.fixed) return Vector2d::Zero();
    LinearDistances<2> distances;
    for (const std::size_t i : touching) distances.push(zone.distance_mm[i] + noise[i], zone.direction[i]);
    const MinimaxGoal goal = which == ReferenceCircle::MZCI   ? MinimaxGoal::Width
                             : which == ReferenceCircle::MICI ? MinimaxGoal::Nearest
                                                              : MinimaxGoal::Farthest;
    return minimax(distances, goal, half).step;
}

/// RONt of one draw (or of the noise-free form), in mm. Only the points in `touching` can be contacts.
double drawnDeviation(const Zone& zone, const std::vector<double>& noise, const std::vector<std::size_t>& touching,
                      ReferenceCircle which, double half)
{
    const Vector2d step = which == ReferenceCircle::LSCI ? leastSquaresStep(zone, noise)
                                                         : minimaxStep(zone, noise, touching, which, half);
    return extentAfter(step, zone, noise, touching).width_mm();
}

/// Long profiles: neighbours on one nearly constant piece of the form are combined into a block. Of independent normal
/// noise on its m points only maximum, minimum and mean matter, and each can be drawn directly.
class Blocks {
public:
    /// Empty when the profile is short, or its form too steep for blocks.
    static std::optional<Blocks> of(const std::vector<Vector2d>& points, const FittedCircle& circle,
                                    const PointNoise& noise)
    {
        constexpr std::size_t enough = 16384, least = 4;
        const std::size_t width = points.size() / enough;
        if (width < least) return std::nullopt;
        Blocks blocks(points, circle, width, noise.sigma_um / 1000);
        return blocks.areFlat(noise.sigma_um / 1000) ? std::optional(std::move(blocks)) : std::nullopt;
    }

    std::size_t count() const { return mean_.distance_mm.size(); }

    /// RONt in mm of the form alone.
    double quietDeviation(ReferenceCircle which, double half) const
    {
        const std::vector<double> none(edges_.near.size(), 0.0), no_means(count(), 0.0);
        const Vector2d step = stepOf(none, no_means, edges_.near, which, half);
        return extentAfter(step, edges_, none, edges_.near).width_mm();
    }

    /// RONt in mm of the form with the noise of one draw.
    double deviation(std::uint64_t draw, double sigma_mm, ReferenceCircle which, double half) const
    {
        std::vector<double> means;
        if (which == ReferenceCircle::LSCI)
            for (std::size_t b = 0; b < count(); ++b)
                means.push_back(sigma_mm / std::sqrt(width_) * randomNormal(drawSeed + 1, draw, b));
        std::vector<double> noise(edges_.near.size(), 0.0);
        std::vector<std::size_t> touching;
        for (const bool all : {false, true}) {
            touching.clear();
            for (const std::size_t i : edges_.near) {
                const double uniform = randomUniform(drawSeed, draw, i);
                if (!all && uniform > edges_.rarity[i]) continue;
                noise[i] = (i % 2 == 0 ? -sigma_mm : sigma_mm) * largest(1 - uniform);
                touching.push_back(i);
            }
            if (touching.empty()) continue;
            const Vector2d step = stepOf(noise, means, touching, which, half);
            const Extent extent = extentAfter(step, edges_, noise, touching);
            // If one of the other points leaves the zone, which is rare, all are drawn.
            const double least = beyond * sigma_mm + step.norm();
            if (all ||
                (extent.farthest_mm >= quiet_.farthest_mm + least && extent.nearest_mm <= quiet_.nearest_mm - least))
                return extent.width_mm();
        }
        return 0;
    }

private:
    Blocks(const std::vector<Vector2d>& points, const FittedCircle& circle, std::size_t width, double sigma_mm)
        : width_(static_cast<double>(width))
    {
        edges_.fixed = circle.held;
        const auto add = [](Zone& zone, double distance, const Vector2d& direction) {
            zone.near.push_back(zone.near.size());
            zone.distance_mm.push_back(distance);
            zone.direction.push_back(direction);
        };
        for (std::size_t begin = 0; begin < points.size(); begin += width) {
            const std::size_t end = std::min(points.size(), begin + width);
            double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
            Vector2d middle = Vector2d::Zero();
            for (std::size_t i = begin; i < end; ++i) {
                const Vector2d ray = points[i] - circle.centre_mm;
                nearest = std::min(nearest, ray.norm());
                farthest = std::max(farthest, ray.norm());
                middle += ray / static_cast<double>(end - begin);
            }
            const Vector2d direction = middle.normalized();
            add(edges_, nearest, direction);
            add(edges_, farthest, direction);
            add(mean_, (nearest + farthest) / 2, direction);
            quiet_.nearest_mm = std::min(quiet_.nearest_mm, nearest);
            quiet_.farthest_mm = std::max(quiet_.farthest_mm, farthest);
        }
        for (std::size_t b = 0; b < count(); ++b) {
            edges_.rarity.push_back(rarityOf(edges_.distance_mm[2 * b] - quiet_.nearest_mm, sigma_mm));
            edges_.rarity.push_back(rarityOf(quiet_.farthest_mm - edges_.distance_mm[2 * b + 1], sigma_mm));
        }
    }

    Vector2d stepOf(const std::vector<double>& noise, const std::vector<double>& means,
                    const std::vector<std::size_t>& touching, ReferenceCircle which, double half) const
    {
        return which == ReferenceCircle::LSCI ? leastSquaresStep(mean_, means)
                                              : minimaxStep(edges_, noise, touching, which, half);
    }

    /// Whether the form is nearly constant within blocks compared with the noise; one block in a hundred may exceed
    /// this.
    bool areFlat(double sigma_mm) const
    {
        std::size_t steep = 0;
        for (std::size_t b = 0; b < count(); ++b)
            steep += edges_.distance_mm[2 * b + 1] - edges_.distance_mm[2 * b] > 0.25 * sigma_mm;
        return 100 * steep <= count();
    }

    /// Probability that a block extreme lying `deep` inside the form's extreme exceeds it by more than `beyond`.
    double rarityOf(double deep_mm, double sigma_mm) const
    {
        const double beyond_here = 0.5 * std::erfc((deep_mm / sigma_mm + beyond) / std::numbers::sqrt2);
        return -std::expm1(width_ * std::log1p(-beyond_here));
    }

    /// The largest of as many normal deviates as a block has points; `uniform` in (0, 1].
    double largest(double uniform) const { return -Eigen::numext::ndtri(-std::expm1(std::log(uniform) / width_)); }

    /// Lower bound, in standard deviations, of the outward shift of the zone edges by the noise of many blocks.
    static constexpr double beyond = 1;

    double width_;
    Zone edges_;  ///< of each block the nearest, then the farthest point of the form
    Zone mean_;
    Extent quiet_;
};

}  // namespace

double expandedUncertainty_um(const PreparedProfile& prepared, const PointNoise& noise,
                              const signal::TransmissionBand& band, ReferenceCircle which, const FittedCircle& circle,
                              const Progress& progress)
{
    if (!std::isfinite(noise.sigma_um)) return noise.sigma_um;
    if (noise.sigma_um == 0 && noise.spikes_um.empty()) return 0;
    const std::size_t n = prepared.distance_mm.size();
    const bool plain = NoiseDraws::isPlain(noise, band);
    std::vector<Vector2d> form = quietPoints(prepared, noise, band, progress);
    const double half = circle.outer_radius_mm / 2;
    // With few points correlated noise is hardly separable from form; factor from simulation of the noise kinds in the
    // tests.
    const double few = 1 + 6 / static_cast<double>(n);
    if (const auto blocks = plain ? Blocks::of(form, circle, noise) : std::nullopt) {
        const double quiet = blocks->quietDeviation(which, half);
        std::vector<double> changes(drawsFor(blocks->count()));
        parallelFor(changes.size(), 1, progress, [&](std::size_t k, std::size_t) {
            changes[k] = 1000 * (blocks->deviation(k, noise.beyond_rounding_um / 1000, which, half) - quiet);
        });
        return few * coverageHalfWidth(std::move(changes), noise.relative_u);
    }
    const std::size_t stride = strideOf(noise, band, n), drawn_points = (n + stride - 1) / stride;
    for (std::size_t i = 0; i < drawn_points; ++i) form[i] = form[i * stride];
    form.resize(drawn_points);
    const Zone zone = zoneAbout(form, prepared.sampling, circle, noise);
    const double quiet = drawnDeviation(zone, std::vector<double>(drawn_points, 0.0), zone.near, which, half);
    std::vector<double> changes(drawsFor(drawn_points));
    parallelFor(changes.size(), 4, progress, [&](std::size_t begin, std::size_t end) {
        const NoiseDraws draw(prepared, noise, band, stride);
        std::vector<double> drawn(drawn_points);
        std::vector<std::size_t> touching;
        for (std::size_t k = begin; k < end; ++k) {
            progress.check();
            if (!plain) {
                drawn = draw(k, progress);
            } else if (which == ReferenceCircle::LSCI) {
                for (std::size_t i = 0; i < drawn_points; ++i) drawn[i] = draw.plain_mm(k, i);
            } else {
                touching.clear();
                for (std::size_t j = 0; j < zone.near.size(); ++j) {
                    const double own = draw.plainBeyond_mm(k, zone.near[j], zone.rarity[j]);
                    if (own == 0 && zone.rarity[j] < 1) continue;
                    drawn[zone.near[j]] = own;
                    touching.push_back(zone.near[j]);
                }
            }
            progress.check();
            const bool some = plain && which != ReferenceCircle::LSCI;
            changes[k] = 1000 * (drawnDeviation(zone, drawn, some ? touching : zone.near, which, half) - quiet);
        }
    });
    return few * coverageHalfWidth(std::move(changes), noise.relative_u);
}

double nominalRadiusEffect_um(const Profile& profile, const PreparedProfile& prepared)
{
    if (!profile.size_is_nominal || !(prepared.radius_mm > 0)) return 0;
    const double e = prepared.centre_mm.norm();
    return 1000 * e * e / (2 * prepared.radius_mm);
}

}  // namespace lathelier::form
