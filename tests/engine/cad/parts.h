// Turned parts with known truth for the tests of CAD files, made in code.
#pragma once

#include <cmath>

#include "engine/shaft/shaft.h"

namespace lathelier::cad {

inline ShaftSegment row(double length, double start, double end, std::optional<double> arc = {}, std::string role = "")
{
    return {length, start, end, 0, arc, std::move(role)};
}

/// The shaft of the paper's Table 1.
inline Shaft tableOne()
{
    Shaft shaft;
    shaft.name = "table1";
    shaft.segments = {row(98, 30, 30), row(10, 37, 37), row(70, 33.8, 33.8), row(5, 33.8, 23.8, {}, "chamfer")};
    return shaft;
}

/// DIN 509 forms E (0.6 × 0.2) and F (0.8 × 0.3, with its relieved face), a circlip groove, chamfers.
inline Shaft undercut()
{
    const double slope = std::tan(std::acos(-1.0) / 12);  // 15°
    const double arc_height = 0.8 * (1 - std::cos(82 * std::acos(-1.0) / 180));
    const double arc_run = 0.8 * std::sin(82 * std::acos(-1.0) / 180);
    const double back = arc_run - 0.6;  // the arc of form F dips under its face, 8° back out
    const double top = 24.4 + 2 * arc_height;
    const double out = top + 2 * back / std::tan(8 * std::acos(-1.0) / 180);
    Shaft shaft;
    shaft.name = "undercut";
    shaft.segments = {row(1, 18, 20, {}, "chamfer"),
                      row(11, 20, 20),
                      row(1.3, 19, 19, {}, "groove"),
                      row(24.7, 20, 20),
                      row(0.2 / slope, 20, 19.6),
                      row(1.4 - 0.2 / slope, 19.6, 19.6),
                      row(0.6, 19.6, 20.8, -0.6),
                      row(27.5, 25, 25),
                      row(0.3 / slope, 25, 24.4),
                      row(1.9 - 0.3 / slope, 24.4, 24.4),
                      row(arc_run, 24.4, top, -0.8),
                      row(-back, top, out),
                      row(0.5, 33, 34, {}, "chamfer"),
                      row(9, 34, 34),
                      row(0.5, 34, 33, {}, "chamfer"),
                      row(1, 27, 25, -1.0),
                      row(37, 25, 25),
                      row(22.5, 17, 17),
                      row(1.5, 17, 14, {}, "chamfer")};
    return shaft;
}

/// A taper 1:10, fillets, edge rounds, a saddle.
inline Shaft taper()
{
    Shaft shaft;
    shaft.name = "taper";
    shaft.segments = {row(1, 14, 16, 1.0, "edge_round"),
                      row(19, 16, 16),
                      row(0.8, 16, 17.6, -0.8, "fillet"),
                      row(20, 24, 24),
                      row(40, 24, 28, {}, "taper"),
                      row(4, 28, 28),
                      row(2.5, 28, 33, -2.5, "fillet"),
                      row(8, 42, 42),
                      row(24, 42, 42, -60.0, "saddle"),
                      row(6, 42, 42),
                      row(3, 42, 36, 3.0, "edge_round"),
                      row(2 * std::sqrt(3.0), 30, 26),
                      row(12, 26, 26),
                      row(1, 26, 24, {}, "chamfer")};
    return shaft;
}

/// Bored through with counterbores at both ends.
inline Shaft flange()
{
    Shaft shaft;
    shaft.name = "flange";
    shaft.segments = {row(1, 58, 60, {}, "chamfer"), row(29, 60, 60), row(1.6, 60, 63.2, -1.6, "fillet"),
                      row(14, 110, 110), row(2, 110, 106, {}, "chamfer")};
    shaft.bores = {{ShaftEnd::Free,
                    {{1, 42, 40, {}, "chamfer"},
                     {17, 40, 40, {}, ""},
                     {20.6, 32, 32, {}, ""},
                     {8, 47, 47, {}, ""},
                     {1, 47, 49, {}, "chamfer"}}}};
    return shaft;
}

/// Blind bores from both ends: a drilled cone, a fillet at the bottom.
inline Shaft blindBores()
{
    Shaft shaft;
    shaft.name = "blind";
    shaft.segments = {row(50, 40, 40), row(10, 50, 50)};
    shaft.bores = {{ShaftEnd::Free, {{20, 12, 12, {}, ""}, {6 / std::sqrt(3.0), 12, 0, {}, ""}}},
                   {ShaftEnd::Chuck, {{15, 20, 20, {}, ""}, {1.5, 20, 17, 1.5, "fillet"}}}};
    return shaft;
}

/// A ball on a stud.
inline Shaft ballEnd()
{
    Shaft shaft;
    shaft.name = "ball";
    shaft.segments = {row(10, 0, 20, 10.0), row(8, 20, 12, 10.0), row(20, 12, 12)};
    return shaft;
}

/// An arc whose centre lies beyond the axis.
inline Shaft lemon()
{
    Shaft shaft;
    shaft.name = "lemon";
    shaft.segments = {row(5, 10, 10), row(30, 10, 10, 25.0), row(5, 10, 10)};
    return shaft;
}

inline std::vector<Shaft> allParts()
{
    return {tableOne(), undercut(), taper(), flange(), ballEnd(), lemon(), blindBores()};
}

}  // namespace lathelier::cad
