#include "engine/registration/revolution/shoulder_rays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/point_tasks.h"
#include "engine/registration/revolution/quick_turn.h"
#include "engine/registration/revolution/scanner_axis.h"

namespace lathelier::registration {
namespace {

/// The rays beside edges, and their lean (README, "Thresholds").
struct EdgeThresholds {
    std::size_t places_per_bin = 8;   ///< of the table of edges
    double radius_sigmas = 6;         ///< points further outside the two radii are spurious
    std::size_t least_hits = 3;       ///< of the rays of an edge, and as many misses
    std::size_t sectors = 24;         ///< of the turn, in which shadows and flats are sought
    double beyond_edge_mm = 0.5;      ///< so far from an edge the spot of a scanner shows one radius only
    double most_missed_share = 0.05;  ///< of the points there off the larger radius: more have another cause,
    std::size_t least_missed = 4;     ///< as have so many
    std::size_t least_whole = 6;      ///< sectors, for the others to be left out
    double first_lean = 0.002;        ///< search for the lean: from here,
    double lean_factor = 1.3;         ///< in these steps,
    double last_lean = 0.4;           ///< up to here,
    int lean_directions = 24;         ///< in so many directions;
    double first_refining = 0.2;      ///< of the lean: first step of the refinement,
    double last_refining = 1e-6;      ///< and the last
    double least_gain = 1e-12;        ///< of the misfit: a smaller improvement is rounding
    double significance = 12;         ///< mean squares by which two more parameters have to lower the misfit
};
constexpr EdgeThresholds edgeThresholds{};

/// A point near a shoulder.
struct EdgePoint {
    double height;  ///< of the point itself; where the scanner is known, of its ray
    double depth;   ///< below the larger radius, 0…1 of the shoulder; negative: further out than noise
    float cosine, sine;
    std::uint8_t sector;

    bool isOutside() const { return depth < 0; }
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

/// Which edge a place along z belongs to, by bins finer than the profile's; -1: none.
class EdgeTable {
public:
    EdgeTable(const RadiusProfile& profile, const std::vector<Edge>& edges, const std::optional<ScannerAxis>& scanner)
        : start_mm_(profile.z_start_mm),
          fine_mm_(profile.step_mm / static_cast<double>(edgeThresholds.places_per_bin)),
          edgeAt_(profile.size() * edgeThresholds.places_per_bin, -1)
    {
        const double slope = scanner ? leanOf(*scanner) : 0;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            // An inclined ray is displaced along the axis between the larger radius and the smaller one, where it may
            // end; points beyond the middle between two edges belong to the other edge.
            const double lean = slope * heightOf(edges[e]);
            double from = edges[e].from_mm - lean;
            double to = edges[e].to_mm + lean;
            if (e > 0) from = std::max(from, (edges[e - 1].z_mm + edges[e].z_mm) / 2);
            if (e + 1 < edges.size()) to = std::min(to, (edges[e].z_mm + edges[e + 1].z_mm) / 2);
            const auto index = [&](double z) { return std::lround((z - start_mm_) / fine_mm_); };
            const long last = std::min(index(to), static_cast<long>(edgeAt_.size()));
            for (long k = std::max(0L, index(from)); k < last; ++k)
                edgeAt_[static_cast<std::size_t>(k)] = static_cast<std::int16_t>(e);
        }
    }

