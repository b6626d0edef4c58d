// Bars, tools and short programs for the tests of stock.
#pragma once

#include <string>

#include "engine/gcode/toolpath.h"
#include "engine/stock/stock_check.h"

namespace lathelier::stock {

inline Shaft bar(double length_mm, double diameter_mm, double bore_mm = 0)
{
    Shaft shaft;
    shaft.segments = {{length_mm, diameter_mm, diameter_mm, bore_mm, {}, {}}};
    return shaft;
}

/// CNMG 120408 in a PCLNL: κ 95°, ε 80°.
inline Tool insertC(double radius_mm = 0.8)
{
    Tool tool;
    tool.corner_radius_mm = radius_mm;
    tool.entering_angle_deg = 95;
    tool.tip_angle_deg = 80;
    tool.edge_length_mm = 12;
    return tool;
}

/// A blade whose sides are square to the axis: what it leaves is exact.
inline Tool blade(double width_mm, double reach_mm = 30)
{
    Tool tool;
    tool.kind = ToolKind::Blade;
    tool.width_mm = width_mm;
    tool.reach_mm = reach_mm;
    return tool;
}

inline StockParameters with(const Tool& tool)
{
    StockParameters parameters;
    parameters.tools = {tool};
    return parameters;
}

/// A program that counts X as diameter, Z0 at the free end.
inline std::vector<gcode::Move> movesOf(const std::string& blocks)
{
    gcode::Program program =
        gcode::readProgram("%\nO1\nG21 G18 G40 G99\n" + blocks + "M30\n%\n", gcode::controlNamed("fanuc"));
    return gcode::findToolpath(program, {}, {}).moves;
}

/// Line of the first of the blocks given to movesOf().
inline constexpr std::int64_t firstLine = 4;

}  // namespace lathelier::stock
