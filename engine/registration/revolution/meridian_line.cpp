#include "engine/registration/revolution/meridian_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/registration/point_tasks.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector2d;

/// Where the line has faces and gaps (README, "Thresholds").
struct MeridianLineThresholds {
    double lowest_face_mm = 1.5;       ///< the spot smears a lower face over its whole height
    double same_face_mm = 0.001;       ///< tolerance for the place where a face was sought
    std::size_t end_points = 20;       ///< least number of points of an end face
    double end_inside_steps = 1.5;     ///< of the profile, before its last known bin: an end face is sought from there
    double end_outside_steps = 6;      ///< and up to there behind it
    double end_reach_sigmas = 4;       ///< the same in the scatter, where noise is wider than the bins
    double end_below_sigmas = 8;       ///< points of an end face lie that much below the radius beside it
    double end_inner_quantile = 0.05;  ///< of the radii of its points: down to there an end face is seen
    std::size_t bore_clearance_bins = 3;  ///< beside one of the bore, in which the bore may be the nearer surface
    double largest_place = 1e9;           ///< in bins: a point further away has no deviation
};
constexpr MeridianLineThresholds lineThresholds{};

/// Radius at z by the straight line through a known bin.
double radiusFrom(const RadiusProfile& profile, std::size_t bin, double z)
{
    return profile.radius_mm[bin] + profile.slope[bin] * (z - profile.middle_mm(bin));
}

/// The end face that the scan shows: points beyond the last known bin and clearly inside its radius lie on it. Its
/// place and the radii between which it is seen; nullopt with too few points. `facing`: 1 for the end at the larger z,
/// -1 for the other.
std::optional<FaceCandidate> findEndFace(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                         const RadiusProfile& profile, std::size_t last_bin, int facing,
                                         const Progress& progress)
{
    struct Found {
        std::vector<double> z, r;
    };
    const Eigen::Isometry3d& axis_T_scan = fit.axis_T_scan;
    const double sign = facing;
    const double z_end = profile.middle_mm(last_bin) + sign * profile.step_mm / 2;
    const double most_r = profile.radius_mm[last_bin] - lineThresholds.end_below_sigmas * fit.sigma_mm;
    const double noise = lineThresholds.end_reach_sigmas * fit.sigma_mm;
    const double inside = std::max(lineThresholds.end_inside_steps * profile.step_mm, noise);
    const double outside = std::max(lineThresholds.end_outside_steps * profile.step_mm, noise);
    Found found = parallelReduce(
        points.size(), largeTaskPoints(points.size()), progress, Found{},
        [&](std::size_t begin, std::size_t end) {
            Found part;
            for (std::size_t i = begin; i < end; ++i) {
                const double z = axis_T_scan.linear().row(2).dot(points[i]) + axis_T_scan.translation().z();
                const double beyond = (z - z_end) * sign;
                if (beyond < -inside || beyond > outside) continue;
                const double r = (axis_T_scan * points[i]).head<2>().norm();
                if (!(r < most_r)) continue;
                part.z.push_back(z);
                part.r.push_back(r);
            }
            return part;
        },
        [](Found all, const Found& part) {
            all.z.insert(all.z.end(), part.z.begin(), part.z.end());
            all.r.insert(all.r.end(), part.r.begin(), part.r.end());
            return all;
        });
    if (found.z.size() < lineThresholds.end_points) return std::nullopt;
    const double z = upperMedianInPlace(found.z);
    const double inner = quantileInPlace(found.r, lineThresholds.end_inner_quantile);
    return FaceCandidate{z, inner, radiusFrom(profile, last_bin, z), facing};
}

/// Rough zones are left out of the axis fit, but are part of the reference surface.
RadiusProfile withRoughZones(const RevolutionFit& fit)
{
    RadiusProfile profile = fit.profile;
    for (std::size_t i = 0; i < std::min(profile.size(), fit.rough_mm.size()); ++i)
        if (std::isnan(profile.radius_mm[i]) && !std::isnan(fit.rough_mm[i])) {
            profile.radius_mm[i] = fit.rough_mm[i];
            profile.slope[i] = 0;
        }
    return profile;
}

