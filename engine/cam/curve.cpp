#include "engine/cam/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

/// u of the crossings of two pieces as lines and full circles, ignoring the ends of the pieces.
int crossings(const CurvePiece& a, const CurvePiece& b, double* u)
{
    if (!a.isArc() && !b.isArc()) {
        const Vector2d da = a.to - a.from, db = b.to - b.from;
        const double slope_a = da.y() / da.x(), slope_b = db.y() / db.x();
        if (!(std::abs(slope_a - slope_b) > 1e-15)) return 0;
        u[0] = (b.from.y() - a.from.y() + slope_a * a.from.x() - slope_b * b.from.x()) / (slope_a - slope_b);
        return 1;
    }
    if (!a.isArc() || !b.isArc()) {
        const CurvePiece &line = a.isArc() ? b : a, &arc = a.isArc() ? a : b;
        const Vector2d d = (line.to - line.from).normalized();
        const Vector2d foot = line.from + d * d.dot(arc.centre - line.from);
        const double square = arc.radius_mm * arc.radius_mm - (foot - arc.centre).squaredNorm();
        if (square < 0) return 0;
        const double half = std::sqrt(square) * d.x();
        u[0] = foot.x() - half;
        u[1] = foot.x() + half;
        return 2;
    }
    const Vector2d between = b.centre - a.centre;
    const double d = between.norm(), ra = std::abs(a.radius_mm), rb = std::abs(b.radius_mm);
    if (d < meet_mm || d > ra + rb) return 0;
    const double along = (d * d + ra * ra - rb * rb) / (2 * d), square = ra * ra - along * along;
    if (square < 0) return 0;
    const double foot = a.centre.x() + along * between.x() / d, half = std::sqrt(square) * between.y() / d;
    u[0] = foot - half;
    u[1] = foot + half;
    return 2;
}

std::vector<double> breaksOf(const Curve& pieces)
{
    std::vector<double> breaks;
    breaks.reserve(4 * pieces.size());
    std::vector<const CurvePiece*> active;
    for (const CurvePiece& piece : pieces) {
        breaks.insert(breaks.end(), {piece.from.x(), piece.to.x()});
        std::erase_if(active, [&](const CurvePiece* other) { return other->to.x() <= piece.from.x() + meet_mm; });
        for (const CurvePiece* other : active) {
            double u[2];
            const double low = std::max(piece.from.x(), other->from.x()), high = std::min(piece.to.x(), other->to.x());
            for (int i = crossings(piece, *other, u); i-- > 0;)
                if (u[i] > low && u[i] < high) breaks.push_back(u[i]);
        }
        active.push_back(&piece);
    }
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(
        std::unique(breaks.begin(), breaks.end(), [](double first, double next) { return next - first < meet_mm; }),
        breaks.end());
    return breaks;
}

/// A vertical line has its x between `low` and `high` and the curve jumps there.
void addJoin(Curve& curve, const Vector2d& to)
{
    CurvePiece join;
    join.from = curve.back().to;
    join.to = {join.from.x(), to.y()};
    join.touch = Touch::Join;
    join.source = curve.back().source;
    curve.push_back(join);
}

}  // namespace

double CurvePiece::at(double u_mm) const
{
    if (isArc()) {
        const double off = u_mm - centre.x(), square = radius_mm * radius_mm - off * off;
        return centre.y() + std::copysign(std::sqrt(std::max(0.0, square)), radius_mm);
    }
    const double run = to.x() - from.x();
    return run > 0 ? from.y() + (to.y() - from.y()) * ((u_mm - from.x()) / run) : std::max(from.y(), to.y());
}

double CurvePiece::length_mm() const
{
    const double chord = (to - from).norm();
    if (!isArc()) return chord;
    return 2 * std::abs(radius_mm) * std::asin(std::min(1.0, chord / (2 * std::abs(radius_mm))));
}

