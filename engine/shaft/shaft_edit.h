// Edits of the outside of a shaft, row by row, as made by hand in a drawing: values in, values out.
//
// Rows count from 0, from the free end. A row is minor when it only breaks or rounds an edge, or is a groove or an
// undercut: it moves with its neighbour, from which its length is taken. Sizes are in shaft_sizes.h.
//
// None of these checks the whole shaft: call checkShaft() (shaft_rules.h) on the result.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/units.h"
#include "engine/shaft/shaft.h"

namespace lathelier {

using ShaftRows = std::vector<ShaftSegment>;

/// Of two diameters or radii: no further apart than sizes that are the same.
inline bool isSameSize(double a_mm, double b_mm)
{
    return std::abs(a_mm - b_mm) < same_mm;
}

/// Quantity of the following rows that an edit preserves.
enum class KeepAfter : std::uint8_t {
    Places,   ///< their z: the next row that is not minor takes the difference (lengths from one datum)
    Lengths,  ///< their lengths: they move along (a chain of lengths)
};

/// Forms for changeForm().
enum class RowForm : std::uint8_t { Cylinder, Cone, Chamfer, Round, Fillet, Groove };

/// By its role; without one, a cone or an arc no longer than 15 % of its larger diameter.
bool isMinorRow(const ShaftSegment& row);

/// Straight, of one diameter.
bool isCylinder(const ShaftSegment& row);

/// z of the row's start, mm.
double startOf_mm(const ShaftRows& rows, std::size_t row);

/// Without the row. KeepAfter::Places: a neighbour becomes longer by it, first a cylinder that meets it without a
/// shoulder, then any row before it. Precondition: row < rows.size(), and there is another one.
ShaftRows deleteRow(ShaftRows rows, std::size_t row, KeepAfter keep);

/// The row and its next one as one: of two cylinders one of their mean diameter by length; of two arcs of the same
/// radius one arc; else a line from the start of the first to the end of the second. Role and tolerance stay where both
/// have the same; measured values are joined in the same way, without U. Precondition: row + 1 < rows.size().
ShaftRows mergeWithNext(ShaftRows rows, std::size_t row);

/// The row in two, cut so far from its start; on a cone or an arc the cut lies on it. Error shaftRowWrong: the cut does
/// not lie inside. Precondition: row < rows.size().
ShaftRows splitRow(ShaftRows rows, std::size_t row, double at_mm);

/// The row as a cylinder of its mean diameter, a cone, a quarter of an arc or a chamfer between the diameters of its
/// neighbours, or a groove below both; where the neighbours leave no difference, a slope of 1:10 toward the nearer end,
/// or 45°. Its length stays. Role: that of the form; cylinders and cones have none. Precondition: row < rows.size().
ShaftRows changeForm(ShaftRows rows, std::size_t row, RowForm form);

}  // namespace lathelier