std::vector<std::size_t> knownBins(const RadiusProfile& profile)
{
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < profile.size(); ++i)
        if (!std::isnan(profile.radius_mm[i])) known.push_back(i);
    return known;
}

}  // namespace

MeridianLine::MeridianLine(const TurnedPart& part, const std::vector<Eigen::Vector3d>& points, const Progress& progress)
    : profile_(withRoughZones(part.fit))
{
    const std::vector<std::size_t> known = knownBins(profile_);
    if (known.empty()) return;
    const Ends ends = measureAllFaces(part, points, known, progress);
    clearance_ = clearanceOf(known, layOutside(part, known, ends));
    binStart_ = zFirst_ - profile_.step_mm;
    binStep_ = profile_.step_mm;
    outside_ = indexOf(0, segments_.size());
    if (part.fit.bore.size() == profile_.size()) addBore(part.fit.bore);
}

/// Measures all faces; gives the end faces as far as they are seen.
MeridianLine::Ends MeridianLine::measureAllFaces(const TurnedPart& part, const std::vector<Eigen::Vector3d>& points,
                                                 const std::vector<std::size_t>& known, const Progress& progress)
{
    const Ends ends{findEndFace(points, part.fit, profile_, known.front(), -1, progress),
                    findEndFace(points, part.fit, profile_, known.back(), 1, progress)};
    std::vector<FaceCandidate> sought;
    const auto seek = [&](const FaceCandidate& face) {
        if (face.outer_mm - face.inner_mm >= lineThresholds.lowest_face_mm) sought.push_back(face);
    };
    if (ends.first) seek(*ends.first);
    for (const Shoulder& s : part.shoulders)
        seek({s.z_mm, std::min(s.before_mm, s.after_mm), std::max(s.before_mm, s.after_mm), s.facing()});
    if (ends.last) seek(*ends.last);
    faces_ = measureFaces(points, part.fit.axis_T_scan, profile_, sought, progress);
    return ends;
}

