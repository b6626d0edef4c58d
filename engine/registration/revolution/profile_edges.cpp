#include "engine/registration/revolution/profile_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lathelier::registration {
namespace {

/// Jumps of the radius that are edges (README, "Thresholds").
struct ProfileEdgeThresholds {
    double least_height_sigmas = 8;    ///< of the scatter: lower jumps are no edges,
    double least_height_steps = 0.02;  ///< nor are those below this share of a bin, on exact meshes
    double least_steepness = 1.5;      ///< height over the width between the known bins; less is a resolved slope
    double slope_ratio = 2;            ///< to the rise beside it, for a jump that is no part of a slope
    int line_bins = 8;                 ///< known bins beside an edge that a straight line is laid through,
    int line_reach = 20;               ///< and bins among which they are sought: noise leaves gaps in a slope
    double least_line_bins = 4;        ///< for a line; the mean of fewer
    std::ptrdiff_t slope_reach = 5;    ///< bins among which the next one of a slope is sought
    double ray_steps = 3;              ///< bins beside an edge whose rays belong to it
};
constexpr ProfileEdgeThresholds profileEdges{};

/// Straight line through the nearest known bins from `bin` in direction `step`, up to the next jump, at `z`.
double extrapolate(const RadiusProfile& profile, std::ptrdiff_t bin, std::ptrdiff_t step, double jump, double z)
{
    double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;
    double last = profile.radius_mm[static_cast<std::size_t>(bin)];
    for (int k = 0; k < profileEdges.line_reach && n < profileEdges.line_bins; ++k, bin += step) {
        if (bin < 0 || bin >= static_cast<std::ptrdiff_t>(profile.size())) break;
        const double r = profile.radius_mm[static_cast<std::size_t>(bin)];
        if (std::isnan(r)) continue;
        if (std::abs(r - last) > jump) break;
        last = r;
        const double dz = profile.middle_mm(static_cast<std::size_t>(bin)) - z;
        n += 1;
        sz += dz;
        sr += r;
        szz += dz * dz;
        szr += dz * r;
    }
    const double spread = n * szz - sz * sz;
    return n < profileEdges.least_line_bins || spread <= 0 ? sr / n : (szz * sr - sz * szr) / spread;
}

/// How much the radius rises (times `sign`) for each bin, up to the known bin next to `bin` in direction `away`.
double riseFrom(const RadiusProfile& profile, std::ptrdiff_t bin, std::ptrdiff_t away, double sign)
{
    const auto radiusAt = [&](std::ptrdiff_t at) { return profile.radius_mm[static_cast<std::size_t>(at)]; };
    for (std::ptrdiff_t k = 1; k <= profileEdges.slope_reach; ++k) {
        const std::ptrdiff_t next = bin + k * away;
        if (next < 0 || next >= static_cast<std::ptrdiff_t>(profile.size())) break;
        if (std::isnan(radiusAt(next))) continue;
        return (radiusAt(next) - radiusAt(bin)) * sign * static_cast<double>(away) / static_cast<double>(k);
    }
    return 0.0;
}

/// The edge between two known bins; nullopt: none. `least`: lowest edge.
std::optional<Edge> edgeBetween(const RadiusProfile& profile, std::ptrdiff_t before, std::ptrdiff_t after, double least)
{
    const auto first = static_cast<std::size_t>(before), last = static_cast<std::size_t>(after);
    const double z1 = profile.middle_mm(first);
    const double z2 = profile.middle_mm(last);
    Edge edge;
    edge.z_mm = (z1 + z2) / 2;
    edge.before_mm = extrapolate(profile, before, -1, least, edge.z_mm);
    edge.after_mm = extrapolate(profile, after, 1, least, edge.z_mm);
    const double rise = edge.after_mm - edge.before_mm;
    const double height = std::abs(rise);
    edge.sign = rise > 0 ? 1 : -1;
    edge.from_mm = z1 - profileEdges.ray_steps * profile.step_mm;
    edge.to_mm = z2 + profileEdges.ray_steps * profile.step_mm;
    // A steep but resolved slope is no shoulder: the bins beside it rise at the same rate.
    const double a_bin = 1 / static_cast<double>(after - before);
    const double beside = std::max(riseFrom(profile, before, -1, edge.sign), riseFrom(profile, after, 1, edge.sign));
    const bool goes_on =
        std::abs(profile.radius_mm[last] - profile.radius_mm[first]) * a_bin < profileEdges.slope_ratio * beside;
    if (!(height > least) || !(height > profileEdges.least_steepness * (z2 - z1) * a_bin) || goes_on)
        return std::nullopt;
    return edge;
}

}  // namespace

std::vector<Edge> findEdges(const RevolutionFit& fit)
{
    const RadiusProfile& profile = fit.profile;
    const double least =
        std::max(profileEdges.least_height_sigmas * fit.sigma_mm, profileEdges.least_height_steps * profile.step_mm);
    std::vector<Edge> edges;
    std::ptrdiff_t before = -1;
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(profile.size()); ++i) {
        if (std::isnan(profile.radius_mm[static_cast<std::size_t>(i)])) continue;
        if (before >= 0 && i - before <= static_cast<std::ptrdiff_t>(longestShoulder_bins))
            if (const auto edge = edgeBetween(profile, before, i, least)) edges.push_back(*edge);
        before = i;
    }
    for (std::size_t k = 1; k < edges.size(); ++k)
        if (edges[k - 1].to_mm > edges[k].from_mm)
            edges[k - 1].to_mm = edges[k].from_mm = (edges[k - 1].z_mm + edges[k].z_mm) / 2;
    return edges;
}

}  // namespace lathelier::registration
