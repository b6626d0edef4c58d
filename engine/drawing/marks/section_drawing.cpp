#include "engine/drawing/marks/section_drawing.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/core/units.h"
#include "engine/drawing/dimension_lines.h"
#include "engine/drawing/marks/section_outline.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double smallestSection_mm = 24, largestSection_mm = 75;  // diameters on paper
constexpr double firstOffset_mm = 5, offsetStep_mm = 2.5;          // of dimension lines from the outline
constexpr int mostSteps = 40;
constexpr double sectionOverhang_mm = 3;

Vector2d turned(const Vector2d& point, const Vector2d& along)
{
    return point.x() * along + point.y() * Vector2d(-along.y(), along.x());
}

/// The drawing turned about 0 so that what pointed right points along the direction of this angle; texts stay readable
/// from below or from the right.
Drawing turned(Drawing drawing, double angle_deg)
{
    const Vector2d along = directionOf(angle_deg);
    for (Line& line : drawing.lines) {
        line.from_mm = turned(line.from_mm, along);
        line.to_mm = turned(line.to_mm, along);
    }
    for (Arc& arc : drawing.arcs) {
        arc.centre_mm = turned(arc.centre_mm, along);
        arc.start_deg -= angle_deg;
        arc.end_deg -= angle_deg;
    }
    for (Arrow& arrow : drawing.arrows) {
        arrow.tip_mm = turned(arrow.tip_mm, along);
        arrow.direction = turned(arrow.direction, along);
    }
    for (Label& label : drawing.labels) {
        label.at_mm = turned(label.at_mm, along);
        label.angle_deg = std::remainder(label.angle_deg - angle_deg, 360);
        // What a measured angle makes nearly upright reads from the right, as what is upright.
        constexpr double upright_deg = 5;
        if (label.angle_deg > -90 + upright_deg && label.angle_deg < 90 + upright_deg) continue;
        // Upside down: turned about the middle of its capitals.
        const double angle = label.angle_deg * rad_per_deg;
        label.at_mm += label.height_mm * Vector2d(-std::sin(angle), std::cos(angle));
        label.angle_deg = std::remainder(label.angle_deg + 180, 360);
        if (label.anchor != Anchor::Middle) label.anchor = label.anchor == Anchor::Start ? Anchor::End : Anchor::Start;
    }
    return drawing;
}

/// Chords of an arc, fine enough to see what it crosses.
std::vector<Line> chordsOf(const Arc& arc)
{
    constexpr int steps = 48;
    const auto on = [&](int i) -> Vector2d {
        const double angle = (arc.start_deg + (arc.end_deg - arc.start_deg) * i / steps) * rad_per_deg;
        return arc.centre_mm + arc.radius_mm * Vector2d(std::cos(angle), std::sin(angle));
    };
    std::vector<Line> chords;
    chords.reserve(steps);
    for (int i = 0; i < steps; ++i) chords.push_back({on(i), on(i + 1)});
    return chords;
}

bool meets(const std::vector<Label>& labels, const Drawing& other)
{
    std::vector<Line> lines = other.lines;
    for (const Arc& arc : other.arcs)
        for (const Line& chord : chordsOf(arc)) lines.push_back(chord);
    return std::any_of(labels.begin(), labels.end(), [&](const Label& label) {
        const Box box = boxOf(label).grown(0.3);
        return std::any_of(other.labels.begin(), other.labels.end(),
                           [&](const Label& one) { return boxOf(one).overlaps(box); }) ||
               std::any_of(lines.begin(), lines.end(), [&](const Line& line) { return passes(line, box); });
    });
}

