// Selection of the columns of a profile in a table, and their roles.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/io/profile/profile_reader.h"
#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// The columns to read, and their properties known before the values are read.
struct ProfileColumnChoice {
    enum class Shape {
        Xy,        ///< two coordinates
        Xyz,       ///< three coordinates: one of them may be constant
        Polar,     ///< angle and radius, or angle and deviation
        Trace,     ///< radii or deviations at uniform angles
        Undecided  ///< two columns without names
    };
    Shape shape = Shape::Undecided;         ///< quantities of the columns
    std::vector<std::size_t> columns;       ///< in the order of the shape's quantities
    bool are_deviations = false;            ///< true: deviations by the heading
    bool is_angle_unit_stated = false;      ///< true: the unit of the angle is stated
    double degrees_per_unit = 1;            ///< degrees per unit of the angles: 1, or 180/π for radians
    std::string angle_name;                 ///< name of the column of angles, in lower case: "winkel"
    std::string angle_unit_text;            ///< in the place of the angle's unit, when it is none that is known
    std::array<char, 2> axes = {'x', 'y'};  ///< Xy: names of the two axes
};

/// Expectation for findLayout().
TableExpectation profileExpectation();

/// Chooses by the headings: "angle" has precedence over "angle2", of two equal names none is used, and a column of
/// another quantity ("force_N") is not a coordinate. Errors columnsUnknown, columnsAmbiguous; formatUnknown when the
/// headings are those of a probe record.
ProfileColumnChoice chooseProfileColumns(const TableLayout& layout, ProfileColumns wanted);

/// True when the first of two columns without names holds angles: it increases (or decreases) over one revolution.
/// Error columnsUnknown when its even steps could be those of an angle as well as of a coordinate.
bool holdsAngles(std::span<const double> rows, const TableLayout& layout);

}  // namespace lathelier::io
