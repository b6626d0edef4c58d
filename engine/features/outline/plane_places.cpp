#include "engine/features/outline/plane_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lathelier::features {
namespace {

constexpr double hollowMargin_mm = 0.3;     // a hollow that begins within this of the larger radius begins at it
constexpr double leastShoulder_sigmas = 8;  // lower shoulders are placed as steps

/// Smallest and largest radius of a run within a distance of one of its planes.
std::pair<double, double> radiiNear(const Run& run, bool start, double reach_mm)
{
    const double from = start ? run.nodes_mm.front() : std::max(run.nodes_mm.front(), run.nodes_mm.back() - reach_mm);
    const double to = start ? std::min(run.nodes_mm.back(), run.nodes_mm.front() + reach_mm) : run.nodes_mm.back();
    double low = 1e300, high = -1e300;
    for (int k = 0; k <= 20; ++k) {
        const double r = radiusAt_mm(run, from + (to - from) * k / 20);
        low = std::min(low, r);
        high = std::max(high, r);
    }
    return {low, high};
}

/// Radius at which the tangent of an arc beside the plane is across the axis, when it is so near the plane; else
/// nothing. Evaluating the arc at the plane is ill-conditioned there: a small error of the plane gives a large one of
/// the radius.
std::optional<double> uprightAt(const Element& element, const Plane& plane, double side)
{
    constexpr double nearPlane_mm = 0.06;
    if (!element.arc) return std::nullopt;
    const double upright = element.centre_z_mm + side * element.radius_mm();
    return std::abs(upright - plane.z_mm) < nearPlane_mm ? std::optional(element.centre_r_mm) : std::nullopt;
}

/// Log-likelihood ratio L of one point: on the wall behind against on the wall before an edge at z_e. A ray at z is
/// read anywhere within its spot of width s and shows the wall behind with the probability P = clamp((z - z_e)/s + ½,
/// 0, 1); the likelihood of z_e is the product of P·exp(L) + 1 - P. Its posterior mean and standard deviation with a
/// uniform prior over the stretch minimise the mean square error of a change point (Ibragimov and Has'minskii 1981,
/// VII).
struct LogLikelihoodRatio {
    double z_mm, log_ratio;
};

std::optional<PlanePlace> placeOfChange(std::vector<LogLikelihoodRatio> points, double from_mm, double to_mm,
                                        double spot_mm)
{
    constexpr double coarseStep_mm = 0.01, negligibleLogRatio = 12;
    constexpr int fineSteps = 240;
    if (points.size() < 40 || !(to_mm > from_mm)) return std::nullopt;
    std::sort(points.begin(), points.end(),
              [](const LogLikelihoodRatio& a, const LogLikelihoodRatio& b) { return a.z_mm < b.z_mm; });
    std::vector<double> behind(points.size() + 1, 0), ratio(points.size());
    for (std::size_t i = points.size(); i-- > 0;) {
        behind[i] = behind[i + 1] + points[i].log_ratio;
        ratio[i] = std::expm1(points[i].log_ratio);
    }
    const double spot = std::max(spot_mm, 1e-3);
    const auto likelihood = [&](double place) {
        const auto at = [](const LogLikelihoodRatio& one, double z) { return one.z_mm < z; };
        const auto low = std::lower_bound(points.begin(), points.end(), place - spot / 2, at);
        auto point = low;
        double sum = 0;
        for (; point != points.end() && point->z_mm < place + spot / 2; ++point)
            sum += std::log1p(((point->z_mm - place) / spot + 0.5) *
                              ratio[static_cast<std::size_t>(point - points.begin())]);
        return sum + behind[static_cast<std::size_t>(point - points.begin())];
    };
    // A coarse grid to bracket the likelihood, then a fine one within.
    std::vector<double> places, values;
    for (double z = from_mm; z <= to_mm; z += coarseStep_mm) {
        places.push_back(z);
        values.push_back(likelihood(z));
    }
    const double most = *std::max_element(values.begin(), values.end());
    double low = to_mm, high = from_mm;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (values[i] < most - negligibleLogRatio) continue;
        low = std::min(low, places[i]);
        high = std::max(high, places[i]);
    }
    low = std::max(from_mm, low - coarseStep_mm);
    high = std::min(to_mm, high + coarseStep_mm);
    double sum = 0, first = 0, second = 0, best = most;
    std::vector<double> fine(fineSteps + 1);
    for (int k = 0; k <= fineSteps; ++k) {
        fine[static_cast<std::size_t>(k)] = likelihood(low + (high - low) * k / fineSteps);
        best = std::max(best, fine[static_cast<std::size_t>(k)]);
    }
    for (int k = 0; k <= fineSteps; ++k) {
        const double z = low + (high - low) * k / fineSteps,
                     weight = std::exp(fine[static_cast<std::size_t>(k)] - best);
        sum += weight;
        first += weight * (z - low);
        second += weight * (z - low) * (z - low);
    }
    PlanePlace found;
    found.z_mm = low + first / sum;
    found.sigma_mm = std::sqrt(std::max(0.0, second / sum - first * first / (sum * sum)) + 1e-6);
    found.spot_mm = spot_mm;
    return found;
}

