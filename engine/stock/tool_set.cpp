#include "engine/stock/tool_set.h"

#include <algorithm>

#include "engine/stock/stock_codes.h"

namespace lathelier::stock {
namespace {

MountedTool mount(const ToolOutline& outline, bool is_stated, double clearance_mm)
{
    MountedTool mounted;
    mounted.is_stated = is_stated;
    const auto add = [&](const ConvexPolygon& shape, bool is_holder) {
        mounted.bodies.push_back({shape, grownBy(shape, clearance_mm), is_holder});
        const Box box = boxOf(shape);
        mounted.width_mm += box.high.z_mm - box.low.z_mm;
    };
    add(outline.insert, false);
    for (const ConvexPolygon& holder : outline.holders) add(holder, true);
    return mounted;
}

const Tool* findTool(const std::vector<Tool>& stated, int number)
{
    const Tool* any = nullptr;
    for (const Tool& tool : stated) {
        if (tool.number == number) return &tool;
        if (tool.number == 0) any = &tool;
    }
    return any;
}

void noteTool(const Tool& tool, const ToolOutline& outline, int number, Notes& notes)
{
    if (outline.is_assumed)
        notes.push_back({notes::toolAssumed,
                         {{"tool", std::int64_t{number}},
                          {"corner_radius_mm", outline.corner_radius_mm},
                          {"entering_angle_deg", outline.entering_angle_deg},
                          {"tip_angle_deg", outline.tip_angle_deg},
                          {"reach_mm", outline.reach_mm}}});
    if (outline.holders.empty() && tool.kind != ToolKind::Drill)
        notes.push_back({notes::toolWithoutHolder, {{"tool", std::int64_t{number}}}});
}

}  // namespace

ToolSet::ToolSet(std::span<const gcode::Move> moves, const std::vector<Tool>& stated, double clearance_mm, Notes& notes)
{
    const Tool unlisted;
    for (const gcode::Move& move : moves) {
        if (move.kind == gcode::MoveKind::Dwell || mounted_.contains(move.tool)) continue;
        const Tool* found = findTool(stated, move.tool);
        const Tool& tool = found ? *found : unlisted;
        const ToolOutline outline = outlineOf(tool);
        noteTool(tool, outline, move.tool, notes);
        mounted_[move.tool] = mount(outline, found != nullptr, clearance_mm);
    }
}

double ToolSet::width_mm() const
{
    double widest = 0;
    for (const auto& [number, tool] : mounted_) widest = std::max(widest, tool.width_mm);
    return widest;
}

}  // namespace lathelier::stock
