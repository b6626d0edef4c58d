// Sets single sizes of a shaft's rows and adapts the neighbours: values in, values out.
//
// A cone or an arc that meets a cylinder without a shoulder follows its diameter: with its whole width where it is
// minor and free on its other side (a chamfer keeps its leg and its angle), else with the end that meets it. Rows whose
// ShaftSegment::tie is the same share one diameter.
//
// Errors of all: shaftRowWrong, where a size is not above 0 or leaves a row no length. Preconditions: rows that are
// named exist.
#pragma once

#include <cstddef>
#include <string>

#include "engine/shaft/shaft_edit.h"

namespace lathelier {

/// Which end of a row a diameter is set at.
enum class RowEnd : std::uint8_t { Both, Start, End };

/// Diameter of the row, of the rows tied to it, and of the neighbours that meet them. RowEnd::Start, End: of that end
/// alone, where the row is no cylinder.
ShaftRows setDiameter(ShaftRows rows, std::size_t row, double diameter_mm, RowEnd end = RowEnd::Both);

/// Length from the start of `first` to the end of `last`: the longest of them that is not minor takes the difference.
ShaftRows setLength(ShaftRows rows, std::size_t first, std::size_t last, double length_mm, KeepAfter keep);

/// The end of the row `before` comes to z; the last row up to there that is not minor becomes longer or shorter.
ShaftRows moveShoulder(ShaftRows rows, std::size_t before, double z_mm, KeepAfter keep);

/// Leg along z and angle to the axis of a chamfer: the end that meets its neighbour stays, else the larger one; the
/// neighbour takes the difference in length.
ShaftRows setChamfer(ShaftRows rows, std::size_t row, double leg_mm, double angle_deg);

/// Angle to the axis of a cone; length and larger diameter stay.
ShaftRows setConeAngle(ShaftRows rows, std::size_t row, double angle_deg);

/// Radius of an arc, its side stays. A quarter of a circle becomes another quarter, its neighbour takes the difference
/// in length; of others the ends stay, and half the chord is the smallest radius.
ShaftRows setArcRadius(ShaftRows rows, std::size_t row, double radius_mm);

/// Width and bottom diameter of the rows [first, last] of a groove or undercut.
ShaftRows setGroove(ShaftRows rows, std::size_t first, std::size_t last, double width_mm, double bottom_mm);

/// The cylinder `row` gets the diameter of the cylinder `other` and keeps it from now on: "same as row 3". Rows tied to
/// either are tied to both. Error shaftRowWrong: one of them is no cylinder.
ShaftRows tieDiameters(ShaftRows rows, std::size_t row, std::size_t other);

/// Unties the row; a single remaining row of the tie is untied too.
ShaftRows untieDiameter(ShaftRows rows, std::size_t row);

/// Numbers (from 0) of the other rows that share the row's diameter.
std::vector<std::size_t> tiedTo(const ShaftRows& rows, std::size_t row);

/// `after` with the ties kept of those cylinders whose diameter is another than in `before`: for edits in a table.
/// Where the number of rows differs, `after` as it is.
ShaftRows followTies(const ShaftRows& before, ShaftRows after);

/// `after` with MeasuredSize filled from `before` (whose values are measured) for each edited row that has none. Where
/// the number of rows differs, `after` as it is.
ShaftRows keepMeasured(const ShaftRows& before, ShaftRows after);

}  // namespace lathelier
