// Shifts, rotation, scale and mirror image between the coordinates that a program states and those of the work: X is a
// radius in both.
//   work = shift + A · stated + translation
#pragma once

#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/move.h"

namespace lathelier::gcode {

/// stated ↦ (xx·x + xz·z + x_mm, zx·x + zz·z + z_mm).
struct Frame {
    double xx = 1, xz = 0, zx = 0, zz = 1;
    double x_mm = 0, z_mm = 0;

    /// Is it a translation alone?
    bool isStraight() const { return xx == 1 && xz == 0 && zx == 0 && zz == 1; }
    bool isMirrored() const { return xx * zz - xz * zx < 0; }
    /// Lengths of all directions change by one factor: arcs stay arcs.
    bool keepsArcs() const
    {
        constexpr double same = 1e-12;
        return std::abs(std::hypot(xx, zx) - std::hypot(xz, zz)) < same && std::abs(xx * xz + zx * zz) < same;
    }
    double scale() const { return std::hypot(xx, zx); }

    /// Where it is straight, coordinates that are not known do not spread to the other axis.
    Point turned(const Point& by) const
    {
        if (isStraight()) return by;
        return {xx * by.x_mm + xz * by.z_mm, zx * by.x_mm + zz * by.z_mm};
    }
    Point applied(const Point& stated) const
    {
        const Point by = turned(stated);
        return {by.x_mm + x_mm, by.z_mm + z_mm};
    }
    Point inverse(const Point& work) const
    {
        const double x = work.x_mm - x_mm, z = work.z_mm - z_mm;
        if (isStraight()) return {x, z};
        const double determinant = xx * zz - xz * zx;
        return {(zz * x - xz * z) / determinant, (xx * z - zx * x) / determinant};
    }

    /// This one with `inner` within its coordinates.
    Frame with(const Frame& inner) const
    {
        const Point at = applied({inner.x_mm, inner.z_mm});
        return {xx * inner.xx + xz * inner.zx,
                xx * inner.xz + xz * inner.zz,
                zx * inner.xx + zz * inner.zx,
                zx * inner.xz + zz * inner.zz,
                at.x_mm,
                at.z_mm};
    }

    static Frame translation(double x_mm, double z_mm) { return {1, 0, 0, 1, x_mm, z_mm}; }
    /// From Z toward X.
    static Frame rotation(double angle_deg)
    {
        const double c = std::cos(angle_deg * rad_per_deg), s = std::sin(angle_deg * rad_per_deg);
        return {c, s, -s, c, 0, 0};
    }
    static Frame scaled(double x, double z) { return {x, 0, 0, z, 0, 0}; }
};

}  // namespace lathelier::gcode
