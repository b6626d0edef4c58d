#include "engine/registration/revolution/measured_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double faceSearchReach_mm = 1;   // a face is sought within this distance of the step in the profile
constexpr double nextFaceShare = 0.45;     // share of the distance to the next face
constexpr double leastDensityRatio = 0.1;  // point density over that of the sides
constexpr std::size_t leastFacePoints = 60;
constexpr std::size_t ringPoints = 24;     // least number of points for the median of a ring
constexpr double steepestFaceSlope = 0.2;  // dz/dr of a face across the axis
constexpr std::size_t faceSectors = 12;
constexpr std::size_t leastSectorPoints = 5;
constexpr double largestScatterShare = 0.25;  // of the search distance: with a larger scatter there is no face
constexpr double faceTukeyLimit_sigmas = 6;   // of the weights of the points of a face; efficiency 99 %
constexpr double medianErrorFactor = 1.2533;  // standard error of a median over that of a mean
constexpr double normalQuantile = 1.96;       // of Student's distribution at 0.975 with many degrees of freedom

using FacePoints = std::vector<std::vector<Vector3d>>;

/// The points about each of the faces, as (z, r, turn 0…1).
FacePoints pointsAbout(const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d& axis_T_points,
                       const std::vector<FaceCandidate>& sought, const std::vector<double>& reach_mm,
                       const Progress& progress)
{
    return parallelReduce(
        points.size(), std::max<std::size_t>(16384, points.size() / 24), progress, FacePoints(sought.size()),
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
        [](FacePoints all, const FacePoints& part) {
            for (std::size_t f = 0; f < all.size(); ++f) all[f].insert(all[f].end(), part[f].begin(), part[f].end());
            return all;
        });
}

template <class Points>
std::vector<double> axialPlaces(const Points& points)
{
    std::vector<double> z;
    z.reserve(points.size());
    for (const auto& p : points) z.push_back(p.x());
    return z;
}

/// The place of the face with its standard error, from the means of its points with Tukey weights about its rings.
/// The error is that of the means of its sectors, since residuals of neighbours are correlated and the face may be
/// tilted; bounded below by the scatter of its points, since a dozen sectors may agree by chance. Scaled by the
/// quantile of Student's distribution over the normal one.
void placeFace(MeasuredFace& face, const std::vector<Vector3d>& points, double scatter_mm)
{
    struct Mean {
        double weight = 0, off = 0;
        std::size_t points = 0;
    };
    std::vector<Mean> sectors(faceSectors);
    double weights = 0;
    double sum = 0;
    for (const Vector3d& p : points) {
        const double off = p.x() - face.zAt_mm(p.y());
        const double u = scatter_mm > 0 ? off / (faceTukeyLimit_sigmas * scatter_mm) : 0;
        if (!(u * u < 1)) continue;
        const double w = (1 - u * u) * (1 - u * u);
        weights += w;
        sum += w * p.x();
        Mean& own =
            sectors[std::min(static_cast<std::size_t>(p.z() * static_cast<double>(faceSectors)), faceSectors - 1)];
        own.weight += w;
        own.off += w * off;
        ++own.points;
    }
    face.z_mm = sum / weights;
    double n = 0;
    double offs = 0;
    double squares = 0;
    for (const Mean& own : sectors) {
        if (own.points < leastSectorPoints) continue;
        const double middle = own.off / own.weight;
        n += 1;
        offs += middle;
        squares += middle * middle;
    }
    face.place_sigma_mm = std::numeric_limits<double>::infinity();
    if (n < 3) return;
    const double variance = std::max(0.0, squares - offs * offs / n) / (n - 1);
    const double few = studentQuantile(0.975, static_cast<std::int64_t>(n) - 1) / normalQuantile;
    face.place_sigma_mm = few * std::max(std::sqrt(variance / n), scatter_mm / std::sqrt(weights));
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
        if (!std::isnan(radius)) area += 2 * std::numbers::pi * radius * profile.step_mm;
    return area > 0 ? static_cast<double>(points) / area : 0;
}