class SectionPainter {
public:
    SectionPainter(const CrossSection& section, double factor, double height_mm)
        : section_(section), factor_(factor), height_mm_(height_mm), radius_(factor * section.diameter_mm / 2)
    {
        drawing_ = sectionOutline(section, factor);
        if (section.eccentric) outer_ = factor * section.eccentric->offset_mm;
        outer_ += radius_;
        for (const HoleCircle& circle : section.circles)
            outer_ = std::max(outer_, factor * (circle.pitch_circle_mm + circle.diameter_mm) / 2);
        addAxes();
        addAngles();
        for (const Slot& slot : section.slots) {
            addAcross(slot.angle_deg, slot.width_mm, slot.width);
            addAlong(slot.angle_deg, -radius_, factor * slot.floor_mm, slot.width_mm, slot.across);
        }
        for (const FlatCut& flat : section.flats) addFlat(flat);
        for (const RadialHole& hole : section.holes) addAcross(hole.angle_deg, hole.diameter_mm, hole.size);
        if (section.teeth && section.teeth->width_mm)
            addAcross(section.teeth->angle_deg, *section.teeth->width_mm, section.teeth->width);
        if (section.eccentric) {
            addAlong(section.eccentric->angle_deg, 0, factor * section.eccentric->offset_mm, 0,
                     section.eccentric->offset);
        }
    }

    Drawing take(const std::string& title)
    {
        double y = boxOf(drawing_).top_mm + 0.8 * height_mm_;
        for (auto caption = section_.captions.rbegin(); caption != section_.captions.rend(); ++caption) {
            drawing_.labels.push_back(
                {{0, y}, height_mm_, 0, caption->text, Anchor::Middle, caption->italic, Layer::Dimensions});
            y += 1.8 * height_mm_;
        }
        drawing_.labels.push_back({{0, y + 0.3 * height_mm_}, 1.4 * height_mm_, 0, title, Anchor::Middle});
        return std::move(drawing_);
    }

private:
    using Group = std::function<Drawing(double offset_mm)>;

    /// The dimension at the smallest offset at which no text meets another one or a line, nor what is `reserved`.
    void add(const Group& group, double angle_deg, const Drawing& reserved = {})
    {
        const auto at = [&](int step) { return turned(group(firstOffset_mm + offsetStep_mm * step), angle_deg); };
        for (int step = 0; step < mostSteps; ++step) {
            Drawing made = at(step);
            if (meets(made.labels, drawing_) || meets(drawing_.labels, made) || meets(made.labels, reserved)) continue;
            append(drawing_, made);
            return;
        }
        append(drawing_, at(0));
    }

    /// Where the extension lines of widths will run.
    Drawing widths() const
    {
        Drawing lines;
        const auto addLines = [&](double angle_deg, double width_mm) {
            const Vector2d along = directionOf(angle_deg), across = directionOf(angle_deg + 90);
            for (const double share : {-0.5, 0.0, 0.5}) {
                const Vector2d side = share * factor_ * width_mm * across;
                lines.lines.push_back({side, side + 3 * (outer_ + largestSection_mm) * along});
            }
        };
        for (const Slot& slot : section_.slots) addLines(slot.angle_deg, slot.width_mm);
        for (const RadialHole& hole : section_.holes) addLines(hole.angle_deg, hole.diameter_mm);
        if (section_.teeth) addLines(section_.teeth->angle_deg, section_.teeth->width_mm.value_or(0));
        return lines;
    }

    void addAxes()
    {
        const double reach = outer_ + sectionOverhang_mm;
        const auto cross = [&](const Vector2d& centre, double length) {
            for (const Vector2d& axis : {Vector2d(length, 0), Vector2d(0, length)})
                drawing_.lines.push_back({centre - axis, centre + axis, Layer::Axis, thin_mm, LineType::DashDot});
        };
        cross(Vector2d::Zero(), reach);
        if (!section_.eccentric) return;
        const Vector2d along = directionOf(section_.eccentric->angle_deg);
        cross(factor_ * section_.eccentric->offset_mm * along, radius_ + sectionOverhang_mm);
    }

    /// A width across the direction, beyond the outline.
    void addAcross(double angle_deg, double width_mm, const DimensionText& label)
    {
        if (label.text.empty()) return;
        const double half = factor_ * width_mm / 2, side = std::sqrt(std::max(0.0, radius_ * radius_ - half * half));
        add(
            [&](double offset) {
                Drawing group;
                DimensionPainter paint(group, height_mm_);
                const double x = outer_ + offset + paint.band_mm();
                for (const double y : {-half, half}) paint.line({side + 1, y}, {x + 1, y});
                paint.vertical(x, -half, half, label);
                return group;
            },
            angle_deg);
    }

