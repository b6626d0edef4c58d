// Spindle speeds by section from the dynamics of the partly machined workpiece.
//
// The workpiece is a beam from its free end to the chuck's face, joined to the spindle there (engine/receptance); the
// speed is that of engine/stability/speed_choice.h for the cutting speed that is selected; by the exact relation, with
// the force of a known work material, that of engine/stability/safe_speed.h at the depth of the cut. Finish passes over
// a cylinder get one speed each, computed at the end toward the free end, where compliance is largest. Roughing passes
// over the whole length get one each as well, for the body after the pass. Faces, and cones and arcs of 3 mm and more,
// keep constant cutting speed.
#pragma once

#include <optional>
#include <vector>

#include "engine/cam/clampings.h"
#include "engine/cam/cutting_data.h"
#include "engine/cam/operation.h"
#include "engine/cam/work_stock.h"
#include "engine/core/frf.h"
#include "engine/core/progress.h"
#include "engine/receptance/spindle/spindle_receptance.h"
#include "engine/stability/lobes.h"

namespace lathelier::cam {

/// Workpiece model for the speeds of finishing.
enum class PartModel : std::uint8_t {
    Finished,  ///< the whole part as drawn, with the bar behind it up to the chuck
    Moment     ///< the workpiece at the start of the section
};

struct SpeedRequest {
    std::optional<receptance::SpindleReceptance> spindle;                     ///< none: no dynamics
    stability::SpeedRelation relation = stability::SpeedRelation::Published;  ///< of lobes and speeds
    PartModel model = PartModel::Finished;                                    ///< for finishing
    double max_rpm = 0;                                                       ///< limit of the spindle
    const WorkMaterial* material = nullptr;                                   ///< for depths in mm; null: not known
    Shaft whole;  ///< the finished part in this clamping, up to the chuck
};

/// A stretch of the part with one speed in the finish.
struct SectionSpeed {
    double z_start_mm = 0;            ///< from the free end of the clamping
    double z_end_mm = 0;              ///< end toward the chuck
    double diameter_mm = 0;           ///< of its cylinder, or the largest
    std::optional<double> speed_rpm;  ///< fixed; none: constant cutting speed
    double cutting_speed_m_min = 0;
    std::optional<double> frequency_hz;  ///< where Re G is least; none: no dynamics
    int lobe = 0;                        ///< k of the selected speed; 0: none
    Text reason;
    double Rz_um = 0;                       ///< ideal, the worst of its rows
    std::optional<double> stable_depth_mm;  ///< stable depth at the kept speed where no speed is stable
    int setup = 1;
    double constant_m_min = 0;  ///< v_c outside fixed speeds; 0: the job states all speeds
    double max_rpm = 0;         ///< limit of the spindle for it
    FrfPtr receptance;          ///< receptance of the workpiece at the point of cut; null: no dynamics
};

/// Speeds of finishing in this clamping. Without spindle and stated sections: constant cutting speed. Notes:
/// noStableSpeedHere, speedChatters. `before_finish`: stock before finishing. Errors of receptanceOf(). Throws
/// Cancelled.
std::vector<SectionSpeed> finishSections(const Clamping& clamping, const SpeedRequest& request,
                                         const WorkStock& before_finish, Notes& notes, const Progress& progress = {});

/// One fixed speed for a pass of the opposite hand, for the longest cylinder that it turns. Notes: backSpeed,
/// noStableSpeedHere, speedChatters.
void setBackSpeed(Operation& back, const Clamping& clamping, const SpeedRequest& request, const WorkStock& before,
                  Notes& notes, const Progress& progress = {});

/// Fixed speeds for the long passes of roughing, from the work as each leaves it; `before`: stock before the operation.
void setRoughSpeeds(Operation& rough, const Clamping& clamping, const SpeedRequest& request, WorkStock before,
                    Notes& notes, const Progress& progress = {});

}  // namespace lathelier::cam
