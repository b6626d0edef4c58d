#include "engine/deflection/bent_skin.h"

#include <algorithm>
#include <cmath>

#include "engine/core/interpolate.h"
#include "engine/core/units.h"

namespace lathelier::deflection {
namespace {

constexpr int angles = 96;
constexpr double stationsOverLength = 300;
constexpr double shownShare = 1.0 / 3;  // of the largest radius

/// NaN before the first place, beyond the last, and in a gap.
double errorAt_um(const FinalContour& error, double z)
{
    constexpr double margin_mm = 1e-6;
    if (error.z_mm.empty() || z < error.z_mm.front() - margin_mm || z > error.z_mm.back() + margin_mm)
        return notANumber;
    const auto after =
        static_cast<std::size_t>(std::upper_bound(error.z_mm.begin(), error.z_mm.end(), z) - error.z_mm.begin());
    const bool is_gap =
        std::binary_search(error.gaps.begin(), error.gaps.end(), after) && z > error.z_mm[after - 1] + margin_mm;
    return is_gap ? notANumber : linearAt(error.z_mm, error.diameter_error_um, z);
}

}  // namespace

Skin bentSkin(const WorkPlan& plan, const DeflectedShape& shape, const FinalContour& error)
{
    std::vector<double> start_mm = plan.outer_start_mm, end_mm = plan.outer_end_mm;
    for (const CutPlan& cut : plan.cuts)
        for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
            start_mm[cut.first + i] = std::min(start_mm[cut.first + i], cut.pieces[i].start_mm);
            end_mm[cut.first + i] = std::min(end_mm[cut.first + i], cut.pieces[i].end_mm);
        }
    std::vector<Eigen::Vector2d> line{{plan.z_mm.front(), 0}};
    for (std::size_t i = 0; i < start_mm.size(); ++i) {
        line.emplace_back(plan.z_mm[i], std::max(0.0, start_mm[i]));
        line.emplace_back(plan.z_mm[i + 1], std::max(0.0, end_mm[i]));
    }
    line.emplace_back(plan.z_mm.back(), 0);

    Skin skin;
    skin.stations = stationsAlong(line, plan.length_mm() / stationsOverLength);
    skin.angle_count = angles;
    skin.values.reserve(skin.vertexCount());
    skin.shift_mm.reserve(skin.vertexCount());
    for (const SkinStation& station : skin.stations) {
        const auto value = static_cast<float>(station.isFace() ? notANumber : errorAt_um(error, station.z_mm));
        const Eigen::Vector3d shift(linearAt(shape.z_mm, shape.x_um, station.z_mm) / um_per_mm,
                                    linearAt(shape.z_mm, shape.y_um, station.z_mm) / um_per_mm, 0);
        skin.values.insert(skin.values.end(), angles, value);
        skin.shift_mm.insert(skin.shift_mm.end(), angles, shift.cast<float>());
    }
    return skin;
}

double bendMagnification(const Skin& skin)
{
    double shift_mm = 0;
    for (const Eigen::Vector3f& shift : skin.shift_mm) shift_mm = std::max(shift_mm, static_cast<double>(shift.norm()));
    return readableFactor(shownShare * skin.largestRadius() / std::max(shift_mm, 1e-9));
}

}  // namespace lathelier::deflection
