// Frame of a drawn plot: axes, ticks, titles, and the mapping from values to the sheet.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "engine/report/chart.h"
#include "engine/report/svg.h"
#include "engine/report/ticks.h"

namespace lathelier::report {

inline constexpr double sheetWidth = 960;  ///< px; equal for all plots, so that plots below each other are aligned
inline constexpr double frameLeft = 78;
inline constexpr double frameRight = 840;  ///< px; the space to the right is for colour scales
inline constexpr double frameTop = 44;
inline constexpr double frameBottomRoom = 52;  ///< px below the frame, for ticks and the title of the axis
inline constexpr double titleSize = 16;
inline constexpr double textSize = 13;
inline constexpr double tickSize = 12;
inline constexpr std::string_view gridColour = "#e3e7eb";

/// The plotting rectangle and the ranges shown in it.
struct PlotFrame {
    double left = frameLeft;
    double right = frameRight;  ///< in px
    double top = frameTop;      ///< in px, downwards
    double bottom = 0;          ///< in px, downwards
    Interval x;                 ///< values at left and right edge
    Interval y;                 ///< values at bottom and top edge
    Axis::Scale x_scale = Axis::Scale::Linear;
    Axis::Scale y_scale = Axis::Scale::Linear;
    double x_factor = 1;  ///< tick label = value × factor
    double y_factor = 1;  ///< tick label = value × factor
    int x_ticks = 10;     ///< about so many

    double toX(double value) const { return left + share(x_scale, x, value) * (right - left); }
    double toY(double value) const { return bottom - share(y_scale, y, value) * (bottom - top); }

    /// Position of a value between the ends; -∞ for values ≤ 0 on a logarithmic axis.
    static double share(Axis::Scale scale, const Interval& range, double value)
    {
        if (scale != Axis::Scale::Logarithmic) return (value - range.from) / (range.to - range.from);
        return value > 0 ? std::log(value / range.from) / std::log(range.to / range.from) : -HUGE_VAL;
    }
};

/// Texts at the frame.
struct FrameWords {
    std::string title;
    std::string remark;  ///< beside the title
    std::string x;       ///< under the x axis, with unit
    std::string y;       ///< beside the y axis, with unit
};

/// Grid, ticks, axis titles and the plot's title.
void drawFrame(Svg& svg, const PlotFrame& frame, const FrameWords& words, const Language& language, bool grid);

/// The outline, drawn after the data.
void drawOutline(Svg& svg, const PlotFrame& frame);

}  // namespace lathelier::report
