// A chart as data: curves, regions, marks, with titles, units and colour roles. The report paints it as SVG
// (plot_svg.h, polar_svg.h), the window with widgets/plot; both with the same ranges, ticks, colours and labels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/value.h"
#include "engine/report/caption.h"
#include "engine/report/colours.h"

namespace lathelier::report {

struct Axis {
    Caption title{};                                                        ///< of the quantity, without unit
    Text unit{};                                                            ///< empty: none
    enum class Scale { Linear, Logarithmic, Whole } scale = Scale::Linear;  ///< Whole: linear, whole numbers only
    std::optional<Interval> range{};  ///< initially shown range. Default: all data
};

/// "Deviation (mm)"
std::string axisLabel(const Axis& axis, const Language& language = {});

struct Curve {
    Caption name{};           ///< for the legend; empty: not in it
    std::vector<double> x{};  ///< Bars: the edges, evenly spaced, one more than y
    std::vector<double> y{};  ///< NaN breaks the line
    enum class Style { Line, Dashed, Points, Bars, Band } style = Style::Line;
    std::vector<double> y_low{};      ///< Band only: the other edge
    ChartColour colour{};             ///< colour role, or index in the palette
    bool thin = false;                ///< one of many: drawn faintly, without readout
    bool has_readout = true;          ///< its values are shown at the pointer
    std::vector<double> readout_y{};  ///< shown and exported instead of y (unmagnified error)
    Text readout_unit{};              ///< unit of `readout_y`
    std::vector<Text> words{};        ///< remark at the pointer, by sample: "three lobes: a three-jaw chuck"
    std::vector<double> along{};      ///< parameter along a path in the plane (an angle), whose x need not increase
};

/// x of the samples of a curve; for bars their centres.
std::vector<double> placesOf(const Curve& curve);

/// A shaded polygon. Corners at ±infinity lie on the edge of the chart, whatever part of it is shown.
struct Region {
    Caption name{};                            ///< for the legend
    ChartColour colour = ColourRole::Neutral;  ///< colour role
    std::vector<double> x{};                   ///< vertices
    std::vector<double> y{};                   ///< vertices
};

/// A region over an interval of x and the full height.
Region stretch(Caption name, const Interval& x, ChartColour colour = ColourRole::Neutral);

/// The region between two curves over the same x; either of them may be ±infinity.
Region between(Caption name, ChartColour colour, const std::vector<double>& x, const std::vector<double>& low,
               const std::vector<double>& high);

/// A straight line across the chart, named where it meets the edge.
struct Limit {
    enum class Direction { Horizontal, Vertical } direction = Direction::Horizontal;
    double place = 0;  ///< coordinate at which it crosses the other axis
    Caption name{};    ///< "tolerance"
};

/// A labelled point, such as the highest lobe.
struct Mark {
    double x = 0, y = 0;
    Caption name{};  ///< label beside it
};

/// A draggable point or line: an operating point, a tolerance.
struct Handle {
    std::string key;  ///< identifies the handle in the signal of its move
    enum class Kind { Point, Vertical, Horizontal } kind = Kind::Point;
    double x = 0, y = 0;                ///< for a line only the coordinate across it
    Caption name{};                     ///< label beside it
    std::optional<Interval> x_range{};  ///< allowed range. Default: unlimited
    std::optional<Interval> y_range{};  ///< allowed range. Default: unlimited
};

/// Constrains a move: within the ranges, a line only across itself.
void moveHandle(Handle& handle, double x, double y);

/// A map of values on a regular grid in a diverging colour scale; x and y are the axes, their ranges are the grid's.
struct ColourMap {
    Caption title{};
    Axis x{};                                           ///< across
    Axis y{};                                           ///< upwards
    Axis value{};                                       ///< axis of the colour scale
    double x_from = 0, x_to = 1, y_from = 0, y_to = 1;  ///< edges of the grid, not middles of its cells
    int columns = 0, rows = 0;                          ///< size of the grid
    std::vector<float> values{};                        ///< row-major, rows along y; NaN is left blank
    double limit = 1;                                   ///< the scale runs from -limit to +limit
    std::optional<double> tolerance{};                  ///< half width of the band coloured green
    int steps = 0;                                      ///< contours on each side of 0; 0: continuous colours
    std::optional<double> marked{};                     ///< value marked in the scale

