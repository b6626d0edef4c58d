#include "engine/registration/revolution/measured_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/registration/point_tasks.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// What counts as a face and how its place is found (README, "Thresholds").
struct FaceThresholds {
    double search_reach_mm = 1;           ///< a face is sought within this distance of the step in the profile
    double next_face_share = 0.45;        ///< of the distance to the next face: less than half, so that none is shared
    double least_density_ratio = 0.1;     ///< least density of the points over that of the sides
    std::size_t least_points = 60;        ///< of a face
    std::size_t ring_points = 24;         ///< least number of points for the median of a ring
    double steepest_slope = 0.2;          ///< dz/dr of a face across the axis; steeper: a chamfer or a cone
    double largest_scatter_share = 0.25;  ///< of the search distance: with a larger scatter there is no face
    std::size_t sectors = 12;             ///< of the place's standard error
    std::size_t least_sector_points = 5;  ///< for the mean of a sector
    double least_sectors = 3;             ///< for a standard error
    double tukey_sigmas = 6;              ///< where the weights of the points reach 0; efficiency 99 %
};
constexpr FaceThresholds faceThresholds{};

constexpr double medianErrorFactor = 1.2533;  // √(π/2): standard error of a median over that of a mean, normal values
constexpr double normalQuantile = 1.96;       // of Student's distribution at 0.975 with many degrees of freedom

using FacePoints = std::vector<std::vector<Vector3d>>;

/// The points about each of the faces, as (z, r, turn 0…1).
FacePoints pointsAbout(const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d& axis_T_points,
                       const std::vector<FaceCandidate>& sought, const std::vector<double>& reach_mm,
                       const Progress& progress)
{
    return parallelReduce(
        points.size(), largeTaskPoints(points.size()), progress, FacePoints(sought.size()),
        [&](std::size_t begin, std::size_t end) {
            FacePoints part(sought.size());
            for (std::size_t i = begin; i < end; ++i) {
                const double z = axis_T_points.linear().row(2).dot(points[i]) + axis_T_points.translation().z();
                for (std::size_t f = 0; f < sought.size(); ++f) {
                    if (!(std::abs(z - sought[f].z_mm) < reach_mm[f])) continue;
                    const Vector3d p = axis_T_points * points[i];
                    const double r = p.head<2>().norm();
                    if (r > sought[f].inner_mm + sought[f].margin_mm && r < sought[f].outer_mm - sought[f].margin_mm)
                        part[f].emplace_back(z, r, quickTurn(p.y(), p.x()) + 0.5);
                }
            }
            return part;
        },
        joinedLists<Vector3d>);
}

std::vector<double> axialPlaces(const std::vector<Vector3d>& points)
{
    std::vector<double> z;
    z.reserve(points.size());
    for (const Vector3d& p : points) z.push_back(p.x());
    return z;
}

/// Mean distance of the points of a sector from the line of their face, with Tukey weights.
struct SectorMean {
    double weight = 0, off = 0;
    std::size_t points = 0;
};

/// Standard error of the mean of all points from the means of their sectors, which differ by more than the scatter
/// where residuals of neighbours are correlated or the face is tilted; bounded below by that of independent points,
/// since a dozen sectors may agree by chance. Scaled by the quantile of Student's distribution over the normal one.
/// Infinite with too few sectors.
double standardErrorOf(const std::vector<SectorMean>& sectors, double scatter_mm, double weights)
{
    double n = 0;
    double offs = 0;
    double squares = 0;
    for (const SectorMean& own : sectors) {
        if (own.points < faceThresholds.least_sector_points) continue;
        const double middle = own.off / own.weight;
        n += 1;
        offs += middle;
        squares += middle * middle;
    }
    if (n < faceThresholds.least_sectors) return std::numeric_limits<double>::infinity();
    const double variance = std::max(0.0, squares - offs * offs / n) / (n - 1);
    const double few = studentQuantile(0.975, static_cast<std::int64_t>(n) - 1) / normalQuantile;
    return few * std::max(std::sqrt(variance / n), scatter_mm / std::sqrt(weights));
}

