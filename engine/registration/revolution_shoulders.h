// Shoulders of a body of revolution: where along the axis the radius jumps.
#pragma once

#include <vector>

#include "engine/registration/revolution_axis.h"

namespace lathelier {

struct Shoulder {
    double z_mm = 0;
    double sigma_mm = 0;   ///< standard uncertainty of z, from the scatter between sectors
    double before_mm = 0;  ///< radius just before it, in z
    double after_mm = 0;   ///< radius just after it
    int facing() const { return after_mm > before_mm ? -1 : 1; }  ///< direction of its outward normal along z
};

/// Shoulders higher than 8 times the scatter, in order of z.
/// A scanner's spot smears a shoulder into a mixture of points of either radius, alike on both sides; the place is the
/// one with as many points of the larger radius on the wrong side as of the smaller. Rays that lean cast a shadow on
/// the side turned away, which displaces that balance by half the shadow; the lean is fitted to the balance in 24
/// sectors of all shoulders together and taken out.
std::vector<Shoulder> findShoulders(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                    const Progress& progress = {});

}  // namespace lathelier