Vector2d CurvePiece::point(double share) const
{
    if (!isArc()) return from + share * (to - from);
    const double start = std::atan2(from.y() - centre.y(), from.x() - centre.x());
    const double turn =
        std::remainder(std::atan2(to.y() - centre.y(), to.x() - centre.x()) - start, 2 * std::numbers::pi);
    const double angle = start + share * turn;
    return centre + std::abs(radius_mm) * Vector2d(std::cos(angle), std::sin(angle));
}

double CurvePiece::distanceTo(const Vector2d& point) const
{
    if (isArc()) {
        const Vector2d out = point - centre;
        const double far = out.norm();
        const double radius = std::abs(radius_mm);
        if (far > meet_mm) {
            const double u = centre.x() + out.x() * radius / far;
            if (u >= from.x() && u <= to.x() && (out.y() >= 0) == (radius_mm > 0)) return std::abs(far - radius);
        }
        return std::min((point - from).norm(), (point - to).norm());
    }
    const Vector2d way = to - from;
    const double square = way.squaredNorm();
    const double share = square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0;
    return (point - from - share * way).norm();
}

Curve upperEnvelope(Curve pieces)
{
    std::erase_if(pieces, [](const CurvePiece& piece) { return !(piece.to.x() - piece.from.x() > meet_mm); });
    std::sort(pieces.begin(), pieces.end(),
              [](const CurvePiece& a, const CurvePiece& b) { return a.from.x() < b.from.x(); });
    const std::vector<double> breaks = breaksOf(pieces);
    Curve curve;
    std::vector<const CurvePiece*> active;
    std::size_t next = 0;
    const CurvePiece* last = nullptr;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double low = breaks[i], high = breaks[i + 1], middle = (low + high) / 2;
        while (next < pieces.size() && pieces[next].from.x() <= middle) active.push_back(&pieces[next++]);
        std::erase_if(active, [middle](const CurvePiece* piece) { return piece->to.x() < middle; });
        const CurvePiece* best = nullptr;
        double height = -std::numeric_limits<double>::infinity();
        for (const CurvePiece* piece : active) {
            const double x = piece->at(middle) + (piece == last ? 1e-12 : 0);
            if (x > height) {
                height = x;
                best = piece;
            }
        }
        if (!best) {
            last = nullptr;
            continue;
        }
        if (best == last) {
            curve.back().to = {high, best->at(high)};
        } else {
            CurvePiece part = *best;
            part.from = {low, best->at(low)};
            part.to = {high, best->at(high)};
            if (!curve.empty() && std::abs(curve.back().to.y() - part.from.y()) > meet_mm) addJoin(curve, part.from);
            curve.push_back(part);
        }
        last = best;
    }
    return curve;
}

double heightAt(const Curve& curve, double u_mm)
{
    auto after = std::upper_bound(curve.begin(), curve.end(), u_mm,
                                  [](double u, const CurvePiece& piece) { return u < piece.from.x(); });
    double height = -std::numeric_limits<double>::infinity();
    if (after == curve.begin()) return curve.front().from.y();
    if (u_mm > curve.back().to.x()) return curve.back().to.y();
    for (auto piece = after; piece != curve.begin();) {
        --piece;
        if (piece->to.x() < u_mm) break;
        height = std::max(height, piece->at(u_mm));
    }
    return height;
}

Curve clipped(const Curve& curve, double from_mm, double to_mm)
{
    Curve result;
    for (CurvePiece piece : curve) {
        if (piece.to.x() < from_mm || piece.from.x() > to_mm) continue;
        if (piece.from.x() < from_mm) piece.from = {from_mm, piece.at(from_mm)};
        if (piece.to.x() > to_mm) piece.to = {to_mm, piece.at(to_mm)};
        if (piece.touch != Touch::Join && !(piece.to.x() - piece.from.x() > meet_mm)) continue;
        result.push_back(piece);
    }
    return result;
}

