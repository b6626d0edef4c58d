#include "engine/features/nominal/nominal_chain.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/features/nominal/nominal_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Vector2d;

/// Unit tangents of an arc at its ends, in the direction of travel.
std::pair<Vector2d, Vector2d> tangents(const ContourPiece& arc)
{
    const auto at = [&](const Vector2d& point) {
        const Vector2d out = (point - arc.centre_mm()).normalized();
        return arc.arc_radius_mm > 0 ? Vector2d(out.y(), -out.x()) : Vector2d(-out.y(), out.x());
    };
    return {at(arc.from_mm), at(arc.to_mm)};
}

/// A straight neighbour of an arc in (u, r).
struct Line {
    Vector2d point, direction;
    double radiusAt_mm(double u_mm) const { return point.y() + (u_mm - point.x()) * direction.y() / direction.x(); }
};

/// Works on the boundaries between rows; those of row i are i and i + 1.
class RowPlacing {
public:
    RowPlacing(const RowChain& chain, const std::vector<bool>& in_place, std::optional<double> end_mm)
        : chain_(chain), inPlace_(in_place), at_(chain.size() + 1), arc_(chain.size()), line_(chain.size())
    {
        const std::size_t n = chain.size();
        for (std::size_t i = 0; i < n; ++i) {
            at_[i].right = {chain.start_mm(i), chain.row(i).start_diameter_mm / 2};
            at_[i + 1].left = {chain.end_mm(i), chain.row(i).end_diameter_mm / 2};
            arc_[i] = chain.row(i).arc_radius_mm.value_or(0);
        }
        at_[0].left = at_[0].right;
        at_[n].right = at_[n].left;
        if (!end_mm && std::none_of(in_place.begin(), in_place.end(), [](bool one) { return one; })) return;
        placePlanes(end_mm);
        placeCylinders();
        for (std::size_t i = 0; i < n; ++i)
            if (kind(i) == RowKind::Cone && chain.length_mm(i) > 0 && chain.row(i).role != "chamfer" && !standard(i))
                placeCone(i);
        for (std::size_t i = 0; i < n; ++i)
            if (chain.row(i).role == "chamfer") placeChamfer(i);
        for (std::size_t i = 0; i < n; ++i)
            if (kind(i) == RowKind::Arc && !standard(i)) placeArc(i);
        for (std::size_t i = 0; i < n; ++i)
            if (const auto undercut = standard(i); undercut && undercut->arc == i) placeUndercut(*undercut);
    }

    std::vector<PlacedRow> rows() const;

private:
    struct Boundary {
        Vector2d left, right;  // end of the row before, start of the row after
    };

    RowKind kind(std::size_t i) const { return chain_.row(i).kind; }
    bool isJoined(std::size_t boundary) const { return chain_.joint(boundary) == Joint::Joined; }

    const Suggestion* suggestion(std::size_t i, std::string_view quantity) const
    {
        if (!inPlace_[i]) return nullptr;
        for (const Suggestion& one : chain_.row(i).suggestions)
            if (one.quantity == quantity) return &one;
        return nullptr;
    }

    /// With its limits, where the nominal diameter of a cylinder is in place and has one.
    std::optional<SizeTolerance> toleranceOf(std::size_t i) const
    {
        const Suggestion* const diameter = kind(i) == RowKind::Cylinder ? suggestion(i, "diameter_mm") : nullptr;
        if (!diameter) return {};
        const auto limits = limitsOf(diameter->tolerance, diameter->nominal_mm);
        if (!limits) return {};
        return SizeTolerance{diameter->tolerance, limits->lower_um, limits->upper_um};
    }

    /// The undercut of the standard that row i is part of and that can be put in place; none: it stays as measured.
    std::optional<UndercutRows> standard(std::size_t i) const;
    /// Moves a row's end together with the neighbour that meets it: in one point, or in the u of a plane.
    void putStart(std::size_t i, const Vector2d& point)
    {
        at_[i].right = point;
        if (isJoined(i)) at_[i].left = point;
        if (chain_.joint(i) == Joint::Plane) at_[i].left.x() = point.x();
    }
    void putEnd(std::size_t i, const Vector2d& point)
    {
        at_[i + 1].left = point;
        if (isJoined(i + 1)) at_[i + 1].right = point;
        if (chain_.joint(i + 1) == Joint::Plane) at_[i + 1].right.x() = point.x();
    }
    std::optional<Line> neighbour(std::size_t i, bool before) const;
    void placePlanes(std::optional<double> end_mm);
    void placeCylinders();
    void placeCone(std::size_t i);
    void placeChamfer(std::size_t i);
    void placeArc(std::size_t i);
    void placeUndercut(const UndercutRows& undercut);