    int find(double z) const
    {
        const double place = (z - start_mm_) / fine_mm_;
        if (!(place >= 0) || place >= static_cast<double>(edgeAt_.size())) return -1;
        return edgeAt_[static_cast<std::size_t>(place)];
    }

private:
    double start_mm_, fine_mm_;
    std::vector<std::int16_t> edgeAt_;
};

/// A point of the axis frame as a point of an edge, from its height along the axis or that of its ray; nullopt where
/// that does not belong to the edge. `reach`: noise of the radii.
std::optional<EdgePoint> edgePointOf(const Eigen::Vector3d& p, double z, const Edge& edge,
                                     const std::optional<ScannerAxis>& scanner, double reach)
{
    const double r = p.head<2>().norm();
    const double high = std::max(edge.before_mm, edge.after_mm);
    const double height = heightOf(edge);
    if (r < high - height - reach || r == 0) return std::nullopt;
    const bool is_outside = r > high + edge.above_mm + reach;
    double own = z * edge.sign;
    if (scanner) {
        own = rayHeight(p, *scanner, edge);
        if (own < std::min(edge.from_mm * edge.sign, edge.to_mm * edge.sign) ||
            own > std::max(edge.from_mm * edge.sign, edge.to_mm * edge.sign))
            return std::nullopt;
    }
    return EdgePoint{own, is_outside ? -1 : std::clamp((high - r) / height, 0.0, 1.0), static_cast<float>(p.x() / r),
                     static_cast<float>(p.y() / r),
                     static_cast<std::uint8_t>(sectorAbout(p.y(), p.x(), edgeThresholds.sectors))};
}

/// The points of each edge.
std::vector<std::vector<EdgePoint>> collect(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                            const std::vector<Edge>& edges, const std::optional<ScannerAxis>& scanner,
                                            const Progress& progress)
{
    const EdgeTable table(fit.profile, edges, scanner);
    using Found = std::vector<std::vector<EdgePoint>>;
    const double reach = edgeThresholds.radius_sigmas * fit.sigma_mm;
    return parallelReduce(
        points.size(), largeTaskPoints(points.size()), progress, Found(edges.size()),
        [&](std::size_t begin, std::size_t end) {
            Found part(edges.size());
            for (std::size_t i = begin; i < end; ++i) {
                const double z = fit.axis_T_scan.linear().row(2).dot(points[i]) + fit.axis_T_scan.translation().z();
                const int e = table.find(z);
                if (e < 0) continue;
                const auto edge = static_cast<std::size_t>(e);
                if (const auto point = edgePointOf(fit.onAxis(points[i]), z, edges[edge], scanner, reach))
                    part[edge].push_back(*point);
            }
            return part;
        },
        joinedLists<EdgePoint>);
}

/// Leaves out points outside the larger radius, and the sectors in which the wall of that radius is not seen, because a
/// flat or a keyway lies there, or because it is off the axis: hits and misses there are not those of the edge.
void dropInterrupted(const Edge& edge, std::vector<EdgePoint>& points)
{
    const double beyond = edge.z_mm * edge.sign + edgeThresholds.beyond_edge_mm;
    std::vector<std::size_t> all(edgeThresholds.sectors, 0), missed(edgeThresholds.sectors, 0);
    for (const EdgePoint& p : points) {
        if (p.height < beyond) continue;
        ++all[p.sector];
        if (p.isOutside() || p.depth >= missShare) ++missed[p.sector];
    }
    const auto isInterrupted = [&](std::size_t s) {
        return missed[s] >= edgeThresholds.least_missed &&
               static_cast<double>(missed[s]) > edgeThresholds.most_missed_share * static_cast<double>(all[s]);
    };
    std::size_t whole = 0;
    for (std::size_t s = 0; s < edgeThresholds.sectors; ++s)
        if (!isInterrupted(s)) ++whole;
    const bool keeps_all = whole == edgeThresholds.sectors || whole < edgeThresholds.least_whole;
    std::erase_if(points, [&](const EdgePoint& p) { return p.isOutside() || (!keeps_all && isInterrupted(p.sector)); });
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
    for (double slope = edgeThresholds.first_lean; slope < edgeThresholds.last_lean;
         slope *= edgeThresholds.lean_factor)
        for (int k = 0; k < edgeThresholds.lean_directions; ++k) {
            const double direction = turn_rad * k / edgeThresholds.lean_directions;
            const Lean lean{slope * std::cos(direction), slope * std::sin(direction)};
            const double value = shadowMisfit(edges, places, lean);
            if (value < least) {
                least = value;
                best = lean;
            }
        }
    for (double step = edgeThresholds.first_refining * std::hypot(best.a, best.b); step > edgeThresholds.last_refining;
         step /= 2)
        for (bool better = true; better;) {
            better = false;
            for (const auto& [da, db] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const Lean lean{best.a + step * da, best.b + step * db};
                const double value = shadowMisfit(edges, places, lean);
                if (value < least * (1 - edgeThresholds.least_gain)) {
                    least = value;
                    best = lean;
                    better = true;
                }
            }
        }
    // Two more parameters must lower the sum by significantly more than by chance.
    const double freedom = std::max(1.0, static_cast<double>(places.size()) - static_cast<double>(edges.size()) - 2);
    return without - least > edgeThresholds.significance * least / freedom ? best : Lean{};
}

/// Lean from the shadows: the balance of each sector of each edge.
Lean leanOfShadows(const std::vector<Edge>& edges, const std::vector<std::vector<EdgePoint>>& points)
{
    std::vector<SectorPlace> places;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        std::vector<std::vector<Ray>> sectors(edgeThresholds.sectors);
        for (const EdgePoint& p : points[e]) sectors[p.sector].push_back({p.height, p.depth < missShare});
        for (std::size_t s = 0; s < sectors.size(); ++s) {
            std::vector<Ray>& rays = sectors[s];
            std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.height < b.height; });
            const double angle =
                turn_rad * ((static_cast<double>(s) + 0.5) / static_cast<double>(sectors.size()) - 0.5);
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
    if (misses < edgeThresholds.least_hits || rays.size() < misses + edgeThresholds.least_hits) return std::nullopt;
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
    const std::optional<ScannerAxis> scanner = findScannerAxis(points, fit.axis_T_scan, fit.profile.largestRadius_mm());
    std::vector<std::vector<EdgePoint>> found = collect(points, fit, edges, scanner, progress);
    for (std::size_t e = 0; e < edges.size(); ++e) dropInterrupted(edges[e], found[e]);
    const Lean lean = scanner ? Lean{} : leanOfShadows(edges, found);

    std::vector<EdgeRays> result(edges.size());
    parallelFor(edges.size(), 1, progress, [&](std::size_t e, std::size_t) {
        const Edge& edge = edges[e];
        std::vector<Ray>& rays = result[e].rays;
        rays.reserve(found[e].size());
        for (const EdgePoint& p : found[e])
            rays.push_back(
                {p.height - (scanner ? 0 : p.depth * shadow(edge, lean, p.cosine, p.sine)), p.depth < missShare});
        std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.height < b.height; });
        result[e].edge = edge;
        // A ray that passes the part's axis at a distance e reaches the radius r turned by e / r, which on the mean
        // over the turn moves half the rays, the misses, by e / (2 r) of the lean.
        const double inner = std::max(std::min(edge.before_mm, edge.after_mm), heightOf(edge));
        result[e].lean_sigma_mm =
            scanner ? heightOf(edge) * leanOf(*scanner) * std::min(axisOffsetShare, scanner->sigma_mm / inner) / 4
                    : heightOf(edge) * std::hypot(lean.a, lean.b) * axisOffsetShare / 4;
    });
    return result;
}

}  // namespace lathelier::registration
