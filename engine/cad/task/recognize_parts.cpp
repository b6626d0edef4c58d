// The scan by kinds of rows, and the drawing of what was recognized.
#include <algorithm>

#include "engine/cad/task/recognize_task.h"
#include "engine/drawing/shaft_drawing.h"

namespace lathelier::cad {
namespace {

constexpr std::size_t noRowKind = 3;

/// Kind of the row at z; a shoulder belongs to the following row.
std::size_t kindAt(const features::Recognition& result, double z_mm)
{
    const auto& rows = result.segments;
    const auto after =
        std::upper_bound(rows.begin(), rows.end(), z_mm,
                         [](double z, const features::RecognizedRow& row) { return z < row.z_start_mm; });
    if (after == rows.begin()) return noRowKind;
    const features::RecognizedRow& row = *(after - 1);
    return z_mm <= row.z_end_mm ? static_cast<std::size_t>(row.kind) : noRowKind;
}

}  // namespace

ScanByKind partedByKind(const Scan& scan, const features::Recognition& result)
{
    std::array<std::shared_ptr<Scan>, 4> parts;
    for (auto& part : parts) part = std::make_shared<Scan>();
    const auto kindOf = [&](const Eigen::Vector3d& point) { return kindAt(result, (result.part_T_scan * point).z()); };
    if (scan.isMesh()) {
        for (auto& part : parts) part->points_mm = scan.points_mm;
        for (const auto& triangle : scan.triangles) {
            Eigen::Vector3d middle = Eigen::Vector3d::Zero();
            for (const std::uint32_t corner : triangle) middle += scan.points_mm[corner] / 3;
            parts[kindOf(middle)]->triangles.push_back(triangle);
        }
    } else {
        for (const Eigen::Vector3d& point : scan.points_mm) parts[kindOf(point)]->points_mm.push_back(point);
    }
    ScanByKind result_parts;
    std::copy(parts.begin(), parts.end(), result_parts.begin());
    return result_parts;
}

drawing::Drawing drawingOf(const RecognizeOutcome& outcome, const Language& language)
{
    return drawing::drawShaft(outcome.shaft, drawingOptions(outcome.question.title, outcome.question.cad, language));
}

}  // namespace lathelier::cad
