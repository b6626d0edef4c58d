#include "engine/cam/deep_rest.h"

#include <algorithm>
#include <cmath>

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double largestFeedPerNoseRadius = 0.4;
constexpr double shortestDeepPass_mm = 0.1;

}  // namespace

std::optional<Operation> deepPasses(const WorkFrame& frame, const JobTool& rough, const JobTool& finish,
                                    const WorkStock& stock)
{
    const RoughCutting& cutting = frame.job->cutting.rough;
    const double step = std::min(cutting.depth_mm, deepFinish_mm), r = finish.radius_mm();
    if (!finish.isProfile() || finish.hand != Hand::TowardChuck) return {};
    ToolReach left = reachOf(frame, rough, cutting.allowance_mm);
    left.radius_mm += cutting.allowance_mm;  // the constant allowance is not residual material
    const double fine = finishFeed(*frame.job, finish);
    const double feed = std::max(fine, std::min(cutting.feed_mm_rev, largestFeedPerNoseRadius * r));
    Operation result{
        OperationKind::SemiFinish, finish.number, frame.job->cutting.finish.cutting_speed_m_min, {}, {}, {}};
    MoveList moves(tipOffset(finish));
    WorkStock worked = stock;
    const Curve finished = toolCurve(frame, finish);
    for (const Unreached& rest : restOf(frame.contour, {left})) {
        // The part of it that the finishing tool can reach.
        double deepest = 0;
        for (const CurvePiece& piece : clipped(finished, rest.z_start_mm - r, rest.z_end_mm + r))
            for (const double share : {0.0, 0.5, 1.0})
                if (piece.touch != Touch::Join)
                    deepest =
                        std::max(deepest, distanceTo(left.curve, piece.point(share), 1e4) - rough.radius_mm() + r);
        const int passes = static_cast<int>(std::ceil(deepest / step - 1e-9));
        for (int i = 1; i < passes; ++i) {
            const double allowance = deepest * (passes - i) / passes;
            const Curve curve = toolCurve(frame, finish, allowance);
            const Curve part = clipped(curve, std::max(rest.z_start_mm - restOverlap_mm - r, curve.front().from.x()),
                                       std::min(rest.z_end_mm + restOverlap_mm + r, curve.back().to.x()));
            if (part.empty() || part.back().to.x() - part.front().from.x() < shortestDeepPass_mm) continue;
            const Vector2d start = part.front().from + moves.offset();
            const std::size_t done = moves.moves().size();
            if (moves.isEmpty())
                moves.rapid({start.x(), frame.safe_x_mm});
            else
                moves.rapidZ(start.x());
            moves.rapidX(std::min(
                frame.safe_x_mm,
                worked.reachableFromAbove_mm(finish.number, start.x(), start.y() + rapidAbove_mm, frame.safe_x_mm)));
            moves.line(start, feed);
            moves.follow(part, feed);
            moves.line(moves.at() + Vector2d(-retract_mm, retract_mm), feed);
            moves.rapidX(frame.safe_x_mm);
            Operation laid = result;
            laid.moves.assign(moves.moves().begin() + static_cast<std::ptrdiff_t>(done), moves.moves().end());
            if (done > 0) laid.moves.front().kind = CutKind::Rapid;
            worked.run(laid);
        }
    }
    if (moves.isEmpty()) return {};
    result.moves = moves.taken();
    return result;
}

}  // namespace lathelier::cam
