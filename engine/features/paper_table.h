// The published method's Table 1 as a view of the rows: cylinders with their chamfers folded in. Source: Miądlicki et
// al., "Remanufacturing System with Chatter Suppression for CNC Turning", Table 1.
//
// A step runs to the outer end of its chamfers, and `chamfer_*_mm` are their legs along z, as the paper prints a step
// from 108 to 183 mm with 5. Cones, arcs and undercuts have no place in it: they are listed beside.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/features/recognition.h"

namespace lathelier::features {

struct PaperStep {
    std::int64_t row = 0;         ///< of Recognition::segments, from 1: the cylinder
    double x_mm = 0, y_mm = 0;    ///< of the axis at the step's middle, in the scan's frame
    double radius_mm = 0;         ///< of the cylinder
    double z_start_mm = 0;        ///< from the free end, its chamfers included
    double z_end_mm = 0;          ///< likewise
    double chamfer_start_mm = 0;  ///< leg along z; 0: none
    double chamfer_end_mm = 0;    ///< leg along z; 0: none
};

struct PaperTable {
    std::vector<PaperStep> steps;      ///< in order of z
    std::vector<std::int64_t> beside;  ///< rows, from 1, that the table cannot say
};

PaperTable paperTable(const Recognition& result);

}  // namespace lathelier::features
