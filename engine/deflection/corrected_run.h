// Correction of one run: corners of the new program and the resulting contour.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/deflection/turning_work.h"
#include "engine/deflection/written_arc.h"

namespace lathelier::deflection {

/// A corner of the corrected path with the quantities that explain it.
struct CorrectedNode {
    double z_mm = 0;
    double x_mm = 0;           ///< radius to program, on the grid where it is corrected
    double programmed_mm = 0;  ///< originally programmed radius
    std::int64_t line = 0;     ///< of the block that ends here, or that this corner divides
    bool added = false;        ///< true: not a block end of the original
    double feed_mm_rev = 0;
    bool in_material = false;      ///< false: in air, not corrected
    std::optional<ArcCentre> arc;  ///< that leads here; none: a line
    bool steps_behind = false;     ///< added by the block that ends here, as the next one begins at another radius
    double dx_um = 0, dy_um = 0, F_t_N = 0, F_f_N = 0, F_ap_N = 0, stiffness_N_mm = 0;  ///< at the tool there

    double correction_um() const { return 2000 * (x_mm - programmed_mm); }  ///< on diameter
};

/// A corrected run.
struct WrittenRun {
    std::vector<CorrectedNode> nodes;  ///< from its start to its end
    ToolRun run;                       ///< the same as a path
    CutPlan cut;                       ///< the same on the nodes of the plan
    std::vector<bool> is_coarse;       ///< pieces of `cut` within an arc
};

/// `before`: workpiece before the run; `ideal`: stations of `cut` with CutTask::Correct, at least one. Corners on a
/// grid of the radius, lines and arcs within the tolerance of the target; arcs that save others within the coarse one.
/// Corners are placed where the cut enters and leaves material, at every end of a block, at shoulders, and in pairs
/// where the feed changes. An arc stays an arc, or becomes several; what of it is in air moves with the rest of it.
/// Error cannotBeWritten.
WrittenRun writtenRun(const WorkPlan& plan, const TurningWork& before, const CutPlan& cut,
                      std::span<const Station> ideal, const ArcLimits& limits);

}  // namespace lathelier::deflection
