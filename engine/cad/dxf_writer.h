// DXF R12 (AC1009): supported by all common CAM programs and viewers.
//
// ASCII with line feeds, 9 decimals, lengths in mm. Angles anticlockwise in degrees. Texts: ⌀ ° ± as %%c %%d %%p,
// other letters beyond ASCII as \U+XXXX.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// Layers of every file; other names create further layers, white and continuous.
namespace layers {
inline constexpr const char* contour = "CONTOUR";
inline constexpr const char* axis = "AXIS";  ///< red, CENTER
inline constexpr const char* dimensions = "DIMENSIONS";
inline constexpr const char* hatch = "HATCH";
inline constexpr const char* text = "TEXT";
}  // namespace layers

struct DxfLine {
    Eigen::Vector2d from_mm = Eigen::Vector2d::Zero(), to_mm = Eigen::Vector2d::Zero();
    std::string layer = layers::contour;  ///< one of `layers`, or a further one
};

/// Anticlockwise from start to end.
struct DxfArc {
    Eigen::Vector2d centre_mm = Eigen::Vector2d::Zero();
    double radius_mm = 0;                 ///< in mm
    double start_deg = 0, end_deg = 0;    ///< anticlockwise from x
    std::string layer = layers::contour;  ///< one of `layers`, or a further one
};

struct DxfText {
    enum class Align { Left, Centre, Right };
    Eigen::Vector2d at_mm = Eigen::Vector2d::Zero();  ///< on its base line
    double height_mm = 2.5;                           ///< of capitals, mm
    double angle_deg = 0;                             ///< anticlockwise from x
    std::string text;                                 ///< UTF-8, one line
    Align align = Align::Left;                        ///< end of the text at `at_mm`
    std::string layer = layers::text;                 ///< one of `layers`, or a further one
};

/// A filled arrow head (SOLID).
struct DxfArrow {
    Eigen::Vector2d tip_mm = Eigen::Vector2d::Zero();
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit, toward the tip
    double length_mm = 2.5;                                ///< along the axis, mm
    std::string layer = layers::dimensions;                ///< one of `layers`, or a further one
};

/// A drawing in the plane; hatches are lines of their layer.
struct DxfDrawing {
    std::vector<DxfLine> lines;
    std::vector<DxfArc> arcs;      ///< drawn after the lines
    std::vector<DxfText> texts;    ///< drawn after the arcs
    std::vector<DxfArrow> arrows;  ///< drawn last
};

std::string dxfText(const DxfDrawing& drawing);

/// The closed half contour for CAM: x is z of the shaft, y its radius. Where it lies on the axis a line closes
/// it.
DxfDrawing halfContour(const Shaft& shaft);

/// Errors: those of checkShaft().
std::string contourDxf(const Shaft& shaft);

}  // namespace lathelier::cad
