// Question of the panel Pass: interval and depth of cut, cutting coefficient, speeds.
#pragma once

#include <optional>

#include "engine/receptance/shaft_receptance.h"
#include "engine/stability/pass/lobes_over_pass.h"

namespace lathelier::pass_panel {

struct PassQuestion {
    stability::PassParameters pass;              ///< interval of the pass, depth, stations
    std::optional<double> operating_speed_rpm;   ///< evaluated speed; none: the best over the pass
    stability::LobeParameters lobes;             ///< coefficient, relation, speeds, process damping
    receptance::ReceptanceParameters computing;  ///< shear coefficient, step correction

    PassQuestion();
};

const std::vector<Field<PassQuestion>>& fieldsOf(const PassQuestion*);

inline constexpr const char* speedKey = "operating_speed_rpm";
inline constexpr const char* depthKey = "pass_depth_mm";

}  // namespace lathelier::pass_panel
