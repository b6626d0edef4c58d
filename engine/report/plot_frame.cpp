#include "engine/report/plot_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lathelier {
namespace {

constexpr std::string_view gridColour = "#e3e7eb";
constexpr std::string_view frameColour = "#7b8794";

}  // namespace

std::string_view plotColour(std::size_t number)
{
    static constexpr std::array<std::string_view, 6> colours{"#1f5fa8", "#c0362c", "#009e73",
                                                             "#e69f00", "#7b4f9d", "#52606d"};
    return colours[number % colours.size()];
}

bool isDrawable(double value)
{
    return std::abs(value) < 1e100;
}

void Extent::add(double value)
{
    if (!isDrawable(value)) return;
    from_ = empty() ? value : std::min(from_, value);
    to_ = from_ > to_ ? value : std::max(to_, value);
}

Interval Extent::interval() const
{
    if (empty()) return {0, 1};
    // Less than this cannot be told apart on the sheet, or in double precision.
    const double least = std::max(1e-9 * std::max(std::abs(from_), std::abs(to_)), 1e-12);
    if (to_ - from_ >= least) return {from_, to_};
    const double half = from_ == 0 ? 0.5 : 0.05 * std::abs(from_);
    return {from_ - half, to_ + half};
}

void drawFrame(Svg& svg, const PlotFrame& frame, const std::string& title, const std::string& x_title,
               const std::string& y_title, const Language& language, bool grid)
{
    svg.text(frame.left, 20, Svg::Anchor::Start, titleSize, title, true);
    const Ticks xTicks = niceTicks(frame.x.from, frame.x.to, 10);
    for (const double value : xTicks.values) {
        const double x = frame.toX(value);
        if (grid) svg.line(x, frame.top, x, frame.bottom, gridColour);
        svg.line(x, frame.bottom, x, frame.bottom + 5, frameColour);
        svg.text(x, frame.bottom + 19, Svg::Anchor::Middle, tickSize, tickLabel(value, xTicks, language));
    }
    const int rows = std::max(3, static_cast<int>((frame.bottom - frame.top) / 40));
    const Ticks yTicks = niceTicks(frame.y.from, frame.y.to, rows);
    for (const double value : yTicks.values) {
        const double y = frame.toY(value);
        if (grid) svg.line(frame.left, y, frame.right, y, gridColour);
        svg.line(frame.left - 5, y, frame.left, y, frameColour);
        svg.text(frame.left - 8, y + 4, Svg::Anchor::End, tickSize, tickLabel(value, yTicks, language));
    }
    svg.text(0.5 * (frame.left + frame.right), frame.bottom + 38, Svg::Anchor::Middle, textSize, x_title);
    svg.verticalText(16, 0.5 * (frame.top + frame.bottom), textSize, y_title);
}

void drawOutline(Svg& svg, const PlotFrame& frame)
{
    svg.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top, "none", frameColour);
}

}  // namespace lathelier
