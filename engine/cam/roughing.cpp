#include "engine/cam/roughing.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/ends.h"
#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double shortestRoughPass_mm = 0.05;  // shorter passes are left to the semi-finish
constexpr double largestFaceFeed_mm_rev = 0.2;

/// Descent along f into a pocket that begins at `from_mm` on a level.
struct Descent {
    Vector2d start = Vector2d::Zero();  // of the centre, at the level before
    Curve path;                         // from there to the pocket's begin on the level
};

/// Backward along f to the previous level or a local maximum below it; from a maximum, a ramp at the back angle.
Descent descentTo(const Curve& curve, double from_mm, double level_mm, double before_mm, double back_deg)
{
    Descent descent;
    descent.start = {from_mm, level_mm};
    Curve way;
    for (auto piece = curve.rbegin(); piece != curve.rend(); ++piece) {
        if (piece->from.x() >= from_mm - same_mm && piece->touch != Touch::Join) continue;
        if (piece->from.x() > from_mm + same_mm) continue;
        CurvePiece part = *piece;
        if (part.to.x() > from_mm) part.to = {from_mm, part.at(from_mm)};
        const bool has_top = part.radius_mm > 0 && part.centre.x() > part.from.x() && part.centre.x() < part.to.x();
        if (has_top) part.from = {part.centre.x(), part.at(part.centre.x())};
        if (part.from.y() <= part.to.y() + 1e-12 && part.touch != Touch::Join) break;
        if (part.touch == Touch::Join && part.from.y() < part.to.y()) break;
        bool is_at_level = false;
        if (part.from.y() > before_mm) {
            const std::vector<Stretch> below = stretchesBelow({part}, before_mm);
            if (part.touch == Touch::Join)
                part.from.y() = before_mm;
            else if (!below.empty())
                part.from = {below.front().from_mm, part.at(below.front().from_mm)};
            is_at_level = true;
        }
        way.push_back(part);
        descent.start = part.from;
        if (is_at_level || has_top) break;
    }
    std::reverse(way.begin(), way.end());
    descent.path = std::move(way);
    if (descent.start.y() < before_mm - same_mm && back_deg > 0 && back_deg < 90) {
        const double rise = before_mm - descent.start.y();
        CurvePiece ramp;
        ramp.to = descent.start;
        ramp.from = {descent.start.x() - rise / std::tan(back_deg * rad_per_deg), before_mm};
        bool is_free = ramp.from.x() > curve.front().from.x();
        for (int i = 0; is_free && i < 32; ++i) {
            const Vector2d point = ramp.point(i / 32.0);
            is_free = heightAt(curve, point.x()) <= point.y() + same_mm;
        }
        if (is_free) {
            descent.start = ramp.from;
            descent.path.insert(descent.path.begin(), ramp);
        }
    }
    return descent;
}

class Roughing {
public:
    Roughing(const WorkFrame& frame, const JobTool& tool, WorkStock& stock)
        : frame_(frame),
          tool_(tool),
          stock_(stock),
          curve_(toolCurve(frame, tool, frame.job->cutting.rough.allowance_mm)),
          moves_(tipOffset(tool)),
          feed_(tool.feed_mm_rev.value_or(frame.job->cutting.rough.feed_mm_rev)),
          frontZ_(frame.frontZ_mm())
    {
        operation_.kind = OperationKind::Rough;
        operation_.tool = tool.number;
        operation_.cutting_speed_m_min = frame.job->cutting.rough.cutting_speed_m_min;
    }

    std::optional<Operation> run()
    {
        const double r = tool_.radius_mm(), top = frame_.stock_radius_mm + r, low = lowestOf(curve_);
        const int steps = static_cast<int>(std::ceil((top - low) / frame_.job->cutting.rough.depth_mm - 1e-9));
        for (int i = 1; i < steps; ++i) {
            const double level = top - (top - low) * i / steps, before = top - (top - low) * (i - 1) / steps;
            for (const Stretch& stretch : stretchesBelow(curve_, level)) {
                if (stretch.to_mm - stretch.from_mm < shortestRoughPass_mm) continue;
                if (stretch.from_mm < curve_.front().from.x() + same_mm)
                    passFromFront(stretch, level);
                else
                    pocket(stretch, level, before);
            }
        }
        if (moves_.isEmpty()) return {};
        moves_.rapidX(frame_.safe_x_mm);
        operation_.moves = moves_.taken();
        stock_.run(partFrom(cutMoves_));
        return std::move(operation_);
    }

private:
    void passFromFront(const Stretch& stretch, double level)
    {
        const double x = level + moves_.offset().y(), end = stretch.to_mm + moves_.offset().x();
        if (moves_.isEmpty()) {
            moves_.rapid({frontZ_, frame_.safe_x_mm});
        } else if (moves_.at().x() != frontZ_) {
            moves_.rapidX(frame_.safe_x_mm);
            moves_.rapidZ(frontZ_);
        }
        moves_.rapidX(x);
        moves_.line({end, x}, feed_);
        moves_.line({end - retract_mm, x + retract_mm}, feed_);
        moves_.rapidZ(frontZ_);
    }

