#include "engine/cam/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

/// Collects the candidates of one tool.
class Candidates {
public:
    Candidates(const HeightContour& contour, const ToolWedge& tool, double radius_mm)
        : radius_(radius_mm),
          first_(-radius_mm),
          last_(contour.pieces.back().to_mm.x()),
          back_(tool.back_angle_deg * rad_per_deg),
          lead_(tool.entering_angle_deg * rad_per_deg),
          hasBack_(tool.back_angle_deg < 90),
          hasLead_(tool.entering_angle_deg < 90)
    {
        all_.reserve(4 * contour.pieces.size());
        const Contour& pieces = contour.pieces;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const auto source = static_cast<std::int32_t>(i);
            addVertex(pieces[i].from_mm, source, i > 0 ? endSlope(pieces[i - 1]) : verticalSlope,
                      startSlope(pieces[i]));
            if (pieces[i].isArc())
                addArc(pieces[i], source);
            else
                addLine(pieces[i], source);
        }
        addVertex(pieces.back().to_mm, static_cast<std::int32_t>(pieces.size()), endSlope(pieces.back()),
                  -verticalSlope);
    }

    Curve taken() { return std::move(all_); }

private:
    static constexpr double verticalSlope = std::numeric_limits<double>::infinity();

    void add(CurvePiece piece)
    {
        if (piece.to.x() <= first_ || piece.from.x() >= last_) return;
        if (piece.from.x() < first_) piece.from = {first_, piece.at(first_)};
        if (piece.to.x() > last_) piece.to = {last_, piece.at(last_)};
        if (piece.to.x() - piece.from.x() > meet_mm) all_.push_back(piece);
    }

    void addLine(const ContourPiece& piece, std::int32_t source)
    {
        const Vector2d way = piece.to_mm - piece.from_mm;
        if (!(way.x() > meet_mm)) return;
        const Vector2d off = radius_ / way.norm() * Vector2d(-way.y(), way.x());
        add({piece.from_mm + off, piece.to_mm + off, 0, {}, Touch::Element, source});
    }

    void addArc(const ContourPiece& piece, std::int32_t source)
    {
        const Vector2d centre = piece.centre_mm();
        const double arc = std::abs(piece.arc_radius_mm);
        const bool convex = piece.arc_radius_mm > 0;
        const double radius = convex ? arc + radius_ : arc - radius_;
        if (radius > meet_mm) {
            const double scale = radius / arc;
            add({centre + scale * (piece.from_mm - centre), centre + scale * (piece.to_mm - centre),
                 convex ? radius : -radius, centre, Touch::Element, source});
        }
        if (!convex) return;
        if (hasBack_ && startSlope(piece) > -std::tan(back_) && endSlope(piece) < -std::tan(back_))
            addBackRay(centre + (arc + radius_) * Vector2d(std::sin(back_), std::cos(back_)), source);
        if (hasLead_ && startSlope(piece) > std::tan(lead_) && endSlope(piece) < std::tan(lead_))
            addLeadRay(centre + (arc + radius_) * Vector2d(-std::sin(lead_), std::cos(lead_)), source);
    }

    void addVertex(const Vector2d& corner, std::int32_t source, double slope_before, double slope_after)
    {
        if (slope_after >= slope_before) return;  // concave or smooth corner: covered by the discs of its neighbours
        add({corner - Vector2d(radius_, 0), corner + Vector2d(radius_, 0), radius_, corner, Touch::Vertex, source});
        if (hasBack_ && slope_after < -std::tan(back_) && slope_before >= -std::tan(back_))
            addBackRay(corner + radius_ * Vector2d(std::sin(back_), std::cos(back_)), source);
        if (hasLead_ && slope_before > std::tan(lead_) && slope_after <= std::tan(lead_))
            addLeadRay(corner + radius_ * Vector2d(-std::sin(lead_), std::cos(lead_)), source);
    }

    void addBackRay(const Vector2d& start, std::int32_t source)
    {
        const double far = last_ - start.x();
        if (far > 0) add({start, start + Vector2d(far, -far * std::tan(back_)), 0, {}, Touch::BackRay, source});
    }

    void addLeadRay(const Vector2d& end, std::int32_t source)
    {
        const double far = end.x() - first_;
        if (far > 0) add({end - Vector2d(far, far * std::tan(lead_)), end, 0, {}, Touch::LeadRay, source});
    }

    double radius_, first_, last_;
    double back_, lead_;
    bool hasBack_, hasLead_;
    Curve all_;
};

}  // namespace

Curve noseCurve(const HeightContour& contour, const ToolWedge& tool, double allowance_mm)
{
    return upperEnvelope(Candidates(contour, tool, tool.radius_mm + allowance_mm).taken());
}

Curve bladeCurve(const HeightContour& contour, double corner_radius_mm, double span_mm, double allowance_mm)
{
    const Curve corner = noseCurve(contour, {std::max(corner_radius_mm, 1e-6), 90, 90}, allowance_mm);
    const double last = corner.back().to.x();
    Curve all;
    for (const CurvePiece& piece : corner)
        if (piece.touch != Touch::Join) all.push_back(piece);
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i) {
        const CurvePiece piece = all[i];
        all.push_back(shifted({piece}, {span_mm, 0}).front());
        // A local maximum limits the straight edge until the second corner has passed it.
        const auto bridge = [&](double u) {
            CurvePiece floor;
            floor.from = {u, piece.at(u)};
            floor.to = floor.from + Vector2d(span_mm, 0);
            floor.touch = Touch::Bridge;
            floor.source = piece.source;
            all.push_back(floor);
        };
        const bool has_top =
            piece.radius_mm > 0 && piece.centre.x() > piece.from.x() && piece.centre.x() < piece.to.x();
        if (has_top) bridge(piece.centre.x());
        if (piece.from.y() > piece.to.y() || piece.from.y() == piece.to.y()) bridge(piece.from.x());
        if (piece.to.y() >= piece.from.y()) bridge(piece.to.x());
    }
    for (CurvePiece& piece : all)
        if (piece.to.x() > last && piece.from.x() < last) piece.to = {last, piece.at(last)};
    std::erase_if(all, [last](const CurvePiece& piece) { return piece.from.x() >= last; });
    return upperEnvelope(std::move(all));
}

}  // namespace lathelier::cam
