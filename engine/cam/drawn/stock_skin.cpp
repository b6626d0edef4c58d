#include "engine/cam/drawn/stock_skin.h"

#include <algorithm>
#include <cmath>

namespace lathelier::cam {
namespace {

constexpr int angles = 120;
constexpr double stationStep_mm = 20;  // straight lines need no stations between their ends
constexpr double insertThickness_mm = 5;
constexpr double holderThickness_mm = 20;

const stock::StockOutline* outlineOf(const TurningOutcome& outcome, std::size_t setup, const StockShown& shown)
{
    const auto& checked = outcome.plan->setups.at(setup).check.stock;
    const auto& bare = outcome.clampings.at(setup).bare;
    if (!checked || !bare) return nullptr;
    if (shown.is_whole) {
        for (auto pass = checked->passes.rbegin(); pass != checked->passes.rend(); ++pass)
            if (pass->is_kept) return &pass->after;
        return &checked->before;
    }
    const bool has_cut = shown.pass && *shown.pass < checked->passes.size() && checked->passes[*shown.pass].is_kept;
    return has_cut ? &checked->passes[*shown.pass].after : &bare->before;
}

Skin skinOf(const std::vector<Eigen::Vector2d>& line_mm)
{
    Skin skin;
    skin.stations = stationsAlong(line_mm, stationStep_mm);
    skin.angle_count = angles;
    skin.values.assign(skin.vertexCount(), std::numeric_limits<float>::quiet_NaN());
    return skin;
}

/// A convex polygon (z, x) as a plate below the plane of the axis.
void addPlate(Scan& mesh, const stock::ConvexPolygon& polygon, double tip_z_mm, double tip_x_mm, double thickness_mm)
{
    const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
    const auto count = static_cast<std::uint32_t>(polygon.size());
    if (count < 3) return;
    for (const double depth_mm : {0.0, -thickness_mm})
        for (const stock::Corner& corner : polygon)
            mesh.points_mm.emplace_back(tip_x_mm + corner.x_mm, depth_mm, tip_z_mm + corner.z_mm);
    for (std::uint32_t i = 1; i + 1 < count; ++i) {
        mesh.triangles.push_back({first, first + i, first + i + 1});
        mesh.triangles.push_back({first + count, first + count + i + 1, first + count + i});
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        mesh.triangles.push_back({first + i, first + count + i, first + next});
        mesh.triangles.push_back({first + next, first + count + i, first + count + next});
    }
}

}  // namespace

std::vector<Skin> stockSkins(const TurningOutcome& outcome, std::size_t setup, const StockShown& shown)
{
    std::vector<Skin> skins;
    const stock::StockOutline* const outline = outlineOf(outcome, setup, shown);
    if (!outline) return skins;
    std::vector<Eigen::Vector2d> line_mm;
    // Outlines have their material on the left, skins on the right.
    for (std::size_t i = outline->z_mm.size(); i-- > 0;) {
        if (!std::isnan(outline->z_mm[i])) line_mm.emplace_back(outline->z_mm[i], std::max(0.0, outline->x_mm[i]));
        if ((i == 0 || std::isnan(outline->z_mm[i])) && line_mm.size() > 2) skins.push_back(skinOf(line_mm));
        if (std::isnan(outline->z_mm[i])) line_mm.clear();
    }
    return skins;
}

std::optional<stock::ToolOutline> outlineOfTool(const ClampingOutcome& clamping, int number)
{
    if (!clamping.bare) return std::nullopt;
    const auto& tools = clamping.bare->parameters.tools;
    const auto tool =
        std::find_if(tools.begin(), tools.end(), [number](const Tool& each) { return each.number == number; });
    if (tool == tools.end()) return std::nullopt;
    return stock::outlineOf(*tool);  // the plan has checked it
}

Scan toolMesh(const ClampingOutcome& clamping, double tip_z_mm, double tip_x_mm, int number)
{
    Scan mesh;
    const auto outline = outlineOfTool(clamping, number);
    if (!outline) return mesh;
    addPlate(mesh, outline->insert, tip_z_mm, tip_x_mm, insertThickness_mm);
    for (const stock::ConvexPolygon& holder : outline->holders)
        addPlate(mesh, holder, tip_z_mm, tip_x_mm, holderThickness_mm);
    return mesh;
}

}  // namespace lathelier::cam
