// Question of the panel Lobes: modes (without a file), cut, operating point, range of the tool.
#pragma once

#include <optional>
#include <vector>

#include "engine/stability/lobes.h"
#include "engine/stability/modes.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::lobes_panel {

struct LobesQuestion {
    std::vector<stability::Mode> modes;         ///< modes of the cutting point, without a file
    stability::LobeParameters lobes;            ///< coefficient, relation, range, process damping, uncertainties
    std::optional<double> operating_speed_rpm;  ///< operating point; none: the middle of the range
    std::optional<double> operating_depth;      ///< mm, or multiples of the least limit; none: 1.5 of it
    stability::SpeedParameters speed;           ///< diameter, range of the tool, rule; the rest is derived
};

const std::vector<Field<LobesQuestion>>& fieldsOf(const LobesQuestion*);

}  // namespace lathelier::lobes_panel
