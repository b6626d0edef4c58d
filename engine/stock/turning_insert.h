// The tool in the meridian plane: outline of its insert and holder, as convex polygons about the imaginary tip that the
// program moves (compensation is in the moves already).
//
// Angles as in ISO 3002-1: entering angle κ between main edge and feed (90° less the lead angle), tip angle ε between
// both edges (ISO 1832: C 80°, D 55°, V 35°, S 90°, T 60°, W 80°), back angle κ' = 180° - κ - ε. The corner is a circle
// of radius r that both edges touch; it is approximated by an inscribed polygon within noseChord_mm, with corners at
// its extreme points along z and x, so that a cylinder and a face are turned exactly.
//
// Fanuc's numbers of the tip, z toward the chuck: 3 cuts toward the chuck from outside, 4 from the chuck from outside,
// 2 and 1 the same from inside; 8, 6, 7, 5 point toward the axis, outward, toward the chuck, from it, with both edges
// alike; 9 and 0: as 3, programmed by the centre of the corner.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/fields.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::stock {

enum class ToolShape : std::uint8_t {
    Insert,  ///< a rhombus of edge_length_mm, one corner of which cuts
    Round,   ///< a disc of corner_radius_mm
    Blade,   ///< grooving and parting off: width_mm wide, edge_length_mm deep, two corners of corner_radius_mm; the tip
             ///< is that at its side toward the chuck (tip 3) or from it (tip 4)
    Drill    ///< width_mm is its diameter, tip_angle_deg its point angle, edge_length_mm its length; on the axis
};

/// Defaults of missing values (note toolAssumed).
inline constexpr double assumedCornerRadius_mm = 0.8;
inline constexpr double assumedEnteringAngle_deg = 95;  ///< holders PCLN, SCLC
inline constexpr double assumedTipAngle_deg = 80;       ///< inserts C
inline constexpr double assumedPointAngle_deg = 118;    ///< drills
inline constexpr double assumedEdge_mm = 12;            ///< insert edge; CNMG 12 has 12.9 mm
inline constexpr double assumedReach_mm = 30;           ///< blade, drill
inline constexpr double assumedWidth_mm = 3;            ///< blade, drill
inline constexpr double noseChord_mm = 0.002;

/// A corner of a holder relative to the imaginary tip: dz toward the chuck, dx away from the axis.
struct HolderCorner {
    double dz_mm = 0;
    double dx_mm = 0;
    friend bool operator==(const HolderCorner&, const HolderCorner&) = default;
};

/// A tool of the program.
struct TurningTool {
    int number = 0;  ///< T of the program; 0: default for unlisted tools
    ToolShape shape = ToolShape::Insert;
    int tip = 3;                               ///< Fanuc's number
    std::optional<double> corner_radius_mm;    ///< r
    std::optional<double> entering_angle_deg;  ///< κ
    std::optional<double> tip_angle_deg;       ///< ε
    std::optional<double> edge_length_mm;      ///< of an insert; reach of a blade, length of a drill
    std::optional<double> width_mm;            ///< of a blade, diameter of a drill
    std::optional<double> shank_width_mm;      ///< a rectangular shank across the axis; none: no shank
    std::vector<HolderCorner> holder;          ///< the holder is its convex hull; empty: shank only
    std::string name;
    friend bool operator==(const TurningTool&, const TurningTool&) = default;
};

const std::vector<Field<HolderCorner>>& fieldsOf(const HolderCorner*);
const std::vector<Field<TurningTool>>& fieldsOf(const TurningTool*);

/// Tool outline with defaults applied, with the imaginary tip at (0, 0), in the coordinates of the work (z toward the
/// chuck).
struct ToolOutline {
    ConvexPolygon insert;
    std::vector<ConvexPolygon> holders;  ///< parts that must not touch the stock; may be empty
    bool is_assumed = false;             ///< a value needed by the shape was not stated
    double corner_radius_mm = 0;         ///< after applying defaults, as the following
    double entering_angle_deg = 0;       ///< 0: the shape has none
    double tip_angle_deg = 0;            ///< 0: the shape has none
    double edge_length_mm = 0;           ///< 0: the shape has none
};

/// Shank: 100 mm long, its lower end one edge length above the tip, its side toward the feed a quarter of its width
/// behind the tip (ISO 5610: f = 1.25 b). Errors toolImpossible (κ + ε at least 180°, or a corner larger than the
/// insert).
ToolOutline outlineOf(const TurningTool& tool);

/// Tip angle of an ISO 1832 code ("CNMG 120408"), by its first letter; none: not such a code.
std::optional<double> tipAngleOfCode_deg(std::string_view code);

}  // namespace lathelier::stock
