// Shoulders of a body of revolution: where along the axis the radius jumps.
#pragma once

#include <vector>

#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

struct Shoulder {
    double z_mm = 0;       ///< place along the axis, in the axis frame of the part
    double sigma_mm = 0;   ///< standard uncertainty of z
    double before_mm = 0;  ///< radius just before it, in z
    double after_mm = 0;   ///< radius just after it
    int facing() const { return after_mm > before_mm ? -1 : 1; }  ///< direction of its outward normal along z
};

/// Shoulders of the two parts to be compared, in order of z, and the end faces that their scans show; the radius beyond
/// an end face is 0.
/// A scanner's spot smears a shoulder: near it, a ray may hit the larger radius or not, with a probability that rises
/// with its height over the width of the spot, in proportion or more in the middle of the spot. Place, width and which
/// of the two are fitted to that by maximum likelihood, the width for all shoulders of a scan together, and for both
/// scans together when that contradicts neither (the same scanner). The uncertainty of the width is part of each
/// shoulder's uncertainty. A shoulder or an end whose face the scan shows is placed by the points of that face
/// (measured_faces.h).
struct ShoulderPair {
    std::vector<Shoulder> reference;       ///< of the reference, in its axis frame
    std::vector<Shoulder> copy;            ///< of the copy, in its axis frame
    std::vector<Shoulder> reference_ends;  ///< at most two, in order of z
    std::vector<Shoulder> copy_ends;       ///< at most two, in order of z
};
ShoulderPair findShoulders(const std::vector<Eigen::Vector3d>& reference_points, const RevolutionFit& reference,
                           const std::vector<Eigen::Vector3d>& copy_points, const RevolutionFit& copy,
                           const Progress& progress = {});

}  // namespace lathelier::registration
