// A turning tool: what cuts, on what it is held, and where its tip is. One value for every task, one description.
//
// Angles as in ISO 3002-1, in the plane of the axis: entering angle κ between main edge and feed, tip angle ε between
// both edges, back angle κ' = 180° - κ - ε between the other edge and the feed reversed. The lead angle of catalogues
// is 90° - κ; files may state it under `lead_angle_deg`, programs speak of κ only. An ISO 1832 code states ε by its
// first letter, and edge length and corner radius r by its digits (toolOfCode).
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

namespace lathelier {

/// What cuts; decides which sizes of a Tool count.
enum class ToolKind : std::uint8_t {
    Insert,           ///< a rhombus of edge_length_mm, one corner of which cuts
    RoundInsert,      ///< a disc of corner_radius_mm
    Blade,            ///< grooving and parting off: width_mm wide, reach_mm deep, two corners of corner_radius_mm; the
                      ///< tip is that at its side toward the chuck (tip 3) or from it (tip 4)
    Drill,            ///< on the axis: diameter_mm, point angle tip_angle_deg, reach_mm long
    BoringBar,        ///< an insert on a bar that reaches reach_mm into a bore
    ThreadingInsert,  ///< both edges alike; its angle is that of the thread
};

enum class Hand : std::uint8_t { TowardChuck, FromChuck };  ///< direction of the feed

/// Sizes taken where none are stated. Tasks note them (toolAssumed).
namespace assumed {
inline constexpr double cornerRadius_mm = 0.8;
inline constexpr double enteringAngle_deg = 95;  ///< holders PCLN, SCLC
inline constexpr double tipAngle_deg = 80;       ///< inserts C
inline constexpr double pointAngle_deg = 118;    ///< drills
inline constexpr double edge_mm = 12;            ///< insert edge; CNMG 12 has 12.9 mm
inline constexpr double reach_mm = 30;           ///< blade, drill
inline constexpr double width_mm = 3;            ///< width of a blade, diameter of a drill
inline constexpr double threadCorner_mm = 0.05, threadAngle_deg = 60, threadEdge_mm = 5;  ///< threading insert
inline constexpr double centreHole_mm = 5, centreAngle_deg = 60;                          ///< centre drill
}  // namespace assumed

/// A corner of a holder relative to the imaginary tip: dz toward the chuck, dx away from the axis.
struct HolderCorner {
    double dz_mm = 0;
    double dx_mm = 0;
    friend bool operator==(const HolderCorner&, const HolderCorner&) = default;
};

struct Tool {
    int number = 0;  ///< T of the program; 0: default for unlisted tools
    ToolKind kind = ToolKind::Insert;
    std::string name = {};         ///< label of insert and holder
    std::string insert = {};       ///< ISO code of an insert in the library; empty: none
    std::string holder_name = {};  ///< ISO code of a holder in the library; empty: none
    Hand hand = Hand::TowardChuck;
    int tip = 3;                                    ///< Fanuc's number
    std::optional<double> corner_radius_mm = {};    ///< r; of a blade: of both corners, none is sharp
    std::optional<double> entering_angle_deg = {};  ///< κ
    std::optional<double> tip_angle_deg = {};       ///< ε; the point of a drill
    std::optional<double> edge_length_mm = {};      ///< of an insert
    std::optional<double> width_mm = {};            ///< of a blade
    std::optional<double> diameter_mm = {};         ///< of a drill
    std::optional<double> reach_mm = {};            ///< depth of a blade on radius, length of a drill or boring bar
    std::optional<double> shank_width_mm = {};      ///< a rectangular shank across the axis; none: no shank
    std::vector<HolderCorner> holder = {};          ///< the holder is its convex hull; empty: shank only
    friend bool operator==(const Tool&, const Tool&) = default;
};

const std::vector<Field<HolderCorner>>& fieldsOf(const HolderCorner*);
/// Former keys: nose_radius_mm (corner_radius_mm), lead_angle_deg (90° - entering_angle_deg), max_depth_mm (reach_mm).
const std::vector<Field<Tool>>& fieldsOf(const Tool*);

/// A code as it is compared: letters and digits only, in small letters ("CNMG 12 04 08" is "cnmg120408").
std::string plainCode(const std::string& name);

/// Tip angle of an ISO 1832 code ("CNMG 120408"), by its first letter: C 80°, D 55°, V 35°, S 90°, T 60°, W 80°. None:
/// not such a code.
std::optional<double> tipAngleOfCode_deg(std::string_view code);

/// An insert by its ISO 1832 code: shape, edge length in whole mm, corner radius in 0.1 mm. None: not such a code.
std::optional<Tool> toolOfCode(const std::string& code);

}  // namespace lathelier
