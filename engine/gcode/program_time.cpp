#include "engine/gcode/program_time.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/gcode/arc.h"

namespace lathelier::gcode {
namespace {

constexpr double chord_rad = 3 * std::numbers::pi / 180;
constexpr double mm_per_m = 1000;
constexpr double s_per_min = 60;

/// Mean of max(linear from a to b, floor) over the path.
double meanAbove(double a, double b, double floor)
{
    if (a > b) std::swap(a, b);
    if (b <= floor) return floor;
    if (a >= floor || a == b) return std::max((a + b) / 2, floor);
    const double share = (floor - a) / (b - a);  // share of the path below the floor
    return share * floor + (1 - share) * (floor + b) / 2;
}

/// Mean duration of a revolution in minutes along a straight path between two radii; NaN: no speed is stated.
double meanTurnMinutes(const Move& move, double from_x_mm, double to_x_mm)
{
    if (!isKnown(move.cutting_speed_m_min)) return 1 / move.speed_rpm;
    const double per_mm = 2 * std::numbers::pi / (mm_per_m * move.cutting_speed_m_min);
    const double least = isKnown(move.speed_limit_rpm) && move.speed_limit_rpm > 0 ? 1 / move.speed_limit_rpm : 0;
    return meanAbove(std::abs(from_x_mm) * per_mm, std::abs(to_x_mm) * per_mm, least);
}

/// Time of a straight feed; NaN or infinite where feed or speed are missing or 0.
double feedTime_s(const Move& move, const Point& from, const Point& to)
{
    const double length = distance_mm(from, to);
    if (isKnown(move.feed_mm_min)) return s_per_min * length / move.feed_mm_min;
    // The lead of a thread counts along the axis that moves farther.
    const double way =
        move.kind == MoveKind::Thread ? std::max(std::abs(to.x_mm - from.x_mm), std::abs(to.z_mm - from.z_mm)) : length;
    return s_per_min * way / move.feed_mm_rev * meanTurnMinutes(move, from.x_mm, to.x_mm);
}

void addStraight(const Move& move, const Point& from, const Point& to, double& length_mm, double& time_s)
{
    length_mm += distance_mm(from, to);
    if (distance_mm(from, to) > 0) time_s += feedTime_s(move, from, to);
}

void addArcTime(const Move& move, const Point& from, double& length_mm, double& time_s)
{
    const Point centre{move.centre_x_mm, move.centre_z_mm};
    const double radius = distance_mm(from, centre);
    const double begin = std::atan2(from.x_mm - centre.x_mm, from.z_mm - centre.z_mm);
    double sweep = std::atan2(move.x_mm - centre.x_mm, move.z_mm - centre.z_mm) - begin;
    if (move.clockwise && sweep >= 0) sweep -= 2 * std::numbers::pi;
    if (!move.clockwise && sweep <= 0) sweep += 2 * std::numbers::pi;
    const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / chord_rad)));
    const double stretch =
        std::abs(sweep / chords) / (2 * std::sin(std::abs(sweep / chords) / 2));  // ratio of arc to chord length
    Point at = from;
    double along_mm = 0, taken_s = 0;
    for (int i = 1; i <= chords; ++i) {
        const double angle = begin + sweep * i / chords;
        const Point next{centre.x_mm + radius * std::sin(angle), centre.z_mm + radius * std::cos(angle)};
        addStraight(move, at, next, along_mm, taken_s);
        at = next;
    }
    length_mm += stretch * along_mm;
    time_s += stretch * taken_s;
}

void addFeed(const Move& move, const Point& from, ToolTime& sum)
{
    const Point to{move.x_mm, move.z_mm};
    double time_s = 0;
    if (move.kind == MoveKind::Arc && isKnown(Point{move.centre_x_mm, move.centre_z_mm}))
        addArcTime(move, from, sum.feed_length_mm, time_s);
    else
        addStraight(move, from, to, sum.feed_length_mm, time_s);
    if (std::isfinite(time_s))
        sum.feed_time_s += time_s;
    else
        ++sum.moves_without_time;
}

