// Question of the panel Shaft: segments, material, supports and response.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/receptance/library.h"
#include "engine/receptance/shaft_receptance.h"
#include "engine/shaft/shaft.h"
#include "widgets/part_common/shaft_table.h"

namespace lathelier::shaft_panel {

/// Support of the shaft at its chuck face. Given: the spindle of the input, else none.
enum class Hold { Given, Springs, Clamped, Free };

/// A tailstock centre or a steady rest.
struct Rest {
    double z_mm = 0;             ///< from the free end
    double radial_N_mm = 10000;  ///< radial stiffness
    double loss_factor = 0.05;   ///< complex stiffness k (1 + i·loss_factor)
    friend bool operator==(const Rest&, const Rest&) = default;
};

const std::vector<Field<Rest>>& fieldsOf(const Rest*);

struct ShaftQuestion {
    std::vector<ShaftSegment> segments;         ///< the table; empty: as the file has them
    std::string segments_of;                    ///< identity() of the input they were changed from
    std::string material = statedChoice;        ///< key of the library, unless own_material is given
    std::optional<Material> own_material;       ///< stated by the user
    Hold hold = Hold::Given;                    ///< at the chuck face
    receptance::SpindleSprings springs;         ///< of Hold::Springs
    std::vector<Rest> rests;                    ///< additional supports
    receptance::ReceptanceParameters response;  ///< places, range, step, method
};

const std::vector<Field<ShaftQuestion>>& fieldsOf(const ShaftQuestion*);

using part_common::segmentsKey;
using part_common::segmentsOfKey;

}  // namespace lathelier::shaft_panel