/// A small step of the radius. The log-likelihood ratio of a point is clipped at ±4.6 (100 : 1), against spurious
/// points.
void placeStep(const OutlineInput& input, Model& model, std::size_t p, const Run& a, const Run& b)
{
    constexpr double largestReach_mm = 3, largestLogRatio = 4.6, farSigmas = 5;
    Plane& plane = model.planes[p];
    const Element &before = a.elements.back(), &after = b.elements.front();
    const double jump = startRadius_mm(b) - endRadius_mm(a), sigma = model.sigma_mm;
    const double reach = std::min({largestReach_mm, 0.4 * (a.nodes_mm.back() - a.nodes_mm[a.nodes_mm.size() - 2]),
                                   0.4 * (b.nodes_mm[1] - b.nodes_mm.front())});
    if (jump == 0 || !(sigma > 0)) return;
    std::vector<LogLikelihoodRatio> points;
    for (std::size_t i = 0; i < input.cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(input.cloud.z_mm[i]);
        if (std::abs(z - plane.z_mm) > reach) continue;
        const double low = before.radiusAt_mm(z), high = after.radiusAt_mm(z);
        const double off = static_cast<double>(input.cloud.r_mm[i]) - (low + high) / 2;
        if (std::abs(off) > std::abs(high - low) / 2 + farSigmas * sigma) continue;
        points.push_back({z, std::clamp(off * (high - low) / (sigma * sigma), -largestLogRatio, largestLogRatio)});
    }
    const auto place = placeOfChange(std::move(points), plane.z_mm - reach, plane.z_mm + reach, model.spot_mm);
    if (!place) return;
    plane.z_mm = plane.seen_mm = place->z_mm;
    plane.sigma_mm = place->sigma_mm;
}

/// The end of a thread or a knurl beside a wall that its grooves nearly reach: the density of the radii on the rough
/// zone is the histogram of all of its points.
void placeRoughEnd(const OutlineInput& input, Model& model, std::size_t p, const Run& a, const Run& b)
{
    constexpr double largestReach_mm = 1.5, largestLogRatio = 4.6, farSigmas = 5, besideBorder_mm = 0.5;
    const bool first_rough = a.elements.back().rough;
    const Run& rough = first_rough ? a : b;
    const Element& wall = first_rough ? b.elements.front() : a.elements.back();
    const double sigma = model.sigma_mm;
    if (wall.arc || wall.rough || std::abs(wall.slope) > 0.1 || !(sigma > 0)) return;
    Plane& plane = model.planes[p];
    const double own =
        first_rough ? b.nodes_mm[1] - b.nodes_mm.front() : a.nodes_mm.back() - a.nodes_mm[a.nodes_mm.size() - 2];
    const double length = rough.nodes_mm.back() - rough.nodes_mm.front();
    const double reach = std::min({largestReach_mm, 0.4 * own, 0.3 * length});
    const double low = std::min(wall.level_mm, rough.elements.front().root_mm) - farSigmas * sigma,
                 high = std::max(wall.level_mm, rough.elements.front().level_mm) + farSigmas * sigma, step = sigma / 2;
    std::vector<double> counts(static_cast<std::size_t>((high - low) / step) + 1, 0.5);
    double all = 0;
    std::vector<std::pair<double, double>> near;
    for (std::size_t i = 0; i < input.cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(input.cloud.z_mm[i]), r = static_cast<double>(input.cloud.r_mm[i]);
        if (!(r > low && r < high)) continue;
        if (std::abs(z - plane.z_mm) < reach) near.emplace_back(z, r);
        if (z < rough.nodes_mm.front() + besideBorder_mm || z > rough.nodes_mm.back() - besideBorder_mm) continue;
        counts[static_cast<std::size_t>((r - low) / step)] += 1;
        all += 1;
    }
    if (all < 200) return;
    std::vector<LogLikelihoodRatio> points;
    for (const auto& [z, r] : near) {
        const double u = (r - wall.radiusAt_mm(z)) / sigma;
        const double on_wall = -u * u / 2 - std::log(sigma * std::sqrt(2 * std::numbers::pi));
        const double on_rough = std::log(counts[static_cast<std::size_t>((r - low) / step)] / (all * step));
        const double log_ratio = std::clamp(on_wall - on_rough, -largestLogRatio, largestLogRatio);
        points.push_back({z, first_rough ? log_ratio : -log_ratio});
    }
    const auto place = placeOfChange(std::move(points), plane.z_mm - reach, plane.z_mm + reach, model.spot_mm);
    if (!place) return;
    plane.z_mm = plane.seen_mm = place->z_mm;
    plane.sigma_mm = place->sigma_mm;
}

}  // namespace

