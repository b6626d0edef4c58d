// The files that a part is written as: shaft, stock, tables, drawing and CAD. One list for every task that makes a
// part.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/drawing/drawing.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/receptance/library.h"
#include "engine/shaft/shaft.h"
#include "engine/task/task.h"

namespace lathelier::cad {

/// Kinds of the files.
struct CadQuestion {
    std::string step_schema = "AP214";  ///< "AP214" | "AP242"
    bool dxf_contour = false;           ///< the closed half contour in place of the drawing
    bool undated = false;               ///< no date in drawing, DXF and STEP: the same shaft gives the same bytes
};

const std::vector<Field<CadQuestion>>& fieldsOf(const CadQuestion*);

/// What a person adds to the title block of a drawing.
struct TitleQuestion {
    std::string material = statedChoice;  ///< key of the library; material for the mass
    std::string material_name;            ///< printed name; empty: that of the material
    std::string general_tolerances;       ///< "ISO 2768-m"; empty: as the shaft states
    std::string surface_texture;          ///< note on roughness; empty: none
    std::string author;                   ///< empty: none
    std::string date;                     ///< printed date; empty: today
};

const std::vector<Field<TitleQuestion>>& fieldsOf(const TitleQuestion*);

/// Puts material and general tolerances into the shaft. Note materialOfLibrary.
void addTitle(const TitleQuestion& title, Shaft& shaft, Notes& notes);

/// The options of a drawing that these questions settle.
drawing::DrawingOptions drawingOptions(const TitleQuestion& title, const CadQuestion& cad, const Language& language);

/// What the files are made of.
struct PartToWrite {
    Shaft shaft;  ///< shaft that satisfies checkShaft()
    Shaft stock;  ///< shaft for the stock text: the part outside the chuck
    std::function<drawing::Drawing(const Language&)> drawing;
    std::function<void()> require_complete = {};  ///< before all files but the shaft; throws Error. Empty: complete
    std::function<std::string()> csv = {};        ///< table of rows as CSV; empty: shaftCsv()
    CadQuestion cad;
};

inline constexpr const char* shaftExport = "shaft";
inline constexpr const char* stepExport = "step";
inline constexpr const char* freecadExport = "freecad";
inline constexpr const char* solidworksExport = "solidworks";
inline constexpr const char* drawingExport = "drawing";

/// Their options and labels.
std::vector<task::Export> partExports();

/// Their writers, by Export::option.
std::map<std::string, task::WriteExport> partWriters(const std::shared_ptr<const PartToWrite>& part);

/// Is a file asked for that a CAD system reads as a solid?
bool isSolidWanted(const task::Wanted& wanted);

/// The date of today as ISO 8601 has it.
std::string today();

/// Decimal mark of this language.
std::string decimalMark(const Language& language);

}  // namespace lathelier::cad
