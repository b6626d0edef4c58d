#include "engine/cam/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double farDistance_mm = 1e4;
constexpr int edgeBisections = 24;

Vector2d pointOf(const ContourPiece& piece, double share)
{
    if (!piece.isArc()) return piece.from_mm + share * (piece.to_mm - piece.from_mm);
    const auto [start, end] = piece.arcAngles();
    const double angle = start + share * (end - start);
    return piece.centre_mm() + std::abs(piece.arc_radius_mm) * Vector2d(std::cos(angle), std::sin(angle));
}

/// A point of the contour: piece and parameter along it.
struct DrawnPlace {
    std::size_t piece = 0;
    double share = 0;
    double way_mm = 0;  // from the start of the drawing
};

class RestSearch {
public:
    RestSearch(const HeightContour& contour, const std::vector<ToolReach>& tools) : contour_(contour), tools_(tools) {}

    std::vector<Unreached> run()
    {
        double way = 0;
        for (std::size_t i = 0; i < contour_.pieces.size(); ++i) {
            const ContourPiece& piece = contour_.pieces[i];
            if (piece.from_mm.x() >= contour_.length_mm - 1e-9 && piece.to_mm.x() > contour_.length_mm) break;
            const double length = piece.length_mm();
            const auto steps = static_cast<std::size_t>(std::max(8.0, std::ceil(length / restSpacing_mm)));
            double skip = 0;  // step bound: the residual of all tools at the skipped points is smaller
            for (std::size_t k = 0; k <= steps; ++k) {
                if (k > 0 && k < steps && skip > 0) {
                    --skip;
                    continue;
                }
                skip = 0;
                const DrawnPlace place{i, static_cast<double>(k) / static_cast<double>(steps),
                                       way + length * static_cast<double>(k) / static_cast<double>(steps)};
                take(place, leftAt(place));
            }
            way += length;
        }
        close(last_);
        return std::move(found_);
    }

private:
    double leftAt(const DrawnPlace& place) const
    {
        return leftAt_mm(pointOf(contour_.pieces[place.piece], place.share), tools_, farDistance_mm);
    }

    void take(const DrawnPlace& place, double left)
    {
        const bool is_rest = left > leastRest_mm;
        if (is_rest && !isOpen_) {
            isOpen_ = true;
            start_ = hasLast_ && last_.piece == place.piece ? edgeBetween(last_, place) : place;
            most_ = place;
            mostLeft_ = left;
        } else if (is_rest && left > mostLeft_) {
            most_ = place;
            mostLeft_ = left;
        } else if (!is_rest && isOpen_) {
            close(last_.piece == place.piece ? edgeBetween(place, last_) : last_);
        }
        last_ = place;
        hasLast_ = true;
    }

    /// Bisects for the point of one piece where `left` crosses the threshold.
    DrawnPlace edgeBetween(DrawnPlace below, DrawnPlace above) const
    {
        for (int i = 0; i < edgeBisections; ++i) {
            const DrawnPlace middle{below.piece, (below.share + above.share) / 2, (below.way_mm + above.way_mm) / 2};
            (leftAt(middle) > leastRest_mm ? above : below) = middle;
        }
        return above;
    }

    void close(const DrawnPlace& end)
    {
        if (!isOpen_) return;
        isOpen_ = false;
        refineMost();
        Unreached rest;
        const Vector2d a = pointOf(contour_.pieces[start_.piece], start_.share);
        const Vector2d b = pointOf(contour_.pieces[end.piece], end.share);
        const Vector2d most = pointOf(contour_.pieces[most_.piece], most_.share);
        rest.z_start_mm = std::min(a.x(), b.x());
        rest.z_end_mm = std::max(a.x(), b.x());
        rest.left_mm = mostLeft_;
        rest.z_most_mm = most.x();
        rest.x_most_mm = most.y();
        rest.path_from_mm = start_.way_mm;
        rest.path_to_mm = end.way_mm;
        assignCause(rest, most, end);
        found_.push_back(rest);
    }

