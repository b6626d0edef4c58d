// The fastest growing vibration of a cut from snapshots of its deflection, one for each revolution (dynamic mode
// decomposition: P. J. Schmid, J. Fluid Mech. 656 (2010) 5-28). In a file of its own: its solvers take long to compile.
#pragma once

#include <Eigen/Core>

#include "engine/stability/simulation/growth.h"

namespace lathelier::stability {

inline constexpr int mostSnapshots = 16;

using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostSnapshots + 1, mostSnapshots + 1>;

/// Scalar products of the snapshots of one cut, and of the snapshots with themselves a step later.
struct SnapshotProducts {
    Small same;   ///< all snapshots, the last one included
    Small later;  ///< without the last one
};

/// Growth over a revolution of `steps` steps; none where the snapshots have no size.
Growth growthOf(const SnapshotProducts& products, double revolution_s, int steps);

}  // namespace lathelier::stability
