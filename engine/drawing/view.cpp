#include "engine/drawing/view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/units.h"
#include "engine/drawing/marks/view_marks.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double cornerSine = 0.02;  // least sine of the angle between two pieces that meet in an edge

Vector2d mirrored(const Vector2d& point)
{
    return {point.x(), -point.y()};
}

Vector2d tangent(const ContourPiece& piece, bool at_end)
{
    if (!piece.isArc()) return (piece.to_mm - piece.from_mm).normalized();
    const Vector2d out = ((at_end ? piece.to_mm : piece.from_mm) - piece.centre_mm()).normalized();
    const Vector2d anticlockwise(-out.y(), out.x());
    return piece.arc_radius_mm > 0 ? Vector2d(-anticlockwise) : anticlockwise;
}

bool isCorner(const ContourPiece& a, const ContourPiece& b)
{
    const Vector2d u = tangent(a, true), v = tangent(b, false);
    return std::abs(u.x() * v.y() - u.y() * v.x()) > cornerSine || u.dot(v) < 0;
}

/// The point at this share of the piece, 0 its start.
Vector2d pointOn(const ContourPiece& piece, double share)
{
    if (!piece.isArc()) return piece.from_mm + share * (piece.to_mm - piece.from_mm);
    const auto [start, end] = piece.arcAngles();
    const double angle = start + share * (end - start);
    return piece.centre_mm() + std::abs(piece.arc_radius_mm) * Vector2d(std::cos(angle), std::sin(angle));
}

/// Is this place of the outside behind material of a larger radius?
bool isHidden(const Contour& outside, const Vector2d& point)
{
    return std::any_of(outside.begin(), outside.end(), [&](const ContourPiece& piece) {
        const double low = std::min(piece.from_mm.x(), piece.to_mm.x()),
                     high = std::max(piece.from_mm.x(), piece.to_mm.x());
        return point.x() > low + same_mm && point.x() < high - same_mm &&
               piece.radiusAt_mm(point.x()) > point.y() + 1e-3;
    });
}

class View {
public:
    View(const Shaft& shaft, double factor)
        : factor_(factor), outside_(outerContour(shaft)), shaped_(shapedStretches(shaft))
    {
        for (const ShapedStretch& stretch : shaped_)
            for (const double z : {stretch.from_z_mm, stretch.to_z_mm}) partAt(z);
        if (outside_.empty()) return;
        if (shaft.bores.empty()) {
            addOutside(true);
        } else {
            const Contour closed = closedContour(shaft);
            for (const ContourPiece& piece : closed)
                if (piece.from_mm.y() > same_mm || piece.to_mm.y() > same_mm) addPiece(piece, false);
            addBoreEdges(closed);
            for (const Line& line : hatch({polygonOf(closed, factor)}, 2.5)) view_.lines.push_back(line);
        }
        addOutside(false);
        for (const ShaftMark& mark : shaft.marks) addMark(mark);
        addMarkLines(view_, shaft, factor, !shaft.bores.empty());
    }

    Drawing take() { return std::move(view_); }

private:
    /// A cylinder that a stretch begins or ends in becomes two.
    void partAt(double z_mm)
    {
        const auto piece = std::find_if(outside_.begin(), outside_.end(), [&](const ContourPiece& one) {
            return !one.isArc() && std::abs(one.from_mm.y() - one.to_mm.y()) < same_mm &&
                   z_mm > one.from_mm.x() + same_mm && z_mm < one.to_mm.x() - same_mm;
        });
        if (piece == outside_.end()) return;
        const ContourPiece before = *piece;
        piece->from_mm.x() = z_mm;
        ContourPiece first = before;
        first.to_mm.x() = z_mm;
        outside_.insert(piece, first);
    }

    void addLine(const Vector2d& from, const Vector2d& to, double width_mm = thick_mm)
    {
        if ((to - from).norm() * factor_ < 1e-3) return;
        const Layer layer = width_mm == thick_mm ? Layer::Contour : Layer::Dimensions;
        const Line line{factor_ * from, factor_ * to, layer, width_mm};
        if (std::find(view_.lines.begin(), view_.lines.end(), line) == view_.lines.end()) view_.lines.push_back(line);
    }

