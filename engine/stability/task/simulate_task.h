// The task simulate: a cut in time, with loss of contact, on the modes of the point that is cut (point_modes.h). Where
// these are not those of the response at the vibration that is found, the verdict is undecided. The verb.
#pragma once

#include <memory>
#include <vector>

#include "engine/stability/simulation/simulation.h"
#include "engine/stability/task/point_response.h"

namespace lathelier::stability {

struct SimulateQuestion {
    ResponseQuestion response;
    SimulationParameters cut;
};

const std::vector<Field<SimulateQuestion>>& fieldsOf(const SimulateQuestion*);

struct SimulateOutcome : task::Answered {
    SimulateQuestion question;                       ///< the parameters as a value
    PointResponse response;                          ///< what the modes are of
    std::vector<Mode> modes;                         ///< that are simulated
    std::shared_ptr<const SimulationResult> result;  ///< never null
};

/// Errors: those of takeResponse(), modesOfPoint(), simulate(). Throws Cancelled.
SimulateOutcome answerSimulate(const project::PanelState& state, Stores& stores, task::Sources& sources,
                               const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const SimulateOutcome>& outcome);

inline constexpr const char* waveformExport = "csv";
inline constexpr const char* soundExport = "wav";

const task::Task& simulateTask();

}  // namespace lathelier::stability
