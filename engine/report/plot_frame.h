// What every drawn plot has: a frame with axes, ticks, titles, and the way from values to the sheet.
#pragma once

#include <string>

#include "engine/report/document.h"
#include "engine/report/svg.h"
#include "engine/report/ticks.h"

namespace lathelier {

inline constexpr double sheetWidth = 960;  ///< of every plot, so that plots below each other line up
inline constexpr double frameLeft = 78;
inline constexpr double frameRight = 840;  ///< the room beyond is for colour scales
inline constexpr double frameTop = 44;
inline constexpr double titleSize = 16;
inline constexpr double textSize = 13;
inline constexpr double tickSize = 12;

/// The plotting rectangle and the ranges shown in it.
struct PlotFrame {
    double left = frameLeft;
    double right = frameRight;
    double top = frameTop;
    double bottom = 0;
    Interval x;
    Interval y;

    double toX(double value) const { return left + (value - x.from) / (x.to - x.from) * (right - left); }
    double toY(double value) const { return bottom - (value - y.from) / (y.to - y.from) * (bottom - top); }
};

/// The colours of curves by number: original blue, copy red, then colours that stay apart for colour-blind
/// eyes (Okabe and Ito); after six from the start.
std::string_view plotColour(std::size_t number);

/// A number with a place on a sheet: finite, and not so large that differences overflow.
bool isDrawable(double value);

/// The range of drawable values seen so far.
class Extent {
public:
    void add(double value);
    bool empty() const { return !(from_ <= to_); }

    /// Never empty and never of no width: what is not there becomes 0…1.
    Interval interval() const;

private:
    double from_ = 1;
    double to_ = 0;
};

/// Grid, ticks, axis titles and the plot's title.
void drawFrame(Svg& svg, const PlotFrame& frame, const std::string& title, const std::string& x_title,
               const std::string& y_title, const Language& language, bool grid);

/// The outline, drawn after the data.
void drawOutline(Svg& svg, const PlotFrame& frame);

}  // namespace lathelier