    void addPiece(const ContourPiece& piece, bool mirror)
    {
        if (!piece.isArc()) {
            addLine(mirror ? mirrored(piece.from_mm) : piece.from_mm, mirror ? mirrored(piece.to_mm) : piece.to_mm);
            return;
        }
        auto [start, end] = piece.arcAngles();
        if (start > end) std::swap(start, end);
        if (mirror) {
            std::swap(start, end);
            start = -start;
            end = -end;
        }
        const Vector2d centre = mirror ? mirrored(piece.centre_mm()) : piece.centre_mm();
        view_.arcs.push_back({factor_ * centre, factor_ * std::abs(piece.arc_radius_mm), start * 180 / std::numbers::pi,
                              end * 180 / std::numbers::pi, Layer::Contour, thick_mm});
    }

    /// The visible part of the piece, if at least one of its ends is visible.
    void addVisible(const ContourPiece& piece, bool mirror)
    {
        constexpr double insideMargin = 1e-6;
        const bool start_hidden = isHidden(outside_, pointOn(piece, insideMargin)),
                   end_hidden = isHidden(outside_, pointOn(piece, 1 - insideMargin));
        if (start_hidden && end_hidden) return;
        if (start_hidden == end_hidden) {
            addPiece(piece, mirror);
            return;
        }
        double seen = end_hidden ? 0 : 1, hidden = 1 - seen;
        for (int i = 0; i < 50; ++i) {
            const double middle = (seen + hidden) / 2;
            (isHidden(outside_, pointOn(piece, middle)) ? hidden : seen) = middle;
        }
        ContourPiece part = piece;
        (end_hidden ? part.to_mm : part.from_mm) = pointOn(piece, seen);
        addPiece(part, mirror);
    }

    /// Is the piece the round surface of a stretch that has a shape of its own?
    bool isShaped(const ContourPiece& piece) const
    {
        const double from = std::min(piece.from_mm.x(), piece.to_mm.x()),
                     to = std::max(piece.from_mm.x(), piece.to_mm.x());
        return to > from && std::any_of(shaped_.begin(), shaped_.end(), [&](const ShapedStretch& stretch) {
                   const double common = std::min(to, stretch.to_z_mm) - std::max(from, stretch.from_z_mm);
                   return common > 0.8 * (to - from);
               });
    }

    /// Is this corner one of such a surface?
    bool isShapedCorner(const Vector2d& at) const
    {
        return std::any_of(outside_.begin(), outside_.end(), [&](const ContourPiece& piece) {
            return isShaped(piece) && ((piece.from_mm - at).norm() < same_mm || (piece.to_mm - at).norm() < same_mm);
        });
    }

    /// The upper or the lower half of the outside; its edges run from the axis.
    void addOutside(bool upper)
    {
        const double sign = upper ? 1 : -1;
        const auto edge = [&](const Vector2d& at) {
            if (!isShapedCorner(at)) addLine({at.x(), 0}, {at.x(), sign * at.y()});
        };
        edge(outside_.front().from_mm);
        edge(outside_.back().to_mm);
        for (std::size_t i = 0; i < outside_.size(); ++i) {
            const ContourPiece& piece = outside_[i];
            const bool is_face = piece.from_mm.x() == piece.to_mm.x();
            const bool is_shaped =
                isShaped(piece) || (is_face && (isShapedCorner(piece.from_mm) || isShapedCorner(piece.to_mm)));
            if (!is_shaped) addVisible(piece, !upper);
            if (i + 1 == outside_.size() || !isCorner(piece, outside_[i + 1])) continue;
            if (!isHidden(outside_, piece.to_mm)) edge(piece.to_mm);
        }
    }

    /// Edges of the bores, seen behind the section.
    void addBoreEdges(const Contour& closed)
    {
        for (std::size_t i = 0; i < closed.size(); ++i) {
            const ContourPiece &piece = closed[i], &next = closed[(i + 1) % closed.size()];
            const bool inside = piece.bore != ContourPiece::none || next.bore != ContourPiece::none;
            if (inside && isCorner(piece, next)) addLine({piece.to_mm.x(), 0}, piece.to_mm);
        }
    }

