// A row of the step table of the published method: a cylinder including its chamfers.
#pragma once

#include <cstdint>

#include "engine/core/quantities.h"

namespace lathelier {

struct ShaftStep {
    double x_mm = 0, y_mm = 0;  ///< of its centre; 0 on the axis of a shaft
    double radius_mm = 0;
    double z_start_mm = 0, z_end_mm = 0;  ///< to the outer ends of its chamfers
    double chamfer_start_mm = 0;          ///< leg along z; 0: none
    double chamfer_end_mm = 0;            ///< leg along z
    std::int64_t sections = 0;            ///< of a scan that it was found in; 0: made of a table of rows
    friend bool operator==(const ShaftStep&, const ShaftStep&) = default;
};

const std::vector<QuantityOf<ShaftStep>>& quantitiesOf(const ShaftStep*);

}  // namespace lathelier
