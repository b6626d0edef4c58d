#include "engine/registration/revolution/shoulder_rays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/revolution/quick_turn.h"
#include "engine/registration/revolution/scanner_axis.h"

namespace lathelier::registration {
namespace {

constexpr int edgeSectors = 24;

/// A point near a shoulder.
struct EdgePoint {
    double height;  ///< of the point itself; where the scanner is known, of its ray
    double depth;   ///< below the larger radius, 0…1 of the shoulder
    float cosine, sine;
    std::uint8_t sector;
};

/// Lean of the rays: going inward by 1 mm they move by a·cos + b·sin along z.
struct Lean {
    double a = 0;
    double b = 0;
};

double heightOf(const Edge& edge)
{
    return std::abs(edge.after_mm - edge.before_mm);
}

/// How far rays lean along the part's axis at most, in mm for each mm inward.
double leanOf(const ScannerAxis& scanner)
{
    return std::hypot(scanner.direction.x(), scanner.direction.y()) / scanner.direction.z();
}

constexpr int linePoints = 8;             // known bins beside an edge that a straight line is laid through
constexpr std::ptrdiff_t slopeReach = 5;  // bins among which the next one of a slope is sought
constexpr int lineReach = 20;             // bins among which they are sought: noise leaves gaps in a slope

/// Straight line through the nearest known bins from `bin` in direction `step`, up to the next jump, at `z`.
double extrapolate(const RadiusProfile& profile, std::ptrdiff_t bin, std::ptrdiff_t step, double jump, double z)
{
    double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;
    double last = profile.radius_mm[static_cast<std::size_t>(bin)];
    for (int k = 0; k < lineReach && n < linePoints; ++k, bin += step) {
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
    return n < 4 || spread <= 0 ? sr / n : (szz * sr - sz * szr) / spread;
}

std::vector<Edge> findEdges(const RevolutionFit& fit)
{
    const RadiusProfile& profile = fit.profile;
    const double least = std::max(8 * fit.sigma_mm, 0.02 * profile.step_mm);
    const auto radiusAt = [&](std::ptrdiff_t bin) { return profile.radius_mm[static_cast<std::size_t>(bin)]; };
    // How much the radius rises (times `sign`) for each bin, up to the known bin next to `bin` that lies away from the
    // edge.
    const auto riseFrom = [&](std::ptrdiff_t bin, std::ptrdiff_t away, double sign) {
        for (std::ptrdiff_t k = 1; k <= slopeReach; ++k) {
            const std::ptrdiff_t next = bin + k * away;
            if (next < 0 || next >= static_cast<std::ptrdiff_t>(profile.size())) break;
            if (std::isnan(radiusAt(next))) continue;
            return (radiusAt(next) - radiusAt(bin)) * sign * static_cast<double>(away) / static_cast<double>(k);
        }
        return 0.0;
    };
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
            edge.before_mm = extrapolate(profile, before, -1, least, middle);
            edge.after_mm = extrapolate(profile, i, 1, least, middle);
            edge.z_mm = middle;
            const double rise = edge.after_mm - edge.before_mm;
            const double height = std::abs(rise);
            edge.sign = rise > 0 ? 1 : -1;
            edge.from_mm = z1 - 3 * profile.step_mm;
            edge.to_mm = z2 + 3 * profile.step_mm;
            // A steep but resolved slope is no shoulder: the bins beside it rise at the same rate.
            const double a_bin = 1 / static_cast<double>(gap);
            const bool goes_on = std::abs(radiusAt(i) - radiusAt(before)) * a_bin <
                                 2 * std::max(riseFrom(before, -1, edge.sign), riseFrom(i, 1, edge.sign));
            if (height > least && height > 1.5 * (z2 - z1) * a_bin && !goes_on) edges.push_back(edge);
        }
        before = i;
    }
    for (std::size_t k = 1; k < edges.size(); ++k)
        if (edges[k - 1].to_mm > edges[k].from_mm)
            edges[k - 1].to_mm = edges[k].from_mm = (edges[k - 1].z_mm + edges[k].z_mm) / 2;
    return edges;
}

/// The ray of the point `p` passes the radius `radius_mm` at this z.
double heightAt(const Eigen::Vector3d& p, const Eigen::Vector3d& outward, double radius_mm)
{
    const double a = outward.x() * outward.x() + outward.y() * outward.y();
    const double b = p.x() * outward.x() + p.y() * outward.y();
    const double c = p.x() * p.x() + p.y() * p.y() - radius_mm * radius_mm;
    return p.z() + outward.z() * (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
}

/// How far inside the larger radius, as a share of the shoulder's height, a point still counts as a hit. At half height
/// neither a spot that shows one of the radii at random nor one that averages over both displaces the balance: the mean
/// over a symmetric spot passes half height where its middle does.
constexpr double missShare = 0.5;

/// Height of the ray that made `p` at the radius that separates hits from misses. A ray inclined toward the face
/// strikes the face when it does not strike the larger radius, and counts as a hit while it does so within `missShare`;
/// one inclined away from the face passes the larger radius or strikes it.
double rayHeight(const Eigen::Vector3d& p, const ScannerAxis& scanner, const Edge& edge)
{
    const Eigen::Vector3d outward = scanner.outward(p);
    const double high = std::max(edge.before_mm, edge.after_mm);
    const bool toward_face = outward.z() * edge.sign < 0;
    return heightAt(p, outward, toward_face ? high - missShare * heightOf(edge) : high) * edge.sign;
}

std::vector<std::vector<EdgePoint>> collect(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                            const std::vector<Edge>& edges, const std::optional<ScannerAxis>& scanner,
                                            const Progress& progress)
{
    // Which edge a place along z belongs to, by bins as fine as the profile's.
    const RadiusProfile& profile = fit.profile;
    const double fine = profile.step_mm / 8;
    std::vector<std::int16_t> edge_at(profile.size() * 8, -1);
    const double slope = scanner ? leanOf(*scanner) : 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        // An inclined ray is displaced along the axis between the larger radius and the smaller one, where it may end;
        // points beyond the middle between two edges belong to the other edge.
        const double lean = slope * heightOf(edges[e]);
        const double from = std::max(edges[e].from_mm - lean,
                                     e > 0 ? (edges[e - 1].z_mm + edges[e].z_mm) / 2 : edges[e].from_mm - lean);
        const double to = std::min(edges[e].to_mm + lean, e + 1 < edges.size() ? (edges[e].z_mm + edges[e + 1].z_mm) / 2
                                                                               : edges[e].to_mm + lean);
        const auto index = [&](double z) { return std::lround((z - profile.z_start_mm) / fine); };
        const long last = std::min(index(to), static_cast<long>(edge_at.size()));
        for (long k = std::max(0L, index(from)); k < last; ++k)
            edge_at[static_cast<std::size_t>(k)] = static_cast<std::int16_t>(e);
    }
    using Found = std::vector<std::vector<EdgePoint>>;
    const double reach = 6 * fit.sigma_mm;
    return parallelReduce(
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
                const Eigen::Vector3d p = fit.onAxis(points[i]);
                const double r = p.head<2>().norm();
                const double high = std::max(edge.before_mm, edge.after_mm);
                const double height = heightOf(edge);
                if (r > high + edge.above_mm + reach || r < high - height - reach || r == 0) continue;
                const double turn = quickTurn(p.y(), p.x()) + 0.5;
                double own = z * edge.sign;
                if (scanner) {
                    own = rayHeight(p, *scanner, edge);
                    if (own < std::min(edge.from_mm * edge.sign, edge.to_mm * edge.sign) ||
                        own > std::max(edge.from_mm * edge.sign, edge.to_mm * edge.sign))
                        continue;
                }
                part[static_cast<std::size_t>(e)].push_back(
                    {own, std::clamp((high - r) / height, 0.0, 1.0), static_cast<float>(p.x() / r),
                     static_cast<float>(p.y() / r),
                     static_cast<std::uint8_t>(std::min(edgeSectors - 1.0, turn * edgeSectors))});
            }
            return part;
        },
        [](Found all, const Found& part) {
            for (std::size_t e = 0; e < all.size(); ++e) all[e].insert(all[e].end(), part[e].begin(), part[e].end());
            return all;
        });
}

