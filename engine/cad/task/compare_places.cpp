#include "engine/cad/task/compare_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lathelier::cad {
namespace {

double angleOf(const Eigen::Vector3d& axisPlace)
{
    const double angle = std::atan2(axisPlace.y(), axisPlace.x()) * 180 / std::numbers::pi;
    return angle < 0 ? angle + 360 : angle;
}

/// Index of the map's cell; none outside.
std::optional<std::size_t> cellOf(const registration::UnrolledMap& map, double z_mm, double angle_deg)
{
    const double row = std::floor((z_mm - map.z_start_mm) / map.z_step_mm);
    if (!(row >= 0 && row < map.z_count)) return std::nullopt;
    const int column = std::clamp(static_cast<int>(angle_deg / 360 * map.angle_count), 0, map.angle_count - 1);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.angle_count) + static_cast<std::size_t>(column);
}

void fillAxisPlace(const CompareOutcome& outcome, ComparePlace& place)
{
    const registration::CompareResult& result = *outcome.result;
    if (!result.axis_T_reference) return;
    const Eigen::Vector3d axisPlace = *result.axis_T_reference * place.reference_mm;
    place.z_mm = axisPlace.z();
    place.angle_deg = angleOf(axisPlace);
    if (!outcome.form.map_mean_mm || place.local_mean_mm) return;
    const auto cell = cellOf(*result.unrolled, axisPlace.z(), *place.angle_deg);
    if (!cell) return;
    const float mean = (*outcome.form.map_mean_mm)[*cell];
    if (!std::isnan(mean)) place.local_mean_mm = mean;
}

}  // namespace

ComparePlace placeOfPoint(const CompareOutcome& outcome, std::size_t point, bool of_reference)
{
    const registration::CompareResult& result = *outcome.result;
    ComparePlace place;
    if (of_reference) {
        place.reference_mm = outcome.original->file.scan.points_mm[point];
    } else {
        place.reference_mm = result.alignment.reference_T_copy * outcome.copyScan().points_mm[point];
        place.point = point;
        if (result.used[point]) place.deviation_mm = result.deviation_mm[point];
        if (outcome.form.local_mean_mm && !std::isnan((*outcome.form.local_mean_mm)[point]))
            place.local_mean_mm = (*outcome.form.local_mean_mm)[point];
    }
    fillAxisPlace(outcome, place);
    return place;
}

ComparePlace placeOnMesh(const CompareOutcome& outcome, const MeshPlace& surface, bool of_reference)
{
    const registration::CompareResult& result = *outcome.result;
    const Scan& mesh = of_reference ? outcome.original->file.scan : outcome.copyScan();
    Eigen::Vector3d mesh_mm = Eigen::Vector3d::Zero();
    double deviation_mm = 0;
    bool used = !of_reference;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t corner = surface.corners[i];
        const double weight = surface.weights[static_cast<Eigen::Index>(i)];
        mesh_mm += weight * mesh.points_mm[corner];
        if (of_reference) continue;
        used = used && result.used[corner];
        deviation_mm += weight * static_cast<double>(result.deviation_mm[corner]);
    }
    ComparePlace place;
    place.reference_mm = of_reference ? mesh_mm : result.alignment.reference_T_copy * mesh_mm;
    if (!of_reference) place.surface = surface;
    if (used) place.deviation_mm = deviation_mm;
    fillAxisPlace(outcome, place);
    return place;
}

ComparePlace placeOnSkin(const CompareOutcome& outcome, const MeshPlace& on)
{
    const Skin& skin = *outcome.form.skin;
    const Eigen::Vector3d axis_place = placeOn(skin, on);
    ComparePlace place;
    place.reference_mm = outcome.result->axis_T_reference->inverse() * axis_place;
    place.z_mm = axis_place.z();
    place.angle_deg = angleOf(axis_place);
    double mean_mm = 0;
    for (std::size_t i = 0; i < 3; ++i)
        mean_mm += on.weights[static_cast<Eigen::Index>(i)] * static_cast<double>(skin.values[on.corners[i]]);
    if (!std::isnan(mean_mm)) place.local_mean_mm = mean_mm;
    return place;
}