/// The line and the extent of a face from its points; the scatter of the points, NaN: most rings are too
/// thin for a face.
double layRings(const std::vector<Vector3d>& points, double inner_mm, std::size_t rings, MeasuredFace& face)
{
    std::vector<std::vector<Vector3d>> thin(rings);
    for (const Vector3d& p : points)
        thin[std::min(rings - 1, static_cast<std::size_t>((p.y() - inner_mm) / face.ring_mm))].push_back(p);
    const auto filled = std::count_if(thin.begin(), thin.end(),
                                      [](const std::vector<Vector3d>& ring) { return ring.size() >= ringPoints; });
    if (2 * static_cast<std::size_t>(filled) < rings) return notANumber;

    const double enough = static_cast<double>(points.size()) / static_cast<double>(rings);
    double variance = 0;
    double start = inner_mm;
    std::vector<double> scatter;
    std::vector<Vector3d> ring;
    const auto close = [&](double end) {
        if (ring.size() >= ringPoints) {
            const double z = median(axialPlaces(ring));
            std::vector<double> off;
            off.reserve(ring.size());
            double radius = 0;
            for (const Vector3d& p : ring) {
                off.push_back(std::abs(p.x() - z));
                radius += p.y() / static_cast<double>(ring.size());
            }
            scatter.push_back(madToSigma * median(std::move(off)));
            const auto n = static_cast<double>(ring.size());
            if (face.line.empty()) face.inner_mm = start;
            face.outer_mm = end;
            face.line.emplace_back(z, radius);
            variance += std::pow(medianErrorFactor * scatter.back(), 2) / n;
        }
        ring.clear();
        start = end;
    };
    for (std::size_t k = 0; k < rings; ++k) {
        const double end = inner_mm + static_cast<double>(k + 1) * face.ring_mm;
        if (thin[k].empty()) {  // a hole
            close(end - face.ring_mm);
            start = end;
            continue;
        }
        ring.insert(ring.end(), thin[k].begin(), thin[k].end());
        if (static_cast<double>(ring.size()) >= enough) close(end);
    }
    close(inner_mm + static_cast<double>(rings) * face.ring_mm);
    if (face.line.empty()) return notANumber;
    face.sigma_mm = std::sqrt(variance / static_cast<double>(face.line.size()));
    return median(std::move(scatter));
}

/// Search distance along z for each of the faces.
std::vector<double> reachesOf(const std::vector<FaceCandidate>& sought)
{
    std::vector<double> reach_mm(sought.size(), faceSearchReach_mm);
    for (std::size_t f = 1; f < sought.size(); ++f) {
        const double apart = nextFaceShare * (sought[f].z_mm - sought[f - 1].z_mm);
        reach_mm[f - 1] = std::min(reach_mm[f - 1], apart);
        reach_mm[f] = std::min(reach_mm[f], apart);
    }
    return reach_mm;
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
    std::vector<MeasuredFace> faces;
    const std::vector<double> reach_mm = reachesOf(sought);
    const double density = pointDensity(profile, points_mm.size());
    const FacePoints found = pointsAbout(points_mm, axis_T_points, sought, reach_mm, progress);
    for (std::size_t f = 0; f < sought.size(); ++f) {
        const std::vector<Vector3d>& points = found[f];
        if (points.size() < leastFacePoints) continue;
        const double inner = sought[f].inner_mm + sought[f].margin_mm;
        const double outer = sought[f].outer_mm - sought[f].margin_mm;
        const double area = std::numbers::pi * (outer * outer - inner * inner);
        const double density_ratio = static_cast<double>(points.size()) / (density * area);
        if (!(density_ratio >= leastDensityRatio)) continue;
        if (std::abs(slopeOf(points)) > steepestFaceSlope) continue;  // a chamfer or a cone
        // As many rings of one width as points allow; neighbours with few points, near the middle of an end face, are
        // one.
        const double most = (outer - inner) / profile.step_mm;
        const auto rings = static_cast<std::size_t>(
            std::clamp(static_cast<double>(points.size()) / (2 * ringPoints), 1.0, std::max(1.0, most)));
        MeasuredFace face;
        face.sought_mm = sought[f].z_mm;
        face.facing = sought[f].facing;
        face.ring_mm = (outer - inner) / static_cast<double>(rings);
        const double scatter_mm = layRings(points, inner, rings, face);
        if (std::isnan(scatter_mm) || scatter_mm > largestScatterShare * reach_mm[f]) continue;
        face.density_ratio = density_ratio;
        placeFace(face, points, scatter_mm);
        faces.push_back(std::move(face));
    }
    return faces;
}

}  // namespace lathelier::registration
