// Stock in the meridian plane as columns of radial spans ("dexels": T. Van Hook, "Real-time shaded NC milling display",
// SIGGRAPH 1986). A column represents one step along z, at its middle. Several spans occur at undercuts: an insert with
// κ = 95° leaves every shoulder overhanging by 5°.
//
// Subtraction is one-dimensional in each column, so no input is degenerate and the result is deterministic. Radii in a
// column are exact; along z a wall is located within half a step. Units: mm, mm², mm³. z from the free end toward the
// chuck, 0 … length.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/shaft/shaft.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::stock {

/// Material between two radii.
struct RadialSpan {
    double low_mm = 0;   ///< toward the axis
    double high_mm = 0;  ///< outer
    friend bool operator==(const RadialSpan&, const RadialSpan&) = default;
};

/// Removed material.
struct Removal {
    double area_mm2 = 0;    ///< in the meridian plane
    double volume_mm3 = 0;  ///< of the body of revolution
};

/// Overlap of a polygon with the material.
struct StockOverlap {
    double depth_mm = 0;  ///< largest radial length in one column; 0: none
    double z_mm = 0;      ///< of that column; the one nearest to the free end of several equal ones
    double x_mm = 0;      ///< inner radius of that length
    double width_mm = 0;  ///< from the first overlapping column to the last
    bool isThere() const { return depth_mm > 0; }
};

/// The largest number of columns: longer stock has wider columns.
inline constexpr std::size_t mostColumns = 20000;

class MeridianStock {
public:
    MeridianStock() = default;  ///< no material

    /// Columns of `step_mm` or a little less, so that they fill the length; wider where they would be more than
    /// mostColumns. A cone or an arc is sampled at the middle of each column. Errors stockWithoutLength,
    /// stockSegmentImpossible.
    MeridianStock(const Shaft& shaft, double step_mm);

    /// The first `length_mm`, mirrored: z becomes length - z. Shorter if the stock is shorter.
    MeridianStock turnedRound(double length_mm) const;

    double length_mm() const { return static_cast<double>(columns_.size()) * step_mm_; }
    double step_mm() const { return step_mm_; }  ///< width of a column
    std::size_t columns() const { return columns_.size(); }
    double middle_mm(std::size_t column) const { return (static_cast<double>(column) + 0.5) * step_mm_; }

    /// From the axis outward. Empty: no material.
    std::vector<RadialSpan> spans(std::size_t column) const;
    void appendSpans(std::size_t column, std::vector<RadialSpan>& spans) const;

    /// Outer radius of the column at z; none outside and without material.
    std::optional<double> outerRadius_mm(double z_mm) const;
    std::optional<double> innerRadius_mm(double z_mm) const;  ///< of the innermost span: the bore

    double largestRadius_mm() const;
    double area_mm2() const;
    double volume_mm3() const;

    /// Removes the polygon. About 3 ns per column reached; columns entirely below it are skipped in blocks.
    Removal remove(const ConvexPolygon& polygon);

    /// Material within the polygon, in columns where it is thicker than `least_mm`, so that contact is no overlap. Same
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
    std::vector<double> blockTops_;  // largest radius in each block of columns
    double step_mm_ = 1;
};

}  // namespace lathelier::stock
