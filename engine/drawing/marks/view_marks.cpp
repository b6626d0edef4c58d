#include "engine/drawing/marks/view_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/drawing/marks/mark_geometry.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double overhang_mm = 3;      // of centre lines, on paper
constexpr double roundEndRatio = 1.5;  // a keyway longer than so many widths has the round ends of its cutter
constexpr double atEnd_mm = 0.5;       // a keyway that ends no further from an end of its row is open there

/// Height in the view of what lies in this direction at this distance from the axis.
double heightOf(double turn_deg, double radius_mm)
{
    return -radius_mm * std::sin(turn_deg * rad_per_deg);
}

bool isSeen(double turn_deg)
{
    return std::cos(turn_deg * rad_per_deg) > 1e-3;
}

class MarkView {
public:
    MarkView(Drawing& view, const Shaft& shaft, double factor, bool bored)
        : view_(view),
          shaft_(shaft),
          rows_(outerRows(shaft)),
          factor_(factor),
          bored_(bored),
          viewed_deg_(viewedAngle_deg(shaft))
    {
        for (const ShaftMark& mark : shaft.marks) {
            if (!mark.z_start_mm || !mark.z_end_mm) continue;
            if (mark.kind == MarkKind::Keyway) addKeyway(mark);
            if (mark.kind == MarkKind::Flat) addFlat(mark);
            if (mark.kind == MarkKind::CrossHole) addHole(mark);
            if (mark.kind == MarkKind::BoltCircle) addBoltCircle(mark);
            if (mark.kind == MarkKind::Spline) addSpline(mark);
        }
        for (const ShapedStretch& stretch : shapedStretches(shaft)) addStretch(stretch);
    }

private:
    double turn(const ShaftMark& mark) const { return turnOf_deg(mark, viewed_deg_); }
    double radiusAt(const ShaftMark& mark) const { return outerRadius(rows_, (*mark.z_start_mm + *mark.z_end_mm) / 2); }

    /// Of a half section only the lower half is left, and no hidden edges.
    void line(Vector2d from, Vector2d to, double width_mm = thick_mm)
    {
        if (hidden_ && bored_) return;
        if (bored_ && from.y() > 0 && to.y() > 0) return;
        for (Vector2d* const end : {&from, &to}) {
            const Vector2d& other = end == &from ? to : from;
            if (!bored_ || end->y() <= 0) continue;
            *end += (other - *end) * (end->y() / (end->y() - other.y()));
        }
        if ((to - from).norm() * factor_ < 1e-3) return;
        if (hidden_)
            view_.lines.push_back({factor_ * from, factor_ * to, Layer::Contour, thin_mm, LineType::Dashed});
        else
            view_.lines.push_back(
                {factor_ * from, factor_ * to, width_mm == thick_mm ? Layer::Contour : Layer::Dimensions, width_mm});
    }

    void axis(const Vector2d& from, const Vector2d& to)
    {
        const Vector2d along = (to - from).normalized();
        view_.lines.push_back({factor_ * from - overhang_mm * along, factor_ * to + overhang_mm * along, Layer::Axis,
                               thin_mm, LineType::DashDot});
    }

    /// Open where it ends with its row, else with the round ends of its cutter.
    void addKeyway(const ShaftMark& mark)
    {
        if (!mark.width_mm) return;
        const double radius = radiusAt(mark), half = *mark.width_mm / 2, middle = heightOf(turn(mark), radius);
        if (!(half > 0) || half >= radius) return;
        const double slot_deg = std::asin(half / radius) / rad_per_deg, from = *mark.z_start_mm, to = *mark.z_end_mm;
        double low = heightOf(turn(mark) + slot_deg, radius), high = heightOf(turn(mark) - slot_deg, radius);
        hidden_ = !isSeen(turn(mark) + slot_deg) && !isSeen(turn(mark) - slot_deg);
        if (std::abs(std::remainder(turn(mark), 180)) < 1) low = middle - half, high = middle + half;
        const double depth = std::abs(high - low) / 2;  // of a round end, along the axis half the width
        const bool round = to - from > roundEndRatio * *mark.width_mm && depth > 0;
        const double begin = round && !isOpen(from) ? from + half : from, end = round && !isOpen(to) ? to - half : to;
        for (const double y : {low, high}) line({begin, y}, {end, y});
        addKeywayEnd(begin, begin > from ? -half : 0, (low + high) / 2, depth);
        addKeywayEnd(end, end < to ? half : 0, (low + high) / 2, depth);
        hidden_ = false;
    }

    /// Does a shoulder or an end of the part lie there?
    bool isOpen(double z_mm) const
    {
        return std::any_of(rows_.begin(), rows_.end(), [&](const ContourRow& row) {
            return std::abs(row.start_z_mm - z_mm) < atEnd_mm || std::abs(row.end_z_mm - z_mm) < atEnd_mm;
        });
    }