    static constexpr double groundOpacity = 0.6;  ///< opacity below the curves of a chart

    bool empty() const { return columns <= 0 || rows <= 0; }
    /// The value of the cell at a place; NaN outside and where there are no data.
    double at(double x_place, double y_place) const;
};

struct Plot {
    Caption title{};                    ///< above the chart; also identifies the chart for keeping the user's zoom
    Caption remark{};                   ///< beside the title: "error × 200"
    Axis x{};                           ///< across
    Axis y{};                           ///< upwards
    Axis along{};                       ///< axis of Curve::along
    bool equal_scales = false;          ///< equal scales of x and y: a circle is drawn as a circle
    std::optional<ColourMap> ground{};  ///< colour map drawn below everything; only its grid and values are used
    std::vector<Curve> curves{};        ///< drawn in this order
    std::vector<Region> regions{};      ///< drawn below the curves
    std::vector<Limit> limits{};        ///< drawn above the curves
    std::vector<Mark> marks{};          ///< drawn above the curves
    std::vector<Handle> handles{};      ///< drawn on top
};

/// A number with a place on a sheet: finite, and not so large that differences overflow.
bool isDrawable(double value);

/// Initially shown range: the axis' stated range, or all data with margins. Never of zero width; positive on a
/// logarithmic axis.
Interval shownX(const Plot& plot);
Interval shownY(const Plot& plot);

/// Colour scale of the values.
DeviationColours coloursOf(const ColourMap& map);

/// Deviations of closed profiles from a circle, drawn around it with a stated magnification.
struct PolarPlot {
    struct Trace {
        Caption name{};
        std::vector<double> angle_deg{};     ///< about the centre of the base circle, anticlockwise from x
        std::vector<double> deviation_um{};  ///< from the base circle; NaN breaks the line
        ChartColour colour{};                ///< colour role, or index in the palette
        bool thin = false;                   ///< one of many, such as single revolutions
    };
    struct ReferenceLine {  ///< a circle of a radius differing from the base circle's, off its centre
        Caption name{};     ///< for the legend
        double x_um = 0, y_um = 0,
               deviation_um = 0;  ///< centre from that of the base circle, radius minus the base radius
        ChartColour colour{};     ///< colour role, or index in the palette
        bool dashed = false;      ///< drawn in dashes
        std::string asked{};      ///< not empty: drawn only on request by this key, never on paper
    };
    struct Ring {        ///< shaded between two circles of one centre
        Caption name{};  ///< for the legend
        double x_um = 0, y_um = 0, inner_um = 0,
               outer_um = 0;   ///< centre from that of the base circle, radii minus the base radius
        ChartColour colour{};  ///< colour role, or index in the palette
    };
    struct Mark {
        double angle_deg = 0, deviation_um = 0;  ///< from the base circle
        bool outer = true;                       ///< contact of the outer circle; decides the shape of the mark
        Caption name{};                          ///< label beside it
    };
    Caption title{};                       ///< above the chart
    double base_radius_mm = 0;             ///< of the base circle, about whose centre angles and deviations are given
    std::vector<Trace> traces{};           ///< profiles
    std::vector<ReferenceLine> circles{};  ///< reference circles
    std::vector<Ring> rings{};             ///< zones between two circles; drawn below everything else
    std::vector<Mark> contacts{};          ///< contact points of the reference circle
    /// Scale of the deviations relative to that of the base radius. Default: a round value that fits.
    std::optional<double> magnification{};
};

}  // namespace lathelier::report
