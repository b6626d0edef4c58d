// Edits of the bores of a shaft, row by row, as made by hand in a drawing: values in, values out.
//
// Rows count from 0, from the mouth inward. A bore without rows is removed. When a row changes, the lengths of deeper
// rows stay and their depths shift. None of these checks the whole shaft (shaft_rules.h).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/shaft/shaft_edit.h"

namespace lathelier {

using ShaftBores = std::vector<ShaftBore>;

/// Appends a cylinder behind the last row of the bore from this end, of its diameter at its bottom, or as a bore of
/// its own.
ShaftBores addBoreRow(ShaftBores bores, ShaftEnd from, double diameter_mm, double length_mm);

/// A cylinder behind the row, with the diameter of its end and its length. Precondition: both indices are in range.
ShaftBores insertBoreRow(ShaftBores bores, std::size_t bore, std::size_t row);

/// Removes the row. Precondition: both indices are in range.
ShaftBores deleteBoreRow(ShaftBores bores, std::size_t bore, std::size_t row);

/// Diameters at both ends of the row; a cylinder stays one. Precondition: both indices are in range.
ShaftBores setBoreDiameter(ShaftBores bores, std::size_t bore, std::size_t row, double diameter_mm);

/// The row ends so far from the mouth. Error shaftRowWrong where it would have no length. Precondition: both indices
/// are in range.
ShaftBores setBoreDepth(ShaftBores bores, std::size_t bore, std::size_t row, double depth_mm);

/// As a cylinder of its first diameter, a cone or a chamfer of 45° (which narrows inward by its length on the radius),
/// a quarter of an arc, or a groove 1 mm deeper than the row before it. Its length stays. Precondition: both indices
/// are in range.
ShaftBores changeBoreForm(ShaftBores bores, std::size_t bore, std::size_t row, RowForm form);

}  // namespace lathelier
