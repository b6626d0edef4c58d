#include "engine/cam/rest_operations.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double plungeAllowance_mm = 0.05;  // left on the floor by plunges
constexpr double plungeSpacingShare = 0.7;   // plunge spacing over the blade width
constexpr double bladeSpeedShare = 0.6;      // over the cutting speed of roughing
constexpr double assumedBladeFeed_mm_rev = 0.06;
constexpr double leastCut_mm3 = 1e-3;       // passes that cut less are left out
constexpr double leastShoulderSlope = 1.0;  // smallest slope of a drawn shoulder

/// Rapid move above a tip position and down to the clearance above the stock, not below `x_mm`.
void approach(MoveList& moves, const WorkFrame& frame, const WorkStock& stock, int tool, double z_mm, double x_mm)
{
    if (moves.isEmpty())
        moves.rapid({z_mm, frame.safe_x_mm});
    else
        moves.rapidX(frame.safe_x_mm);
    moves.rapidZ(z_mm);
    moves.rapidX(std::min(frame.safe_x_mm, stock.reachableFromAbove_mm(tool, z_mm, x_mm, frame.safe_x_mm)));
}

/// True if the rest is the corner at the foot of a shoulder rising toward the chuck, which the finishing tool reaches
/// itself.
bool isAtShoulder(const WorkFrame& frame, const Unreached& rest)
{
    const Contour& pieces = frame.contour.pieces;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
        if ((pieces[i].to_mm - Vector2d(rest.z_most_mm, rest.x_most_mm)).norm() > 1e-3) continue;
        return startSlope(pieces[i + 1]) > leastShoulderSlope && endSlope(pieces[i]) > -leastShoulderSlope;
    }
    return false;
}

/// Removes the moves from `first` on from the stock; the volume that they cut.
double cutMovesFrom(MoveList& moves, std::size_t first, int tool, WorkStock& stock)
{
    Operation laid;
    laid.tool = tool;
    laid.moves.assign(moves.moves().begin() + static_cast<std::ptrdiff_t>(first), moves.moves().end());
    const double before_mm3 = stock.removed_mm3();
    stock.run(laid);
    return stock.removed_mm3() - before_mm3;
}

/// Adds moves that prepare for a pass along the contour, and removes what they cut from the stock; where they cut
/// nothing, neither they nor the way to them are added.
template <class AddMoves>
void addIfCutting(MoveList& moves, int tool, WorkStock& stock, AddMoves add)
{
    MoveList longer = moves;
    WorkStock left = stock;
    add(longer);
    if (!(cutMovesFrom(longer, moves.moves().size(), tool, left) > leastCut_mm3)) return;
    moves = std::move(longer);
    stock = std::move(left);
}

/// Without the beginning (`backwards`: the end) in which the blade would only rub along finished surface before it
/// descends, but for restOverlap_mm of it.
Curve trimmed(const Curve& way, bool backwards, double span_mm, double corner_mm, const WorkStock& stock)
{
    constexpr double step_mm = 0.05, level_mm = 0.02;
    if (way.empty()) return way;
    const double first = way.front().from.x(), last = way.back().to.x();
    const double begin = backwards ? last : first, end = backwards ? first : last;
    const double height = heightAt(way, begin), sign = backwards ? -1 : 1;
    double rubs_to = begin;
    for (double z = begin; sign * (end - z) > 0; z += sign * step_mm) {
        const double at = heightAt(way, z);
        if (at < height - level_mm) break;
        if (stock.topBetween_mm(z - span_mm - corner_mm, z + corner_mm) > at - corner_mm + level_mm) break;
        rubs_to = z;
    }
    const double from = rubs_to - sign * restOverlap_mm;
    if (sign * (from - begin) <= 0) return way;
    return backwards ? clipped(way, first, from) : clipped(way, from, last);
}

/// The lowest places of a blade's curve.
struct Floor {
    double from_mm = 0, to_mm = 0;  // in z
    double x_mm = 0;
    double middle_mm() const { return (from_mm + to_mm) / 2; }
};

Floor floorOf(const Curve& part)
{
    Floor floor{part.front().from.x(), part.front().from.x(), lowestOf(part)};
    bool is_found = false;
    for (const CurvePiece& piece : part)
        for (const Vector2d& end : {piece.from, piece.to}) {
            if (end.y() > floor.x_mm + same_mm) continue;
            if (!is_found) floor.from_mm = end.x();
            is_found = true;
            floor.to_mm = end.x();
        }
    if (is_found) return floor;
    for (const CurvePiece& piece : part)  // the lowest place is within a hollow arc
        if (piece.radius_mm < 0) floor.from_mm = floor.to_mm = piece.centre.x();
    return floor;
}