/// The line of the outside. Vertices: the middles of the bins, interrupted by shoulders (a segment across the axis) and
/// by gaps (the line ends). Gives z of everything that is not smooth side, in order.
std::vector<double> MeridianLine::layOutside(const TurnedPart& part, const std::vector<std::size_t>& known,
                                             const Ends& ends)
{
    const double step = profile_.step_mm;
    const auto at = [&](std::size_t bin, double z) { return radiusFrom(profile_, bin, z); };
    std::vector<Vector2d> line;
    zFirst_ = ends.first ? ends.first->z_mm : profile_.middle_mm(known.front()) - step / 2;
    if (ends.first)
        addFace(line, zFirst_, ends.first->inner_mm, ends.first->outer_mm);
    else
        line.emplace_back(zFirst_, at(known.front(), zFirst_));
    std::vector<double> corners{zFirst_};
    auto shoulder = part.shoulders.begin();
    for (std::size_t k = 0; k < known.size(); ++k) {
        const double z1 = profile_.middle_mm(known[k]);
        line.emplace_back(z1, profile_.radius_mm[known[k]]);
        if (k + 1 == known.size()) break;
        const double z2 = profile_.middle_mm(known[k + 1]);
        while (shoulder != part.shoulders.end() && shoulder->z_mm < z1) ++shoulder;
        if (shoulder != part.shoulders.end() && shoulder->z_mm <= z2) {
            addFace(line, shoulder->z_mm, at(known[k], shoulder->z_mm), at(known[k + 1], shoulder->z_mm));
            corners.push_back(shoulder->z_mm);
        } else if (known[k + 1] - known[k] > longestShoulder_bins) {
            line.emplace_back(z1 + step / 2, at(known[k], z1 + step / 2));
            addPiece(line);
            corners.insert(corners.end(), {z1, z2});
            line = {Vector2d(z2 - step / 2, at(known[k + 1], z2 - step / 2))};
        } else if (known[k + 1] - known[k] > 1) {
            corners.insert(corners.end(), {z1, z2});
        }
    }
    zLast_ = ends.last ? ends.last->z_mm : profile_.middle_mm(known.back()) + step / 2;
    if (ends.last)
        addFace(line, zLast_, ends.last->outer_mm, ends.last->inner_mm);
    else
        line.emplace_back(zLast_, at(known.back(), zLast_));
    corners.push_back(zLast_);
    addPiece(line);
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// How far each known bin is from the nearest corner, less a step.
std::vector<double> MeridianLine::clearanceOf(const std::vector<std::size_t>& known,
                                              const std::vector<double>& corners) const
{
    std::vector<double> clearance(profile_.size(), 0);
    for (const std::size_t i : known) {
        if (i == 0 || i + 1 == profile_.size()) continue;  // an end face may lie beyond it, an inner one does not
        const double z = profile_.middle_mm(i);
        const auto next = std::lower_bound(corners.begin(), corners.end(), z);
        double nearest = std::numeric_limits<double>::infinity();
        if (next != corners.end()) nearest = *next - z;
        if (next != corners.begin()) nearest = std::min(nearest, z - *(next - 1));
        clearance[i] = nearest - profile_.step_mm;
    }
    return clearance;
}

/// The segment across the axis, through the rings of the face where it is measured.
void MeridianLine::addFace(std::vector<Vector2d>& line, double z, double from_radius, double to_radius) const
{
    const auto face = std::find_if(faces_.begin(), faces_.end(), [&](const MeasuredFace& f) {
        return std::abs(f.sought_mm - z) < lineThresholds.same_face_mm;
    });
    if (face == faces_.end()) {
        line.emplace_back(z, from_radius);
        line.emplace_back(z, to_radius);
        return;
    }
    line.emplace_back(face->zAt_mm(from_radius), from_radius);
    if (from_radius < to_radius)
        line.insert(line.end(), face->line.begin(), face->line.end());
    else
        line.insert(line.end(), face->line.rbegin(), face->line.rend());
    line.emplace_back(face->zAt_mm(to_radius), to_radius);
}

MeridianLine::Index MeridianLine::indexOf(std::size_t from, std::size_t to) const
{
    const auto bins = static_cast<std::size_t>((zLast_ - zFirst_) / binStep_) + 3;
    Index index{std::vector<std::size_t>(bins, segments_.size()), std::vector<std::size_t>(bins, 0)};
    for (std::size_t s = from; s < to; ++s) {
        const double low = std::min(segments_[s].from.x(), segments_[s].to.x());
        const double high = std::max(segments_[s].from.x(), segments_[s].to.x());
        const auto clampBin = [&](double z) {
            return static_cast<std::size_t>(std::clamp((z - binStart_) / binStep_, 0.0, static_cast<double>(bins - 1)));
        };
        for (std::size_t b = clampBin(low); b <= clampBin(high); ++b) {
            index.first[b] = std::min(index.first[b], s);
            index.last[b] = std::max(index.last[b], s + 1);
        }
    }
    return index;
}

/// The bore's bins joined from the last to the first, so that the material lies on the other side; a step between bins
/// is a shoulder, many unknown bins are a gap.
void MeridianLine::addBore(const RadiusProfile& bore)
{
    const std::size_t first = segments_.size();
    std::vector<Vector2d> line;
    std::size_t before = bore.size();
    for (std::size_t i = bore.size(); i-- > 0;) {
        if (std::isnan(bore.radius_mm[i])) continue;
        const Vector2d here(bore.middle_mm(i), bore.radius_mm[i]);
        if (before < bore.size() && before - i > longestShoulder_bins) {
            addPiece(line);
            line.clear();
        } else if (before < bore.size() && std::abs(bore.radius_mm[before] - here.y()) > bore.step_mm) {
            const double middle = (bore.middle_mm(before) + here.x()) / 2;
            line.emplace_back(middle, bore.radius_mm[before]);
            line.emplace_back(middle, here.y());
        }
        line.push_back(here);
        before = i;
        // Nearer to the bore than to the outside: the quick interpolation does not apply.
        if (!std::isnan(profile_.radius_mm[i])) {
            const double half = (profile_.radius_mm[i] - here.y()) / 2;
            constexpr std::size_t reach = lineThresholds.bore_clearance_bins;
            for (std::size_t k = i < reach ? 0 : i - reach; k < std::min(clearance_.size(), i + reach + 1); ++k)
                clearance_[k] = std::min(clearance_[k], half);
        }
    }
    if (!line.empty()) addPiece(line);
    bore_ = indexOf(first, segments_.size());
}

void MeridianLine::addPiece(const std::vector<Vector2d>& line)
{
    const std::size_t first = segments_.size();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vector2d along = line[i] - line[i - 1];
        if (along.norm() == 0) continue;
        Segment segment;
        segment.from = line[i - 1];
        segment.to = line[i];
        segment.normal = Vector2d(-along.y(), along.x()).normalized();
        segment.from_normal = segment.to_normal = segment.normal;
        segments_.push_back(segment);
    }
    if (segments_.size() == first) return;
    for (std::size_t s = first + 1; s < segments_.size(); ++s) {
        const Vector2d both = segments_[s - 1].normal + segments_[s].normal;
        segments_[s - 1].to_normal = both;
        segments_[s].from_normal = both;
    }
    segments_[first].open_from = true;
    segments_.back().open_to = true;
}