/// How far the smaller radius lies displaced in the shadow.
double shadow(const Edge& edge, const Lean& lean, double cosine, double sine)
{
    return heightOf(edge) * std::min(0.0, edge.sign * (lean.a * cosine + lean.b * sine));
}

struct SectorPlace {
    std::size_t edge;
    double cosine, sine;
    double z;
};

/// Sum of squares with each edge's own place free; half of the shadow shows in the balance.
double shadowMisfit(const std::vector<Edge>& edges, const std::vector<SectorPlace>& places, const Lean& lean)
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
    const double without = shadowMisfit(edges, places, {});
    Lean best;
    double least = without;
    for (double slope = 0.002; slope < 0.4; slope *= 1.3)
        for (int k = 0; k < 24; ++k) {
            const Lean lean{slope * std::cos(turn_rad * k / 24), slope * std::sin(turn_rad * k / 24)};
            const double value = shadowMisfit(edges, places, lean);
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
                const double value = shadowMisfit(edges, places, lean);
                if (value < least * (1 - 1e-12)) {
                    least = value;
                    best = lean;
                    better = true;
                }
            }
        }
    // Two more parameters must lower the sum by significantly more than by chance.
    const double freedom = std::max(1.0, static_cast<double>(places.size()) - static_cast<double>(edges.size()) - 2);
    return without - least > 12 * least / freedom ? best : Lean{};
}

