// Results of the workspace as JSON.
#include <nlohmann/json.hpp>

#include "engine/form/roundness/roundness_quantities.h"
#include "engine/report/result_json.h"
#include "engine/trajectory/trajectory_quantities.h"
#include "widgets/trajectory_common/spindle_picture.h"

namespace lathelier::trajectory_common {

std::string roundnessJson(const SpindlePicture& picture)
{
    const form::RoundnessResult& result = *picture.roundness();
    Json profile{{"path", picture.inputs.empty() ? "" : picture.inputs.front().path}};
    profile.update(toJson(result));
    Json whole{{"profiles", Json::array({profile})}};
    if (picture.superimposed) whole["superimposed"] = toJson(*picture.superimposed);
    return report::toText(
        report::wholeResult("roundness", picture.inputs, toValues(result.parameters), whole, picture.notes));
}

std::string trajectoryJson(const SpindlePicture& picture)
{
    const trajectory::TrajectoryResult& result = *picture.trajectory;
    return report::toText(
        report::wholeResult("trajectory", picture.inputs, toValues(result.parameters), toJson(result), picture.notes));
}

}  // namespace lathelier::trajectory_common
