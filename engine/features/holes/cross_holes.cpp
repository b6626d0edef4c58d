#include "engine/features/holes/cross_holes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/holes/hole_floor.h"
#include "engine/features/holes/hole_limits.h"
#include "engine/features/holes/hole_rim.h"
#include "engine/features/marks/off_regions.h"
#include "engine/features/structure/map_cells.h"
#include "engine/features/structure/map_regions.h"
#include "engine/features/structure/unexplained.h"

namespace lathelier::features {
namespace {

/// A rim with its place about the axis of the part.
struct WallHole {
    RoundHole rim;
    double angle_rad = 0;  ///< about the axis
    double radius_mm = 0;  ///< of the wall there
    std::optional<double> depth_mm;
};

/// Cells where the wall is missing: without points, or with points below.
std::vector<std::uint8_t> missingCells(const ResidualMap& map, double form_mm)
{
    std::vector<std::uint8_t> missing = emptyCells(map);
    const std::vector<std::uint8_t> off = offCells(map, form_mm);
    for (std::size_t c = 0; c < missing.size(); ++c) {
        const MapCell& cell = map.cells[c];
        if (off[c] && cell.far > cell.on && cell.far_sum_mm < 0) missing[c] = 1;
    }
    return missing;
}

/// The hole that takes the wall away in a region.
std::optional<WallHole> holeIn(const WallScan& scan, const ResidualMap& map, const SurfaceTable& surface,
                               const std::vector<std::size_t>& region, const Progress& progress)
{
    const RegionBox box = boxOf(region, mapSectors, true);
    const double z = map.first_mm + map.cell_mm * static_cast<double>(box.first_row + box.last_row + 1) / 2;
    const double radius = static_cast<double>(surface.at(z).radius_mm);
    const Run* const run = smoothRunAt(scan.model, z);
    if (!run || !(radius > 0)) return std::nullopt;
    const double column = turn_rad * radius / mapThresholds.sectors;
    const double length = map.cell_mm * static_cast<double>(box.rows()),
                 width = column * static_cast<double>(box.columns());
    if (static_cast<double>(region.size()) * map.cell_mm * column < holeLimits.least_area_mm2) return std::nullopt;
    // A box of few cells says little of the shape.
    const double longer = std::max(length, width) - std::max(map.cell_mm, column), shorter = std::min(length, width);
    if (longer > holeLimits.most_aspect * shorter || longer > 2 * holeLimits.most_radius_share * radius)
        return std::nullopt;
    const double half = (length + width) / 4 + map.cell_mm / 4;
    WallHole found;
    found.radius_mm = radius;
    const double middle =
        turn_rad / mapThresholds.sectors * static_cast<double>(box.first_column + box.last_column + 1) / 2;
    WallWindow window{z - half - holeLimits.beside_mm, z + half + holeLimits.beside_mm, middle, 0};
    window.half_rad = std::asin(std::min(std::sin(holeLimits.most_half_rad), (half + holeLimits.beside_mm) / radius));
    window = withinRun(*run, window);
    const auto hole = roundHole(raysAt(scan, *run, window, progress), circleRim(z, 0, half), progress);
    if (!hole) return std::nullopt;
    found.rim = *hole;
    found.angle_rad = middle + std::asin(std::clamp(hole->across_mm / radius, -1.0, 1.0));
    found.radius_mm = radiusAt_mm(*run, hole->z_mm);
    const HoleFloor floor = floorOf(scan.cloud, {hole->z_mm, found.angle_rad, hole->diameter_mm / 2, found.radius_mm},
                                    wallLimit_mm(scan.model));
    if (floor.is_dent) return std::nullopt;
    found.depth_mm = floor.depth_mm;
    return found;
}

/// All holes with a proven rim; none where the scan has patches without points, which may be round.
std::vector<WallHole> wallHoles(const WallScan& scan, const ResidualMap& map, const SurfaceTable& surface,
                                double form_mm, const Progress& progress)
{
    std::vector<WallHole> holes;
    std::size_t patches = 0;
    std::vector<std::vector<std::size_t>> regions = connectedRegions(missingCells(map, form_mm), mapSectors, true);
    std::erase_if(regions, [](const auto& region) { return region.size() < holeLimits.least_cells; });
    if (regions.size() > holeLimits.most_regions) return holes;
    for (const std::vector<std::size_t>& region : regions) {
        progress.check();
        if (const auto hole = holeIn(scan, map, surface, region, progress))
            holes.push_back(*hole);
        else
            patches += static_cast<std::size_t>(std::count_if(
                region.begin(), region.end(), [&](std::size_t c) { return map.cells[c].on + map.cells[c].far == 0; }));
    }
    if (static_cast<double>(patches) > structureThresholds.most_missing * static_cast<double>(map.cells.size()))
        holes.clear();
    return holes;
}

bool areOpposite(const WallHole& a, const WallHole& b)
{
    const double place = holeLimits.pair_mm +
                         holeLimits.pair_sigmas * std::hypot(a.rim.place_sigma_mm, b.rim.place_sigma_mm),
                 size = holeLimits.pair_mm +
                        holeLimits.pair_sigmas * std::hypot(a.rim.diameter_sigma_mm, b.rim.diameter_sigma_mm);
    const double aside = a.radius_mm * std::abs(std::remainder(a.angle_rad - b.angle_rad - turn_rad / 2, turn_rad));
    return std::abs(a.rim.z_mm - b.rim.z_mm) < place && aside < place &&
           std::abs(a.rim.diameter_mm - b.rim.diameter_mm) < size;
}

/// Drops holes without a floor where there are many that are not all equal: round places that the scanner did not see.
void dropPatches(std::vector<WallHole>& single)
{
    std::vector<double> diameters_mm;
    for (const WallHole& hole : single)
        if (!hole.depth_mm) diameters_mm.push_back(hole.rim.diameter_mm);
    if (diameters_mm.size() <= holeLimits.most_lone) return;
    const auto [least, most] = std::minmax_element(diameters_mm.begin(), diameters_mm.end());
    if (*most - *least > holeLimits.pair_mm) std::erase_if(single, [](const WallHole& hole) { return !hole.depth_mm; });
}

/// Is the wall seen opposite a hole?
bool isWallOpposite(const WallScan& scan, const WallHole& hole, const Progress& progress)
{
    const Run* const run = smoothRunAt(scan.model, hole.rim.z_mm);
    if (!run) return false;
    const double half = hole.rim.diameter_mm / 2;
    const WallWindow there{hole.rim.z_mm - half, hole.rim.z_mm + half, hole.angle_rad + turn_rad / 2,
                           std::asin(std::min(0.9, half / hole.radius_mm))};
    const WallWindow aside{there.from_mm, there.to_mm, hole.angle_rad + turn_rad / 4, there.half_rad};
    const auto points = [&](const WallWindow& window) {
        const RimView view = raysAt({scan.cloud, scan.model, {}, true}, *run, window, progress);
        return static_cast<double>(view.rays.size());
    };
    return points(there) > holeLimits.opposite_share * points(aside);
}

double degrees(double angle_rad)
{
    const double turn = angle_rad / turn_rad;
    return 360 * (turn - std::floor(turn));
}

ShaftMark markOfHole(const WallHole& hole)
{
    ShaftMark mark{MarkKind::CrossHole};
    mark.z_start_mm = hole.rim.z_mm - hole.rim.diameter_mm / 2;
    mark.z_end_mm = hole.rim.z_mm + hole.rim.diameter_mm / 2;
    mark.angle_deg = degrees(hole.angle_rad);
    mark.diameter_mm = hole.rim.diameter_mm;
    mark.uncertainty_mm = 2 * hole.rim.diameter_sigma_mm;
    // Of its middle: half of what its two edges may be broken by.
    mark.place_uncertainty_mm = 2 * std::hypot(hole.rim.place_sigma_mm, holeLimits.form_mm / 2);
    mark.angle_uncertainty_deg = *mark.place_uncertainty_mm / hole.radius_mm * deg_per_rad;
    return mark;
}

/// One hole of two rims: their means, weighted by their uncertainties.
ShaftMark markOfPair(const WallHole& a, const WallHole& b)
{
    const double wa = 1 / (a.rim.diameter_sigma_mm * a.rim.diameter_sigma_mm),
                 wb = 1 / (b.rim.diameter_sigma_mm * b.rim.diameter_sigma_mm);
    WallHole both = degrees(a.angle_rad) < degrees(b.angle_rad) ? a : b;
    both.rim.z_mm = (wa * a.rim.z_mm + wb * b.rim.z_mm) / (wa + wb);
    both.rim.diameter_mm = (wa * a.rim.diameter_mm + wb * b.rim.diameter_mm) / (wa + wb);
    both.rim.diameter_sigma_mm = std::max(holeLimits.form_mm, std::sqrt(1 / (wa + wb)));
    ShaftMark mark = markOfHole(both);
    mark.through = 1;
    return mark;
}

bool startsBefore(const ShaftMark& a, const ShaftMark& b)
{
    return a.z_start_mm < b.z_start_mm;
}

}  // namespace

std::vector<ShaftMark> crossHoles(const WallScan& scan, const ResidualMap& map, const SurfaceTable& surface,
                                  double form_mm, const Progress& progress)
{
    const std::vector<WallHole> holes = wallHoles(scan, map, surface, form_mm, progress);
    std::vector<ShaftMark> marks;
    std::vector<WallHole> single;
    std::vector<std::uint8_t> taken(holes.size(), 0);
    for (std::size_t i = 0; i < holes.size(); ++i) {
        for (std::size_t k = i + 1; k < holes.size() && !taken[i]; ++k)
            if (!taken[k] && areOpposite(holes[i], holes[k])) {
                taken[i] = taken[k] = 1;
                marks.push_back(markOfPair(holes[i], holes[k]));
                break;
            }
        if (!taken[i]) single.push_back(holes[i]);
    }
    dropPatches(single);
    for (const WallHole& hole : single) {
        ShaftMark mark = markOfHole(hole);
        mark.depth_mm = hole.depth_mm;
        if (mark.depth_mm || isWallOpposite(scan, hole, progress)) mark.through = 0;
        marks.push_back(std::move(mark));
    }
    std::sort(marks.begin(), marks.end(), startsBefore);
    return marks;
}

std::vector<ShaftMark> withHoles(std::vector<ShaftMark> marks, std::vector<ShaftMark> holes)
{
    const auto isKeywayAt = [](const ShaftMark& mark, const ShaftMark& hole) {
        if (mark.kind != MarkKind::Keyway || hole.kind != MarkKind::CrossHole) return false;
        const double apart_deg = std::abs(std::remainder(*mark.angle_deg - *hole.angle_deg, 360));
        const double along_mm = std::min(*mark.z_end_mm, *hole.z_end_mm) - std::max(*mark.z_start_mm, *hole.z_start_mm);
        return (apart_deg < holeLimits.same_deg ||
                (hole.through.value_or(0) > 0 && apart_deg > 180 - holeLimits.same_deg)) &&
               along_mm > *hole.diameter_mm / 2;
    };
    const auto isLong = [](const ShaftMark& slot, const ShaftMark& hole) {
        return *slot.z_end_mm - *slot.z_start_mm > holeLimits.slot_length * *hole.diameter_mm;
    };
    std::erase_if(holes, [&](const ShaftMark& hole) {
        return std::any_of(marks.begin(), marks.end(),
                           [&](const ShaftMark& mark) { return isKeywayAt(mark, hole) && isLong(mark, hole); });
    });
    std::erase_if(marks, [&](const ShaftMark& mark) {
        return std::any_of(holes.begin(), holes.end(), [&](const ShaftMark& hole) { return isKeywayAt(mark, hole); });
    });
    marks.insert(marks.end(), holes.begin(), holes.end());
    std::stable_sort(marks.begin(), marks.end(), startsBefore);
    return marks;
}

}  // namespace lathelier::features
