#include "engine/registration/revolution_shoulders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/core/parallel.h"

namespace lathelier {
namespace {

constexpr int kSectors = 24;
constexpr double kPi = std::numbers::pi;

/// A point near a shoulder, z counted so that the larger radius lies at larger z.
struct EdgePoint {
    double z;
    double depth;  ///< below the larger radius, 0…1 of the height
    float cosine, sine;
    std::uint8_t sector;
};

struct Edge {
    Shoulder shoulder;
    double sign = 1;  ///< +1 when the radius rises with z
    double from = 0, to = 0;
    double height = 0;
    std::vector<EdgePoint> points;
};

/// Straight line through up to 8 known bins from `bin` in direction `step`, at `z`.
double extrapolate(const RadiusProfile& profile, std::ptrdiff_t bin, std::ptrdiff_t step, double jump, double z)
{
    double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;
    double last = profile.radius_mm[static_cast<std::size_t>(bin)];
    for (int k = 0; k < 8; ++k, bin += step) {
        if (bin < 0 || bin >= static_cast<std::ptrdiff_t>(profile.size())) break;
        const double r = profile.radius_mm[static_cast<std::size_t>(bin)];
        if (std::isnan(r) || std::abs(r - last) > jump) break;
        last = r;
        const double dz = profile.middle_mm(static_cast<std::size_t>(bin)) - z;
        n += 1;
        sz += dz;
        sr += r;
        szz += dz * dz;
        szr += dz * r;
    }
    const double spread = n * szz - sz * sz;
    return n < 4 || spread <= 0 ? sr / n : (szz * sr - sz * szr) / spread;
}

std::vector<Edge> findEdges(const RevolutionFit& fit)
{
    const RadiusProfile& profile = fit.profile;
    const double least = std::max(8 * fit.sigma_mm, 0.02 * profile.step_mm);
    std::vector<Edge> edges;
    std::ptrdiff_t before = -1;
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(profile.size()); ++i) {
        if (std::isnan(profile.radius_mm[static_cast<std::size_t>(i)])) continue;
        const std::ptrdiff_t gap = i - before;
        if (before >= 0 && gap <= 10) {
            const double z1 = profile.middle_mm(static_cast<std::size_t>(before));
            const double z2 = profile.middle_mm(static_cast<std::size_t>(i));
            const double middle = (z1 + z2) / 2;
            Edge edge;
            edge.shoulder.before_mm = extrapolate(profile, before, -1, least, middle);
            edge.shoulder.after_mm = extrapolate(profile, i, 1, least, middle);
            edge.shoulder.z_mm = middle;
            const double rise = edge.shoulder.after_mm - edge.shoulder.before_mm;
            edge.height = std::abs(rise);
            edge.sign = rise > 0 ? 1 : -1;
            edge.from = z1 - 3 * profile.step_mm;
            edge.to = z2 + 3 * profile.step_mm;
            // A steep but resolved slope is no shoulder: it has bins of its own.
            if (edge.height > least &&
                edge.height > 1.5 * (z2 - z1) / static_cast<double>(std::max<std::ptrdiff_t>(1, gap)))
                edges.push_back(edge);
        }
        before = i;
    }
    for (std::size_t k = 1; k < edges.size(); ++k)
        if (edges[k - 1].to > edges[k].from)
            edges[k - 1].to = edges[k].from = (edges[k - 1].shoulder.z_mm + edges[k].shoulder.z_mm) / 2;
    return edges;
}

void collect(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit, std::vector<Edge>& edges,
             const Progress& progress)
{
    // Which edge a place along z belongs to, by bins as fine as the profile's.
    const RadiusProfile& profile = fit.profile;
    const double fine = profile.step_mm / 8;
    std::vector<std::int16_t> edge_at(profile.size() * 8, -1);
    for (std::size_t e = 0; e < edges.size(); ++e)
        for (double z = edges[e].from; z < edges[e].to; z += fine) {
            const double place = (z - profile.z_start_mm) / fine;
            if (place >= 0 && place < static_cast<double>(edge_at.size()))
                edge_at[static_cast<std::size_t>(place)] = static_cast<std::int16_t>(e);
        }
    using Found = std::vector<std::vector<EdgePoint>>;
    const double reach = 6 * fit.sigma_mm;
    const Found found = parallelReduce(
        points.size(), std::max<std::size_t>(16384, points.size() / 24), progress, Found(edges.size()),
        [&](std::size_t begin, std::size_t end) {
            Found part(edges.size());
            for (std::size_t i = begin; i < end; ++i) {
                const double z = fit.axis_T_scan.linear().row(2).dot(points[i]) + fit.axis_T_scan.translation().z();
                const double place = (z - profile.z_start_mm) / fine;
                if (!(place >= 0) || place >= static_cast<double>(edge_at.size())) continue;
                const int e = edge_at[static_cast<std::size_t>(place)];
                if (e < 0) continue;
                const Edge& edge = edges[static_cast<std::size_t>(e)];
                const Eigen::Vector3d p = fit.axis_T_scan * points[i];
                const double r = std::hypot(p.x(), p.y());
                const double high = std::max(edge.shoulder.before_mm, edge.shoulder.after_mm);
                if (r > high + reach || r < high - edge.height - reach || r == 0) continue;
                const double turn = std::atan2(p.y(), p.x()) / (2 * kPi) + 0.5;
                part[static_cast<std::size_t>(e)].push_back(
                    {z * edge.sign, std::clamp((high - r) / edge.height, 0.0, 1.0), static_cast<float>(p.x() / r),
                     static_cast<float>(p.y() / r),
                     static_cast<std::uint8_t>(std::min(kSectors - 1.0, turn * kSectors))});
            }
            return part;
        },
        [](Found all, const Found& part) {
            for (std::size_t e = 0; e < all.size(); ++e) all[e].insert(all[e].end(), part[e].begin(), part[e].end());
            return all;
        });
    for (std::size_t e = 0; e < edges.size(); ++e) edges[e].points = found[e];
}

/// The place with as many points before it as there are points of the smaller radius; nullopt with too few of either.
std::optional<double> balance(std::vector<double>& z, std::size_t low_count)
{
    if (low_count < 3 || z.size() < low_count + 3) return std::nullopt;
    const auto place = z.begin() + static_cast<std::ptrdiff_t>(low_count);
    std::nth_element(z.begin(), place, z.end());
    return (*std::max_element(z.begin(), place) + *place) / 2;
}

/// Lean of the rays: going inward by 1 mm they move by a·cos + b·sin along z.
struct Lean {
    double a = 0;
    double b = 0;
};

/// How far the smaller radius lies displaced in the shadow, for each unit of depth.
double shadow(const Edge& edge, const Lean& lean, double cosine, double sine)
{
    return edge.height * std::min(0.0, edge.sign * (lean.a * cosine + lean.b * sine));
}

std::optional<double> balanceOf(const Edge& edge, const Lean& lean, int sector)
{
    std::vector<double> z;
    z.reserve(edge.points.size());
    std::size_t low = 0;
    for (const EdgePoint& p : edge.points) {
        if (sector >= 0 && p.sector != sector) continue;
        z.push_back(p.z - p.depth * shadow(edge, lean, p.cosine, p.sine));
        low += p.depth > 0.5 ? 1 : 0;
    }
    return balance(z, low);
}

struct SectorPlace {
    std::size_t edge;
    double cosine, sine;
    double z;
};

/// Sum of squares with each edge's own place free; half of the shadow shows in the balance.
double misfit(const std::vector<Edge>& edges, const std::vector<SectorPlace>& places, const Lean& lean)
{
    std::vector<std::array<double, 3>> sums(edges.size(), {0, 0, 0});
    for (const SectorPlace& p : places) {
        const double z = p.z - 0.5 * shadow(edges[p.edge], lean, p.cosine, p.sine);
        sums[p.edge][0] += 1;
        sums[p.edge][1] += z;
        sums[p.edge][2] += z * z;
    }
    double total = 0;
    for (const auto& [n, sum, squares] : sums)
        if (n > 0) total += squares - sum * sum / n;
    return total;
}

Lean fitLean(const std::vector<Edge>& edges, const std::vector<SectorPlace>& places)
{
    const double without = misfit(edges, places, {});
    Lean best;
    double least = without;
    for (double slope = 0.002; slope < 0.4; slope *= 1.3)
        for (int k = 0; k < 24; ++k) {
            const Lean lean{slope * std::cos(2 * kPi * k / 24), slope * std::sin(2 * kPi * k / 24)};
            const double value = misfit(edges, places, lean);
            if (value < least) {
                least = value;
                best = lean;
            }
        }
    for (double step = 0.2 * std::hypot(best.a, best.b); step > 1e-6; step /= 2)
        for (bool better = true; better;) {
            better = false;
            for (const auto& [da, db] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const Lean lean{best.a + step * da, best.b + step * db};
                const double value = misfit(edges, places, lean);
                if (value < least * (1 - 1e-12)) {
                    least = value;
                    best = lean;
                    better = true;
                }
            }
        }
    // Two parameters more must lower the sum by clearly more than chance does.
    const double freedom = std::max(1.0, static_cast<double>(places.size()) - static_cast<double>(edges.size()) - 2);
    return without - least > 12 * least / freedom ? best : Lean{};
}

}  // namespace

