#include "engine/trajectory/surface_image.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/form/circle/circles.h"

namespace lathelier::trajectory {
namespace {

double turned(double angle_deg)
{
    const double within = std::fmod(angle_deg, 360);
    return within < 0 ? within + 360 : within;
}

/// Radii about the spindle axis approximate those about the circle's centre: for an eccentricity of some µm the
/// difference is some pm.
void filterRadii(SurfaceImage& image, const signal::TransmissionBand& band, bool whole)
{
    if (whole) {
        image.radius_mm = filterClosed(image.radius_mm, band);
        return;
    }
    std::vector<double> angle_rad, radius_mm;
    for (std::size_t i = 0; i < image.radius_mm.size(); ++i)
        if (std::isfinite(image.radius_mm[i])) {
            angle_rad.push_back(rad_per_deg * image.body_angle_deg[i]);
            radius_mm.push_back(image.radius_mm[i]);
        }
    if (radius_mm.empty()) return;
    const std::vector<double> filtered = filterClosedAt(angle_rad, radius_mm, band).values;
    std::size_t next = 0;
    for (double& radius : image.radius_mm)
        if (std::isfinite(radius)) radius = filtered[next++];
}

}  // namespace

std::vector<Eigen::Vector2d> SurfaceImage::points_mm() const
{
    std::vector<Eigen::Vector2d> points;
    points.reserve(radius_mm.size());
    for (std::size_t i = 0; i < radius_mm.size(); ++i)
        if (std::isfinite(radius_mm[i]))
            points.emplace_back(radius_mm[i] * std::cos(rad_per_deg * body_angle_deg[i]),
                                radius_mm[i] * std::sin(rad_per_deg * body_angle_deg[i]));
    return points;
}

SurfaceImage imageOf(const Motions& motions, std::span<const double> angle_deg, double workpiece_diameter_mm,
                     Rotation rotation)
{
    SurfaceImage image;
    image.radius_mm.reserve(angle_deg.size());
    image.body_angle_deg.reserve(angle_deg.size());
    const double sense = rotation == Rotation::Same ? 1 : -1;
    for (std::size_t i = 0; i < angle_deg.size(); ++i) {
        const double across_mm = workpiece_diameter_mm / 2 - 1e-3 * (motions.X3_um[i] - motions.Xp_um[i]);
        const double up_mm = 1e-3 * (motions.Y3_um[i] - motions.Yp_um[i]);
        const double radius_mm = std::hypot(across_mm, up_mm);
        image.radius_mm.push_back(radius_mm);
        image.body_angle_deg.push_back(std::isfinite(radius_mm)
                                           ? turned(sense * (angle_deg[i] + std::atan2(up_mm, across_mm) / rad_per_deg))
                                           : notANumber);
    }
    return image;
}

RevolutionImages revolutionImages(const SectionSignals& signals, std::span<const double> angle_deg,
                                  double workpiece_diameter_mm, Rotation rotation, const signal::TransmissionBand& band)
{
    const std::size_t n = signals.points;
    RevolutionImages result;
    result.envelope_min_mm.assign(n, notANumber);
    result.envelope_max_mm.assign(n, notANumber);
    for (std::size_t k = 0; k < signals.revolutions(); ++k) {
        const auto part = [&](Probe probe) {
            return std::span(signals.um[static_cast<std::size_t>(probe)]).subspan(k * n, n);
        };
        SurfaceImage image = imageOf({part(Probe::X3), part(Probe::Y3), part(Probe::Xp), part(Probe::Yp)}, angle_deg,
                                     workpiece_diameter_mm, rotation);
        bool whole = true;  // no sample was rejected
        for (std::size_t i = 0; i < n; ++i) {
            const double radius_mm = image.radius_mm[i];
            whole = whole && std::isfinite(radius_mm);
            result.envelope_min_mm[i] = std::fmin(result.envelope_min_mm[i], radius_mm);
            result.envelope_max_mm[i] = std::fmax(result.envelope_max_mm[i], radius_mm);
        }
        if (!band.isAll()) filterRadii(image, band, whole);
        const std::vector<Eigen::Vector2d> points = image.points_mm();
        result.RONt_um.push_back(points.size() >= 4 ? form::fitLeastSquaresCircle(points).RONt_um : notANumber);
    }
    return result;
}

}  // namespace lathelier::trajectory
