#include "engine/features/plane_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lathelier::features {
namespace {

constexpr double kLeastShoulder = 8;  // in σ: what is lower is placed as a step

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

/// A small step of the radius: the place that parts the points of the two levels best. A point's word for one of them
/// is the logarithm of the ratio of its likelihoods, held to 100 : 1, for some points are spurious.
void placeStep(const OutlineInput& input, Model& model, std::size_t p, const Run& a, const Run& b)
{
    constexpr double kMostReach_mm = 3, kLongestWord = 4.6, kFar = 5;
    Plane& plane = model.planes[p];
    const Element &before = a.elements.back(), &after = b.elements.front();
    const double jump = startRadius_mm(b) - endRadius_mm(a), sigma = model.sigma_mm;
    const double reach = std::min({kMostReach_mm, 0.4 * (a.nodes_mm.back() - a.nodes_mm[a.nodes_mm.size() - 2]),
                                   0.4 * (b.nodes_mm[1] - b.nodes_mm.front())});
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < input.cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(input.cloud.z_mm[i]);
        if (std::abs(z - plane.z_mm) > reach) continue;
        const double low = before.radiusAt_mm(z), high = after.radiusAt_mm(z);
        const double off = static_cast<double>(input.cloud.r_mm[i]) - (low + high) / 2;
        if (std::abs(off) > std::abs(high - low) / 2 + kFar * sigma) continue;
        points.emplace_back(z, std::clamp(off * (high - low) / (sigma * sigma), -kLongestWord, kLongestWord));
    }
    if (points.size() < 40 || jump == 0 || !(sigma > 0)) return;
    std::sort(points.begin(), points.end());
    double sum = 0, best = 0, place = plane.z_mm;
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        sum -= points[i].second;
        if (sum > best) {
            best = sum;
            place = (points[i].first + points[i + 1].first) / 2;
            at = i;
        }
    }
    double gap = 0;
    for (std::size_t i = at < 8 ? 0 : at - 8; i + 1 < points.size() && i < at + 8; ++i)
        gap = std::max(gap, points[i + 1].first - points[i].first);
    const double density = static_cast<double>(points.size()) / (2 * reach);
    plane.z_mm = plane.seen_mm = place;
    // Spread of the likeliest change point of a mean: about 5 σ²/(Δ²·density) (Hinkley 1970); of an edge that the spot
    // blurs and rows meet: as of edges.h.
    const double change = 5 * sigma * sigma / (jump * jump * density);
    plane.sigma_mm = std::sqrt(change * change + model.spot_mm / (6 * density) + gap * gap / 12 + 1e-6);
}

}  // namespace

void placePlanes(const OutlineInput& input, Outline& outline, const std::vector<Border>& borders,
                 const Progress& progress)
{
    Model& model = outline.model;
    std::vector<registration::Edge> edges;
    std::vector<std::size_t> plane_of;
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
        const double jump = std::abs(startRadius_mm(b) - endRadius_mm(a));
        const bool is_rough = a.elements.back().rough || b.elements.front().rough;
        if (borders[a.right] == Border::Step ||
            (borders[a.right] == Border::Shoulder && !is_rough && jump < kLeastShoulder * model.sigma_mm)) {
            placeStep(input, model, a.right, a, b);
            continue;
        }
        const double room = std::min(
            {1.0, 0.45 * (a.nodes_mm.back() - a.nodes_mm.front()), 0.45 * (b.nodes_mm.back() - b.nodes_mm.front())});
        const auto [a_low, a_high] = radiiNear(a, false, room);
        const auto [b_low, b_high] = radiiNear(b, true, room);
        const bool a_rough = a.elements.back().rough, b_rough = b.elements.front().rough;
        const double end = a_rough ? a.elements.back().root_mm : endRadius_mm(a);
        const double start = b_rough ? b.elements.front().root_mm : startRadius_mm(b);
        const bool rises = start > end;
        plane.lean = lean * std::abs(start - end);
        if (borders[a.right] == Border::Rough && std::abs(start - end) < 4 * model.sigma_mm) continue;
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
    }
    if (!edges.empty() && !input.bore) {
        std::vector<double> spots;
        const auto rays = registration::findEdgeRays(input.points_mm, input.fit, edges, progress);
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (const auto place = placeOf(rays[e])) {
                Plane& plane = model.planes[plane_of[e]];
                plane.z_mm = plane.seen_mm = place->z_mm;
                plane.sigma_mm = place->sigma_mm;
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
