#include "engine/registration/revolution/measured_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kEdge_mm = 0.5;       // the scanner's spot smears what lies nearer to an edge
constexpr double kReach_mm = 1;        // a face lies within this of where the profile has a step
constexpr double kApart = 0.45;        // of the way to the next face
constexpr double kLeastDensity = 0.1;  // of that of the other points
constexpr std::size_t kLeastPoints = 60;
constexpr std::size_t kRingPoints = 24;  // enough for the median of a ring
constexpr double kMostSlope = 0.2;       // dz/dr of a face across the axis
constexpr std::size_t kSectors = 12;
constexpr std::size_t kSectorPoints = 5;
constexpr double kStrayShare = 0.25;  // of the reach: points that scatter more lie on no face
constexpr double kToSigma = 1.4826;   // from the median of absolute values to the standard deviation
constexpr double kOfMedian = 1.2533;  // standard error of a median over that of a mean

using Found = std::vector<std::vector<Vector3d>>;

/// The points about each of the faces, as (z, r, turn 0…1).
Found pointsAbout(const std::vector<Eigen::Vector3d>& points, const Eigen::Isometry3d& axis_T_points,
                  const std::vector<FaceSought>& sought, const std::vector<double>& reach_mm, const Progress& progress)
{
    return parallelReduce(
        points.size(), std::max<std::size_t>(16384, points.size() / 24), progress, Found(sought.size()),
        [&](std::size_t begin, std::size_t end) {
            Found part(sought.size());
            for (std::size_t i = begin; i < end; ++i) {
                const double z = axis_T_points.linear().row(2).dot(points[i]) + axis_T_points.translation().z();
                for (std::size_t f = 0; f < sought.size(); ++f) {
                    if (!(std::abs(z - sought[f].z_mm) < reach_mm[f])) continue;
                    const Vector3d p = axis_T_points * points[i];
                    const double r = p.head<2>().norm();
                    if (r > sought[f].inner_mm + kEdge_mm && r < sought[f].outer_mm - kEdge_mm)
                        part[f].emplace_back(z, r, quickTurn(p.y(), p.x()) + 0.5);
                }
            }
            return part;
        },
        [](Found all, const Found& part) {
            for (std::size_t f = 0; f < all.size(); ++f) all[f].insert(all[f].end(), part[f].begin(), part[f].end());
            return all;
        });
}

template <class Points>
std::vector<double> placesOf(const Points& points)
{
    std::vector<double> z;
    z.reserve(points.size());
    for (const auto& p : points) z.push_back(p.x());
    return z;
}

/// Standard error of the face's place: neighbours go together, and the face may lean, so that its sectors tell, not the
/// scatter of the points.
double placeSigma_mm(const MeasuredFace& face, const std::vector<Vector3d>& points)
{
    std::vector<std::vector<double>> sectors(kSectors);
    for (const Vector3d& p : points) {
        const auto sector = static_cast<std::size_t>(p.z() * static_cast<double>(kSectors));
        sectors[std::min(sector, kSectors - 1)].push_back(p.x() - face.zAt_mm(p.y()));
    }
    double n = 0;
    double sum = 0;
    double squares = 0;
    for (std::vector<double>& off : sectors) {
        if (off.size() < kSectorPoints) continue;
        const double middle = median(std::move(off));
        n += 1;
        sum += middle;
        squares += middle * middle;
    }
    if (n < 3) return std::numeric_limits<double>::infinity();
    const double variance = std::max(0.0, squares - sum * sum / n) / (n - 1);
    return std::sqrt(variance / n);
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

/// How far from its place each of the faces is looked for.
std::vector<double> reachesOf(const std::vector<FaceSought>& sought)
{
    std::vector<double> reach_mm(sought.size(), kReach_mm);
    for (std::size_t f = 1; f < sought.size(); ++f) {
        const double apart = kApart * (sought[f].z_mm - sought[f - 1].z_mm);
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
                                       const std::vector<FaceSought>& sought, const Progress& progress)
{
    std::vector<MeasuredFace> faces;
    const std::vector<double> reach_mm = reachesOf(sought);
    const double density = pointDensity(profile, points_mm.size());
    const Found found = pointsAbout(points_mm, axis_T_points, sought, reach_mm, progress);
    for (std::size_t f = 0; f < sought.size(); ++f) {
        const std::vector<Vector3d>& points = found[f];
        if (points.size() < kLeastPoints) continue;
        const double inner = sought[f].inner_mm + kEdge_mm;
        const double outer = sought[f].outer_mm - kEdge_mm;
        const double area = std::numbers::pi * (outer * outer - inner * inner);
        if (static_cast<double>(points.size()) < kLeastDensity * density * area) continue;
        if (std::abs(slopeOf(points)) > kMostSlope) continue;  // a chamfer or a cone
        // Rings hold about as many points each: few near the middle of an end face.
        const double most = (outer - inner) / profile.step_mm;
        const auto rings = static_cast<std::size_t>(
            std::clamp(static_cast<double>(points.size()) / (2 * kRingPoints), 1.0, std::max(1.0, most)));
        MeasuredFace face;
        face.sought_mm = sought[f].z_mm;
        face.facing = sought[f].facing;
        face.ring_mm = (outer - inner) / static_cast<double>(rings);
        std::vector<std::vector<Vector3d>> ring_points(rings);
        for (const Vector3d& p : points)
            ring_points[std::min(rings - 1, static_cast<std::size_t>((p.y() - inner) / face.ring_mm))].push_back(p);
        double variance = 0;
        double count = 0;
        double sum = 0;
        std::vector<double> scatter;
        for (std::size_t k = 0; k < rings; ++k) {
            if (ring_points[k].size() < kRingPoints) continue;
            const double z = median(placesOf(ring_points[k]));
            std::vector<double> off;
            for (const Vector3d& p : ring_points[k]) off.push_back(std::abs(p.x() - z));
            const double sigma = kToSigma * median(std::move(off));
            const double start = inner + static_cast<double>(k) * face.ring_mm;
            if (face.line.empty()) face.inner_mm = start;
            face.outer_mm = start + face.ring_mm;
            face.line.emplace_back(z, start + face.ring_mm / 2);
            scatter.push_back(sigma);
            count += static_cast<double>(ring_points[k].size());
            sum += static_cast<double>(ring_points[k].size()) * z;
            variance += std::pow(kOfMedian * sigma, 2) / static_cast<double>(ring_points[k].size());
        }
        // Most of the rings, or what is there is no face.
        if (2 * face.line.size() < rings || median(scatter) > kStrayShare * reach_mm[f]) continue;
        face.z_mm = sum / count;
        face.place_sigma_mm = placeSigma_mm(face, points);
        face.sigma_mm = std::sqrt(variance / static_cast<double>(face.line.size()));
        faces.push_back(std::move(face));
    }
    return faces;
}

}  // namespace lathelier::registration
