#include "engine/features/structure/unexplained.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/features/structure/map_cells.h"
#include "engine/features/structure/map_regions.h"

namespace lathelier::features {
namespace {

/// Where a cell lies, and where its points do.
struct CellPlace {
    double z_mm = 0, angle_rad = 0;
    double wall_mm = 1;    ///< radius of the wall
    double points_mm = 1;  ///< of the points on another surface, where they are most of the cell; else that of the wall
};

CellPlace placeOf(const ResidualMap& map, const SurfaceTable& surface, std::size_t c)
{
    const MapCell& cell = map.cells[c];
    CellPlace place;
    place.z_mm = map.middle_mm(c / mapSectors);
    place.angle_rad = turn_rad * (static_cast<double>(c % mapSectors) + 0.5) / mapSectors;
    place.wall_mm = place.points_mm = std::max(1e-3, static_cast<double>(surface.at(place.z_mm).radius_mm));
    if (cell.far > cell.on) place.points_mm += static_cast<double>(cell.far_sum_mm / static_cast<float>(cell.far));
    return place;
}

/// Does a hole across the axis cover the place, or hold its points? Near the axis these have any direction.
bool isInHole(const ShaftMark& hole, const CellPlace& place)
{
    const double off_rad = place.angle_rad - *hole.angle_deg / deg_per_rad, half_mm = *hole.diameter_mm / 2;
    if (std::abs(place.points_mm * std::sin(off_rad)) < half_mm && place.points_mm < place.wall_mm) return true;
    const double period_rad = hole.through.value_or(0) > 0 ? turn_rad / 2 : turn_rad;
    const double half_rad =
        std::asin(std::min(1.0, half_mm / place.wall_mm)) + structureThresholds.beside_mark_mm / place.wall_mm;
    return std::abs(std::remainder(off_rad, period_rad)) < half_rad;
}

/// Does a named mark cover the place?
bool isNamed(const std::vector<ShaftMark>& marks, const CellPlace& place)
{
    return std::any_of(marks.begin(), marks.end(), [&](const ShaftMark& mark) {
        if (!mark.z_start_mm || !mark.z_end_mm || mark.kind == MarkKind::BoltCircle) return false;
        const double rim = structureThresholds.beside_mark_mm;
        if (place.z_mm < *mark.z_start_mm - rim || place.z_mm > *mark.z_end_mm + rim) return false;
        if (mark.kind == MarkKind::CrossHole) return isInHole(mark, place);
        if (!mark.angle_deg || !mark.width_mm || mark.kind == MarkKind::Spline) return true;
        const double half = std::asin(std::min(1.0, *mark.width_mm / (2 * place.wall_mm))) + rim / place.wall_mm;
        return std::abs(std::remainder(place.angle_rad - *mark.angle_deg / deg_per_rad, turn_rad)) < half;
    });
}

double columnWidth_mm(const SurfaceTable& surface, double z_mm)
{
    return turn_rad * static_cast<double>(surface.at(z_mm).radius_mm) / mapThresholds.sectors;
}

/// Box, area and height of a region.
UnexplainedStructure structureOf(const ResidualMap& map, const SurfaceTable& surface,
                                 const std::vector<std::size_t>& region)
{
    const RegionBox box = boxOf(region, mapSectors, true);
    UnexplainedStructure found;
    found.z_start_mm = map.first_mm + map.cell_mm * static_cast<double>(box.first_row);
    found.z_end_mm = map.first_mm + map.cell_mm * static_cast<double>(box.last_row + 1);
    const double sector_deg = 360.0 / mapThresholds.sectors;
    found.span_deg = sector_deg * static_cast<double>(box.columns());
    found.angle_deg = std::fmod(sector_deg * (static_cast<double>(box.first_column + box.last_column) + 1) / 2, 360.0);
    double height = 0;
    for (const std::size_t c : region) {
        const MapCell& cell = map.cells[c];
        found.area_mm2 += map.cell_mm * columnWidth_mm(surface, map.middle_mm(c / mapSectors));
        const bool is_far = cell.far > cell.on;
        const auto count = static_cast<float>(is_far ? cell.far : cell.on);
        if (count == 0) continue;
        const double mean = static_cast<double>((is_far ? cell.far_sum_mm : cell.sum_mm) / count);
        if (std::abs(mean) > std::abs(height)) height = mean;
    }
    found.kind = height > 0 ? StructureKind::Raised : StructureKind::Sunken;
    found.height_mm = height;
    return found;
}

bool isNamed(const std::vector<ShaftMark>& marks, const ResidualMap& map, const SurfaceTable& surface,
             const std::vector<std::size_t>& region)
{
    std::size_t named = 0;
    for (const std::size_t c : region)
        if (isNamed(marks, placeOf(map, surface, c))) ++named;
    return 2 * named > region.size();
}

/// Round places without points; none where the scan has patches without points.
std::vector<std::vector<std::size_t>> holesOf(const ResidualMap& map, const SurfaceTable& surface)
{
    const std::vector<std::uint8_t> empty = emptyCells(map);
    std::vector<std::vector<std::size_t>> round;
    std::size_t others = 0;
    for (std::vector<std::size_t>& region : connectedRegions(empty, mapSectors, true)) {
        const RegionBox box = boxOf(region, mapSectors, true);
        const double width = columnWidth_mm(surface, map.middle_mm((box.first_row + box.last_row) / 2));
        const double area = static_cast<double>(region.size()) * map.cell_mm * width;
        if (area >= structureThresholds.least_hole_mm2 &&
            isRound(region, box, map.cell_mm, width, structureThresholds.most_aspect, structureThresholds.most_fill))
            round.push_back(std::move(region));
        else
            others += region.size();
    }
    if (static_cast<double>(others) > structureThresholds.most_missing * static_cast<double>(map.cells.size()))
        round.clear();
    return round;
}

/// Structures of one kind over the same stretch are one, at several places.
void joinAround(std::vector<UnexplainedStructure>& all)
{
    std::vector<UnexplainedStructure> joined;
    for (const UnexplainedStructure& one : all) {
        const auto same = std::find_if(joined.begin(), joined.end(), [&](const UnexplainedStructure& other) {
            const double shared = std::min(one.z_end_mm, other.z_end_mm) - std::max(one.z_start_mm, other.z_start_mm);
            const double longer = std::max(one.z_end_mm - one.z_start_mm, other.z_end_mm - other.z_start_mm);
            return one.kind == other.kind && shared >= structureThresholds.same_z_share * longer;
        });
        if (same == joined.end()) {
            joined.push_back(one);
            continue;
        }
        same->z_start_mm = std::min(same->z_start_mm, one.z_start_mm);
        same->z_end_mm = std::max(same->z_end_mm, one.z_end_mm);
        same->area_mm2 += one.area_mm2;
        ++same->places;
        same->angle_deg.reset();
        same->span_deg.reset();
        if (one.height_mm && std::abs(*one.height_mm) > std::abs(same->height_mm.value_or(0)))
            same->height_mm = one.height_mm;
    }
    all = std::move(joined);
}

/// Zones too rough for a row that no thread or knurl explains.
void addRoughZones(const Outline& outside, const std::vector<ShaftMark>& marks, std::vector<UnexplainedStructure>& all)
{
    for (const RoughZone& zone : outside.rough) {
        const double middle = (zone.z_start_mm + zone.z_end_mm) / 2;
        const bool named = std::any_of(marks.begin(), marks.end(), [&](const ShaftMark& mark) {
            return mark.z_start_mm && *mark.z_start_mm<middle&& * mark.z_end_mm> middle;
        });
        if (named) continue;
        UnexplainedStructure found;
        found.kind = zone.eccentric_mm > 0 ? StructureKind::Eccentric : StructureKind::Rough;
        found.z_start_mm = zone.z_start_mm;
        found.z_end_mm = zone.z_end_mm;
        for (const Run& run : outside.model.runs) {
            const Element& crest = run.elements.front();
            if (!crest.rough || run.nodes_mm.front() > middle || run.nodes_mm.back() < middle) continue;
            found.area_mm2 = turn_rad * crest.level_mm * (zone.z_end_mm - zone.z_start_mm);
            found.height_mm = zone.eccentric_mm > 0 ? zone.eccentric_mm : crest.root_mm - crest.level_mm;
        }
        all.push_back(found);
    }
}

}  // namespace

std::vector<UnexplainedStructure> unexplainedOutside(const ResidualMap& map, const SurfaceTable& surface,
                                                     const Outline& outside, const std::vector<ShaftMark>& marks,
                                                     double form_mm, const Progress& progress)
{
    std::vector<UnexplainedStructure> all;
    const std::vector<std::uint8_t> off = offCells(map, form_mm);
    for (const std::vector<std::size_t>& region : connectedRegions(off, mapSectors, true)) {
        progress.check();
        if (region.size() < structureThresholds.least_cells || isNamed(marks, map, surface, region)) continue;
        all.push_back(structureOf(map, surface, region));
    }
    for (const std::vector<std::size_t>& region : holesOf(map, surface)) {
        progress.check();
        if (isNamed(marks, map, surface, region)) continue;
        all.push_back(structureOf(map, surface, region));
        all.back().kind = StructureKind::NoPoints;  // the few points are those of its rim
        all.back().height_mm.reset();
    }
    joinAround(all);
    addRoughZones(outside, marks, all);
    std::stable_sort(all.begin(), all.end(), [](const UnexplainedStructure& a, const UnexplainedStructure& b) {
        return a.z_start_mm < b.z_start_mm;
    });
    return all;
}

}  // namespace lathelier::features
