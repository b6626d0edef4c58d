// Chains of walls along the axis.
#pragma once

#include <vector>

#include "engine/features/walls/walls.h"

namespace lathelier::features {

/// Appends the wall to the chain whose last wall is nearest in radius, or begins a chain. A row of points that the
/// border of two bins divides becomes one wall.
void appendWall(std::vector<Chain>& open, const Wall& wall, double bin_mm);

/// A chain that continues behind a short gap ends there when other walls lie in the gap: those of a narrow groove.
void splitAtGrooves(std::vector<Chain>& chains, double bin_mm);

/// Takes scattered walls off a chain's ends: clusters of points of a face are no walls.
void trimFaces(Chain& chain);

/// A chain that lies over most of its length inside another one is a bore.
bool isBore(const Chain& chain, const std::vector<Chain>& chains, double bin_mm);

}  // namespace lathelier::features
