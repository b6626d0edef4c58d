#include "engine/report/plot_frame.h"

#include <algorithm>

namespace lathelier::report {
namespace {

constexpr std::string_view frameColour = "#7b8794";
constexpr double boldFactor = 1.1;  ///< width of bold type relative to regular type

}  // namespace

void drawFrame(Svg& svg, const PlotFrame& frame, const FrameWords& words, const Language& language, bool grid)
{
    svg.text(frame.left, 20, Svg::Anchor::Start, titleSize, words.title, true);
    if (!words.remark.empty())
        svg.text(frame.left + boldFactor * textWidth(words.title, titleSize) + titleSize, 20, Svg::Anchor::Start,
                 textSize, words.remark);
    const Ticks xTicks = axisTicks(frame.x_scale, frame.x, frame.x_ticks, frame.x_factor);
    for (const double value : xTicks.values) {
        const double x = frame.toX(value);
        if (grid) svg.line(x, frame.top, x, frame.bottom, gridColour);
        svg.line(x, frame.bottom, x, frame.bottom + 5, frameColour);
        svg.text(x, frame.bottom + 19, Svg::Anchor::Middle, tickSize, tickLabel(value, xTicks, language));
    }
    for (const double value : xTicks.minor)
        svg.line(frame.toX(value), frame.bottom, frame.toX(value), frame.bottom + 3, frameColour);
    const int rows = std::max(3, static_cast<int>((frame.bottom - frame.top) / 40));
    const Ticks yTicks = axisTicks(frame.y_scale, frame.y, rows, frame.y_factor);
    for (const double value : yTicks.values) {
        const double y = frame.toY(value);
        if (grid) svg.line(frame.left, y, frame.right, y, gridColour);
        svg.line(frame.left - 5, y, frame.left, y, frameColour);
        svg.text(frame.left - 8, y + 4, Svg::Anchor::End, tickSize, tickLabel(value, yTicks, language));
    }
    for (const double value : yTicks.minor)
        svg.line(frame.left - 3, frame.toY(value), frame.left, frame.toY(value), frameColour);
    svg.text(0.5 * (frame.left + frame.right), frame.bottom + 38, Svg::Anchor::Middle, textSize, words.x);
    svg.verticalText(16, 0.5 * (frame.top + frame.bottom), textSize, words.y);
}

void drawOutline(Svg& svg, const PlotFrame& frame)
{
    svg.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top, "none", frameColour);
}

}  // namespace lathelier::report