void addRapid(const Point& from, const Point& to, const RapidRates& rates, ToolTime& sum)
{
    sum.rapid_length_mm += distance_mm(from, to);
    sum.rapid_time_s +=
        s_per_min / mm_per_m *
        std::max(std::abs(to.x_mm - from.x_mm) / rates.x_m_min, std::abs(to.z_mm - from.z_mm) / rates.z_m_min);
}

void addTool(const ToolTime& one, ToolTime& sum)
{
    sum.moves += one.moves;
    sum.feed_length_mm += one.feed_length_mm;
    sum.rapid_length_mm += one.rapid_length_mm;
    sum.feed_time_s += one.feed_time_s;
    sum.rapid_time_s += one.rapid_time_s;
    sum.dwell_time_s += one.dwell_time_s;
    sum.moves_without_time += one.moves_without_time;
}

}  // namespace

ProgramTimes timesOf(std::span<const Move> moves, const RapidRates& rates)
{
    ProgramTimes times;
    Point at;
    ToolTime* sum = nullptr;
    for (const Move& move : moves) {
        if (!sum || sum->tool != move.tool) {
            const auto known = std::find_if(times.tools.begin(), times.tools.end(),
                                            [&](const ToolTime& time) { return time.tool == move.tool; });
            if (known == times.tools.end()) {
                sum = &times.tools.emplace_back();
                sum->tool = move.tool;
                sum->line = move.line;
            } else {
                sum = &*known;
            }
        }
        ++sum->moves;
        if (move.kind == MoveKind::Dwell) {
            if (isKnown(move.dwell_s)) sum->dwell_time_s += move.dwell_s;
            continue;
        }
        const Point to{move.x_mm, move.z_mm};
        if (isKnown(at) && isKnown(to)) {
            if (move.kind == MoveKind::Rapid)
                addRapid(at, to, rates, *sum);
            else
                addFeed(move, at, *sum);
        }
        at = to;
    }
    for (const ToolTime& time : times.tools) addTool(time, times.all);
    if (!times.tools.empty()) times.all.line = times.tools.front().line;
    return times;
}

const std::vector<QuantityOf<ToolTime>>& quantitiesOf(const ToolTime*)
{
    using T = ToolTime;
    static const auto all = describedBy<T>(
        quantity<T>("tool", &T::tool, {LT_TEXT("Engine", "Tool"), {}, 0}),
        quantity<T>("line", &T::line, {LT_TEXT("Engine", "Line"), {}, 0}),
        quantity<T>("moves", &T::moves, {LT_TEXT("Engine", "Moves"), {}, 0}),
        quantity<T>("time_s", &T::time_s, {LT_TEXT("Engine", "Time"), unit::s, 1}),
        quantity<T>("feed_time_s", &T::feed_time_s, {LT_TEXT("Engine", "Time in feed"), unit::s, 1}),
        quantity<T>("rapid_time_s", &T::rapid_time_s, {LT_TEXT("Engine", "Time in rapid"), unit::s, 1}),
        quantity<T>("dwell_time_s", &T::dwell_time_s, {LT_TEXT("Engine", "Dwell"), unit::s, 1}),
        quantity<T>("feed_length_mm", &T::feed_length_mm, {LT_TEXT("Engine", "Way in feed"), unit::mm, 1}),
        quantity<T>("rapid_length_mm", &T::rapid_length_mm, {LT_TEXT("Engine", "Way in rapid"), unit::mm, 1}),
        quantity<T>("moves_without_time", &T::moves_without_time,
                    {LT_TEXT("Engine", "Feed moves without feed or speed"), {}, 0}));
    return all;
}

const std::vector<QuantityOf<ProgramTimes>>& quantitiesOf(const ProgramTimes*)
{
    using P = ProgramTimes;
    static const auto all =
        describedBy<P>(part("all", &P::all), quantity<P>("tools", [](const P& p) { return listed(p.tools); }));
    return all;
}

}  // namespace lathelier::gcode
