#include "engine/shaft/contour_distance.h"

#include <algorithm>
#include <cmath>

namespace lathelier {
namespace {

using Eigen::Vector2d;

constexpr double onAxis_mm = 1e-9;
constexpr std::size_t mostSteps = 2048;

Vector2d leftOf(const Vector2d& direction)
{
    return {-direction.y(), direction.x()};
}

bool isSurface(const ContourPiece& piece)
{
    return std::max(piece.from_mm.y(), piece.to_mm.y()) > onAxis_mm || piece.isArc();
}

/// Unit normals to the left, out of the material, at the ends of a piece.
std::pair<Vector2d, Vector2d> endNormals(const ContourPiece& piece)
{
    if (!piece.isArc()) {
        const Vector2d normal = leftOf((piece.to_mm - piece.from_mm).normalized());
        return {normal, normal};
    }
    const double sense = piece.arc_radius_mm > 0 ? 1 : -1;  // > 0 bulges to the left: away from the centre is left
    const Vector2d centre = piece.centre_mm();
    return {sense * (piece.from_mm - centre).normalized(), sense * (piece.to_mm - centre).normalized()};
}

}  // namespace

ContourDistance::ContourDistance(const Contour& contour, double reach_mm) : reach_mm_(reach_mm)
{
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const ContourPiece& piece = contour[i];
        if (!isSurface(piece) || (piece.to_mm - piece.from_mm).norm() == 0) continue;
        const ContourPiece& before = contour[(i + contour.size() - 1) % contour.size()];
        const ContourPiece& behind = contour[(i + 1) % contour.size()];
        Piece made;
        made.from = piece.from_mm;
        made.to = piece.to_mm;
        made.length = (made.to - made.from).norm();
        made.along = (made.to - made.from) / made.length;
        const auto [from, to] = endNormals(piece);
        made.from_normal = isSurface(before) ? Vector2d(from + endNormals(before).second) : from;
        made.to_normal = isSurface(behind) ? Vector2d(to + endNormals(behind).first) : to;
        made.low = made.from.cwiseMin(made.to);
        made.high = made.from.cwiseMax(made.to);
        if (piece.isArc()) {
            made.radius = std::abs(piece.arc_radius_mm);
            made.bulges_out = piece.arc_radius_mm > 0;
            made.centre = piece.centre_mm();
            const auto [start, end] = piece.arcAngles();
            made.middle = {std::cos((start + end) / 2), std::sin((start + end) / 2)};
            made.least_cosine = std::cos((end - start) / 2);
            const Vector2d bulge = Vector2d::Constant(made.radius * (1 - made.least_cosine));
            made.low -= bulge;
            made.high += bulge;
        }
        pieces_.push_back(made);
    }
    if (pieces_.empty()) return;
    first_mm_ = pieces_.front().low.x();
    double last_mm = pieces_.front().high.x();
    for (const Piece& piece : pieces_) {
        first_mm_ = std::min(first_mm_, piece.low.x());
        last_mm = std::max(last_mm, piece.high.x());
    }
    first_mm_ -= reach_mm;
    step_mm_ = std::max(1e-9, (last_mm + reach_mm - first_mm_) / static_cast<double>(mostSteps));
    start_.push_back(0);
    for (std::size_t step = 0; step < mostSteps; ++step) {
        const double from = first_mm_ + step_mm_ * static_cast<double>(step), to = from + step_mm_;
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (pieces_[i].low.x() - reach_mm <= to && pieces_[i].high.x() + reach_mm >= from)
                within_.push_back(static_cast<std::uint32_t>(i));
        start_.push_back(static_cast<std::uint32_t>(within_.size()));
    }
}

void ContourDistance::look(const Piece& piece, const Vector2d& point, double& nearest, Foot& foot) const
{
    const Vector2d beyond = (piece.low - point).cwiseMax(point - piece.high).cwiseMax(0);
    if (beyond.squaredNorm() >= nearest * nearest) return;
    const auto take = [&](double signed_mm, const Vector2d& outward) {
        if (!(std::abs(signed_mm) < nearest)) return;
        nearest = std::abs(signed_mm);
        foot = {signed_mm, outward};
    };
    const auto corner = [&](const Vector2d& at, const Vector2d& normal) {
        const Vector2d off = point - at;
        const double distance = off.norm(), sign = off.dot(normal) >= 0 ? 1 : -1;
        take(sign * distance, distance > 0 ? Vector2d(sign * off / distance) : Vector2d(normal.normalized()));
    };
    if (piece.radius == 0) {
        const double place = (point - piece.from).dot(piece.along);
        if (place <= 0) return corner(piece.from, piece.from_normal);
        if (place >= piece.length) return corner(piece.to, piece.to_normal);
        const Vector2d outward = leftOf(piece.along);
        return take((point - piece.from).dot(outward), outward);
    }
    const Vector2d off = point - piece.centre;
    const double distance = off.norm();
    if (distance > 0 && off.dot(piece.middle) >= piece.least_cosine * distance) {
        const double sense = piece.bulges_out ? 1 : -1;
        return take(sense * (distance - piece.radius), sense * off / distance);
    }
    const bool start = (point - piece.from).squaredNorm() < (point - piece.to).squaredNorm();
    corner(start ? piece.from : piece.to, start ? piece.from_normal : piece.to_normal);
}

std::optional<ContourDistance::Foot> ContourDistance::footOf(double z_mm, double r_mm) const
{
    if (pieces_.empty() || !(z_mm >= first_mm_)) return std::nullopt;
    const auto step = static_cast<std::size_t>(std::min((z_mm - first_mm_) / step_mm_, 1e9));
    if (step >= mostSteps) return std::nullopt;
    double nearest = std::nextafter(reach_mm_, 2 * reach_mm_ + 1);
    Foot foot;
    bool any = false;
    for (std::uint32_t i = start_[step]; i < start_[step + 1]; ++i) {
        const double before = nearest;
        look(pieces_[within_[i]], {z_mm, r_mm}, nearest, foot);
        any = any || nearest < before;
    }
    return any ? std::optional(foot) : std::nullopt;
}

}  // namespace lathelier
