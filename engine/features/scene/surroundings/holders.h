// What holds an end of a turned part in its scan: a chuck with jaws, or a centre.
//
// Jaws stand higher than the part in a few directions only, with planes across and along the axis for faces, and
// nothing of the part's size follows behind them: the chuck, seen as a larger body of revolution, or no data. A centre
// is a cone of 60° whose tip lies in the end of the part and which grows away from it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/features/scene/surroundings/seen_surface.h"

namespace lathelier::features {

/// Input of findHolders(): a scan in the frame of the part's axis.
struct HolderInput {
    const MeridianCloud& cloud;
    const SeenSurface& surface;
    const std::vector<std::uint32_t>& off;            ///< points of the cloud on no wall and no face
    const std::vector<Eigen::Vector3d>& off_on_axis;  ///< these points
};

struct Holder {
    bool at_last = true;    ///< at the end with the larger z, else at the first one
    double from_mm = 0;     ///< z at which it begins, seen from the part
    double to_mm = 0;       ///< z at which the part must have ended: of the chuck's face, or of the last data
    bool hides_end = true;  ///< false: a centre, beside which the end of the part is seen
    std::vector<std::vector<std::uint32_t>> parts;  ///< points of the cloud: jaws, then all the rest
};

/// At most one at each end.
std::vector<Holder> findHolders(const HolderInput& input, const Progress& progress = {});

}  // namespace lathelier::features
