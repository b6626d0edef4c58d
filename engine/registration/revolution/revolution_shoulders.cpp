#include "engine/registration/revolution/revolution_shoulders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/registration/revolution/measured_faces.h"
#include "engine/registration/revolution/shoulder_rays.h"

namespace lathelier::registration {
namespace {

/// The spot of the scanner, its fit, and the ends of the part (README, "Thresholds").
struct ShoulderThresholds {
    double spurious_probability = 0.003;  ///< that a spurious point is a hit or a miss anywhere
    double other_shape_factor = 1.2;      ///< of the variance of a place, when the spot is of neither shape (a disc)
    double finest_width_steps = 1e-3;     ///< of the profiles: finest width of a spot
    double width_factor = 3;              ///< within which of the estimate widths are tried, to both sides
    int grid_steps = 5;                   ///< of the geometric grid of widths, to each side
    int averaged_widths = 17;             ///< over the likely range
    double likely_difference = 8;       ///< of the negative log-likelihood: wider than that has a weight below e⁻⁸
    double shared_spot_difference = 6;  ///< by which two spots have to be more likely than one for both scans
    int place_steps = 16;               ///< of the scan for a place, over a width to each side
    int zoom_steps = 6;                 ///< of each finer scan to each side
    double zoom = 5;                    ///< by which a scan is finer than the one before
    int coarse_zooms = 1;               ///< enough to compare widths and shapes
    int fine_zooms = 3;                 ///< for the place
    double row_gap_share = 0.25;        ///< of the widest gap between rays: a wider one is a step between rows
    int few_rows = 2;                   ///< steps between rows within a ramp: no more do not separate place and width
    double beside_end_mm = 1;           ///< the radius of a part at its end is that of this stretch
    double squarely_seen = 0.5;         ///< density of a face over that of the sides, from which it is seen as well
    double face_margin_sigmas = 4;      ///< beside the edges of such a face: noise of the sides
};
constexpr ShoulderThresholds shoulderThresholds{};

constexpr double rampPerMisplacement = 6;  // the mean misplacement in a ramp is a sixth of its width
constexpr double leastProduct = 1e-200;    // of probabilities: below it its logarithm is taken, before it underflows

/// Distribution of the places within a spot that the range is taken from: all of its width alike, or falling off from
/// its middle, as that of a round spot or of one with a soft edge.
enum class SpotShape { Uniform, Triangle };
constexpr double triangleShare = std::numbers::sqrt2;  // base of a triangle over the width of the uniform distribution
                                                       // of the same variance

/// The width of a spot is that of the uniform distribution of the same variance.
struct Spot {
    SpotShape shape = SpotShape::Uniform;
    double width_mm = 0;
};

/// The likelihood of one edge for trial places and spot widths.
class EdgeLikelihood {
public:
    EdgeLikelihood(EdgeRays edge, double start) : edge_(std::move(edge)), start_(start)
    {
        hitsBefore_.push_back(0);
        double count = 0, sum = 0;
        for (const Ray& ray : edge_.rays) {
            hitsBefore_.push_back(hitsBefore_.back() + (ray.hit ? 1 : 0));
            if (ray.hit != (ray.height < start)) continue;
            count += 1;
            sum += std::abs(ray.height - start);
        }
        guess_ = count > 0 ? rampPerMisplacement * sum / count : 0;
        density_ = static_cast<double>(edge_.rays.size()) / (edge_.edge.to_mm - edge_.edge.from_mm);
    }

    const Edge& edge() const { return edge_.edge; }
    double widthGuess() const { return guess_; }
    double leanSigma() const { return edge_.lean_sigma_mm; }
    double density() const { return density_; }  ///< rays for each mm of height

    struct Place {
        double height = 0;
        double neg_log_likelihood = 0;  ///< -log of the likelihood
    };

    /// The best place for a spot: a fine scan, then `zooms` finer ones around the best.
    Place findPlace(const Spot& spot, int zooms) const
    {
        Place best{start_, negativeLogLikelihood(start_, spot)};
        double step = spot.width_mm / shoulderThresholds.place_steps;
        for (int zoom = 0; zoom <= zooms; ++zoom, step /= shoulderThresholds.zoom) {
            const double centre = best.height;
            const int reach = zoom == 0 ? shoulderThresholds.place_steps : shoulderThresholds.zoom_steps;
            for (int k = -reach; k <= reach; ++k) {
                const Place trial{centre + k * step, negativeLogLikelihood(centre + k * step, spot)};
                if (trial.neg_log_likelihood < best.neg_log_likelihood) best = trial;
            }
        }
        return best;
    }

