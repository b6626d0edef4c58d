#include "engine/drawing/marks/section_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/drawing/view.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr int samples = 3600;  // of the circle, to find what bounds it
constexpr double hatchSpacing_mm = 2.5;

double paperAngle_deg(double angle_deg)
{
    return -angle_deg;
}

/// What bounds the section in a direction: the circle, a flat or a keyway.
struct Bound {
    std::ptrdiff_t flat = -1, slot = -1;
    friend bool operator==(const Bound&, const Bound&) = default;
};

class Outline {
public:
    Outline(const CrossSection& section, double factor)
        : section_(section), factor_(factor), radius_(factor * section.diameter_mm / 2)
    {
        if (section.eccentric)
            centre_ = factor * section.eccentric->offset_mm * directionOf(section.eccentric->angle_deg);
        addBoundary();
        addBore();
        std::vector<Polygon> polygons{polygon_, bore_};
        for (const RadialHole& hole : section.holes) addHole(hole, polygons);
        for (const HoleCircle& circle : section.circles) addCircle(circle, polygons);
        if (section.teeth) addTeeth(*section.teeth);
        for (const Line& line : hatch(polygons, hatchSpacing_mm)) drawing_.lines.push_back(line);
    }

    Drawing take() { return std::move(drawing_); }

private:
    static double angleAt(double place) { return 360 * place / samples; }

    Bound boundAt(double angle_deg, double& reach) const
    {
        Bound bound;
        reach = radius_;
        for (std::size_t i = 0; i < section_.slots.size(); ++i) {
            const double half = std::asin(std::min(1.0, section_.slots[i].width_mm / section_.diameter_mm));
            const double off = std::remainder(angle_deg - section_.slots[i].angle_deg, 360) * rad_per_deg;
            if (std::abs(off) < half) bound = {-1, static_cast<std::ptrdiff_t>(i)};
        }
        if (bound.slot >= 0) return bound;
        for (std::size_t i = 0; i < section_.flats.size(); ++i) {
            const double cosine = std::cos((angle_deg - section_.flats[i].angle_deg) * rad_per_deg);
            const double distance = factor_ * section_.flats[i].distance_mm;
            if (cosine <= 0 || distance >= reach * cosine) continue;
            reach = distance / cosine;
            bound = {static_cast<std::ptrdiff_t>(i), -1};
        }
        return bound;
    }

    Vector2d pointAt(double angle_deg) const
    {
        double reach = 0;
        boundAt(angle_deg, reach);
        return centre_ + reach * directionOf(angle_deg);
    }

    void line(const Vector2d& from, const Vector2d& to, double width_mm = thick_mm)
    {
        if ((to - from).norm() < 1e-3) return;
        drawing_.lines.push_back({from, to, width_mm == thick_mm ? Layer::Contour : Layer::Dimensions, width_mm});
    }

    /// Around the section, clockwise: where what bounds it changes, one piece ends.
    void addBoundary()
    {
        double reach = 0;
        std::vector<double> changes;
        Bound before = boundAt(0, reach);
        for (int i = 1; i <= samples; ++i) {
            const Bound now = boundAt(angleAt(i), reach);
            if (now == before) continue;
            double low = angleAt(i - 1), high = angleAt(i);
            for (int step = 0; step < 40; ++step) {
                const double middle = (low + high) / 2;
                (boundAt(middle, reach) == before ? low : high) = middle;
            }
            changes.push_back((low + high) / 2);
            before = now;
        }
        if (changes.empty()) {
            drawing_.arcs.push_back({centre_, radius_, 0, 360, Layer::Contour, thick_mm});
            addArcPoints(0, 360);
            return;
        }
        for (std::size_t i = 0; i < changes.size(); ++i) {
            const double from = changes[i], to = i + 1 < changes.size() ? changes[i + 1] : changes.front() + 360;
            addPiece(boundAt((from + to) / 2, reach), from, to);
        }
    }

    void addPiece(const Bound& bound, double from_deg, double to_deg)
    {
        constexpr double within_deg = 1e-6;
        if (bound.slot >= 0) {
            const Slot& slot = section_.slots[static_cast<std::size_t>(bound.slot)];
            const double half = factor_ * slot.width_mm / 2, floor = factor_ * slot.floor_mm;
            const double side = std::sqrt(std::max(0.0, radius_ * radius_ - half * half));
            const Vector2d along = directionOf(slot.angle_deg), across = directionOf(slot.angle_deg + 90);
            const std::vector<Vector2d> corners{side * along - half * across, floor * along - half * across,
                                                floor * along + half * across, side * along + half * across};
            for (std::size_t i = 0; i < corners.size(); ++i) {
                polygon_.push_back(centre_ + corners[i]);
                if (i > 0) line(centre_ + corners[i - 1], centre_ + corners[i]);
            }
            return;
        }
        if (bound.flat >= 0) {
            const Vector2d from = pointAt(from_deg + within_deg), to = pointAt(to_deg - within_deg);
            line(from, to);
            polygon_.push_back(from);
            polygon_.push_back(to);
            return;
        }
        drawing_.arcs.push_back(
            {centre_, radius_, paperAngle_deg(to_deg), paperAngle_deg(from_deg), Layer::Contour, thick_mm});
        addArcPoints(from_deg, to_deg);
    }