Eigen::Vector3d shownPlace_mm(const CompareOutcome& outcome, const Eigen::Vector3d& reference_mm, double factor)
{
    if (!outcome.form.skin) return reference_mm;
    const Eigen::Isometry3d& axis_T_reference = *outcome.result->axis_T_reference;
    return axis_T_reference.inverse() * displacedPlace(*outcome.form.skin, axis_T_reference * reference_mm, factor);
}

std::vector<std::vector<Eigen::Vector3d>> outlineOf(const registration::CompareResult& result)
{
    constexpr int ringCorners = 96;
    constexpr int along = 12;
    std::vector<std::vector<Eigen::Vector3d>> lines;
    if (!result.windows || !result.axis_T_reference) return lines;
    const Eigen::Isometry3d reference_T_axis = result.axis_T_reference->inverse();
    const auto place = [&](double z, double radius, int part, int parts) {
        const double angle = 2 * std::numbers::pi * part / parts;
        return Eigen::Vector3d(reference_T_axis *
                               Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z));
    };
    struct Corner {
        double z, radius;
    };
    std::vector<Corner> meridian;
    for (const registration::MeridianStretch& stretch : result.windows->stretches) {
        if (stretch.is_bore || stretch.isFace()) continue;
        const double half = stretch.slope * (stretch.end_mm - stretch.start_mm) / 2;
        meridian.push_back({stretch.start_mm, stretch.radius_mm - half});
        meridian.push_back({stretch.end_mm, stretch.radius_mm + half});
    }
    for (const Corner& corner : meridian) {
        std::vector<Eigen::Vector3d>& ring = lines.emplace_back();
        for (int i = 0; i <= ringCorners; ++i) ring.push_back(place(corner.z, corner.radius, i, ringCorners));
    }
    for (int i = 0; i < along && !meridian.empty(); ++i) {
        std::vector<Eigen::Vector3d>& line = lines.emplace_back();
        for (const Corner& corner : meridian) line.push_back(place(corner.z, corner.radius, i, along));
    }
    return lines;
}

std::vector<CompareFlag> flagsOf(const CompareOutcome& outcome)
{
    constexpr std::size_t most = 3;  // as many as the answer has
    constexpr double facingUs_deg = 90;
    using Kind = registration::Finding::Kind;
    const registration::CompareResult& result = *outcome.result;
    std::vector<CompareFlag> flags;
    for (std::size_t i = 0; i < std::min(most, result.findings.size()); ++i) {
        const registration::Finding& finding = result.findings[i];
        if (finding.kind == Kind::Missing) continue;
        CompareFlag flag{finding.point_mm, finding.value_mm, finding.limit_mm, finding.verdict};
        if (finding.kind != Kind::Bump) {
            if (!finding.z_start_mm || !finding.z_end_mm || !result.meridian) continue;
            flag.reference_mm =
                placeOnSurface(outcome, (*finding.z_start_mm + *finding.z_end_mm) / 2, facingUs_deg).reference_mm;
        }
        flags.push_back(flag);
    }
    return flags;
}

ComparePlace placeOnSurface(const CompareOutcome& outcome, double z_mm, double angle_deg)
{
    const registration::CompareResult& result = *outcome.result;
    const registration::Meridian& meridian = *result.meridian;
    double radius_mm = 0;
    double nearest = std::numeric_limits<double>::infinity();
    // The radius is undefined at a shoulder: take the nearest defined one.
    for (std::size_t i = 0; i < meridian.z_mm.size(); ++i) {
        const double away = std::abs(meridian.z_mm[i] - z_mm);
        if (away >= nearest || std::isnan(meridian.reference_radius_mm[i])) continue;
        nearest = away;
        radius_mm = meridian.reference_radius_mm[i];
    }
    const double angle = angle_deg * std::numbers::pi / 180;
    ComparePlace place;
    place.reference_mm = result.axis_T_reference->inverse() *
                         Eigen::Vector3d(radius_mm * std::cos(angle), radius_mm * std::sin(angle), z_mm);
    fillAxisPlace(outcome, place);
    return place;
}

}  // namespace lathelier::cad