    /// Golden section on the piece of the largest point found, one step to both sides.
    void refineMost()
    {
        const ContourPiece& piece = contour_.pieces[most_.piece];
        const double step = std::min(0.125, restSpacing_mm / std::max(piece.length_mm(), 1e-9));
        double low = std::max(0.0, most_.share - step), high = std::min(1.0, most_.share + step);
        const double golden = (std::sqrt(5.0) - 1) / 2;
        for (int i = 0; i < 2 * edgeBisections; ++i) {
            DrawnPlace a = most_, b = most_;
            a.share = high - golden * (high - low);
            b.share = low + golden * (high - low);
            (leftAt(a) < leftAt(b) ? low : high) = leftAt(a) < leftAt(b) ? a.share : b.share;
        }
        DrawnPlace best = most_;
        best.share = (low + high) / 2;
        if (const double left = leftAt(best); left > mostLeft_) {
            mostLeft_ = left;
            most_ = best;
        }
    }

    void assignCause(Unreached& rest, const Vector2d& most, const DrawnPlace& end) const
    {
        const ToolReach* nearest = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (const ToolReach& tool : tools_)
            if (const double left = tool.left_mm(most, farDistance_mm); left < least) {
                least = left;
                nearest = &tool;
            }
        if (!nearest) return;
        rest.tool = nearest->tool;
        rest.tool_radius_mm = nearest->radius_mm;
        rest.cause = nearest->span_mm > 0 ? RestCause::Blade : causeOf(*nearest, most);
        for (std::size_t i = start_.piece; i <= end.piece; ++i)
            if (const double arc = contour_.pieces[i].arc_radius_mm; arc < 0 && -arc < nearest->radius_mm)
                rest.fillet_radius_mm = -arc;
    }

    static RestCause causeOf(const ToolReach& tool, const Vector2d& most)
    {
        const CurvePiece* nearest = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (const CurvePiece& piece : tool.curve)
            if (const double distance = piece.distanceTo(most); distance < least - 1e-9) {
                least = distance;
                nearest = &piece;
            }
        if (!nearest) return RestCause::NoseRadius;
        // At a corner between two pieces the ray next to it is the limiting contact.
        for (const CurvePiece& piece : tool.curve)
            if (piece.distanceTo(most) < least + 1e-6) {
                if (piece.touch == Touch::Tailstock) return RestCause::Tailstock;
                if (piece.touch == Touch::BackRay) return RestCause::BackAngle;
                if (piece.touch == Touch::LeadRay) return RestCause::LeadingAngle;
            }
        return RestCause::NoseRadius;
    }

    const HeightContour& contour_;
    const std::vector<ToolReach>& tools_;
    std::vector<Unreached> found_;
    bool isOpen_ = false, hasLast_ = false;
    DrawnPlace start_, most_, last_;
    double mostLeft_ = 0;
};

}  // namespace

double ToolReach::left_mm(const Vector2d& point, double most_mm) const
{
    if (curve.empty()) return most_mm;
    double distance = distanceTo(curve, point, most_mm + radius_mm);
    if (span_mm > 0) {
        const Vector2d back(span_mm, 0);
        distance = std::min(distance, distanceTo(curve, point + back, distance));
        // Straight edge at the piece ends; sloped stretches between are swept by the corners.
        auto piece = std::lower_bound(curve.begin(), curve.end(), point.x() - 1e-9,
                                      [](const CurvePiece& a, double u) { return a.to.x() < u; });
        for (; piece != curve.end() && piece->from.x() - span_mm <= point.x(); ++piece)
            for (const Vector2d& end : {piece->from, piece->to})
                if (end.x() >= point.x() && end.x() - span_mm <= point.x())
                    distance = std::min(distance, std::abs(end.y() - point.y()));
    }
    return distance - radius_mm;
}

double leftAt_mm(const Vector2d& point, const std::vector<ToolReach>& tools, double most_mm)
{
    double least = most_mm;
    for (const ToolReach& tool : tools) least = std::min(least, tool.left_mm(point, least));
    return least;
}

std::vector<Unreached> restOf(const HeightContour& contour, const std::vector<ToolReach>& tools)
{
    return RestSearch(contour, tools).run();
}

}  // namespace lathelier::cam