    /// Half an ellipse that bulges by `reach`, or a straight end.
    void addKeywayEnd(double z, double reach, double middle, double half)
    {
        constexpr int steps = 24;
        Vector2d before(z, middle - half);
        for (int i = 1; i <= steps; ++i) {
            const double angle = std::numbers::pi * i / steps;
            const Vector2d now(z + reach * std::sin(angle), middle - half * std::cos(angle));
            line(before, now);
            before = now;
        }
    }

    void addFlat(const ShaftMark& mark)
    {
        const double radius = radiusAt(mark);
        if (!mark.distance_mm || std::abs(*mark.distance_mm) >= radius) return;
        const double half_deg = std::acos(*mark.distance_mm / radius) / rad_per_deg;
        const double a = turn(mark) - half_deg, b = turn(mark) + half_deg;
        const double from = *mark.z_start_mm, to = *mark.z_end_mm;
        const double high = heightOf(a, radius), low = heightOf(b, radius);
        hidden_ = !isSeen(turn(mark));
        for (const double y : {low, high}) line({from, y}, {to, y});
        for (const double z : {from, to}) line({z, low}, {z, high});
        hidden_ = false;
        if (std::abs(turn(mark)) < 60) diagonals(from, to, low, high);
    }

    /// Thin crossed diagonals: a flat face of a turned part.
    void diagonals(double from, double to, double low, double high)
    {
        if (bored_) high = std::min(high, 0.0);
        if (high - low < same_mm) return;
        line({from, low}, {to, high}, thin_mm);
        line({from, high}, {to, low}, thin_mm);
    }

    void addHole(const ShaftMark& mark)
    {
        if (!mark.diameter_mm || !(*mark.diameter_mm > 0)) return;
        const double z = (*mark.z_start_mm + *mark.z_end_mm) / 2, radius = outerRadius(rows_, z);
        const bool through = mark.through.value_or(0) > 0;
        for (const double turned : {turn(mark), turn(mark) + 180}) {
            if (turned != turn(mark) && !through) break;
            const double cosine = std::cos(turned * rad_per_deg), y = heightOf(turned, radius);
            hidden_ = cosine < -1e-3;
            if (hidden_ && through) continue;  // its other end is seen
            axis({z, y + *mark.diameter_mm / 2 * cosine}, {z, y - *mark.diameter_mm / 2 * cosine - 1e-3});
            if (std::abs(cosine) > 0.05) ellipse({z, y}, *mark.diameter_mm / 2, *mark.diameter_mm / 2 * cosine);
            hidden_ = false;
        }
    }

    void ellipse(const Vector2d& centre, double along, double across)
    {
        if (!bored_ && !hidden_ && std::abs(along - across) < 1e-3 * along) {
            view_.arcs.push_back({factor_ * centre, factor_ * along, 0, 360, Layer::Contour, thick_mm});
            return;
        }
        constexpr int steps = 72;
        Vector2d before = centre + Vector2d(along, 0);
        for (int i = 1; i <= steps; ++i) {
            const double angle = 2 * std::numbers::pi * i / steps;
            const Vector2d now = centre + Vector2d(along * std::cos(angle), across * std::sin(angle));
            line(before, now);
            before = now;
        }
    }

    void addBoltCircle(const ShaftMark& mark)
    {
        if (!mark.pitch_circle_mm) return;
        for (const double sign : {1.0, -1.0}) {
            const double y = sign * *mark.pitch_circle_mm / 2;
            axis({*mark.z_start_mm, y}, {*mark.z_end_mm, y});
        }
    }

    /// Root thin, crest thick (ISO 6413); the row may be drawn at either.
    void addSpline(const ShaftMark& mark)
    {
        if (!mark.major_mm || !mark.minor_mm) return;
        const double from = *mark.z_start_mm, to = *mark.z_end_mm, crest = *mark.major_mm / 2;
        const bool at_root = radiusAt(mark) < crest - 0.05;
        for (const double sign : {1.0, -1.0}) {
            line({from, sign * *mark.minor_mm / 2}, {to, sign * *mark.minor_mm / 2}, thin_mm);
            if (!at_root && !isOpen(to)) line({to, 0}, {to, sign * crest}, thin_mm);
            if (!at_root && !isOpen(from)) line({from, 0}, {from, sign * crest}, thin_mm);
            if (!at_root) continue;
            line({from, sign * crest}, {to, sign * crest});
            for (const double z : {from, to}) line({z, 0}, {z, sign * crest});
        }
    }

