// Results of the workspace as JSON.
#include <nlohmann/json.hpp>

#include "engine/form/roundness/roundness_quantities.h"
#include "engine/report/result_json.h"
#include "engine/trajectory/trajectory_quantities.h"
#include "widgets/trajectory_common/spindle_outcome.h"

namespace lathelier::trajectory_common {

std::string roundnessJson(const SpindleOutcome& outcome)
{
    const form::RoundnessResult& result = *outcome.roundness();
    Json profile{{"path", outcome.inputs.empty() ? "" : outcome.inputs.front().path}};
    profile.update(toJson(result));
    Json whole{{"profiles", Json::array({profile})}};
    if (outcome.superimposed) whole["superimposed"] = toJson(*outcome.superimposed);
    return report::toText(
        report::wholeResult("roundness", outcome.inputs, toValues(result.parameters), whole, outcome.notes));
}

std::string trajectoryJson(const SpindleOutcome& outcome)
{
    const trajectory::TrajectoryResult& result = *outcome.trajectory;
    return report::toText(
        report::wholeResult("trajectory", outcome.inputs, toValues(result.parameters), toJson(result), outcome.notes));
}

}  // namespace lathelier::trajectory_common