    void pocket(const Stretch& stretch, double level, double before)
    {
        const Descent descent = descentTo(curve_, stretch.from_mm, level, before, wedgeOf(tool_).back_angle_deg);
        const Vector2d start = descent.start + moves_.offset();
        const double end = stretch.to_mm + moves_.offset().x(), x = level + moves_.offset().y();
        cutPendingMoves();
        if (moves_.isEmpty())
            moves_.rapid({start.x(), frame_.safe_x_mm});
        else
            moves_.rapidX(frame_.safe_x_mm);
        moves_.rapidZ(start.x());
        const double above = std::max(start.y(), before + moves_.offset().y()) + retract_mm;
        moves_.rapidX(stock_.reachableFromAbove_mm(tool_.number, start.x(), above, frame_.safe_x_mm));
        moves_.line(start, slowShare * feed_);
        moves_.follow(descent.path, slowShare * feed_);
        moves_.line({stretch.from_mm + moves_.offset().x(), x}, slowShare * feed_);
        moves_.line({end, x}, feed_);
        moves_.line({end - retract_mm, x + retract_mm}, feed_);
        moves_.rapidX(frame_.safe_x_mm);
    }

    /// Removes the moves added since the last call from the stock.
    void cutPendingMoves()
    {
        stock_.run(partFrom(cutMoves_));
        cutMoves_ = moves_.moves().size();
    }

    Operation partFrom(std::size_t first)
    {
        const std::vector<CutMove>& all = operation_.moves.empty() ? moves_.moves() : operation_.moves;
        Operation part = operation_;
        part.moves.assign(all.begin() + static_cast<std::ptrdiff_t>(first == 0 ? 0 : first - 1), all.end());
        if (first > 0) part.moves.front().kind = CutKind::Rapid;  // from the current position
        return part;
    }

    const WorkFrame& frame_;
    const JobTool& tool_;
    WorkStock& stock_;
    Curve curve_;
    MoveList moves_;
    double feed_, frontZ_;
    Operation operation_;
    std::size_t cutMoves_ = 0;
};

Operation alongContour(const WorkFrame& frame, const JobTool& tool, OperationKind kind, const Curve& curve, double feed,
                       double speed)
{
    Operation result{kind, tool.number, speed, {}, {}, {}};
    MoveList moves(tipOffset(tool));
    const Vector2d start = curve.front().from + moves.offset();
    moves.rapid({frame.frontZ_mm(), frame.safe_x_mm});
    if (kind == OperationKind::Finish && frame.faces_end) {
        moves.rapidX(std::min(innerEnd_mm(frame, tool), start.y()));
        moves.line({start.x(), moves.at().y()}, feed);
    } else {
        moves.rapidX(start.y());
    }
    moves.line(start, feed);
    if (kind == OperationKind::Finish)
        moves.follow(curve, finishFeeds(frame, tool), feed);
    else
        moves.follow(curve, feed);
    moves.line({moves.at().x(), std::max(moves.at().y(), frame.stock_radius_mm) + retract_mm},
               std::max(feed, largestFaceFeed_mm_rev));
    moves.rapidX(frame.safe_x_mm);
    result.moves = moves.taken();
    return result;
}

}  // namespace

std::optional<Operation> roughing(const WorkFrame& frame, const JobTool& tool, WorkStock& stock)
{
    return Roughing(frame, tool, stock).run();
}

Operation semiFinishing(const WorkFrame& frame, const JobTool& tool)
{
    const RoughCutting& rough = frame.job->cutting.rough;
    return alongContour(frame, tool, OperationKind::SemiFinish, toolCurve(frame, tool, rough.allowance_mm),
                        tool.feed_mm_rev.value_or(rough.feed_mm_rev), rough.cutting_speed_m_min);
}

Operation finishing(const WorkFrame& frame, const JobTool& tool)
{
    const FinishCutting& finish = frame.job->cutting.finish;
    return alongContour(frame, tool, OperationKind::Finish, toolCurve(frame, tool), finishFeed(*frame.job, tool),
                        finish.cutting_speed_m_min);
}

}  // namespace lathelier::cam