/// z of plunges: both ends of the floor, equally spaced between, then outward to the ends of the curve.
std::vector<double> plungesFor(const Curve& part, const Floor& floor, double step_mm)
{
    std::vector<double> places;
    const double from = floor.from_mm + plungeAllowance_mm, to = floor.to_mm - plungeAllowance_mm;
    if (to > from) {
        const int count = std::max(1, static_cast<int>(std::ceil((to - from) / step_mm)));
        for (int i = 0; i <= count; ++i) places.push_back(from + (to - from) * i / count);
    } else {
        places.push_back(floor.middle_mm());
    }
    for (double z = floor.from_mm - step_mm; z > part.front().from.x(); z -= step_mm) places.push_back(z);
    for (double z = floor.to_mm + step_mm; z < part.back().to.x(); z += step_mm) places.push_back(z);
    return places;
}

/// Adds passes at levels above the curve where the stock exceeds one depth of cut.
void addLevels(MoveList& moves, const WorkFrame& frame, const JobTool& tool, const Curve& part, WorkStock& stock,
               double feed)
{
    const double depth = frame.job->cutting.rough.depth_mm, r = tool.radius_mm();
    const double low = lowestOf(part);
    const double from = part.front().from.x(), to = part.back().to.x();
    const double top = std::min(stock.topBetween_mm(from, to), frame.stock_radius_mm) + r;
    const int steps = static_cast<int>(std::ceil((top - low) / depth - 1e-9));
    for (int i = 1; i < steps; ++i) {
        const double level = top - (top - low) * i / steps;
        for (const Stretch& stretch : stretchesBelow(part, level)) {
            if (stretch.to_mm - stretch.from_mm < 0.2) continue;
            // Only where stock exceeds the level.
            if (stock.topBetween_mm(stretch.from_mm, stretch.to_mm) < level - r + plungeAllowance_mm) continue;
            const double x = level + moves.offset().y(), begin = stretch.to_mm + moves.offset().x(),
                         end = stretch.from_mm + moves.offset().x();
            // Down along the curve, which is no steeper than the back edge.
            const double before = level + (top - low) / steps;
            Curve way = clipped(part, stretch.to_mm, to);
            double until = to;
            for (const Stretch& below : stretchesBelow(way, before))
                if (below.from_mm <= stretch.to_mm + same_mm) until = below.to_mm;
            way = clipped(part, stretch.to_mm, until);
            addIfCutting(moves, tool.number, stock, [&](MoveList& pass) {
                if (way.empty()) {
                    approach(pass, frame, stock, tool.number, begin, x + rapidAbove_mm);
                } else {
                    approach(pass, frame, stock, tool.number, until + pass.offset().x(),
                             way.back().to.y() + pass.offset().y() + rapidAbove_mm);
                    pass.line(way.back().to + pass.offset(), slowShare * feed);
                    pass.follow(way, slowShare * feed, true);
                }
                pass.line({begin, x}, slowShare * feed);
                pass.line({end, x}, feed);
                pass.line({end + retract_mm, x + retract_mm}, feed);
                pass.rapidX(frame.safe_x_mm);
            });
        }
    }
}

}  // namespace

std::optional<Operation> backTurning(const WorkFrame& frame, const JobTool& tool, const ToolReach& reach,
                                     const Unreached& rest, const WorkStock& stock)
{
    const double r = tool.radius_mm();
    const double from = std::max(rest.z_start_mm - restOverlap_mm - r, reach.curve.front().from.x());
    const double to = std::min(rest.z_end_mm + restOverlap_mm + r, reach.curve.back().to.x());
    const Curve part = clipped(reach.curve, from, to);
    if (part.empty()) return {};
    const RoughCutting& rough = frame.job->cutting.rough;
    const FinishCutting& finish = frame.job->cutting.finish;
    const double feed = finishFeed(*frame.job, tool);
    Operation result{OperationKind::FinishBack, tool.number, finish.cutting_speed_m_min, {}, {}, {}};
    MoveList moves(tipOffset(tool));
    WorkStock worked = stock;
    if (rest.left_mm > rough.depth_mm) addLevels(moves, frame, tool, part, worked, feed);
    const Vector2d start = part.back().to + moves.offset();
    approach(moves, frame, worked, tool.number, start.x(), start.y() + rapidAbove_mm);
    moves.line(start, feed);
    moves.follow(part, finishFeeds(frame, tool), feed, true);
    moves.line({moves.at().x(), moves.at().y() + retract_mm}, 2 * feed);
    moves.rapidX(frame.safe_x_mm);
    result.moves = moves.taken();
    return result;
}

