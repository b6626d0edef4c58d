// Flanks so steep that the radii of one bin spread far and those of neighbouring bins differ by more than those of a
// chamfer: of V-pulleys, of balls near their poles.
#pragma once

#include <vector>

#include "engine/features/walls/walls.h"

namespace lathelier::features {

/// Sets Wall::slope of the walls of steep flanks, which are compact then: walls of at least five bins that follow each
/// other evenly, whose points fill the slope between them. A face across the axis has one or two such walls; its points
/// spread further than its walls advance. `bins`: the walls of each bin. `sigma_mm`: noise of single points.
void findSteepWalls(const std::vector<std::vector<Wall*>>& bins, double sigma_mm, double bin_mm);

}  // namespace lathelier::features
