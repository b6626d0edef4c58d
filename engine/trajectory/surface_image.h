// The geometric image of the machined surface from the motions of workpiece and tool. Source: Yurkevich & Orlova,
// equation (1), with the polar angle corrected: the generated point P, seen from the workpiece's axis A, does not lie
// at the rotation angle of the spindle.
#pragma once

#include <span>

#include "engine/trajectory/section_signals.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// Displacements of the workpiece's axis (X3, Y3) and of the tool (Xp, Yp) at the same angles, in µm.
struct Motions {
    std::span<const double> X3_um, Y3_um, Xp_um, Yp_um;
};

/// R = |AP| with A = (X3, Y3), P = (D/2 + Xp, Yp), at the polar angle θ + atan2(Y3 - Yp, D/2 - X3 + Xp) on the part;
/// with Rotation::Opposite at minus that angle. NaN where a displacement is missing.
struct SurfaceImage {
    std::vector<double> radius_mm;
    std::vector<double> body_angle_deg;  ///< polar angle on the part, 0…360

    std::vector<Eigen::Vector2d> points_mm() const;  ///< finite points in order
};
SurfaceImage imageOf(const Motions& motions, std::span<const double> angle_deg, double workpiece_diameter_mm,
                     Rotation rotation);

/// Images of the single revolutions, which show the variation that the averages hide.
struct RevolutionImages {
    std::vector<double> envelope_min_mm, envelope_max_mm;  ///< of the radii at each angle
    std::vector<double> RONt_um;                           ///< about each image's own LSC centre
};
RevolutionImages revolutionImages(const SectionSignals& signals, std::span<const double> angle_deg,
                                  double workpiece_diameter_mm, Rotation rotation,
                                  const signal::TransmissionBand& band);

}  // namespace lathelier::trajectory