    /// Variance of the place from the spacing of the rows. Where the part is parallel to the scanner's rows, rays exist
    /// at few heights only: with one or none of them within the ramp, place and width are not separately identifiable,
    /// and the place is uniform between the adjoining rows.
    double rowVariance(double place, double width) const
    {
        const auto below = [](const Ray& ray, double height) { return ray.height < height; };
        const auto& rays = edge_.rays;
        auto from = std::lower_bound(rays.begin(), rays.end(), place - width / 2, below);
        auto to = std::lower_bound(from, rays.end(), place + width / 2, below);
        if (from != rays.begin()) --from;
        if (to != rays.end()) ++to;
        double gap = 0;
        for (auto ray = from; ray != to && ray + 1 != to; ++ray) gap = std::max(gap, (ray + 1)->height - ray->height);
        int wide = 0;  // steps between rows, those to the rows beside the ramp among them
        for (auto ray = from; ray != to && ray + 1 != to; ++ray)
            wide += (ray + 1)->height - ray->height > shoulderThresholds.row_gap_share * gap ? 1 : 0;
        return wide <= shoulderThresholds.few_rows ? gap * gap / 12 : 0;  // of a uniform distribution
    }

private:
    double negativeLogLikelihood(double place, const Spot& spot) const
    {
        constexpr double spuriousProbability = shoulderThresholds.spurious_probability;
        static const double stray = -std::log(spuriousProbability);
        static const double regular = -std::log(1 - spuriousProbability);
        const auto below = [](const Ray& ray, double height) { return ray.height < height; };
        const auto& rays = edge_.rays;
        const bool is_triangle = spot.shape == SpotShape::Triangle;
        const double half = (is_triangle ? triangleShare : 1) * spot.width_mm / 2;
        const auto from = std::lower_bound(rays.begin(), rays.end(), place - half, below);
        const auto to = std::lower_bound(from, rays.end(), place + half, below);
        // Outside the ramp only counts matter.
        const auto first = static_cast<std::size_t>(from - rays.begin());
        const auto last = static_cast<std::size_t>(to - rays.begin());
        const double hits_before = hitsBefore_[first];
        const double misses_after = static_cast<double>(rays.size() - last) - (hitsBefore_.back() - hitsBefore_[last]);
        double total = (hits_before + misses_after) * stray +
                       (static_cast<double>(first + rays.size() - last) - hits_before - misses_after) * regular;
        const double per_half = 1 / half;
        double product = 1;
        for (auto ray = from; ray != to; ++ray) {
            const double u = (ray->height - place) * per_half;
            const double rest = 1 - std::abs(u);
            const double tail = std::max(0.5 * (is_triangle ? rest * rest : rest), spuriousProbability);
            product *= ray->hit == (u > 0) ? 1 - tail : tail;
            if (product < leastProduct) {
                total -= std::log(product);
                product = 1;
            }
        }
        return total - std::log(product);
    }

