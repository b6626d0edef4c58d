// Question of the task training: scenario or the shop's own machine, operating point, visibility of the chart.
#pragma once

#include <optional>
#include <vector>

#include "engine/stability/modes.h"
#include "engine/training/scenario.h"

namespace lathelier::training {

enum class Part { Rigid, Slender, Tailstock, WornBearing };  ///< in the order of scenarios()

struct TrainingQuestion {
    Part part = Part::Slender;        ///< where neither a response nor modes are given
    std::optional<double> speed_rpm;  ///< operating point; none: that of the scenario
    std::optional<double> depth_mm;   ///< operating point; none: that of the scenario
    stability::SpeedRelation relation = stability::SpeedRelation::Exact;  ///< of the lobes in the chart
    bool hide_chart = false;                          ///< teacher mode: the stability chart is hidden
    std::optional<double> cutting_coefficient_N_mm2;  ///< K_r; none: that of the scenario
    std::optional<double> feed_mm_rev;                ///< none: that of the scenario
    std::vector<Interval> range_rpm;                  ///< speeds that are shown, at most one; none: of the scenario
    std::vector<stability::Mode> modes;               ///< of the shop's own machine, in place of a response
};

const std::vector<Field<TrainingQuestion>>& fieldsOf(const TrainingQuestion*);

/// The scenario with what the question changes of it, but for its depths, which follow from the limits. `own`: modes of
/// the shop's machine; empty: those of the scenario.
Scenario scenarioOf(const TrainingQuestion& question, const std::vector<stability::Mode>& own);

}  // namespace lathelier::training
