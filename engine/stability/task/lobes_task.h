// The task lobes: the limiting depth of cut over the spindle speed, an operating point and the speed to use at its
// depth; over a pass as well. The verb and the panels Lobes and Pass.
//
// The operating point is judged where its speed or its depth is stated; what of it is not stated is the middle of the
// speeds shown, or one and a half times the least limit. A pass is judged at its own depth.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/receptance/shaft/forced_shape.h"
#include "engine/stability/lobes.h"
#include "engine/stability/marks_item.h"
#include "engine/stability/operating_point.h"
#include "engine/stability/pass/lobes_over_pass.h"
#include "engine/stability/safe_speed.h"
#include "engine/stability/speed_choice.h"
#include "engine/stability/task/point_response.h"

namespace lathelier::stability {

inline constexpr const char* marksRole = "marks";

struct LobesQuestion {
    ResponseQuestion response;
    LobeParameters lobes;
    PointParameters point;
    SpeedParameters speed;  ///< range of the tool, and the rule of the papers for the candidates; the rest is derived
    PassParameters pass;
};

const std::vector<Field<LobesQuestion>>& fieldsOf(const LobesQuestion*);

inline constexpr const char* operatingSpeedKey = "operating_speed_rpm";
inline constexpr const char* operatingDepthKey = "operating_depth";
inline constexpr const char* passDepthKey = "pass_depth_mm";

struct LobesOutcome : task::Answered {
    LobesQuestion question;  ///< the parameters as a value
    PointResponse response;
    std::shared_ptr<const LobeResult> lobes;  ///< never null
    OperatingPoint point;                     ///< as stated, else its default
    bool is_judged = false;                   ///< the point is stated
    SafeSpeed safe;                           ///< of the point; of the pass where there is one
    std::optional<SpeedResult> candidates;    ///< by the rule and relation asked for; none: no speed by it
    std::shared_ptr<const PassResult> pass;   ///< null: not asked
    std::optional<SurfaceMarks> marks;        ///< of a cut surface; none: not given
    /// How the work swings as it chatters, at the point's speed, else at the least limit; none: its shaft is not known,
    /// nothing chatters, or a pass is asked for.
    std::optional<receptance::ForcedShape> swing;
};

/// Errors: those of takeResponse(), findLobes(), lobesOverPass(). Throws Cancelled.
LobesOutcome answerLobes(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress);

/// What the chart of the outcome marks; valid while the outcome is.
LobesMarks marksOf(const LobesOutcome& outcome);

/// The depth of the pass or of the operating point against its limit; else the depth that is stable at every speed.
report::Answer answer(const LobesOutcome& outcome, const Language& language = {});

task::Outcome outcomeOf(const std::shared_ptr<const LobesOutcome>& outcome);

inline constexpr const char* limitExport = "csv";

const task::Task& lobesTask();

}  // namespace lathelier::stability