    const RowChain& chain_;
    const std::vector<bool>& inPlace_;
    std::vector<Boundary> at_;
    std::vector<double> arc_;                              // radius of each arc, signed
    std::vector<std::optional<Line>> line_;                // of cylinders, cones and chamfers that are in place
    std::vector<std::pair<std::size_t, Vector2d>> faces_;  // after which row, where the relieved face ends
};

std::optional<UndercutRows> RowPlacing::standard(std::size_t i) const
{
    if (chain_.row(i).role != "undercut") return {};
    for (std::size_t first = i >= 3 ? i - 3 : 0; first <= i; ++first) {
        const auto rows = undercutRowsAt(chain_, first);
        if (!rows || rows->last < i) continue;
        const Suggestion* named = suggestion(rows->arc, "undercut");
        const auto found = named ? undercutOf(named->designation) : std::nullopt;
        if (!found) return {};
        if (found->second == UndercutForm::E) return rows;
        const double face = 2 * (faceExtent_mm(found->first) - found->first.depth_mm);
        const double shaft = rows->before_face ? chain_.startHeight_mm(rows->first) : chain_.endHeight_mm(rows->last);
        if (!rows->before_face || shaft + face >= chain_.startHeight_mm(rows->last + 1)) return {};
        return rows;
    }
    return {};
}

void RowPlacing::placePlanes(std::optional<double> end_mm)
{
    const std::size_t n = chain_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Joint joint = chain_.joint(i + 1);
        double u = chain_.closing_mm(i);
        if (const Suggestion* z = suggestion(i, "z_mm")) u = z->nominal_mm;
        if (i + 1 == n && end_mm) u = *end_mm;
        const double shift = u - chain_.closing_mm(i);
        at_[i + 1].left.x() += shift;
        if (joint != Joint::Gap) at_[i + 1].right.x() += shift;
    }
    // The second wall of a groove follows from its width.
    for (std::size_t i = 0; i < n; ++i) {
        const Suggestion* width = suggestion(i, "length_mm");
        if (!width) continue;
        std::size_t first = i, last = i;
        while (isJoined(first)) --first;
        while (isJoined(last + 1)) ++last;
        if (chain_.joint(first) != Joint::Plane || chain_.joint(last + 1) != Joint::Plane) continue;
        at_[last + 1].left.x() = at_[last + 1].right.x() = at_[first].left.x() + width->nominal_mm;
    }
}

void RowPlacing::placeCylinders()
{
    for (std::size_t i = 0; i < chain_.size(); ++i) {
        if (kind(i) != RowKind::Cylinder) continue;
        if (const Suggestion* diameter = suggestion(i, "diameter_mm"))
            at_[i].right.y() = at_[i + 1].left.y() = diameter->nominal_mm / 2;
        putStart(i, at_[i].right);
        putEnd(i, at_[i + 1].left);
        line_[i] = Line{at_[i].right, Vector2d::UnitX()};
    }
}

void RowPlacing::placeCone(std::size_t i)
{
    const RecognizedRow& row = chain_.row(i);
    const bool starts_at_cylinder = isJoined(i) && kind(i - 1) == RowKind::Cylinder;
    const bool ends_at_cylinder = isJoined(i + 1) && kind(i + 1) == RowKind::Cylinder;
    const double growth = row.end_diameter_mm > row.start_diameter_mm ? 1 : -1;
    double slope = (row.end_diameter_mm - row.start_diameter_mm) / 2 / chain_.length_mm(i);
    if (const Suggestion* taper = suggestion(i, "taper")) slope = growth * taper->nominal_mm / 2;
    const Suggestion* large = suggestion(i, "diameter_mm");
    Vector2d start = at_[i].right, end = at_[i + 1].left;
    if (large) (growth > 0 ? end : start).y() = large->nominal_mm / 2;
    const bool start_known = starts_at_cylinder || (large && growth < 0);
    const bool end_known = ends_at_cylinder || (large && growth > 0);
    if (start_known && end_known && suggestion(i, "taper") && slope != 0) {
        // Its length follows; the end that a plane or the end of the part fixes stays.
        const double length = (end.y() - start.y()) / slope;
        if (isJoined(i + 1))
            end.x() = start.x() + length;
        else
            start.x() = end.x() - length;
    } else if (start_known && end_known) {
        slope = (end.y() - start.y()) / (end.x() - start.x());
    } else if (start_known) {
        end.y() = start.y() + slope * (end.x() - start.x());
    } else if (end_known) {
        start.y() = end.y() - slope * (end.x() - start.x());
    } else {
        const Vector2d middle = (start + end) / 2;
        start.y() = middle.y() + slope * (start.x() - middle.x());
        end.y() = middle.y() + slope * (end.x() - middle.x());
    }
    putStart(i, start);
    putEnd(i, end);
    line_[i] = Line{start, Vector2d(1, slope).normalized()};
}

