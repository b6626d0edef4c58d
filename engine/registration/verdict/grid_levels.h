// The levels of cells on the grids of a meridian.
#pragma once

#include <vector>

#include "engine/registration/verdict/revolution_grids.h"
#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {

/// The cells that have points, joined to windows with their neighbours, and the levels above, each of cells twice as
/// large. `cells`: by their place in the grids; `size_mm`: side of a cell.
std::vector<CellLevel> gridLevels(std::vector<Grid> grids, std::vector<SurfaceCell> cells, double size_mm);

}  // namespace lathelier::registration
