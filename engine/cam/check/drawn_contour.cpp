#include "engine/cam/check/drawn_contour.h"

#include <algorithm>
#include <cmath>

namespace lathelier::cam {
namespace {

Contour piecesOf(const Shaft& part, double hole_radius_mm)
{
    Contour pieces = outerContour(part);
    if (pieces.empty()) return pieces;
    const Eigen::Vector2d edge = pieces.front().from_mm;
    if (edge.y() > hole_radius_mm) pieces.insert(pieces.begin(), ContourPiece{{edge.x(), hole_radius_mm}, edge});
    return pieces;
}

Corner plainAt(const ContourPiece& piece, double t)
{
    if (!piece.isArc()) {
        const Eigen::Vector2d at = piece.from_mm + t * (piece.to_mm - piece.from_mm);
        return {at.x(), at.y()};
    }
    const auto [begin, end] = piece.arcAngles();
    const Eigen::Vector2d centre = piece.centre_mm();
    const double angle = begin + t * (end - begin), radius = std::abs(piece.arc_radius_mm);
    return {centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle)};
}

}  // namespace

DrawnContour::DrawnContour(const Shaft& part, gcode::StatedCorrection correction, double spacing_mm,
                           double hole_radius_mm)
    : pieces_(piecesOf(part, hole_radius_mm)), correction_(std::move(correction))
{
    double length = 0;
    for (const ContourPiece& piece : pieces_) length += piece.length_mm();
    spacing_mm_ = std::max(spacing_mm, length / static_cast<double>(mostDrawnPoints));
    for (std::uint32_t number = 0; number < pieces_.size(); ++number) {
        const int steps = std::max(1, static_cast<int>(std::ceil(pieces_[number].length_mm() / spacing_mm_)));
        for (int i = 0; i <= steps; ++i) {
            DrawnPoint point;
            point.t = static_cast<double>(i) / steps;
            point.piece = number;
            point.at = at(number, point.t);
            if (!points_.empty())
                point.along_mm = points_.back().along_mm + stock::length_mm(point.at - points_.back().at);
            points_.push_back(point);
        }
    }
}

Corner DrawnContour::at(std::uint32_t piece, double t) const
{
    Corner corner = plainAt(pieces_[piece], t);
    if (correction_.isAny()) corner.x_mm += correction_.at_mm(corner.z_mm);
    return corner;
}

Corner DrawnContour::normalAt(std::uint32_t piece, double t) const
{
    const ContourPiece& of = pieces_[piece];
    if (!of.isArc()) {
        const Eigen::Vector2d way = (of.to_mm - of.from_mm).normalized();
        return {-way.y(), way.x()};
    }
    const Eigen::Vector2d centre = of.centre_mm();
    const Corner outward = plainAt(of, t) - Corner{centre.x(), centre.y()};
    return (of.arc_radius_mm > 0 ? 1 : -1) / std::abs(of.arc_radius_mm) * outward;
}

}  // namespace lathelier::cam
