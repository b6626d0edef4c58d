// Question of the task draw: the rows of the shaft, the title block, and the kinds of files.
#pragma once

#include <string>
#include <vector>

#include "engine/cad/task/part_files.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/project/project.h"
#include "engine/shaft/shaft.h"
#include "engine/task/edited_segments.h"

namespace lathelier::cad {

inline constexpr const char* shaftRole = "shaft";

enum class SheetChoice { Automatic, A4, A4Portrait, A3 };

inline constexpr const char* boresKey = "bores";       ///< key of the table of bores
inline constexpr const char* boresOfKey = "bores_of";  ///< key of bores_of; not in the form

/// A row of a bore in the table, from the mouth inward.
struct BoreRow {
    ShaftEnd from = ShaftEnd::Free;  ///< end at which its mouth is
    BoreSegment row;
    friend bool operator==(const BoreRow&, const BoreRow&) = default;
};

const std::vector<Field<BoreRow>>& fieldsOf(const BoreRow*);

/// The bores as rows of the table, and the same back.
std::vector<BoreRow> rowsOfBores(const std::vector<ShaftBore>& bores);
std::vector<ShaftBore> boresOfRows(const std::vector<BoreRow>& rows);

/// Identity of the input that the edited table of bores belongs to; never empty.
std::string boresOf(const project::PanelState& state);

/// Stores the bores in the table, assigned to the present input.
void setBores(project::PanelState& state, const std::vector<ShaftBore>& bores);

struct DrawQuestion {
    std::vector<ShaftSegment> segments;  ///< table of segments; empty: those of the file
    std::string segments_of;             ///< identity() of the input of the edited table
    std::vector<BoreRow> bores;          ///< table of bores; has precedence if bores_of equals boresOf()
    std::string bores_of;                ///< boresOf() of the input of the edited table; empty: bores of the file
    std::string name;                    ///< name of the part; empty: that of the input
    TitleQuestion title;                 ///< of the drawing
    SheetChoice sheet = SheetChoice::Automatic;                  ///< sheet size
    drawing::LengthsFrom lengths = drawing::LengthsFrom::Datum;  ///< reference of lengths in the drawing and of edits
    bool measured = false;                                       ///< rows without a nominal size are measured values
    CadQuestion cad;                                             ///< kinds of the files that are written
    bool check = false;                                          ///< nothing is written
};

const std::vector<Field<DrawQuestion>>& fieldsOf(const DrawQuestion*);

}  // namespace lathelier::cad
