// What the panel "Drawing" is asked: the rows of the shaft and what stands in the title block.
#pragma once

#include <string>
#include <vector>

#include "engine/core/shaft.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/project/project.h"
#include "widgets/chatter_common/libraries.h"
#include "widgets/part_common/shaft_table.h"

namespace lathelier::drawing_panel {

enum class SheetChoice { Automatic, A4, A4Portrait, A3 };

inline constexpr const char* boresKey = "bores";       ///< of the table of bores
inline constexpr const char* boresOfKey = "bores_of";  ///< boresOf() of the input they were changed from; no form

/// A row of a bore in the table, from the mouth inward.
struct BoreRow {
    ShaftEnd from = ShaftEnd::Free;  ///< the end that its mouth is at
    BoreSegment row;                 ///< of the bore
    friend bool operator==(const BoreRow&, const BoreRow&) = default;
};

const std::vector<Field<BoreRow>>& fieldsOf(const BoreRow*);

/// The bores as rows of the table, and the same back.
std::vector<BoreRow> rowsOfBores(const std::vector<ShaftBore>& bores);
std::vector<ShaftBore> boresOfRows(const std::vector<BoreRow>& rows);

/// Which input the table of bores belongs to once it was changed; never empty.
std::string boresOf(const project::PanelState& state);

/// Puts the bores into the table, changed from the input that is there now.
void setBores(project::PanelState& state, const std::vector<ShaftBore>& bores);

struct DrawingQuestion {
    std::vector<ShaftSegment> segments;  ///< the table; empty: as the file has them
    std::string segments_of;             ///< identity() of the input they were changed from
    std::vector<BoreRow> bores;          ///< the table; rules where bores_of is boresOf()
    std::string bores_of;                ///< boresOf() of the input they were changed from; empty: as the file has them
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
