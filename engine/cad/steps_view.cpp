#include "engine/cad/steps_view.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::cad {
namespace {

constexpr double flattest = 15 * std::numbers::pi / 180, steepest = 75 * std::numbers::pi / 180;
constexpr double longestShare =
    0.5;  ///< longest chamfer without a role, as a share of radius and length of its cylinder

enum class Use { Beside, Cylinder, ChamferBefore, ChamferAfter, Face };

bool isCylinder(const ShaftSegment& row)
{
    return !row.arc_radius_mm && row.length_mm > 0 && std::abs(row.start_diameter_mm - row.end_diameter_mm) < same_mm;
}

/// True if a cone with these end diameters is a chamfer of the cylinder.
bool isChamfer(const ShaftSegment& cone, const ShaftSegment& cylinder, double large_mm, double small_mm,
               const double* beyond_mm)
{
    if (cone.arc_radius_mm || !(cone.length_mm > 0) || !(large_mm > small_mm)) return false;
    if (std::abs(large_mm - cylinder.start_diameter_mm) > same_mm) return false;
    if (cone.role == "chamfer") return true;
    const double angle = std::atan2((large_mm - small_mm) / 2, cone.length_mm);
    const bool ends_at_face = beyond_mm == nullptr || std::abs(*beyond_mm - small_mm) > same_mm;
    return cone.role.empty() && angle >= flattest && angle <= steepest && ends_at_face &&
           cone.length_mm <= longestShare * std::min(cylinder.start_diameter_mm / 2, cylinder.length_mm);
}

std::vector<Use> usesOf(const std::vector<ShaftSegment>& rows)
{
    std::vector<Use> uses(rows.size(), Use::Beside);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].length_mm == 0 && !rows[i].arc_radius_mm) uses[i] = Use::Face;
        if (isCylinder(rows[i])) uses[i] = Use::Cylinder;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (uses[i] != Use::Cylinder) continue;
        if (i > 0 && uses[i - 1] == Use::Beside &&
            isChamfer(rows[i - 1], rows[i], rows[i - 1].end_diameter_mm, rows[i - 1].start_diameter_mm,
                      i > 1 ? &rows[i - 2].end_diameter_mm : nullptr))
            uses[i - 1] = Use::ChamferBefore;
        if (i + 1 < rows.size() && uses[i + 1] == Use::Beside &&
            isChamfer(rows[i + 1], rows[i], rows[i + 1].start_diameter_mm, rows[i + 1].end_diameter_mm,
                      i + 2 < rows.size() ? &rows[i + 2].start_diameter_mm : nullptr))
            uses[i + 1] = Use::ChamferAfter;
    }
    return uses;
}

}  // namespace

std::vector<ShaftStep> stepsOf(const Shaft& shaft)
{
    const std::vector<Use> uses = usesOf(shaft.segments);
    std::vector<ShaftStep> steps;
    double z = 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const ShaftSegment& row = shaft.segments[i];
        if (uses[i] == Use::Cylinder) {
            ShaftStep step;
            step.radius_mm = row.start_diameter_mm / 2;
            step.chamfer_start_mm = i > 0 && uses[i - 1] == Use::ChamferBefore ? shaft.segments[i - 1].length_mm : 0;
            step.z_start_mm = z - step.chamfer_start_mm;
            const bool after = i + 1 < uses.size() && uses[i + 1] == Use::ChamferAfter;
            step.chamfer_end_mm = after ? shaft.segments[i + 1].length_mm : 0;
            step.z_end_mm = z + row.length_mm + step.chamfer_end_mm;
            steps.push_back(step);
        }
        z += row.length_mm;
    }
    return steps;
}

std::vector<std::size_t> rowsBesideSteps(const Shaft& shaft)
{
    const std::vector<Use> uses = usesOf(shaft.segments);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < uses.size(); ++i)
        if (uses[i] == Use::Beside) rows.push_back(i);
    return rows;
}

Json stepsJson(const Shaft& shaft)
{
    Json steps = Json::array();
    for (const ShaftStep& step : stepsOf(shaft))
        steps.push_back({{"x_mm", step.x_mm},
                         {"y_mm", step.y_mm},
                         {"radius_mm", step.radius_mm},
                         {"z_start_mm", step.z_start_mm},
                         {"z_end_mm", step.z_end_mm},
                         {"chamfer_start_mm", step.chamfer_start_mm},
                         {"chamfer_end_mm", step.chamfer_end_mm}});
    return steps;
}

}  // namespace lathelier::cad
