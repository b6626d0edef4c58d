// The task speed: the spindle speed to cut at in place of a selected one, by the depth of cut and by the rule of the
// papers. The verb and the panel Speed, the operator's screen of Jasiewicz and Miądlicki, "An integrated CNC system for
// chatter suppression in turning": D, L, range of v_c, v_c give N_cor.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/core/material.h"
#include "engine/stability/lobes.h"
#include "engine/stability/speed_choice.h"
#include "engine/stability/stability_plots.h"
#include "engine/stability/task/point_response.h"

namespace lathelier::stability {

struct SpeedQuestion {
    ResponseQuestion response;
    SpeedParameters speed;                            ///< D, v_c or N, range, and what the papers' rule asks
    std::optional<double> depth_mm;                   ///< depth of cut; with the coefficient
    std::optional<double> cutting_coefficient_N_mm2;  ///< K_r; with the depth
    std::optional<double> length_mm;                  ///< L: overhang of a plain bar of diameter D, without a shaft
    std::optional<Material> material;                 ///< of the bar; none: steel is assumed
};

const std::vector<Field<SpeedQuestion>>& fieldsOf(const SpeedQuestion*);

inline constexpr const char* barLengthKey = "length_mm";

struct SpeedOutcome : task::Answered {
    SpeedQuestion question;                  ///< the parameters as a value
    PointResponse response;                  ///< without a response: see `problem`
    std::shared_ptr<const LobeResult> near;  ///< lobes about the selected speed, for charts; null: see `problem`
    std::optional<SpeedResult> published;    ///< by the rule and relation asked for; none: see `problem`
    std::optional<SafeSpeed> safe;           ///< by the depth; none: no depth is given
    std::optional<Error> problem;            ///< a value that is missing, or no speed by the rule

    /// The speed that is recommended: by the depth where it is given, else by the rule.
    std::optional<double> recommendedRpm() const;
};

/// A value that is missing, or no speed by the rule, is part of the outcome. Errors: those of takeResponse(),
/// findLobes(). Throws Cancelled.
SpeedOutcome answerSpeed(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress);

/// What the chart of the outcome marks; valid while the outcome is.
LobesMarks marksOf(const SpeedOutcome& outcome);

/// By the depth of cut where it is given, else by the rule of the papers.
report::Answer answer(const SpeedOutcome& outcome, const Language& language = {});

task::Outcome outcomeOf(const std::shared_ptr<const SpeedOutcome>& outcome);

const task::Task& speedTask();

}  // namespace lathelier::stability