/// Lean from the shadows: the balance of each sector of each edge.
Lean leanOfShadows(const std::vector<Edge>& edges, const std::vector<std::vector<EdgePoint>>& points)
{
    std::vector<SectorPlace> places;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        std::vector<std::vector<Ray>> sectors(edgeSectors);
        for (const EdgePoint& p : points[e]) sectors[p.sector].push_back({p.height, p.depth < missShare});
        for (int s = 0; s < edgeSectors; ++s) {
            std::vector<Ray>& rays = sectors[static_cast<std::size_t>(s)];
            std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.height < b.height; });
            const double angle = turn_rad * ((s + 0.5) / edgeSectors - 0.5);
            if (const auto z = balance(rays)) places.push_back({e, std::cos(angle), std::sin(angle), *z});
        }
    }
    return fitLean(edges, places);
}

}  // namespace

std::optional<double> balance(const std::vector<Ray>& rays)
{
    const auto misses =
        static_cast<std::size_t>(std::count_if(rays.begin(), rays.end(), [](const Ray& r) { return !r.hit; }));
    if (misses < 3 || rays.size() < misses + 3) return std::nullopt;
    return (rays[misses - 1].height + rays[misses].height) / 2;
}

std::vector<EdgeRays> findEdgeRays(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                   const Progress& progress)
{
    return findEdgeRays(points, fit, findEdges(fit), progress);
}

std::vector<EdgeRays> findEdgeRays(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                   const std::vector<Edge>& edges, const Progress& progress)
{
    if (edges.empty()) return {};
    double largest = 0;
    for (const double r : fit.profile.radius_mm) largest = std::isnan(r) ? largest : std::max(largest, r);
    const std::optional<ScannerAxis> scanner = findScannerAxis(points, fit.axis_T_scan, largest);
    const std::vector<std::vector<EdgePoint>> found = collect(points, fit, edges, scanner, progress);
    const Lean shade = scanner ? Lean{} : leanOfShadows(edges, found);

    std::vector<EdgeRays> result(edges.size());
    parallelFor(edges.size(), 1, progress, [&](std::size_t e, std::size_t) {
        const Edge& edge = edges[e];
        std::vector<Ray>& rays = result[e].rays;
        rays.reserve(found[e].size());
        for (const EdgePoint& p : found[e])
            rays.push_back(
                {p.height - (scanner ? 0 : p.depth * shadow(edge, shade, p.cosine, p.sine)), p.depth < missShare});
        std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.height < b.height; });
        result[e].edge = edge;
        // A ray that passes the part's axis at a distance e reaches the radius r turned by e / r, which on the mean
        // over the turn moves half the rays, the misses, by e / (2 r) of the lean.
        const double inner = std::max(std::min(edge.before_mm, edge.after_mm), heightOf(edge));
        result[e].lean_sigma_mm =
            scanner ? heightOf(edge) * leanOf(*scanner) * std::min(0.15, scanner->sigma_mm / inner) / 4
                    : heightOf(edge) * std::hypot(shade.a, shade.b) * 0.15 / 4;
    });
    return result;
}

}  // namespace lathelier::registration