Curve shifted(Curve curve, const Vector2d& by)
{
    for (CurvePiece& piece : curve) {
        piece.from += by;
        piece.to += by;
        piece.centre += by;
    }
    return curve;
}

Curve mirrored(const Curve& curve, double length_mm)
{
    Curve result(curve.rbegin(), curve.rend());
    for (CurvePiece& piece : result) {
        std::swap(piece.from, piece.to);
        for (Vector2d* point : {&piece.from, &piece.to, &piece.centre}) point->x() = length_mm - point->x();
    }
    return result;
}

double distanceTo(const Curve& curve, const Vector2d& point, double guess_mm)
{
    double best = guess_mm;
    const auto middle = std::upper_bound(curve.begin(), curve.end(), point.x(),
                                         [](double u, const CurvePiece& piece) { return u < piece.from.x(); });
    for (auto piece = middle; piece != curve.end() && piece->from.x() - point.x() < best; ++piece)
        best = std::min(best, piece->distanceTo(point));
    for (auto piece = middle; piece != curve.begin();) {
        --piece;
        if (point.x() - piece->to.x() >= best) break;
        best = std::min(best, piece->distanceTo(point));
    }
    return best;
}

std::vector<Stretch> stretchesBelow(const Curve& curve, double level_mm)
{
    std::vector<Stretch> found;
    const auto add = [&found](double from, double to) {
        if (!(to > from)) return;
        if (!found.empty() && from - found.back().to_mm < meet_mm)
            found.back().to_mm = to;
        else
            found.push_back({from, to});
    };
    for (const CurvePiece& piece : curve) {
        if (piece.touch == Touch::Join) {
            // A jump up and down ends a stretch even if it has zero width.
            if (std::max(piece.from.y(), piece.to.y()) >= level_mm && !found.empty() &&
                std::max(piece.from.y(), piece.to.y()) > level_mm + meet_mm &&
                std::abs(found.back().to_mm - piece.from.x()) < meet_mm)
                found.back().to_mm = std::min(found.back().to_mm, piece.from.x());
            continue;
        }
        std::vector<double> cuts{piece.from.x(), piece.to.x()};
        if (piece.isArc()) {
            const double up = level_mm - piece.centre.y(), square = piece.radius_mm * piece.radius_mm - up * up;
            if (square > 0 && (up > 0) == (piece.radius_mm > 0))
                for (const double side : {-1.0, 1.0}) {
                    const double u = piece.centre.x() + side * std::sqrt(square);
                    if (u > piece.from.x() && u < piece.to.x()) cuts.push_back(u);
                }
        } else if ((piece.from.y() < level_mm) != (piece.to.y() < level_mm)) {
            const double share = (level_mm - piece.from.y()) / (piece.to.y() - piece.from.y());
            cuts.push_back(piece.from.x() + share * (piece.to.x() - piece.from.x()));
        }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (piece.at((cuts[i] + cuts[i + 1]) / 2) < level_mm) add(cuts[i], cuts[i + 1]);
    }
    return found;
}

double lowestOf(const Curve& curve)
{
    double lowest = std::numeric_limits<double>::infinity();
    for (const CurvePiece& piece : curve) {
        lowest = std::min({lowest, piece.from.y(), piece.to.y()});
        if (piece.radius_mm < 0 && piece.centre.x() > piece.from.x() && piece.centre.x() < piece.to.x())
            lowest = std::min(lowest, piece.centre.y() + piece.radius_mm);
    }
    return lowest;
}

double highestOf(std::span<const CurvePiece> curve)
{
    double highest = -std::numeric_limits<double>::infinity();
    for (const CurvePiece& piece : curve) {
        highest = std::max({highest, piece.from.y(), piece.to.y()});
        if (piece.radius_mm > 0 && piece.centre.x() > piece.from.x() && piece.centre.x() < piece.to.x())
            highest = std::max(highest, piece.centre.y() + piece.radius_mm);
    }
    return highest;
}

}  // namespace lathelier::cam
