// A recognition as it would be of a part whose table is known: rows in z, planes and joints exact, with uncertainties.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "engine/features/recognition.h"

namespace lathelier::features {

/// A row of a table of shafts.
struct TableRow {
    double length_mm, start_mm, end_mm;
    std::optional<double> arc_mm = {};
};
using Table = std::vector<TableRow>;

inline Table operator+(Table a, const Table& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
inline Table cylinder(double d, double length)
{
    return {{length, d, d}};
}
inline Table cone(double a, double b, double length)
{
    return {{length, a, b}};
}
inline Table filletUp(double d, double R)
{
    return {{R, d, d + 2 * R, -R}};
}
inline Table filletDown(double d, double R)
{
    return {{R, d + 2 * R, d, -R}};
}
inline Table roundUp(double d, double R)
{
    return {{R, d - 2 * R, d, R}};
}
inline Table roundDown(double d, double R)
{
    return {{R, d, d - 2 * R, R}};
}
/// DIN 509 form E before a shoulder.
inline Table undercutE(double d, double r, double t, double f)
{
    const double k = t / std::tan(std::numbers::pi / 12);
    return cone(d, d - 2 * t, k) + cylinder(d - 2 * t, f - k - r) + filletUp(d - 2 * t, r);
}
/// Form F before a shoulder: the face is relieved, t2 deep under 8°, and its row runs back.
inline Table undercutF(double d, double r, double t, double f, double t2)
{
    const double k = t / std::tan(std::numbers::pi / 12), a = 8 * std::numbers::pi / 180, bottom = d - 2 * t;
    const double back = t2 - r * (1 - std::cos(a)), rise = r * (1 + std::sin(a));
    return cone(d, bottom, k) + cylinder(bottom, f - k - r + t2) +
           Table{{r * std::cos(a), bottom, bottom + 2 * rise, -r},
                 {-back, bottom + 2 * rise, bottom + 2 * rise + 2 * back / std::tan(a)}};
}

inline std::vector<RecognizedRow> rowsOf(const Table& table, double z_mm = 0)
{
    std::vector<RecognizedRow> rows;
    for (const TableRow& one : table) {
        RecognizedRow row;
        row.kind = one.arc_mm ? RowKind::Arc : one.start_mm == one.end_mm ? RowKind::Cylinder : RowKind::Cone;
        row.z_start_mm = z_mm;
        row.z_end_mm = z_mm += one.length_mm;
        row.start_diameter_mm = one.start_mm;
        row.end_diameter_mm = one.end_mm;
        row.arc_radius_mm = one.arc_mm;
        if (row.kind == RowKind::Cone)
            row.half_angle_deg = std::atan((one.end_mm - one.start_mm) / 2 / one.length_mm) * 180 / std::numbers::pi;
        row.points = 1000;
        row.uncertainty = {5.0, 5.0, 7.0, 1.0, 1.0, {}, {}};
        if (row.kind == RowKind::Arc) row.uncertainty.arc_radius_um = 12;
        if (row.kind == RowKind::Cone) row.uncertainty.angle_deg = one.length_mm > 3 ? 0.03 : 0.3;
        rows.push_back(row);
    }
    return rows;
}

inline Recognition recognitionOf(const Table& table)
{
    Recognition result;
    result.segments = rowsOf(table);
    result.length_mm = result.segments.back().z_end_mm;
    result.ends = {{0, 0.02, "edge"}, {*result.length_mm, 0.02, "edge"}};
    return result;
}

// The practice parts.
inline Table tableOne()
{
    return cylinder(30, 98) + cylinder(37, 10) + cylinder(33.8, 70) + cone(33.8, 23.8, 5);
}
inline Table undercutPart()
{
    return cone(18, 20, 1) + cylinder(20, 11) + cylinder(19, 1.3) + cylinder(20, 24.7) + undercutE(20, 0.6, 0.2, 2) +
           cylinder(25, 27.5) + undercutF(25, 0.8, 0.3, 2.5, 0.2) + cone(33, 34, 0.5) + cylinder(34, 9) +
           cone(34, 33, 0.5) + filletDown(25, 1) + cylinder(25, 37) + cylinder(17, 22.5) + cone(17, 14, 1.5);
}
inline Table taperPart()
{
    return roundUp(16, 1) + cylinder(16, 19) + filletUp(16, 0.8) + cylinder(24, 20) + cone(24, 28, 40) +
           cylinder(28, 4) + filletUp(28, 2.5) + cylinder(42, 8) + Table{{24, 42, 42, -60.0}} + cylinder(42, 6) +
           roundDown(42, 3) + cone(30, 26, 2 * std::sqrt(3.0)) + cylinder(26, 12) + cone(26, 24, 1);
}

}  // namespace lathelier::features
