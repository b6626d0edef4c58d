#include "engine/stock/stock_work.h"

#include <algorithm>
#include <cmath>

namespace lathelier::stock {
namespace {

constexpr double widestColumn_mm = 2;
constexpr double longestFeedStep_mm = 50;

/// Quantities of a feed move that determine the computing time: its extent along z over the stock, length, chords.
struct FeedWay {
    double over_mm = 0;
    double length_mm = 0;
    double chords = 1;
};

std::vector<FeedWay> feedWays(double stock_length_mm, std::span<const gcode::Move> moves, double z_zero_mm)
{
    std::vector<FeedWay> ways;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        const gcode::Move &from = moves[i - 1], &to = moves[i];
        if (to.kind == gcode::MoveKind::Rapid || to.kind == gcode::MoveKind::Dwell) continue;
        const double length = std::hypot(to.z_mm - from.z_mm, to.x_mm - from.x_mm);
        if (!std::isfinite(length)) continue;
        const double a = std::clamp(z_zero_mm - from.z_mm, 0.0, stock_length_mm);
        const double b = std::clamp(z_zero_mm - to.z_mm, 0.0, stock_length_mm);
        FeedWay way{std::abs(a - b), length, 1};
        if (to.kind == gcode::MoveKind::Arc) {
            const double radius_mm = std::hypot(to.z_mm - to.centre_z_mm, to.x_mm - to.centre_x_mm);
            if (std::isfinite(radius_mm) && radius_mm > 0)
                way.chords = std::clamp(2 * length / std::sqrt(8 * radius_mm * arcChord_mm), 1.0, 2000.0);
        }
        ways.push_back(way);
    }
    return ways;
}

double workOf(std::span<const FeedWay> ways, double tool_width_mm, const StockSteps& steps)
{
    double visits = 0;
    for (const FeedWay& way : ways) {
        const double strokes = std::max(way.chords, std::ceil(way.length_mm / steps.feed_mm));
        visits += (way.over_mm + strokes * tool_width_mm) / steps.column_mm;
    }
    return visits;
}

}  // namespace

StockSteps stepsFor(double stock_length_mm, std::span<const gcode::Move> moves, double tool_width_mm,
                    const StockParameters& parameters)
{
    StockSteps steps{std::max(parameters.step_mm, stock_length_mm / static_cast<double>(mostColumns)),
                     parameters.feed_step_mm};
    const std::vector<FeedWay> ways = feedWays(stock_length_mm, moves, parameters.z_zero_mm);
    while (workOf(ways, tool_width_mm, steps) > mostWork && steps.column_mm < widestColumn_mm) {
        steps.column_mm *= 2;
        steps.feed_mm = std::min(2 * steps.feed_mm, std::max(longestFeedStep_mm, parameters.feed_step_mm));
    }
    return steps;
}

}  // namespace lathelier::stock
