// What the panel "Lobes" is asked: the modes where there is no file, the cut, the point of work, the tool's range.
#pragma once

#include <optional>
#include <vector>

#include "engine/stability/lobes.h"
#include "engine/stability/modes.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::lobes_panel {

struct LobesQuestion {
    std::vector<stability::Mode> modes;         ///< of the point that is cut, when no file is given
    stability::LobeParameters lobes;            ///< coefficient, relation, range, process damping, uncertainties
    std::optional<double> operating_speed_rpm;  ///< point of work; none: the middle of the range
    std::optional<double> operating_depth;      ///< mm, or multiples of the least limit; none: 1.5 of it
    stability::SpeedParameters speed;           ///< diameter, the tool's range, rule; the rest follows
};

const std::vector<Field<LobesQuestion>>& fieldsOf(const LobesQuestion*);

}  // namespace lathelier::lobes_panel