void RowPlacing::placeChamfer(std::size_t i)
{
    const RecognizedRow& row = chain_.row(i);
    const bool rises = chain_.endHeight_mm(i) > chain_.startHeight_mm(i);
    double leg = chain_.length_mm(i);
    double radial = std::abs(row.end_diameter_mm - row.start_diameter_mm) / 2;
    const Suggestion* named = suggestion(i, "leg_mm");
    const auto angle = nominalChamferAngle_deg(chain_.angle_deg(i), row.uncertainty.angle_deg.value_or(0));
    if (named && angle) {
        leg = named->nominal_mm;
        radial = leg * std::tan(*angle * rad_per_deg);
    }
    // Its lower edge lies in a plane; the upper one on the row that it joins.
    Vector2d lower = rises ? at_[i].right : at_[i + 1].left, upper = rises ? at_[i + 1].left : at_[i].right;
    const std::size_t next = rises ? i + 1 : i - 1;
    upper.x() = lower.x() + (rises ? leg : -leg);
    if (line_[next]) upper.y() = line_[next]->radiusAt_mm(upper.x());
    lower.y() = upper.y() - chain_.sign() * radial;
    putStart(i, rises ? lower : upper);
    putEnd(i, rises ? upper : lower);
    line_[i] = Line{lower, (upper - lower).normalized() * (rises ? 1 : -1)};
}

/// The straight row or the plane that row i meets; none: an arc, or nothing.
std::optional<Line> RowPlacing::neighbour(std::size_t i, bool before) const
{
    const std::size_t boundary = before ? i : i + 1;
    const Joint joint = chain_.joint(boundary);
    const Vector2d here = before ? at_[i].right : at_[i + 1].left;
    if (joint == Joint::Plane || joint == Joint::End || joint == Joint::Relieved) return Line{here, Vector2d::UnitY()};
    if (joint == Joint::Joined) return line_[before ? i - 1 : i + 1];
    return {};
}

void RowPlacing::placeArc(std::size_t i)
{
    const ContourPiece measured = chain_.piece(i);
    double radius = std::abs(measured.arc_radius_mm);
    if (const Suggestion* named = suggestion(i, "radius_mm")) radius = named->nominal_mm;
    const double scale = radius / std::abs(measured.arc_radius_mm);
    const auto [leaving, arriving] = tangents(measured);
    const auto before = neighbour(i, true), after = neighbour(i, false);
    // For an arc that was tangent to its neighbour: the direction of the neighbour after placing.
    const auto along = [&](const std::optional<Line>& line, bool is_before,
                           const Vector2d& tangent) -> std::optional<Vector2d> {
        if (!line) return {};
        Vector2d direction = line->direction;
        if (isJoined(is_before ? i : i + 1)) {
            const ContourPiece row = chain_.piece(is_before ? i - 1 : i + 1);
            direction = (row.to_mm - row.from_mm).normalized();
        }
        const double cosine = direction.dot(tangent);
        if (std::abs(cosine) < std::cos(placingLimits.tangent_deg * rad_per_deg)) return {};
        return line->direction.dot(tangent) > 0 ? line->direction : Vector2d(-line->direction);
    };
    const auto a = along(before, true, leaving), b = along(after, false, arriving);
    Vector2d start = at_[i].right, end = at_[i + 1].left;
    const Vector2d chord = measured.to_mm - measured.from_mm;
    const double cross = a && b ? a->x() * b->y() - a->y() * b->x() : 0;
    if (a && b && std::abs(cross) > placingLimits.straight_sine) {
        const Vector2d w = after->point - before->point;
        const Vector2d corner = before->point + (w.x() * b->y() - w.y() * b->x()) / cross * *a;
        const double tangent = std::tan(std::abs(std::atan2(cross, a->dot(*b))) / 2);
        // A ball ends on the axis for any radius.
        if (std::min(measured.from_mm.y(), measured.to_mm.y()) < placingLimits.on_axis_mm)
            radius = corner.y() / tangent;
        start = corner - radius * tangent * *a;
        end = corner + radius * tangent * *b;
    } else {
        const auto isPlane = [&](std::size_t boundary) {
            const Joint joint = chain_.joint(boundary);
            return joint != Joint::Joined && joint != Joint::Gap;
        };
        const Vector2d kept = a.has_value() != b.has_value() ? Vector2d(scale * chord) : chord;
        if (isJoined(i) && isPlane(i + 1)) {  // the plane fixes u, the joined row r
            start.x() = end.x() - kept.x();
            if (before) start.y() = before->radiusAt_mm(start.x());
            end.y() = start.y() + kept.y();
        } else if (isJoined(i + 1) && isPlane(i)) {
            end.x() = start.x() + kept.x();
            if (after) end.y() = after->radiusAt_mm(end.x());
            start.y() = end.y() - kept.y();
        } else if (isJoined(i) && isJoined(i + 1)) {
            if (before) start.y() = before->radiusAt_mm(start.x());
            if (after) end.y() = after->radiusAt_mm(end.x());
        }
    }
    // No arc exists for a radius below half the chord.
    radius = std::max(radius, (end - start).norm() / 2);
    arc_[i] = measured.arc_radius_mm > 0 ? radius : -radius;
    putStart(i, start);
    putEnd(i, end);
}

