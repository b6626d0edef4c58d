// Which columns of a table are a profile, and what they mean.
#pragma once

#include <span>
#include <vector>

#include "engine/io/profile/profile_reader.h"
#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// The columns to read, and what is known of them before their values are seen.
struct ProfileColumnChoice {
    enum class Shape {
        Xy,        ///< two coordinates
        Xyz,       ///< three coordinates: one of them may be constant
        Polar,     ///< angle and radius, or angle and deviation
        Trace,     ///< radii or deviations at uniform angles
        Undecided  ///< two columns without names
    };
    Shape shape = Shape::Undecided;         ///< what the columns hold
    std::vector<std::size_t> columns;       ///< in the order that the shape names
    bool areDeviations = false;             ///< the heading says so
    bool angleStated = false;               ///< its unit
    double degreesPerUnit = 1;              ///< of the angles: 1 for degrees, 180/π for radians
    std::array<char, 2> axes = {'x', 'y'};  ///< Xy: what they are called
};

/// What findLayout() should look for.
TableExpectation profileExpectation();

/// Chooses by the headings: a column named "angle" comes before "angle2", of two that are named alike none is taken,
/// and one whose name says something else ("force_N") is no coordinate. Errors columnsUnknown, columnsAmbiguous;
/// formatUnknown when the headings are those of a probe record.
ProfileColumnChoice chooseProfileColumns(const TableLayout& layout, ProfileColumns wanted);

/// True when the first of two columns without names holds angles: it rises (or falls) over one turn. Error
/// columnsUnknown when its even steps could be those of an angle as well as of a coordinate.
bool holdsAngles(std::span<const double> rows, const TableLayout& layout);

}  // namespace lathelier::io
