#include "engine/features/paper_table.h"

#include <cmath>

namespace lathelier::features {
namespace {

constexpr double kLeastAngle_deg = 10;  ///< of a chamfer; flatter ones are tapers
constexpr double kSteepAngle_deg = 25;  ///< of a chamfer that leads on into another row
constexpr double kMeets_mm = 1e-3;      ///< ends of neighbouring rows that are one place

double lengthOf(const RecognizedRow& row)
{
    return row.z_end_mm - row.z_start_mm;
}

/// Is rows[cone] a cone that goes on from the longer cylinder rows[cylinder] beside it, becomes narrower away from it,
/// and ends there? A flat one that leads on into another row is the side of an undercut.
bool isChamferOf(const std::vector<RecognizedRow>& rows, std::size_t cone_at, std::size_t cylinder_at)
{
    if (cone_at >= rows.size()) return false;
    const RecognizedRow &cone = rows[cone_at], &cylinder = rows[cylinder_at];
    if (cone.kind != RowKind::Cone || lengthOf(cone) >= lengthOf(cylinder)) return false;
    const bool before = cone_at < cylinder_at;
    const double narrows_deg = before ? cone.half_angle_deg : -cone.half_angle_deg;
    const double gap_mm = before ? cylinder.z_start_mm - cone.z_end_mm : cone.z_start_mm - cylinder.z_end_mm;
    const double meets_mm = before ? cone.end_diameter_mm : cone.start_diameter_mm;
    if (narrows_deg < kLeastAngle_deg || std::abs(gap_mm) > kMeets_mm ||
        std::abs(meets_mm - cylinder.start_diameter_mm) > kMeets_mm)
        return false;
    if (narrows_deg >= kSteepAngle_deg) return true;
    const std::size_t beyond = before ? cone_at - 1 : cone_at + 1;  // before the first row: none either
    if (beyond >= rows.size()) return true;
    return before ? std::abs(rows[beyond].end_diameter_mm - cone.start_diameter_mm) > kMeets_mm
                  : std::abs(rows[beyond].start_diameter_mm - cone.end_diameter_mm) > kMeets_mm;
}

}  // namespace

PaperTable paperTable(const Recognition& result)
{
    PaperTable table;
    const std::vector<RecognizedRow>& rows = result.segments;
    std::vector<bool> said(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].kind != RowKind::Cylinder) continue;
        said[i] = true;
        PaperStep step;
        step.row = static_cast<std::int64_t>(i) + 1;
        step.radius_mm = rows[i].start_diameter_mm / 2;
        step.z_start_mm = rows[i].z_start_mm;
        step.z_end_mm = rows[i].z_end_mm;
        if (i > 0 && isChamferOf(rows, i - 1, i)) {
            said[i - 1] = true;
            step.chamfer_start_mm = lengthOf(rows[i - 1]);
            step.z_start_mm = rows[i - 1].z_start_mm;
        }
        if (isChamferOf(rows, i + 1, i)) {
            said[i + 1] = true;
            step.chamfer_end_mm = lengthOf(rows[i + 1]);
            step.z_end_mm = rows[i + 1].z_end_mm;
        }
        const Eigen::Vector3d middle =
            result.axis_point_mm + (step.z_start_mm + step.z_end_mm) / 2 * result.axis_direction;
        step.x_mm = middle.x();
        step.y_mm = middle.y();
        table.steps.push_back(step);
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!said[i]) table.beside.push_back(static_cast<std::int64_t>(i) + 1);
    return table;
}

}  // namespace lathelier::features
