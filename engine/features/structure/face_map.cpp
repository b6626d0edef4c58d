#include "engine/features/structure/face_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/units.h"
#include "engine/features/structure/map_regions.h"
#include "engine/features/structure/residual_map.h"

namespace lathelier::features {
namespace {

std::vector<SeenFace> facesOf(const Outline& outside, const Outline* bore)
{
    const Model& model = outside.model;
    std::vector<SeenFace> faces;
    const auto add = [&](double z, double a, double b) {
        SeenFace face;
        face.z_mm = z;
        face.inner_mm = std::min(a, b) + faceThresholds.rim_mm;
        face.outer_mm = std::max(a, b) - faceThresholds.rim_mm;
        if (face.outer_mm > face.inner_mm) faces.push_back(std::move(face));
    };
    const Run &first = model.runs.front(), &last = model.runs.back();
    if (outside.face_seen[0])
        add(first.nodes_mm.front(), startRadius_mm(first), boreRadius_mm(bore, first.nodes_mm.front()));
    for (std::size_t r = 0; r + 1 < model.runs.size(); ++r)
        if (model.runs[r].right == model.runs[r + 1].left)
            add(model.planes[model.runs[r].right].z_mm, endRadius_mm(model.runs[r]), startRadius_mm(model.runs[r + 1]));
    if (outside.face_seen[1]) add(last.nodes_mm.back(), endRadius_mm(last), boreRadius_mm(bore, last.nodes_mm.back()));
    return faces;
}

/// Points of a face on a grid across the axis.
struct FaceGrid {
    double cell_mm = 1;
    std::size_t side = 0;       ///< cells along x and along y
    std::vector<float> points;  ///< by y, then x; -1 outside the ring
    double mean = 0;            ///< of the cells within
};

std::optional<FaceGrid> gridOf(const SeenFace& face)
{
    const std::vector<Eigen::Vector2d>& places = face.places_mm;
    const double area = turn_rad / 2 * (face.outer_mm * face.outer_mm - face.inner_mm * face.inner_mm);
    const double density = static_cast<double>(places.size()) / area;
    FaceGrid grid;
    grid.cell_mm =
        std::max(faceThresholds.least_cell_mm, std::sqrt(faceThresholds.cell_points / std::max(1e-9, density)));
    if (grid.cell_mm > faceThresholds.most_cell_mm) return std::nullopt;
    grid.side = static_cast<std::size_t>(std::ceil(2 * face.outer_mm / grid.cell_mm));
    grid.points.assign(grid.side * grid.side, 0);
    const auto index = [&](double x) {
        return std::min(grid.side - 1, static_cast<std::size_t>((x + face.outer_mm) / grid.cell_mm));
    };
    for (const Eigen::Vector2d& p : places) grid.points[index(p.y()) * grid.side + index(p.x())] += 1;
    double cells = 0, seen = 0, sum = 0;
    const double half = grid.cell_mm * std::sqrt(0.5);
    for (std::size_t c = 0; c < grid.points.size(); ++c) {
        const std::size_t column = c % grid.side, line = c / grid.side;
        const double x = (static_cast<double>(column) + 0.5) * grid.cell_mm - face.outer_mm,
                     y = (static_cast<double>(line) + 0.5) * grid.cell_mm - face.outer_mm;
        const double r = std::hypot(x, y);
        if (r - half < face.inner_mm || r + half > face.outer_mm) {
            grid.points[c] = -1;
            continue;
        }
        cells += 1;
        seen += grid.points[c] > 0 ? 1 : 0;
        sum += static_cast<double>(grid.points[c]);
    }
    if (seen < faceThresholds.seen_share * cells || seen == 0) return std::nullopt;
    grid.mean = sum / seen;
    return grid;
}

/// Round places without points; none where the face is seen in patches only.
std::vector<FaceHole> holesOn(const FaceGrid& grid, const SeenFace& face)
{
    std::vector<std::uint8_t> empty(grid.points.size(), 0);
    double cells = 0, others = 0;
    for (std::size_t c = 0; c < empty.size(); ++c) {
        if (grid.points[c] < 0) continue;
        cells += 1;
        empty[c] = static_cast<double>(grid.points[c]) <= faceThresholds.empty_share * grid.mean ? 1 : 0;
    }
    std::vector<FaceHole> holes;
    const double cell_mm2 = grid.cell_mm * grid.cell_mm;
    for (const std::vector<std::size_t>& region : connectedRegions(empty, grid.side, false)) {
        const RegionBox box = boxOf(region, grid.side, false);
        const double area = static_cast<double>(region.size()) * cell_mm2;
        if (area < faceThresholds.least_hole_mm2 ||
            !isRound(region, box, grid.cell_mm, grid.cell_mm, faceThresholds.most_aspect, faceThresholds.most_fill)) {
            others += static_cast<double>(region.size());
            continue;
        }
        const auto middle = [&](std::size_t first, std::size_t last) {
            return static_cast<double>(first + last + 1) / 2 * grid.cell_mm - face.outer_mm;
        };
        holes.push_back({middle(box.first_column, box.last_column), middle(box.first_row, box.last_row), area});
    }
    if (others > faceThresholds.most_missing * cells) holes.clear();
    return holes;
}

bool isBolt(const FaceHole& hole, double z_mm, const std::vector<ShaftMark>& marks)
{
    return std::any_of(marks.begin(), marks.end(), [&](const ShaftMark& mark) {
        if (mark.kind != MarkKind::BoltCircle || !mark.diameter_mm || !mark.pitch_circle_mm || !mark.count)
            return false;
        const double near_mm = *mark.diameter_mm / 2, radius_mm = *mark.pitch_circle_mm / 2;
        if (std::min(std::abs(z_mm - *mark.z_start_mm), std::abs(z_mm - *mark.z_end_mm)) > faceThresholds.rim_mm)
            return false;
        const double off_rad = std::remainder(
            std::atan2(hole.y_mm, hole.x_mm) - mark.angle_deg.value_or(0) / deg_per_rad, turn_rad / *mark.count);
        return std::abs(std::hypot(hole.x_mm, hole.y_mm) - radius_mm) < near_mm &&
               radius_mm * std::abs(off_rad) < near_mm;
    });
}

}  // namespace

std::vector<SeenFace> seenFaces(const MeridianCloud& cloud, const Outline& outside, const Outline* bore,
                                const Progress& progress)
{
    std::vector<SeenFace> seen;
    if (!outside.surface_scan) return seen;
    const double near = faceThresholds.near_sigmas * outside.model.sigma_mm + faceThresholds.near_mm;
    for (SeenFace& face : facesOf(outside, bore)) {
        progress.check();
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
            const auto z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
            if (std::abs(z - face.z_mm) > near || r < face.inner_mm || r > face.outer_mm) continue;
            const double angle = turn_rad * static_cast<double>(cloud.turn[i]);
            face.places_mm.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        const std::optional<FaceGrid> grid = gridOf(face);
        if (!grid) continue;
        face.holes = holesOn(*grid, face);
        seen.push_back(std::move(face));
    }
    return seen;
}

std::vector<UnexplainedStructure> holesInFaces(const std::vector<SeenFace>& faces, const std::vector<ShaftMark>& marks)
{
    std::vector<UnexplainedStructure> all;
    for (const SeenFace& face : faces) {
        UnexplainedStructure found;
        found.kind = StructureKind::NoPoints;
        found.z_start_mm = found.z_end_mm = face.z_mm;
        found.places = 0;
        for (const FaceHole& hole : face.holes) {
            if (isBolt(hole, face.z_mm, marks)) continue;
            ++found.places;
            found.area_mm2 += hole.area_mm2;
        }
        if (found.places > 0) all.push_back(found);
    }
    return all;
}

}  // namespace lathelier::features