    void addArcPoints(double from_deg, double to_deg)
    {
        const int steps = std::max(1, static_cast<int>(std::ceil((to_deg - from_deg) / 2)));
        for (int i = 0; i <= steps; ++i)
            polygon_.emplace_back(centre_ + radius_ * directionOf(from_deg + (to_deg - from_deg) * i / steps));
    }

    Polygon round(const Vector2d& centre, double radius) const
    {
        Polygon points;
        for (int i = 0; i < 180; ++i) points.emplace_back(centre + radius * directionOf(2.0 * i));
        return points;
    }

    void addBore()
    {
        const double bore = factor_ * section_.bore_diameter_mm / 2;
        if (!(bore > 0)) return;
        drawing_.arcs.push_back({Vector2d::Zero(), bore, 0, 360, Layer::Contour, thick_mm});
        bore_ = round(Vector2d::Zero(), bore);
    }

    /// Between two radii, along the direction of the hole; a hole through a bored shaft is two of them.
    void addHole(const RadialHole& hole, std::vector<Polygon>& polygons)
    {
        const double half = factor_ * hole.diameter_mm / 2, bore = factor_ * section_.bore_diameter_mm / 2;
        const auto reach = [&](double radius) { return std::sqrt(std::max(0.0, radius * radius - half * half)); };
        const auto reachAt = [&](double side) { return std::sqrt(std::max(0.0, radius_ * radius_ - side * side)); };
        const double inner = bore > half ? reach(bore) : 0;
        const double bottom = hole.depth_mm ? radius_ - factor_ * *hole.depth_mm : -radius_;
        const auto add = [&](double from, double to, bool has_bottom) {
            const Vector2d along = directionOf(hole.angle_deg), across = directionOf(hole.angle_deg + 90);
            const std::vector<Vector2d> corners{to * along - half * across, from * along - half * across,
                                                from * along + half * across, to * along + half * across};
            line(corners[0], corners[1]);
            line(corners[2], corners[3]);
            if (has_bottom) line(corners[1], corners[2]);
            // At the outline the hole ends with its arc.
            Polygon inside;
            const auto addMouth = [&](const Vector2d& outward, const Vector2d& side) {
                for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0})
                    inside.emplace_back(reachAt(share * half) * outward + share * half * side);
            };
            if (std::abs(to - reach(radius_)) < 1e-9)
                addMouth(along, -across);
            else
                inside.insert(inside.end(), {corners[3], corners[0]});
            if (std::abs(from + reach(radius_)) < 1e-9)
                addMouth(-along, across);
            else
                inside.insert(inside.end(), {corners[1], corners[2]});
            polygons.push_back(std::move(inside));
        };
        const bool through = !hole.depth_mm;
        if (inner > 0 && bottom < inner) {
            add(inner, reach(radius_), false);
            if (through) add(-reach(radius_), -inner, false);
        } else {
            add(through ? -reach(radius_) : bottom, reach(radius_), !through);
        }
    }

    void addCircle(const HoleCircle& circle, std::vector<Polygon>& polygons)
    {
        const double radius = factor_ * circle.diameter_mm / 2, pitch = factor_ * circle.pitch_circle_mm / 2;
        drawing_.arcs.push_back({Vector2d::Zero(), pitch, 0, 360, Layer::Axis, thin_mm});
        for (std::size_t i = 0; i < circle.count; ++i) {
            const double angle = circle.angle_deg + 360.0 * static_cast<double>(i) / static_cast<double>(circle.count);
            const Vector2d outward = directionOf(angle), centre = pitch * outward;
            drawing_.arcs.push_back({centre, radius, 0, 360, Layer::Contour, thick_mm});
            drawing_.lines.push_back({(pitch - radius - 1.5) * outward, (pitch + radius + 1.5) * outward, Layer::Axis,
                                      thin_mm, LineType::DashDot});
            polygons.push_back(round(centre, radius));
        }
    }

    void addTeeth(const Teeth& teeth)
    {
        const double root = factor_ * teeth.root_mm / 2;
        drawing_.arcs.push_back({Vector2d::Zero(), root, 0, 360, Layer::Dimensions, thin_mm});
        if (!teeth.width_mm) return;
        const double half = factor_ * *teeth.width_mm / 2;
        const Vector2d along = directionOf(teeth.angle_deg), across = directionOf(teeth.angle_deg + 90);
        for (const double sign : {1.0, -1.0})
            line(std::sqrt(root * root - half * half) * along + sign * half * across,
                 std::sqrt(radius_ * radius_ - half * half) * along + sign * half * across);
    }

    const CrossSection& section_;
    double factor_, radius_;
    Vector2d centre_ = Vector2d::Zero();
    Polygon polygon_, bore_;
    Drawing drawing_;
};

}  // namespace

Vector2d directionOf(double angle_deg)
{
    const double angle = paperAngle_deg(angle_deg) * rad_per_deg;
    return {std::cos(angle), std::sin(angle)};
}

Drawing sectionOutline(const CrossSection& section, double factor)
{
    return Outline(section, factor).take();
}

}  // namespace lathelier::drawing