/// The place of the face with its standard error, from the means of its points with Tukey weights about its rings.
void placeFace(MeasuredFace& face, const std::vector<Vector3d>& points, double scatter_mm)
{
    std::vector<SectorMean> sectors(faceThresholds.sectors);
    const auto count = static_cast<double>(sectors.size());
    double weights = 0;
    double sum = 0;
    for (const Vector3d& p : points) {
        const double off = p.x() - face.zAt_mm(p.y());
        const double w = tukeyWeight(scatter_mm > 0 ? off / (faceThresholds.tukey_sigmas * scatter_mm) : 0);
        if (w == 0) continue;
        weights += w;
        sum += w * p.x();
        SectorMean& own = sectors[std::min(static_cast<std::size_t>(p.z() * count), sectors.size() - 1)];
        own.weight += w;
        own.off += w * off;
        ++own.points;
    }
    face.z_mm = sum / weights;
    face.place_sigma_mm = standardErrorOf(sectors, scatter_mm, weights);
}

/// dz/dr of the straight line through the points.
double slopeOf(const std::vector<Vector3d>& points)
{
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& p : points) middle += p / static_cast<double>(points.size());
    double both = 0;
    double squares = 0;
    for (const Vector3d& p : points) {
        both += (p.y() - middle.y()) * (p.x() - middle.x());
        squares += (p.y() - middle.y()) * (p.y() - middle.y());
    }
    return squares > 0 ? both / squares : 0;
}

/// Points for each mm² of the sides.
double pointDensity(const RadiusProfile& profile, std::size_t points)
{
    double area = 0;
    for (const double radius : profile.radius_mm)
        if (!std::isnan(radius)) area += turn_rad * radius * profile.step_mm;
    return area > 0 ? static_cast<double>(points) / area : 0;
}

/// Median and scatter of one ring, added to the line of the face.
struct RingBuilder {
    MeasuredFace& face;
    double start_mm;  ///< inner radius of the ring
    std::vector<Vector3d> points = {};
    std::vector<double> scatter_mm = {};  ///< of the rings before it
    double variance_mm2 = 0;              ///< sum of those of the rings' medians

    void close(double end_mm)
    {
        if (points.size() >= faceThresholds.ring_points) {
            const double z = median(axialPlaces(points));
            std::vector<double> off;
            off.reserve(points.size());
            double radius = 0;
            for (const Vector3d& p : points) {
                off.push_back(std::abs(p.x() - z));
                radius += p.y() / static_cast<double>(points.size());
            }
            scatter_mm.push_back(madToSigma * medianInPlace(off));
            if (face.line.empty()) face.inner_mm = start_mm;
            face.outer_mm = end_mm;
            face.line.emplace_back(z, radius);
            variance_mm2 += std::pow(medianErrorFactor * scatter_mm.back(), 2) / static_cast<double>(points.size());
        }
        points.clear();
        start_mm = end_mm;
    }
};

/// The line and the extent of a face from its points; the scatter of the points, NaN: most rings are too
/// thin for a face.
double layRings(const std::vector<Vector3d>& points, double inner_mm, std::size_t rings, MeasuredFace& face)
{
    std::vector<std::vector<Vector3d>> thin(rings);
    for (const Vector3d& p : points)
        thin[std::min(rings - 1, static_cast<std::size_t>((p.y() - inner_mm) / face.ring_mm))].push_back(p);
    const auto filled = std::count_if(thin.begin(), thin.end(), [](const std::vector<Vector3d>& ring) {
        return ring.size() >= faceThresholds.ring_points;
    });
    if (2 * static_cast<std::size_t>(filled) < rings) return notANumber;

    const double enough = static_cast<double>(points.size()) / static_cast<double>(rings);
    RingBuilder ring{face, inner_mm};
    for (std::size_t k = 0; k < rings; ++k) {
        const double end = inner_mm + static_cast<double>(k + 1) * face.ring_mm;
        if (thin[k].empty()) {  // a hole
            ring.close(end - face.ring_mm);
            ring.start_mm = end;
            continue;
        }
        ring.points.insert(ring.points.end(), thin[k].begin(), thin[k].end());
        if (static_cast<double>(ring.points.size()) >= enough) ring.close(end);
    }
    ring.close(inner_mm + static_cast<double>(rings) * face.ring_mm);
    if (face.line.empty()) return notANumber;
    face.sigma_mm = std::sqrt(ring.variance_mm2 / static_cast<double>(face.line.size()));
    return medianInPlace(ring.scatter_mm);
}