void RowPlacing::placeUndercut(const UndercutRows& rows)
{
    const auto [standard, form] = *undercutOf(suggestion(rows.arc, "undercut")->designation);
    const double out = chain_.sign(), r = standard.radius_mm, t = standard.depth_mm;
    const double run_out = t / std::tan(undercutRunOut_deg * rad_per_deg);
    const double way = rows.before_face ? 1 : -1;  // from the run-out toward the face
    const std::size_t shaft_row = rows.before_face ? rows.first - 1 : rows.last + 1;
    const double face_u = rows.before_face ? at_[rows.last + 1].right.x() : at_[rows.first].left.x();
    const double shaft_r = line_[shaft_row] ? line_[shaft_row]->point.y() : chain_.row(shaft_row).end_diameter_mm / 2;
    const auto point = [&](double before_face, double above_bottom) {
        return Vector2d(face_u - way * before_face, shaft_r + out * (above_bottom - t));
    };
    const auto place = [&](std::size_t i, const Vector2d& low, const Vector2d& high) {  // low: away from the face
        putStart(i, rows.before_face ? low : high);
        putEnd(i, rows.before_face ? high : low);
    };
    const double a = undercutFace_deg * rad_per_deg;
    const bool relieved = form == UndercutForm::F;
    const double centre = relieved ? r - standard.face_depth_mm : r;  // before the face
    const Vector2d edge = point(standard.width_mm, t), floor = point(standard.width_mm - run_out, 0);
    const Vector2d foot = point(centre, 0);
    const Vector2d top = relieved ? point(centre - r * std::cos(a), r * (1 + std::sin(a))) : point(0, r);
    place(rows.run_out, edge, floor);
    place(rows.bottom, floor, foot);
    place(rows.arc, foot, top);
    arc_[rows.arc] = std::copysign(r, *chain_.row(rows.arc).arc_radius_mm);
    if (!relieved) return;
    const Vector2d end = point(0, faceExtent_mm(standard));
    if (rows.last > rows.arc)
        place(rows.last, top, end);
    else
        faces_.emplace_back(rows.arc, end);
    at_[rows.last + 1].right.x() = face_u;
}

std::vector<PlacedRow> RowPlacing::rows() const
{
    std::vector<PlacedRow> placed;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
        Vector2d start = at_[i].right, end = at_[i + 1].left;
        if (chain_.joint(i) == Joint::Gap) {
            const PlacedRow& last = placed.back();
            placed.push_back({last.end_u_mm, start.x(), last.end_mm, 2 * start.y(), {}, "gap", PlacedRow::none});
        }
        const auto face = std::find_if(faces_.begin(), faces_.end(), [&](const auto& one) { return one.first == i; });
        const ContourPiece piece{start, end, arc_[i]};
        // A row that runs behind the edge of a face is cut there.
        if (i > 0 && chain_.joint(i) == Joint::Relieved && start.x() < placed.back().end_u_mm && piece.isArc()) {
            start.x() = placed.back().end_u_mm;
            start.y() = piece.radiusAt_mm(start.x());
        }
        if (face == faces_.end() && chain_.joint(i + 1) == Joint::Relieved && piece.isArc() && chain_.isConcave(i) &&
            end.x() > at_[i + 1].right.x()) {
            end.x() = at_[i + 1].right.x();
            end.y() = piece.radiusAt_mm(end.x());
        }
        placed.push_back(
            {start.x(), end.x(), 2 * start.y(), 2 * end.y(), {}, chain_.row(i).role, static_cast<std::ptrdiff_t>(i)});
        if (piece.isArc()) placed.back().arc_radius_mm = arc_[i];
        placed.back().tolerance = toleranceOf(i);
        if (face != faces_.end())
            placed.push_back(
                {end.x(), face->second.x(), 2 * end.y(), 2 * face->second.y(), {}, "undercut", PlacedRow::none});
    }
    return placed;
}

}  // namespace

std::vector<PlacedRow> placedRows(const RowChain& chain, const std::vector<bool>& in_place,
                                  std::optional<double> end_mm)
{
    return RowPlacing(chain, in_place, end_mm).rows();
}

}  // namespace lathelier::features