void placePlanes(const OutlineInput& input, Outline& outline, const std::vector<Border>& borders,
                 const Progress& progress)
{
    Model& model = outline.model;
    std::vector<registration::Edge> edges;
    std::vector<std::size_t> plane_of;
    std::vector<double> jumps, lags_mm;  // steps of the radius; distance behind the plane at which the rays show it
    double walls = 0, area = 0;
    for (const Run& run : model.runs)
        for (const Wall& wall : run.walls) {
            walls += wall.points;
            area += 2 * std::numbers::pi * wall.r_mm * input.fine.bin_mm;
        }
    const double density = area > 0 ? walls / area : 0;
    int faces = 0, sought = 0;
    const double lean = input.scanner ? std::hypot(input.scanner->direction.x(), input.scanner->direction.y()) /
                                            std::abs(input.scanner->direction.z())
                                      : 0;
    for (std::size_t r = 0; r + 1 < model.runs.size(); ++r) {
        const Run &a = model.runs[r], &b = model.runs[r + 1];
        if (a.right != b.left) continue;
        Plane& plane = model.planes[a.right];
        const auto upright = uprightAt(a.elements.back(), plane, 1);
        const auto upright_next = uprightAt(b.elements.front(), plane, -1);
        const bool hollow_here = (upright && !a.elements.back().convex) || (upright_next && !b.elements.front().convex);
        const double jump =
            hollow_here ? hollowMargin_mm + 8 * model.sigma_mm : std::abs(startRadius_mm(b) - endRadius_mm(a));
        const bool is_rough = a.elements.back().rough || b.elements.front().rough;
        if (borders[a.right] == Border::Lead) continue;
        if (borders[a.right] == Border::Step ||
            (borders[a.right] == Border::Shoulder && !is_rough && jump < leastShoulder_sigmas * model.sigma_mm)) {
            placeStep(input, model, a.right, a, b);
            continue;
        }
        const double room = std::min(
            {1.0, 0.45 * (a.nodes_mm.back() - a.nodes_mm.front()), 0.45 * (b.nodes_mm.back() - b.nodes_mm.front())});
        const auto [a_low, a_high] = radiiNear(a, false, room);
        const auto [b_low, b_high] = radiiNear(b, true, room);
        const bool a_rough = a.elements.back().rough, b_rough = b.elements.front().rough;
        const Element &before = a.elements.back(), &after = b.elements.front();
        const auto upright_before = uprightAt(before, plane, 1), upright_after = uprightAt(after, plane, -1);
        double end = a_rough ? before.root_mm : upright_before && before.convex ? *upright_before : endRadius_mm(a);
        double start = b_rough ? after.root_mm : upright_after && after.convex ? *upright_after : startRadius_mm(b);
        const bool rises = start > end;
        // A hollow that falls across the axis from the larger radius counts as that radius until it is deep enough.
        const bool hollow = rises ? upright_before && !before.convex && *upright_before > start - hollowMargin_mm
                                  : upright_after && !after.convex && *upright_after > end - hollowMargin_mm;
        double lag_mm = 0;
        if (hollow) {
            const Element& fall = rises ? before : after;
            const double most = fall.radius_mm(), depth = std::min(5 * model.sigma_mm, most / 2);
            const auto along = [&](double deep) { return most - std::sqrt(most * most - deep * deep); };
            (rises ? end : start) = (rises ? start : end) - std::min(2 * depth, most);
            lag_mm = (rises ? -1 : 1) * along(depth);
        }
        plane.lean = lean * std::abs(start - end);
        plane.low_side = rises ? -1 : 1;
        plane.is_clear = false;
        if (is_rough && std::abs(start - end) < leastShoulder_sigmas * model.sigma_mm) {
            placeRoughEnd(input, model, a.right, a, b);
            continue;
        }
        ++sought;
        if (const auto face = seenFace(input.cloud, plane.z_mm, std::min(start, end), std::max(start, end),
                                       model.sigma_mm, density)) {
            plane.z_mm = plane.seen_mm = face->z_mm;
            plane.sigma_mm = face->sigma_mm;
            ++faces;
            continue;
        }
        registration::Edge edge;
        edge.z_mm = plane.z_mm;
        edge.sign = rises ? 1 : -1;
        edge.before_mm = rises ? a_low : end;
        edge.after_mm = rises ? start : b_low;
        edge.above_mm = std::max(0.0, rises ? b_high - start : a_high - end);
        edge.from_mm = plane.z_mm - room;
        edge.to_mm = plane.z_mm + room;
        if (std::abs(edge.after_mm - edge.before_mm) < 4 * model.sigma_mm) continue;
        edges.push_back(edge);
        plane_of.push_back(a.right);
        lags_mm.push_back(lag_mm);
        jumps.push_back(std::abs(start - end));
    }
    // Clusters of points are separated by gaps of 6 σ or 0.3 mm; noise fills 3.5 σ on each side.
    const double clear = std::max(6 * model.sigma_mm, 0.3) + 7 * model.sigma_mm;
    if (!edges.empty() && !input.bore) {
        std::vector<double> spots;
        const auto rays = registration::findEdgeRays(input.points_mm, input.fit, edges, progress);
        for (std::size_t e = 0; e < edges.size(); ++e)
            // The widest spot is a bound: hits and misses mix over all of the stretch, and say nothing of the edge.
            if (const auto place = placeOf(rays[e]); place && place->spot_mm < widestSpot_mm) {
                Plane& plane = model.planes[plane_of[e]];
                plane.z_mm = plane.seen_mm = place->z_mm - lags_mm[e];
                plane.sigma_mm = place->sigma_mm;
                plane.is_clear = lags_mm[e] == 0 && jumps[e] > clear;
                spots.push_back(place->spot_mm);
            }
        if (!spots.empty()) {
            std::sort(spots.begin(), spots.end());
            model.spot_mm = spots[spots.size() / 2];
        }
    }
    // Ends.
    for (const bool start : {true, false}) {
        const std::size_t p = start ? model.runs.front().left : model.runs.back().right;
        Plane& plane = model.planes[p];
        const Run& run = start ? model.runs.front() : model.runs.back();
        const double radius = start ? startRadius_mm(run) : endRadius_mm(run);
        const auto part_end = std::find_if(input.part_ends.begin(), input.part_ends.end(),
                                           [&](const Plane& end) { return std::abs(end.z_mm - plane.z_mm) < 1; });
        if (part_end != input.part_ends.end()) {
            plane.z_mm = plane.seen_mm = part_end->z_mm;
            plane.sigma_mm = std::max(1e-4, part_end->sigma_mm);
            continue;
        }
        ++sought;
        if (const auto face = input.bore
                                  ? std::nullopt
                                  : seenFace(input.cloud, plane.z_mm, 0.55 * radius, radius, model.sigma_mm, density)) {
            plane.z_mm = plane.seen_mm = face->z_mm;
            plane.sigma_mm = face->sigma_mm;
            outline.face_seen[start ? 0 : 1] = true;
            ++faces;
        } else if (!run.elements.front().rough) {
            outline.ends[start ? 0 : 1] = endOf(input.cloud, model, run, start, input.scanner);
            if (const auto& end = outline.ends[start ? 0 : 1]) {
                plane.z_mm = plane.seen_mm = end->place.z_mm;
                plane.sigma_mm = end->place.sigma_mm;
            }
        }
    }
    outline.surface_scan = !input.scanner && faces > 0 && 2 * faces >= sought;
    if (outline.surface_scan || (input.bore && !input.scanner)) {
        model.corner_mm = model.edge_mm = 0.16;
        model.spot_mm = 0;
    }
    for (Run& run : model.runs) resolve(model, run);
}

}  // namespace lathelier::features