    /// A distance along the direction, beside the outline; `width_mm`: of what it ends at.
    void addAlong(double angle_deg, double from, double to, double width_mm, const DimensionText& label)
    {
        if (label.text.empty()) return;
        add(
            [&](double offset) {
                Drawing group;
                DimensionPainter paint(group, height_mm_);
                paint.horizontal(from, to, -outer_ - offset, 0, -factor_ * width_mm / 2, label);
                return group;
            },
            angle_deg);
    }

    /// Of a flat from the opposite side, of a prism between two faces.
    void addFlat(const FlatCut& flat)
    {
        if (flat.across.text.empty()) return;
        const bool has_opposite = std::any_of(section_.flats.begin(), section_.flats.end(), [&](const FlatCut& other) {
            return std::abs(std::abs(std::remainder(other.angle_deg - flat.angle_deg, 360)) - 180) < 1e-3;
        });
        const double distance = factor_ * flat.distance_mm;
        const double half = std::sqrt(std::max(0.0, radius_ * radius_ - distance * distance)) / factor_;
        const double from = flat.opposite_mm ? -factor_ * *flat.opposite_mm : has_opposite ? -distance : -radius_;
        addAlong(flat.angle_deg, from, distance, half, flat.across);
    }

    /// Nearest to the outline.
    void addAngles()
    {
        for (const Slot& slot : section_.slots) addAngle(slot.angle_deg, slot.angle);
        for (const FlatCut& flat : section_.flats) addAngle(flat.angle_deg, flat.angle);
        for (const RadialHole& hole : section_.holes) addAngle(hole.angle_deg, hole.angle);
        for (const HoleCircle& circle : section_.circles) addAngle(circle.angle_deg, circle.angle);
        if (section_.eccentric) addAngle(section_.eccentric->angle_deg, section_.eccentric->angle);
    }

    /// An arc from the direction of the viewer to this one.
    void addAngle(double angle_deg, const DimensionText& label)
    {
        if (label.text.empty()) return;
        add(
            [&](double offset) {
                Drawing group;
                const double radius = outer_ + offset;
                DimensionPainter paint(group, height_mm_);
                for (const double end : {0.0, angle_deg})
                    paint.line((outer_ + 1) * directionOf(end), (radius + 1) * directionOf(end));
                group.arcs.push_back({Vector2d::Zero(), radius, std::min(0.0, -angle_deg), std::max(0.0, -angle_deg),
                                      Layer::Dimensions, thin_mm});
                const double sense = angle_deg > 0 ? 1 : -1;
                paint.arrow(radius * directionOf(0), -sense * directionOf(90));
                paint.arrow(radius * directionOf(angle_deg), sense * directionOf(angle_deg + 90));
                const Vector2d outward = directionOf(angle_deg / 2);
                const double beyond = radius + 0.8 + paint.widthOf(label) / 2 * std::abs(outward.x()) +
                                      height_mm_ * std::abs(outward.y());
                paint.text(beyond * outward - Vector2d(0, height_mm_ / 2), label, Anchor::Middle);
                return group;
            },
            0, widths());
    }

    const CrossSection& section_;
    double factor_, height_mm_, radius_, outer_ = 0;
    Drawing drawing_;
};

}  // namespace

Scale sectionScale(const CrossSection& section, const Scale& main)
{
    const double size_mm = section.diameter_mm * main.factor();
    if (size_mm >= smallestSection_mm && size_mm <= largestSection_mm) return main;
    Scale best = main;
    for (const Scale& scale : scales()) {
        const double size = section.diameter_mm * scale.factor();
        if (size_mm > largestSection_mm && size <= largestSection_mm) return scale;
        if (size_mm < smallestSection_mm && size >= smallestSection_mm) best = scale;
    }
    return best;
}

Drawing sectionDrawing(const CrossSection& section, const std::string& title, double factor, double height_mm)
{
    return SectionPainter(section, factor, height_mm).take(title);
}

}  // namespace lathelier::drawing
