#include "engine/features/holes/bolt_circles.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/units.h"
#include "engine/features/holes/hole_limits.h"
#include "engine/features/holes/hole_rim.h"

namespace lathelier::features {
namespace {

/// A hole of a face in polar coordinates about the axis.
struct AxialHole {
    RoundHole rim;
    double from_axis_mm = 0, angle_rad = 0;
};

/// Equal holes of one face.
struct HoleCircle {
    std::size_t count = 0;
    double diameter_mm = 0, diameter_sigma_mm = 0;
    double radius_mm = 0;       ///< of the circle of their centres
    double place_sigma_mm = 0;  ///< of the mean of their centres' places
    double angle_rad = 0;       ///< of one of them, 0 to less than a turn over their number
};

std::vector<AxialHole> provenHoles(const SeenFace& face, const Progress& progress)
{
    std::vector<AxialHole> proven;
    for (const FaceHole& hole : face.holes) {
        progress.check();
        const double radius = std::sqrt(2 * hole.area_mm2 / turn_rad), reach = radius + holeLimits.beside_mm;
        RimView view;
        view.inner_mm = face.inner_mm;
        view.outer_mm = face.outer_mm;
        for (const Eigen::Vector2d& p : face.places_mm)
            if (std::hypot(p.x() - hole.x_mm, p.y() - hole.y_mm) < reach) view.rays.push_back({p.x(), p.y(), true});
        const auto rim = roundHole(view, circleRim(hole.x_mm, hole.y_mm, radius), progress);
        if (!rim) continue;
        proven.push_back({*rim, std::hypot(rim->z_mm, rim->across_mm), std::atan2(rim->across_mm, rim->z_mm)});
    }
    return proven;
}

/// Limit of a difference between two places or sizes of these uncertainties.
double sameWithin_mm(double a_sigma_mm, double b_sigma_mm)
{
    return holeLimits.circle_mm + holeLimits.circle_sigmas * std::hypot(a_sigma_mm, b_sigma_mm);
}

bool areEqual(const AxialHole& a, const AxialHole& b)
{
    return std::abs(a.from_axis_mm - b.from_axis_mm) < sameWithin_mm(a.rim.place_sigma_mm, b.rim.place_sigma_mm) &&
           std::abs(a.rim.diameter_mm - b.rim.diameter_mm) <
               sameWithin_mm(a.rim.diameter_sigma_mm, b.rim.diameter_sigma_mm);
}

/// The circle of equal holes, where they are equally spaced.
std::optional<HoleCircle> circleThrough(const std::vector<AxialHole>& equal)
{
    HoleCircle circle;
    circle.count = equal.size();
    if (circle.count < holeLimits.least_bolts || circle.count > holeLimits.most_bolts) return std::nullopt;
    const auto n = static_cast<double>(circle.count);
    double sine = 0, cosine = 0, variance = 0, place_variance = 0;
    for (const AxialHole& hole : equal) {
        circle.diameter_mm += hole.rim.diameter_mm / n;
        circle.radius_mm += hole.from_axis_mm / n;
        variance += hole.rim.diameter_sigma_mm * hole.rim.diameter_sigma_mm / (n * n);
        place_variance += hole.rim.place_sigma_mm * hole.rim.place_sigma_mm / (n * n);
        sine += std::sin(n * hole.angle_rad);
        cosine += std::cos(n * hole.angle_rad);
    }
    circle.diameter_sigma_mm = std::max(holeLimits.form_mm, std::sqrt(variance));
    circle.place_sigma_mm = std::hypot(std::sqrt(place_variance), holeLimits.form_mm / 2 / std::sqrt(n));
    const double period = turn_rad / n, angle = std::atan2(sine, cosine) / n;
    circle.angle_rad = angle < 0 ? angle + period : angle;
    std::vector<std::uint8_t> taken(circle.count, 0);
    for (const AxialHole& hole : equal) {
        const double off = std::remainder(hole.angle_rad - circle.angle_rad, period);
        if (circle.radius_mm * std::abs(off) > sameWithin_mm(hole.rim.place_sigma_mm, 0)) return std::nullopt;
        const auto place = static_cast<std::ptrdiff_t>(std::lround((hole.angle_rad - circle.angle_rad - off) / period));
        const auto count = static_cast<std::ptrdiff_t>(circle.count);
        std::uint8_t& here = taken[static_cast<std::size_t>(((place % count) + count) % count)];
        if (here) return std::nullopt;
        here = 1;
    }
    return circle;
}

std::vector<HoleCircle> circlesOf(std::vector<AxialHole> holes)
{
    std::vector<HoleCircle> circles;
    while (!holes.empty()) {
        const AxialHole first = holes.front();
        std::vector<AxialHole> equal;
        for (const AxialHole& hole : holes)
            if (areEqual(first, hole)) equal.push_back(hole);
        std::erase_if(holes, [&](const AxialHole& hole) { return areEqual(first, hole); });
        if (const auto circle = circleThrough(equal)) circles.push_back(*circle);
    }
    return circles;
}

bool areOne(const HoleCircle& a, const HoleCircle& b)
{
    const double turned = std::remainder(a.angle_rad - b.angle_rad, turn_rad / static_cast<double>(a.count));
    return a.count == b.count && std::abs(a.radius_mm - b.radius_mm) < holeLimits.circle_mm &&
           a.radius_mm * std::abs(turned) < 2 * holeLimits.circle_mm &&
           std::abs(a.diameter_mm - b.diameter_mm) < sameWithin_mm(a.diameter_sigma_mm, b.diameter_sigma_mm);
}

/// Is all of the circle within the face, and are there no holes on it?
bool isWhole(const SeenFace& face, const HoleCircle& circle)
{
    const double half = circle.diameter_mm / 2;
    if (circle.radius_mm - half < face.inner_mm || circle.radius_mm + half > face.outer_mm) return false;
    return std::none_of(face.holes.begin(), face.holes.end(), [&](const FaceHole& hole) {
        return std::abs(std::hypot(hole.x_mm, hole.y_mm) - circle.radius_mm) < half;
    });
}

ShaftMark markOfCircle(const HoleCircle& circle, double z_mm)
{
    ShaftMark mark{MarkKind::BoltCircle};
    mark.z_start_mm = mark.z_end_mm = z_mm;
    mark.angle_deg = circle.angle_rad * deg_per_rad;
    mark.diameter_mm = circle.diameter_mm;
    mark.pitch_circle_mm = 2 * circle.radius_mm;
    mark.count = static_cast<double>(circle.count);
    mark.uncertainty_mm = 2 * circle.diameter_sigma_mm;
    mark.place_uncertainty_mm = 4 * circle.place_sigma_mm;  // of the ⌀
    mark.angle_uncertainty_deg = 2 * circle.place_sigma_mm / circle.radius_mm * deg_per_rad;
    return mark;
}

}  // namespace

std::vector<ShaftMark> boltCircles(const std::vector<SeenFace>& faces, const Progress& progress)
{
    std::vector<std::vector<HoleCircle>> circles;
    circles.reserve(faces.size());
    for (const SeenFace& face : faces) circles.push_back(circlesOf(provenHoles(face, progress)));
    std::vector<ShaftMark> marks;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const HoleCircle& circle : circles[f]) {
            ShaftMark mark = markOfCircle(circle, faces[f].z_mm);
            bool is_open = false;
            for (std::size_t g = f + 1; g < faces.size() && !is_open; ++g) {
                const auto other = std::find_if(circles[g].begin(), circles[g].end(),
                                                [&](const HoleCircle& one) { return areOne(circle, one); });
                if (other == circles[g].end()) continue;
                mark.z_end_mm = faces[g].z_mm;
                mark.through = 1;
                is_open = true;
                circles[g].erase(other);
            }
            const bool is_closed =
                std::any_of(faces.begin(), faces.end(), [&](const SeenFace& face) { return isWhole(face, circle); });
            if (!is_open && is_closed) mark.through = 0;
            marks.push_back(std::move(mark));
        }
    return marks;
}

}  // namespace lathelier::features
