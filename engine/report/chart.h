// A chart as data: what it shows, with titles, units and what its colours mean. The report paints it as SVG
// (plot_svg.h, polar_svg.h), the window with widgets/plot; both show the same ranges, ticks, colours and words.
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
    std::optional<Interval> range{};  ///< what is shown at first. Default: all there is
};

/// "Deviation (mm)"
std::string axisLabel(const Axis& axis, const Language& language = {});

struct Curve {
    Caption name{};           ///< for the legend; empty: not in it
    std::vector<double> x{};  ///< Bars: the edges, evenly spaced, one more than y
    std::vector<double> y{};  ///< NaN breaks the line
    enum class Style { Line, Dashed, Points, Bars, Band } style = Style::Line;
    std::vector<double> y_low{};  ///< Band only: the other edge
    ChartColour colour{};         ///< what it stands for, or its place in the palette
    bool thin = false;            ///< one of many: faint, and not read at the pointer
    bool spoken = true;           ///< read at the pointer
    std::vector<double> said{};   ///< what pointer and CSV say instead of y (the true value of a magnified error)
    Text said_unit{};             ///< unit of `said`
    std::vector<Text> words{};    ///< what the pointer says besides, by sample: "three lobes: a three-jaw chuck"
    std::vector<double> along{};  ///< what runs along a path in the plane (an angle), whose x need not rise
};

/// Where the samples of a curve stand: the middles of bars, else its x.
std::vector<double> placesOf(const Curve& curve);

/// A shaded polygon. Corners at ±infinity lie on the edge of the chart, whatever part of it is shown.
struct Region {
    Caption name{};                            ///< for the legend
    ChartColour colour = ColourRole::Neutral;  ///< what it stands for
    std::vector<double> x{};                   ///< of the corners
    std::vector<double> y{};                   ///< of the corners
};

/// A stretch of the x axis over the whole height.
Region stretch(Caption name, const Interval& x, ChartColour colour = ColourRole::Neutral);

/// What lies between two curves over the same x; either of them may be ±infinity.
Region between(Caption name, ChartColour colour, const std::vector<double>& x, const std::vector<double>& low,
               const std::vector<double>& high);

/// A straight line across the chart, named where it meets the edge.
struct Limit {
    enum class Direction { Horizontal, Vertical } direction = Direction::Horizontal;
    double place = 0;  ///< where it crosses the other axis
    Caption name{};    ///< "tolerance"
};

/// A point that deserves a name, such as the highest lobe.
struct Mark {
    double x = 0, y = 0;
    Caption name{};  ///< said beside it
};

/// A point or a line in the plane that a person may drag: an operating point, a tolerance.
struct Handle {
    std::string key;  ///< told back when it moves
    enum class Kind { Point, Vertical, Horizontal } kind = Kind::Point;
    double x = 0, y = 0;                ///< a line has the one across it only
    Caption name{};                     ///< said beside it
    std::optional<Interval> x_range{};  ///< where it may go. Default: anywhere
    std::optional<Interval> y_range{};  ///< where it may go. Default: anywhere
};

/// The handle's own way: inside its ranges, and a line only across itself.
void moveHandle(Handle& handle, double x, double y);

/// A map of values on a regular grid in a diverging colour scale; x and y are the axes, their ranges are the grid's.
struct ColourMap {
    Caption title{};
    Axis x{};                                           ///< across
    Axis y{};                                           ///< upwards
    Axis value{};                                       ///< of the colours
    double x_from = 0, x_to = 1, y_from = 0, y_to = 1;  ///< edges of the grid, not middles of its cells
    int columns = 0, rows = 0;                          ///< of the grid
    std::vector<float> values{};                        ///< row-major, rows along y; NaN is left blank
    double limit = 1;                                   ///< the scale runs from -limit to +limit
    std::optional<double> tolerance{};                  ///< green inside
    int steps = 0;                                      ///< contours on each side of 0; 0: colours run over
    std::optional<double> marked{};                     ///< shown in the scale

    static constexpr double groundOpacity = 0.6;  ///< below the curves of a chart, which have to stand out

    bool empty() const { return columns <= 0 || rows <= 0; }
    /// The value of the cell at a place; NaN outside and where there are no data.
    double at(double x_place, double y_place) const;
};

struct Plot {
    Caption title{};                    ///< above the chart, and by which a chart is known again
    Caption remark{};                   ///< beside the title: "error × 200"
    Axis x{};                           ///< across
    Axis y{};                           ///< upwards
    Axis along{};                       ///< of curves that have it
    bool equal_scales = false;          ///< a length along x is as long along y: a circle looks like one
    std::optional<ColourMap> ground{};  ///< colours below everything, of which only the grid and its values count
    std::vector<Curve> curves{};        ///< drawn in this order
    std::vector<Region> regions{};      ///< drawn below the curves
    std::vector<Limit> limits{};        ///< drawn above the curves
    std::vector<Mark> marks{};          ///< drawn above the curves
    std::vector<Handle> handles{};      ///< drawn on top
};

/// A number with a place on a sheet: finite, and not so large that differences overflow.
bool isDrawable(double value);

/// What is shown at first: the axis' own range, or all there is with some air. Never of no width; on a logarithmic axis
/// above zero.
Interval shownX(const Plot& plot);
Interval shownY(const Plot& plot);

/// The colours of its values.
DeviationColours coloursOf(const ColourMap& map);

/// Deviations of closed profiles from a circle, drawn around it with a stated magnification.
struct PolarPlot {
    struct Trace {
        Caption name{};
        std::vector<double> angle_deg{};     ///< about the centre of the base circle, anticlockwise from x
        std::vector<double> deviation_um{};  ///< from the base circle; NaN breaks the line
        ChartColour colour{};                ///< what it stands for, or its place in the palette
        bool thin = false;                   ///< one of many (single revolutions)
    };
    struct ReferenceLine {  ///< a circle of a radius differing from the base circle's, off its centre
        Caption name{};     ///< for the legend
        double x_um = 0, y_um = 0,
               deviation_um = 0;  ///< centre from that of the base circle, radius minus the base radius
        ChartColour colour{};     ///< what it stands for, or its place in the palette
        bool dashed = false;      ///< drawn in dashes
        std::string asked{};      ///< not empty: drawn only when a person asks for it by this key; never on paper
    };
    struct Ring {        ///< shaded between two circles of one centre
        Caption name{};  ///< for the legend
        double x_um = 0, y_um = 0, inner_um = 0,
               outer_um = 0;   ///< centre from that of the base circle, radii minus the base radius
        ChartColour colour{};  ///< what it stands for, or its place in the palette
    };
    struct Mark {
        double angle_deg = 0, deviation_um = 0;  ///< from the base circle
        bool outer = true;                       ///< shape of the mark
        Caption name{};                          ///< said beside it
    };
    Caption title{};                       ///< above the chart
    double base_radius_mm = 0;             ///< of the base circle, about whose centre angles and deviations are given
    std::vector<Trace> traces{};           ///< profiles
    std::vector<ReferenceLine> circles{};  ///< reference circles
    std::vector<Ring> rings{};             ///< zones between two circles; drawn below everything else
    std::vector<Mark> contacts{};          ///< points that the reference circle rests on
    /// So many times a deviation is drawn larger than the base circle's radius. Default: a round one that fits.
    std::optional<double> magnification{};
};

}  // namespace lathelier::report