/// Search distance along z for each of the faces.
std::vector<double> reachesOf(const std::vector<FaceCandidate>& sought)
{
    std::vector<double> reach_mm(sought.size(), faceThresholds.search_reach_mm);
    for (std::size_t f = 1; f < sought.size(); ++f) {
        const double apart = faceThresholds.next_face_share * (sought[f].z_mm - sought[f - 1].z_mm);
        reach_mm[f - 1] = std::min(reach_mm[f - 1], apart);
        reach_mm[f] = std::min(reach_mm[f], apart);
    }
    return reach_mm;
}

/// The face sought, from the points about it; nullopt where these show none. `density`: points for each mm² of the
/// sides; `step_mm`: least width of a ring.
std::optional<MeasuredFace> faceFrom(const std::vector<Vector3d>& points, const FaceCandidate& sought, double reach_mm,
                                     double density, double step_mm)
{
    if (points.size() < faceThresholds.least_points) return std::nullopt;
    const double inner = sought.inner_mm + sought.margin_mm;
    const double outer = sought.outer_mm - sought.margin_mm;
    const double area = std::numbers::pi * (outer * outer - inner * inner);
    MeasuredFace face;
    face.density_ratio = static_cast<double>(points.size()) / (density * area);
    if (!(face.density_ratio >= faceThresholds.least_density_ratio)) return std::nullopt;
    if (std::abs(slopeOf(points)) > faceThresholds.steepest_slope) return std::nullopt;
    // As many rings of one width as points allow; neighbours with few points, near the middle of an end face, are one.
    const double most = (outer - inner) / step_mm;
    const auto rings = static_cast<std::size_t>(
        std::clamp(static_cast<double>(points.size()) / (2 * faceThresholds.ring_points), 1.0, std::max(1.0, most)));
    face.sought_mm = sought.z_mm;
    face.facing = sought.facing;
    face.ring_mm = (outer - inner) / static_cast<double>(rings);
    const double scatter_mm = layRings(points, inner, rings, face);
    if (std::isnan(scatter_mm) || scatter_mm > faceThresholds.largest_scatter_share * reach_mm) return std::nullopt;
    placeFace(face, points, scatter_mm);
    return face;
}

}  // namespace

double MeasuredFace::zAt_mm(double radius_mm) const
{
    const auto after = std::lower_bound(line.begin(), line.end(), radius_mm,
                                        [](const Vector2d& ring, double radius) { return ring.y() < radius; });
    if (after == line.begin()) return line.front().x();
    if (after == line.end()) return line.back().x();
    const Vector2d& before = *(after - 1);
    const double share = (radius_mm - before.y()) / (after->y() - before.y());
    return before.x() + share * (after->x() - before.x());
}

std::vector<MeasuredFace> measureFaces(const std::vector<Eigen::Vector3d>& points_mm,
                                       const Eigen::Isometry3d& axis_T_points, const RadiusProfile& profile,
                                       const std::vector<FaceCandidate>& sought, const Progress& progress)
{
    const std::vector<double> reach_mm = reachesOf(sought);
    const double density = pointDensity(profile, points_mm.size());
    const FacePoints found = pointsAbout(points_mm, axis_T_points, sought, reach_mm, progress);
    std::vector<MeasuredFace> faces;
    for (std::size_t f = 0; f < sought.size(); ++f)
        if (auto face = faceFrom(found[f], sought[f], reach_mm[f], density, profile.step_mm))
            faces.push_back(std::move(*face));
    return faces;
}

}  // namespace lathelier::registration