std::vector<Shoulder> findShoulders(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                    const Progress& progress)
{
    std::vector<Edge> edges = findEdges(fit);
    if (edges.empty()) return {};
    collect(points, fit, edges, progress);

    std::vector<SectorPlace> places;
    for (std::size_t e = 0; e < edges.size(); ++e)
        for (int s = 0; s < kSectors; ++s) {
            const double angle = 2 * kPi * ((s + 0.5) / kSectors - 0.5);
            if (const auto z = balanceOf(edges[e], {}, s)) places.push_back({e, std::cos(angle), std::sin(angle), *z});
        }
    const Lean lean = fitLean(edges, places);

    std::vector<Shoulder> shoulders;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const Edge& edge = edges[e];
        const auto z = balanceOf(edge, lean, -1);
        double n = 0, squares = 0;
        for (int s = 0; s < kSectors; ++s)
            if (const auto own = balanceOf(edge, lean, s); own && z) {
                n += 1;
                squares += (*own - *z) * (*own - *z);
            }
        if (n < 4) continue;
        Shoulder shoulder = edge.shoulder;
        shoulder.z_mm = *z * edge.sign;
        shoulder.sigma_mm = std::sqrt(squares / (n - 1) / n);
        shoulders.push_back(shoulder);
    }
    return shoulders;
}

}  // namespace lathelier