    double radiusAt(double z_mm) const
    {
        double radius = 0;
        for (const ContourPiece& piece : outside_)
            if (z_mm >= std::min(piece.from_mm.x(), piece.to_mm.x()) - same_mm &&
                z_mm <= std::max(piece.from_mm.x(), piece.to_mm.x()) + same_mm && piece.from_mm.x() != piece.to_mm.x())
                radius = std::max(radius, piece.radiusAt_mm(z_mm));
        return radius;
    }

    void addMark(const ShaftMark& mark)
    {
        if (!mark.z_start_mm || !mark.z_end_mm) return;
        const double from = *mark.z_start_mm, to = *mark.z_end_mm;
        if (mark.kind == MarkKind::Thread && mark.major_mm && (mark.minor_mm || mark.pitch_mm)) {
            const double root = mark.minor_mm ? *mark.minor_mm / 2 : (*mark.major_mm - rootDepth * *mark.pitch_mm) / 2;
            double begin = from;  // the root begins inside a chamfer
            for (const ContourPiece& piece : outside_)
                if (piece.from_mm.x() <= begin && piece.to_mm.x() > begin && piece.from_mm.y() < root &&
                    piece.to_mm.y() > root)
                    begin = piece.from_mm.x() + (piece.to_mm.x() - piece.from_mm.x()) * (root - piece.from_mm.y()) /
                                                    (piece.to_mm.y() - piece.from_mm.y());
            for (const double sign : {1.0, -1.0}) addLine({begin, sign * root}, {to, sign * root}, thin_mm);
        } else if (mark.kind == MarkKind::Knurl) {
            addKnurl(from, to);
        }
    }

    /// A corner of crossed thin lines, as ISO 6413 shows a part of one.
    void addKnurl(double from, double to)
    {
        const double low = -radiusAt((from + to) / 2) * factor_, left = from * factor_;
        const double width = std::min((to - from) * factor_ / 3, 9.0), height = std::min(-low / 2, 7.0);
        const double right = left + width;
        for (Line line : hatch({{{left, low}, {right, low}, {right, low + height}, {left, low + height}}}, 1.5)) {
            line.layer = Layer::Dimensions;
            view_.lines.push_back(line);
            for (Vector2d* point : {&line.from_mm, &line.to_mm}) point->x() = left + right - point->x();
            view_.lines.push_back(line);
        }
    }

    double factor_;
    Contour outside_;
    std::vector<ShapedStretch> shaped_;
    Drawing view_;
};

}  // namespace

Drawing viewOf(const Shaft& shaft, double factor)
{
    return View(shaft, factor).take();
}

Polygon polygonOf(const Contour& contour, double factor)
{
    Polygon points;
    for (const ContourPiece& piece : contour) {
        points.emplace_back(factor * piece.from_mm);
        if (!piece.isArc()) continue;
        const auto [start, end] = piece.arcAngles();
        const int steps =
            std::max(1, static_cast<int>(std::ceil(std::abs(end - start) / (2 * std::numbers::pi / 180))));
        for (int i = 1; i < steps; ++i) {
            const double angle = start + (end - start) * i / steps;
            points.emplace_back(factor * (piece.centre_mm() +
                                          std::abs(piece.arc_radius_mm) * Vector2d(std::cos(angle), std::sin(angle))));
        }
    }
    return points;
}

std::vector<Line> hatch(const std::vector<Polygon>& polygons, double spacing_mm)
{
    const Vector2d along = Vector2d(1, 1).normalized(), across(-along.y(), along.x());
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Polygon& polygon : polygons)
        for (const Vector2d& point : polygon) {
            low = std::min(low, point.dot(across));
            high = std::max(high, point.dot(across));
        }
    std::vector<Line> lines;
    if (!(low < high)) return lines;
    for (double at = (std::floor(low / spacing_mm) + 0.5) * spacing_mm; at < high; at += spacing_mm) {
        std::vector<double> cuts;
        for (const Polygon& polygon : polygons)
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
                const double u = a.dot(across) - at, v = b.dot(across) - at;
                if ((u < 0) != (v < 0)) cuts.push_back((a + (b - a) * (u / (u - v))).dot(along));
            }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); i += 2)
            if (cuts[i + 1] - cuts[i] > 0.05)
                lines.push_back(
                    {cuts[i] * along + at * across, cuts[i + 1] * along + at * across, Layer::Hatch, thin_mm});
    }
    return lines;
}

}  // namespace lathelier::drawing
