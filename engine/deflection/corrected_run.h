// One run with its corners corrected: which corners a program needs, and the contour that they make.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/deflection/turning_work.h"

namespace lathelier::deflection {

/// A corner of the corrected path, and why it is there.
struct CorrectedNode {
    double z_mm = 0;           ///< of the work
    double x_mm = 0;           ///< radius to program, on the grid where it is corrected
    double programmed_mm = 0;  ///< radius as it was programmed
    std::int64_t line = 0;     ///< of the block that ends here, or that this corner divides
    bool added = false;        ///< the original has no block end here
    double feed_mm_rev = 0;    ///< of that block
    bool in_material = false;  ///< false: in air, where nothing is corrected
    double dx_um = 0, dy_um = 0, F_t_N = 0, F_f_N = 0, F_ap_N = 0, stiffness_N_mm = 0;  ///< at the tool there

    double correction_um() const { return 2000 * (x_mm - programmed_mm); }  ///< on diameter
};

/// A run as it is to be written.
struct WrittenRun {
    std::vector<CorrectedNode> nodes;  ///< from its start to its end
    ToolRun run;                       ///< the same as a path
    CutPlan cut;                       ///< the same on the nodes of the plan
};

/// `before`: the work before the run; `ideal`: stations of `cut` taken for correction, at least one. Corners on a grid
/// of `grid_mm` of the radius, straight lines within `tolerance_mm` of what is wanted. A corner stands where the cut
/// enters and leaves material, at every end of a block, at shoulders, and twice where another feed begins. An arc
/// that cuts is replaced by straight blocks, for its ends move by different amounts. Error cannotBeWritten.
WrittenRun writtenRun(const WorkPlan& plan, const TurningWork& before, const CutPlan& cut,
                      std::span<const Station> ideal, double grid_mm, double tolerance_mm);

}  // namespace lathelier::deflection
