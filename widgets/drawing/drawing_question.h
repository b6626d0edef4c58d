// What the panel "Drawing" is asked: the rows of the shaft and what stands in the title block.
#pragma once

#include <string>
#include <vector>

#include "engine/core/shaft.h"
#include "engine/drawing/shaft_drawing.h"
#include "widgets/chatter_common/libraries.h"
#include "widgets/part_common/shaft_table.h"

namespace lathelier::drawing_panel {

enum class SheetChoice { Automatic, A4, A4Portrait, A3 };

struct DrawingQuestion {
    std::vector<ShaftSegment> segments;  ///< the table; empty: as the file has them
    std::string segments_of;             ///< identity() of the input they were changed from
    std::string name;                    ///< of the part; empty: as the input has it
    chatter_common::MaterialChoice material = chatter_common::MaterialChoice::Stated;  ///< for the mass
    std::string material_name;                                   ///< as printed; empty: that of the material
    SheetChoice sheet = SheetChoice::Automatic;                  ///< its size
    drawing::LengthsFrom lengths = drawing::LengthsFrom::Datum;  ///< as drawn, and what an edited length moves
    std::string date;                                            ///< as printed; empty: today
    bool measured = false;                                       ///< rows without a nominal size are measured values
};

const std::vector<Field<DrawingQuestion>>& fieldsOf(const DrawingQuestion*);

using part_common::segmentsKey;
using part_common::segmentsOfKey;

}  // namespace lathelier::drawing_panel
