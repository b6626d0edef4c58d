#include "engine/deflection/tool_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::deflection {
namespace {

constexpr int mostChords = 2000;  ///< of one arc

/// A straight stretch of feed motion.
struct Stretch {
    PathPoint from, to;

    int direction() const
    {
        const double dz = to.z_mm - from.z_mm;
        return dz > meet_mm ? 1 : dz < -meet_mm ? -1 : 0;
    }
};

/// Joins consecutive stretches to runs.
class RunMaker {
public:
    void add(const Stretch& stretch)
    {
        const int direction = stretch.direction();
        if (direction != 0 && direction_ != 0 && direction != direction_) finish();
        if (direction != 0) direction_ = direction;
        if (points_.empty()) points_.push_back(stretch.from);
        points_.push_back(stretch.to);
    }

    void finish()
    {
        if (direction_ == 0)
            addPlunges();
        else
            addRun();
        points_.clear();
        direction_ = 0;
    }

    std::vector<ToolRun> take() { return std::move(runs_); }

private:
    void addPlunges()
    {
        for (std::size_t i = 1; i < points_.size(); ++i) addPlunge(i);
    }

    void addPlunge(std::size_t i)
    {
        if (points_[i].x_mm < points_[i - 1].x_mm)
            runs_.push_back({ToolRun::Kind::Plunge, {points_[i - 1], points_[i]}});
    }

    void addRun()
    {
        const auto along = [this](std::size_t i) { return std::abs(points_[i].z_mm - points_[i - 1].z_mm) > meet_mm; };
        std::size_t first = 1, last = points_.size() - 1;
        while (!along(first)) addPlunge(first++);
        while (!along(last)) --last;
        const auto at = [this](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
        runs_.push_back({direction_ > 0 ? ToolRun::Kind::TowardChuck : ToolRun::Kind::TowardFreeEnd,
                         {at(first - 1), at(last + 1)}});
        for (std::size_t i = last + 1; i < points_.size(); ++i) addPlunge(i);
    }

    std::vector<PathPoint> points_;
    std::vector<ToolRun> runs_;
    int direction_ = 0;
};

}  // namespace

void appendArc(const PathPoint& from, const PathPoint& end, double chord_mm, std::vector<PathPoint>& points)
{
    const ArcCentre& c = *end.arc;
    const double radius_mm = std::hypot(from.z_mm - c.z_mm, from.x_mm - c.x_mm);
    const double begin = std::atan2(from.x_mm - c.x_mm, from.z_mm - c.z_mm);
    double sweep = std::atan2(end.x_mm - c.x_mm, end.z_mm - c.z_mm) - begin;
    if (c.clockwise && sweep >= 0) sweep -= 2 * std::numbers::pi;
    if (!c.clockwise && sweep <= 0) sweep += 2 * std::numbers::pi;
    const double widest = radius_mm > chord_mm ? 2 * std::acos(1 - chord_mm / radius_mm) : std::numbers::pi;
    const int chords = static_cast<int>(std::clamp(std::ceil(std::abs(sweep) / widest), 1.0, double{mostChords}));
    const auto at = [&](int i, double growth_mm) {
        PathPoint next = end;
        if (i == chords) return next;
        next.is_block_end = false;
        const double angle = begin + sweep * i / chords;
        const double here_mm = radius_mm + growth_mm * i / chords;
        next.z_mm = c.z_mm + here_mm * std::cos(angle);
        next.x_mm = c.x_mm + here_mm * std::sin(angle);
        return next;
    };
    // Rounded words put the end beside the circle. Where the circle would lead beyond the end by no more than that, and
    // back, the radius changes along the arc instead, as controls do it.
    const double missed_mm = std::hypot(end.z_mm - c.z_mm, end.x_mm - c.x_mm) - radius_mm;
    const double least_mm = std::min(from.z_mm, end.z_mm), most_mm = std::max(from.z_mm, end.z_mm);
    double beyond_mm = 0;
    for (int i = 1; i < chords; ++i) {
        const double z_mm = at(i, 0).z_mm;
        beyond_mm = std::max({beyond_mm, z_mm - most_mm, least_mm - z_mm});
    }
    const bool turns_back = beyond_mm > meet_mm && beyond_mm <= std::abs(missed_mm);
    for (int i = 1; i <= chords; ++i) points.push_back(at(i, turns_back ? missed_mm : 0));
}

std::vector<ToolRun> toolRuns(std::span<const ToolMove> moves, double chord_mm)
{
    RunMaker maker;
    std::vector<PathPoint> points;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        const ToolMove& move = moves[i];
        if (!move.is_feed) {
            maker.finish();
            continue;
        }
        PathPoint from{moves[i - 1].z_mm, moves[i - 1].x_mm, move.feed_mm_rev, moves[i - 1].line};
        const PathPoint end{move.z_mm, move.x_mm, move.feed_mm_rev, move.line, true, move.arc};
        points.clear();
        if (move.arc)
            appendArc(from, end, chord_mm, points);
        else
            points.push_back(end);
        for (const PathPoint& to : points) {
            maker.add({from, to});
            from = to;
        }
    }
    maker.finish();
    return maker.take();
}

}  // namespace lathelier::deflection