    EdgeRays edge_;
    std::vector<double> hitsBefore_;  ///< hits among the first k rays
    double start_;
    double guess_ = 0;
    double density_ = 0;
};

std::vector<EdgeLikelihood> likelihoodsOf(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                          const Progress& progress)
{
    std::vector<EdgeLikelihood> edges;
    for (EdgeRays& edge : findEdgeRays(points, fit, progress))
        if (const auto start = balance(edge.rays)) edges.emplace_back(std::move(edge), *start);
    return edges;
}

using Group = std::vector<const EdgeLikelihood*>;

/// One trial spot for all shoulders of a group.
struct WidthTrial {
    SpotShape shape = SpotShape::Uniform;
    double log_width = 0;
    double neg_log_likelihood = 0;
    std::vector<double> heights;
};

WidthTrial tryWidth(const Group& group, SpotShape shape, double log_width, int zooms, const Progress& progress)
{
    std::vector<EdgeLikelihood::Place> places(group.size());
    parallelFor(group.size(), 1, progress, [&](std::size_t i, std::size_t) {
        places[i] = group[i]->findPlace({shape, std::exp(log_width)}, zooms);
    });
    WidthTrial trial{shape, log_width, 0, {}};
    for (const EdgeLikelihood::Place& place : places) {
        trial.neg_log_likelihood += place.neg_log_likelihood;
        trial.heights.push_back(place.height);
    }
    return trial;
}

std::vector<WidthTrial> tryWidths(const Group& group, SpotShape shape, double from, double to, int count, int zooms,
                                  const Progress& progress)
{
    std::vector<WidthTrial> trials;
    trials.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        trials.push_back(tryWidth(group, shape, from + (to - from) * k / (count - 1), zooms, progress));
    return trials;
}

bool isMoreLikely(const WidthTrial& a, const WidthTrial& b)
{
    return a.neg_log_likelihood < b.neg_log_likelihood;
}

double leastNegativeLogLikelihood(const std::vector<WidthTrial>& trials)
{
    double least = std::numeric_limits<double>::infinity();
    for (const WidthTrial& trial : trials) least = std::min(least, trial.neg_log_likelihood);
    return least;
}

/// Trial widths about the estimate from the misplaced points, on one geometric grid for all groups,
/// so that their likelihoods are comparable; of the shape that is more likely.
std::vector<WidthTrial> coarseTrials(const Group& group, double finest, const Progress& progress)
{
    std::vector<double> guesses;
    for (const EdgeLikelihood* edge : group) guesses.push_back(edge->widthGuess());
    const double middle = upperMedianInPlace(guesses);
    constexpr int grid_steps = shoulderThresholds.grid_steps;
    const double log_step = std::log(shoulderThresholds.width_factor) / grid_steps;
    const double guess = std::round(std::log(std::max(middle / finest, 1.0)) / log_step) * log_step + std::log(finest);
    const auto trials = [&](SpotShape shape, double from, double to, int count) {
        return tryWidths(group, shape, from, to, count, shoulderThresholds.coarse_zooms, progress);
    };
    const double from = guess - grid_steps * log_step, to = guess + grid_steps * log_step;
    std::vector<WidthTrial> uniform = trials(SpotShape::Uniform, from, to, 2 * grid_steps + 1);
    const double best = std::min_element(uniform.begin(), uniform.end(), isMoreLikely)->log_width;
    if (leastNegativeLogLikelihood(trials(SpotShape::Triangle, best - log_step, best + log_step, 3)) >=
        leastNegativeLogLikelihood(uniform))
        return uniform;
    return trials(SpotShape::Triangle, from, to, 2 * grid_steps + 1);
}

/// Trials of the widths that are likely by the coarse ones.
std::vector<WidthTrial> fineTrials(const Group& group, const std::vector<WidthTrial>& coarse, const Progress& progress)
{
    const double least = leastNegativeLogLikelihood(coarse);
    std::size_t first = coarse.size(), last = 0;
    for (std::size_t k = 0; k < coarse.size(); ++k)
        if (coarse[k].neg_log_likelihood < least + shoulderThresholds.likely_difference) {
            first = std::min(first, k);
            last = std::max(last, k);
        }
    first = first > 0 ? first - 1 : 0;
    last = std::min(coarse.size() - 1, last + 1);
    return tryWidths(group, coarse.front().shape, coarse[first].log_width, coarse[last].log_width,
                     shoulderThresholds.averaged_widths, shoulderThresholds.fine_zooms, progress);
}

/// The shoulder number `i` of a group, averaged over the trial widths with weights by likelihood.
Shoulder averageShoulder(const EdgeLikelihood& likelihood, const std::vector<WidthTrial>& trials, std::size_t i)
{
    const double best = leastNegativeLogLikelihood(trials);
    double weight = 0, sum = 0, squares = 0, width = 0;
    for (const WidthTrial& trial : trials) {
        const double w = std::exp(best - trial.neg_log_likelihood);
        const double off = trial.heights[i] - trials.front().heights[i];
        weight += w;
        sum += w * off;
        squares += w * off * off;
        width += w * std::exp(trial.log_width);
    }
    const double mean = sum / weight;
    width /= weight;
    const Edge& edge = likelihood.edge();
    const double density = likelihood.density();
    const double open = std::max(0.0, squares / weight - mean * mean);  // variance from the unknown width
    const double own = shoulderThresholds.other_shape_factor * width * width / (6 * std::max(1.0, width * density)) +
                       1 / (density * density);
    const double height = trials.front().heights[i] + mean;
    const double rows = likelihood.rowVariance(height, width);
    return {height * edge.sign, std::hypot(std::sqrt(own + open + rows), likelihood.leanSigma()), edge.before_mm,
            edge.after_mm};
}

std::vector<Shoulder> averageOverWidths(const Group& group, const std::vector<WidthTrial>& coarse,
                                        const Progress& progress)
{
    const std::vector<WidthTrial> fine = fineTrials(group, coarse, progress);
    std::vector<Shoulder> shoulders;
    for (std::size_t i = 0; i < group.size(); ++i) shoulders.push_back(averageShoulder(*group[i], fine, i));
    return shoulders;
}

/// Where the data of a part end, as a face across the axis that may be there.
std::optional<Shoulder> endOf(const RevolutionFit& fit, bool is_first)
{
    const RadiusProfile& profile = fit.profile;
    const std::size_t count = profile.size();
    const auto bin = [&](std::size_t k) { return is_first ? k : count - 1 - k; };
    std::size_t end = 0;
    while (end < count && std::isnan(profile.radius_mm[bin(end)])) ++end;
    if (end == count) return std::nullopt;
    double radius = 0;  // noise along the axis leaves smaller radii beside the face
    for (std::size_t k = end;
         k < count && static_cast<double>(k - end) * profile.step_mm <= shoulderThresholds.beside_end_mm; ++k)
        if (const double r = profile.radius_mm[bin(k)]; r > radius) radius = r;
    const double z = profile.middle_mm(bin(end)) + (is_first ? -0.5 : 0.5) * profile.step_mm;
    return Shoulder{z, std::numeric_limits<double>::infinity(), is_first ? 0 : radius, is_first ? radius : 0};
}

/// Faces that the scan shows are located from their own points: smaller uncertainty than from the rays beside them.
/// An end without a face is left out.
void placeByFaces(std::vector<Shoulder>& shoulders, std::vector<Shoulder>& ends,
                  const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit, const Progress& progress)
{
    if (fit.bend.isSeen()) return;
    const std::optional<Shoulder> first = endOf(fit, true), last = endOf(fit, false);
    if (first) ends.push_back(*first);
    std::vector<Shoulder*> places;
    if (last) ends.push_back(*last);
    if (first) places.push_back(&ends.front());
    for (Shoulder& s : shoulders) places.push_back(&s);
    if (last) places.push_back(&ends.back());
    std::vector<FaceCandidate> sought;
    sought.reserve(places.size());
    const auto seek = [&](double margin_mm) {
        sought.clear();
        for (const Shoulder* s : places)
            sought.push_back({s->z_mm, std::min(s->before_mm, s->after_mm), std::max(s->before_mm, s->after_mm),
                              s->facing(), margin_mm});
        return measureFaces(points, fit.axis_T_scan, fit.profile, sought, progress);
    };
    // A face that is seen as well as the sides is so up to its edges; of one seen in passing the spot smears them.
    std::vector<MeasuredFace> faces =
        seek(std::min(smearedEdge_mm, shoulderThresholds.face_margin_sigmas * fit.sigma_mm));
    if (std::any_of(faces.begin(), faces.end(),
                    [](const MeasuredFace& face) { return face.density_ratio < shoulderThresholds.squarely_seen; }))
        faces = seek(smearedEdge_mm);
    for (const MeasuredFace& face : faces)
        for (Shoulder* s : places)
            if (s->z_mm == face.sought_mm && face.place_sigma_mm < s->sigma_mm) {
                s->z_mm = face.z_mm;
                s->sigma_mm = face.place_sigma_mm;
                break;
            }
    std::erase_if(ends, [](const Shoulder& end) { return !std::isfinite(end.sigma_mm); });
}

Group groupOf(const std::vector<EdgeLikelihood>& edges)
{
    Group group;
    for (const EdgeLikelihood& edge : edges) group.push_back(&edge);
    return group;
}

/// The shoulders of both parts from the rays beside them, with one spot for both scans or one for each.
void placeByRays(const Group& reference, const Group& copy, double finest_mm, ShoulderPair& result,
                 const Progress& progress)
{
    Group both = reference;
    both.insert(both.end(), copy.begin(), copy.end());
    const std::vector<WidthTrial> own1 = coarseTrials(reference, finest_mm, progress);
    const std::vector<WidthTrial> own2 = coarseTrials(copy, finest_mm, progress);
    const std::vector<WidthTrial> shared = coarseTrials(both, finest_mm, progress);
    if (leastNegativeLogLikelihood(shared) < leastNegativeLogLikelihood(own1) + leastNegativeLogLikelihood(own2) +
                                                 shoulderThresholds.shared_spot_difference) {
        const std::vector<Shoulder> all = averageOverWidths(both, shared, progress);
        const auto split = all.begin() + static_cast<std::ptrdiff_t>(reference.size());
        result.reference.assign(all.begin(), split);
        result.copy.assign(split, all.end());
    } else {
        result.reference = averageOverWidths(reference, own1, progress);
        result.copy = averageOverWidths(copy, own2, progress);
    }
}

}  // namespace

ShoulderPair findShoulders(const std::vector<Eigen::Vector3d>& reference_points, const RevolutionFit& reference,
                           const std::vector<Eigen::Vector3d>& copy_points, const RevolutionFit& copy,
                           const Progress& progress)
{
    const std::vector<EdgeLikelihood> reference_edges = likelihoodsOf(reference_points, reference, progress);
    const std::vector<EdgeLikelihood> copy_edges = likelihoodsOf(copy_points, copy, progress);
    const double finest_mm =
        shoulderThresholds.finest_width_steps * std::min(reference.profile.step_mm, copy.profile.step_mm);
    ShoulderPair result;
    if (!reference_edges.empty() && !copy_edges.empty())
        placeByRays(groupOf(reference_edges), groupOf(copy_edges), finest_mm, result, progress);
    placeByFaces(result.reference, result.reference_ends, reference_points, reference, progress);
    placeByFaces(result.copy, result.copy_ends, copy_points, copy, progress);
    return result;
}

}  // namespace lathelier::registration