    void addStretch(const ShapedStretch& stretch)
    {
        const double from = stretch.from_z_mm, to = stretch.to_z_mm;
        for (const double y : {stretch.low_mm, stretch.high_mm}) line({from, y}, {to, y});
        for (const double z : {from, to}) {
            // In the midst of a row the round body stands beyond the stretch.
            const double beside = isOpen(z) ? 0 : outerRadius(rows_, z);
            line({z, std::min(stretch.low_mm, -beside)}, {z, std::max(stretch.high_mm, beside)});
        }
        for (const double y : stretch.edges_mm) line({from, y}, {to, y});
        for (const auto& [low, high] : stretch.faces_mm) diagonals(from, to, low, high);
        if (stretch.axis_mm) axis({from, *stretch.axis_mm}, {to, *stretch.axis_mm});
    }

    Drawing& view_;
    const Shaft& shaft_;
    std::vector<ContourRow> rows_;
    double factor_;
    bool bored_;
    double viewed_deg_;
    bool hidden_ = false;  // what is drawn lies behind the part
};

/// The faces of a prism between its corners; those that are seen, and its silhouette.
ShapedStretch prismOf(const ShaftMark& mark, int faces, double turn_deg)
{
    ShapedStretch stretch{*mark.z_start_mm, *mark.z_end_mm, 0, 0};
    const double half_deg = 180.0 / faces, corner_mm = *mark.across_flats_mm / 2 / std::cos(half_deg * rad_per_deg);
    for (int i = 0; i < faces; ++i) {
        const double middle = turn_deg + 2 * half_deg * i;
        const double high = heightOf(middle - half_deg, corner_mm), low = heightOf(middle + half_deg, corner_mm);
        stretch.low_mm = std::min({stretch.low_mm, low, high});
        stretch.high_mm = std::max({stretch.high_mm, low, high});
        if (isSeen(middle - half_deg)) stretch.edges_mm.push_back(high);
        if (std::cos(middle * rad_per_deg) > 0.8) stretch.faces_mm.emplace_back(low, high);
    }
    return stretch;
}

}  // namespace

std::vector<ShapedStretch> shapedStretches(const Shaft& shaft)
{
    std::vector<ShapedStretch> stretches;
    const std::vector<ContourRow> rows = outerRows(shaft);
    const double viewed_deg = viewedAngle_deg(shaft);
    for (const ShaftMark& mark : shaft.marks) {
        if (!mark.z_start_mm || !mark.z_end_mm) continue;
        const double turn = turnOf_deg(mark, viewed_deg);
        const bool prism = mark.kind == MarkKind::Hexagon || mark.kind == MarkKind::Square;
        if (prism && mark.across_flats_mm && *mark.across_flats_mm > 0)
            stretches.push_back(prismOf(mark, mark.kind == MarkKind::Hexagon ? 6 : 4, turn));
        if (mark.kind != MarkKind::Eccentric || !mark.offset_mm) continue;
        const double radius =
            mark.diameter_mm ? *mark.diameter_mm / 2 : outerRadius(rows, (*mark.z_start_mm + *mark.z_end_mm) / 2);
        const double y = heightOf(turn, *mark.offset_mm);
        stretches.push_back({*mark.z_start_mm, *mark.z_end_mm, y - radius, y + radius, {}, {}, y});
    }
    return stretches;
}

void addMarkLines(Drawing& view, const Shaft& shaft, double factor, bool bored)
{
    MarkView(view, shaft, factor, bored);
}

std::vector<Box> markBoxes(const Shaft& shaft, double factor)
{
    std::vector<Box> boxes;
    const std::vector<ContourRow> rows = outerRows(shaft);
    const double viewed_deg = viewedAngle_deg(shaft);
    const auto add = [&](double from, double to, double middle, double half) {
        boxes.push_back({factor * from, factor * (middle - half), factor * to, factor * (middle + half)});
    };
    for (const ShaftMark& mark : shaft.marks) {
        if (!mark.z_start_mm || !mark.z_end_mm) continue;
        const double z = (*mark.z_start_mm + *mark.z_end_mm) / 2, radius = outerRadius(rows, z);
        const double turn = turnOf_deg(mark, viewed_deg);
        if (mark.kind == MarkKind::Keyway && mark.width_mm)
            add(*mark.z_start_mm, *mark.z_end_mm, heightOf(turn, radius), *mark.width_mm / 2);
        if (mark.kind == MarkKind::Flat && mark.distance_mm)
            add(*mark.z_start_mm, *mark.z_end_mm, heightOf(turn, radius),
                std::sqrt(std::max(0.0, radius * radius - *mark.distance_mm * *mark.distance_mm)));
        if (mark.kind == MarkKind::CrossHole && mark.diameter_mm)
            add(z - *mark.diameter_mm / 2, z + *mark.diameter_mm / 2, heightOf(turn, radius), *mark.diameter_mm / 2);
    }
    return boxes;
}

}  // namespace lathelier::drawing
