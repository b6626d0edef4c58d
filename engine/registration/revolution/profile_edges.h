// Edges in the profile of a body of revolution: shoulders, where the radius jumps between neighbouring bins.
#pragma once

#include <vector>

#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

/// Where the radius jumps, roughly. Heights are z times `sign`, so that the larger radius lies at larger heights.
struct Edge {
    double z_mm = 0;                ///< half way between the bins beside it
    double before_mm = 0;           ///< radius just before it, in z
    double after_mm = 0;            ///< radius just after it
    double sign = 1;                ///< 1: the radius rises with z, -1: it falls
    double from_mm = 0, to_mm = 0;  ///< range of z of the rays
    double above_mm = 0;            ///< how far beyond the larger radius its wall rises within that stretch
};

/// All jumps that noise and slopes do not make, in order of z.
std::vector<Edge> findEdges(const RevolutionFit& fit);

}  // namespace lathelier::registration
