// Stock in the meridian plane as columns of radial spans ("dexels": T. Van Hook, "Real-time shaded NC milling display",
// SIGGRAPH 1986). A column stands for one step along z, at its middle; a column of several spans is an undercut: an
// insert that enters at κ = 95° leaves every shoulder overhanging by 5°.
//
// Subtracting is done column by column on numbers alone, so no input is degenerate and the answer does not depend on
// anything but the input. Radii in a column are exact; along z a wall stands within half a step of its place.
// Units: mm, mm², mm³. z from the free end toward the chuck, 0 … length.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/shaft.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::stock {

/// Material between two radii.
struct RadialSpan {
    double low_mm = 0;   ///< toward the axis
    double high_mm = 0;  ///< outer
    friend bool operator==(const RadialSpan&, const RadialSpan&) = default;
};

/// What was taken off.
struct Removal {
    double area_mm2 = 0;    ///< in the meridian plane
    double volume_mm3 = 0;  ///< of the body of revolution
};

/// Where a polygon lies in the material.
struct StockOverlap {
    double depth_mm = 0;  ///< largest radial length in one column; 0: none
    double z_mm = 0;      ///< of that column; the one nearest to the free end of several equal ones
    double x_mm = 0;      ///< lower end of that length
    double width_mm = 0;  ///< from the first column that is met to the last
    bool isThere() const { return depth_mm > 0; }
};

/// The largest number of columns: longer stock has wider ones.
inline constexpr std::size_t mostColumns = 20000;

class MeridianStock {
public:
    MeridianStock() = default;  ///< nothing

    /// Columns of `step_mm` or a little less, so that they fill the length; wider where they would be more than
    /// mostColumns. A cone or an arc is sampled at the middle of each column. Errors stockWithoutLength,
    /// stockSegmentImpossible.
    MeridianStock(const Shaft& shaft, double step_mm);

    /// The first `length_mm` of it, seen from its other end: z becomes length - z. Shorter where there is less of it.
    MeridianStock turnedRound(double length_mm) const;

    double length_mm() const { return static_cast<double>(columns_.size()) * step_mm_; }
    double step_mm() const { return step_mm_; }  ///< width of a column
    std::size_t columns() const { return columns_.size(); }
    double middle_mm(std::size_t column) const { return (static_cast<double>(column) + 0.5) * step_mm_; }

    /// From the axis outward. Empty: no material.
    std::vector<RadialSpan> spans(std::size_t column) const;
    void appendSpans(std::size_t column, std::vector<RadialSpan>& spans) const;

    /// Of the column that holds z; none outside, and where there is no material.
    std::optional<double> outerRadius_mm(double z_mm) const;
    std::optional<double> innerRadius_mm(double z_mm) const;  ///< of the innermost span: the bore

    double largestRadius_mm() const;
    double area_mm2() const;
    double volume_mm3() const;

    /// Takes the polygon off. About 3 ns a column that it reaches; columns that lie below it are passed by in blocks.
    Removal remove(const ConvexPolygon& polygon);

    /// Material within the polygon, where a column has more of it than `least_mm`: touching is no overlap. The same
    /// cost.
    StockOverlap overlap(const ConvexPolygon& polygon, double least_mm = 0) const;

private:
    struct Column {
        RadialSpan outer;               // none: high ≤ low
        std::vector<RadialSpan> inner;  // ascending, below `outer`
    };
    static void removeFrom(Column& column, double low_mm, double high_mm, Removal& removal);
    static void measureOverlap(const Column& column, const RadialSpan& within, double z_mm, double least_mm,
                               StockOverlap& found);

    std::vector<Column> columns_;
    std::vector<double> block_tops_;  // largest radius in each block of columns
    double step_mm_ = 1;
};

}  // namespace lathelier::stock