double MeridianLine::deviation_mm(double z, double r, double max_distance) const
{
    const double place = (z - profile_.z_start_mm) / profile_.step_mm;
    if (place >= 0 && place < static_cast<double>(profile_.size())) {
        const auto bin = static_cast<std::size_t>(place);
        if (clearance_[bin] > 0) {  // smooth side: interpolate between this bin and its neighbour on the point's side
            const double t = place - static_cast<double>(bin) - 0.5;
            const std::size_t other = t < 0 ? bin - 1 : bin + 1;
            const double rise = (profile_.radius_mm[other] - profile_.radius_mm[bin]) * (t < 0 ? -1 : 1);
            const double error = r - profile_.radius_mm[bin] - t * rise;
            if (std::abs(error) < clearance_[bin]) {
                const double slope = rise / profile_.step_mm;
                const double deviation = error / std::sqrt(1 + slope * slope);
                return std::abs(deviation) <= max_distance ? deviation : notANumber;
            }
        }
    }
    return search(z, r, max_distance);
}

double MeridianLine::search(double z, double r, double reach) const
{
    const Vector2d point(z, r);
    const auto bins = static_cast<std::ptrdiff_t>(outside_.first.size());
    if (bins == 0) return notANumber;
    const double place = std::floor((z - binStart_) / binStep_);
    if (!(std::abs(place) < lineThresholds.largest_place)) return notANumber;
    const auto centre = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(place), 0, bins - 1);
    double nearest = reach * reach;
    double signed_distance = notANumber;
    const auto tryOne = [&](const Segment& segment) {
        const Vector2d along = segment.to - segment.from;
        const double t = (point - segment.from).dot(along) / along.squaredNorm();
        const Vector2d foot = segment.from + std::clamp(t, 0.0, 1.0) * along;
        const double distance = (point - foot).squaredNorm();
        if (distance > nearest) return;
        nearest = distance;
        const Vector2d& normal = t <= 0 ? segment.from_normal : t >= 1 ? segment.to_normal : segment.normal;
        const bool open = (t < 0 && segment.open_from) || (t > 1 && segment.open_to);
        const double side = (point - foot).dot(normal);
        signed_distance = open ? notANumber : std::copysign(std::sqrt(distance), side);
    };
    // Outward from the point's own bin, until the bins are further than the nearest segment found.
    for (std::ptrdiff_t ring = 0; ring < bins; ++ring) {
        const double gap = (static_cast<double>(ring) - 1) * binStep_;
        if (gap > 0 && gap * gap > nearest) break;
        for (const std::ptrdiff_t bin : {centre - ring, centre + ring}) {
            if (bin < 0 || bin >= bins || (ring == 0 && bin != centre)) continue;
            const auto b = static_cast<std::size_t>(bin);
            for (std::size_t s = outside_.first[b]; s < outside_.last[b]; ++s) tryOne(segments_[s]);
            if (!bore_.first.empty())
                for (std::size_t s = bore_.first[b]; s < bore_.last[b]; ++s) tryOne(segments_[s]);
            if (ring == 0) break;
        }
    }
    return signed_distance;
}

}  // namespace lathelier::registration