std::optional<Operation> grooving(const WorkFrame& frame, const JobTool& blade, const ToolReach& reach,
                                  const Unreached& rest, const WorkStock& stock)
{
    const double c = reach.radius_mm, span = reach.span_mm, width = *blade.width_mm;
    const double from = std::max(rest.z_start_mm - c - restOverlap_mm, reach.curve.front().from.x());
    const double to = std::min(rest.z_end_mm + span + c + restOverlap_mm, reach.curve.back().to.x());
    const Curve part = clipped(reach.curve, from, to);
    if (part.empty()) return {};
    const Floor floor = floorOf(part);
    const double feed = blade.feed_mm_rev.value_or(assumedBladeFeed_mm_rev);
    Operation result{OperationKind::Groove,
                     blade.number,
                     bladeSpeedShare * frame.job->cutting.rough.cutting_speed_m_min,
                     {},
                     {},
                     {}};
    MoveList moves(tipOffset(blade));
    const Vector2d offset = moves.offset();
    WorkStock worked = stock;
    for (const double z : plungesFor(part, floor, plungeSpacingShare * width)) {
        const double x = heightAt(part, z) + plungeAllowance_mm + offset.y();
        const double top = worked.topBetween_mm(z - span - c, z + c);
        if (top < x + plungeAllowance_mm) continue;
        addIfCutting(moves, blade.number, worked, [&](MoveList& plunge) {
            approach(plunge, frame, worked, blade.number, z + offset.x(),
                     std::min(top + rapidAbove_mm / 2, frame.safe_x_mm));
            plunge.line({z + offset.x(), x}, feed);
            plunge.rapidX(frame.safe_x_mm);
        });
    }
    const auto wall = [&](Curve way, bool backwards) {
        // If the floor is a single point, both walls end there.
        const auto is_away = [](const CurvePiece& piece, bool up) {
            return piece.touch == Touch::Join && (piece.to.y() > piece.from.y()) == up;
        };
        while (!backwards && !way.empty() && is_away(way.back(), true)) way.pop_back();
        while (backwards && !way.empty() && is_away(way.front(), false)) way.erase(way.begin());
        if (way.empty()) return;
        const Vector2d start = (backwards ? way.back().to : way.front().from) + offset;
        const std::size_t done = moves.moves().size();
        approach(moves, frame, worked, blade.number, start.x(), start.y() + rapidAbove_mm / 2);
        moves.line(start, feed);
        moves.follow(way, feed, backwards);
        moves.line(moves.at() + Vector2d(0, retract_mm / 5), feed);
        moves.rapidX(frame.safe_x_mm);
        cutMovesFrom(moves, done, blade.number, worked);
    };
    wall(trimmed(clipped(part, from, floor.middle_mm()), false, span, c, worked), false);
    wall(trimmed(clipped(part, floor.middle_mm(), to), true, span, c, worked), true);
    result.moves = moves.taken();
    return result;
}

double depthOf(const Operation& grooving, const JobTool& blade, const WorkStock& stock)
{
    double deepest = 0;
    for (const CutMove& move : grooving.moves)
        if (move.kind != CutKind::Rapid)
            deepest = std::max(deepest, stock.topBetween_mm(move.to.x() - *blade.width_mm, move.to.x()) - move.to.y());
    return deepest;
}

std::vector<Unreached> improvableRests(const WorkFrame& frame, const std::vector<Unreached>& rest,
                                       const std::vector<ToolReach>& so_far, const ToolReach& tool)
{
    std::vector<Unreached> found;
    for (const Unreached& interval : rest) {
        if (interval.cause == RestCause::NoseRadius && isAtShoulder(frame, interval)) continue;
        double gain = 0;
        double way = 0;
        for (const ContourPiece& piece : frame.contour.pieces) {
            const double length = piece.length_mm(), low = std::max(0.0, interval.path_from_mm - way),
                         high = std::min(length, interval.path_to_mm - way);
            way += length;
            if (!(high >= low)) continue;
            constexpr int triedPlaces = 64;
            for (int i = 0; i <= triedPlaces; ++i) {
                const double share = length > 0 ? (low + (high - low) * i / triedPlaces) / length : 0;
                Vector2d point = piece.from_mm + share * (piece.to_mm - piece.from_mm);
                if (piece.isArc()) {
                    const auto [start, end] = piece.arcAngles();
                    const double angle = start + share * (end - start);
                    point =
                        piece.centre_mm() + std::abs(piece.arc_radius_mm) * Vector2d(std::cos(angle), std::sin(angle));
                }
                const double left = leftAt_mm(point, so_far, 1e4);
                gain = std::max(gain, left - std::max(0.0, tool.left_mm(point, left)));
            }
        }
        if (gain > leastGain_mm) found.push_back(interval);
    }
    return found;
}

}  // namespace lathelier::cam
