#include "engine/features/structure/unexplained.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/structure/map_regions.h"

namespace lathelier::features {
namespace {

/// Means of the cells about the median of their ring; NaN where too few points are.
struct CellMeans {
    std::vector<float> mean_mm;
    double scatter = 1;  ///< robust standard deviation of mean·√n, over σ; 1 for white noise
};

CellMeans cellMeans(const ResidualMap& map)
{
    CellMeans means;
    means.mean_mm.assign(map.cells.size(), std::numeric_limits<float>::quiet_NaN());
    std::vector<float> ring, weighted;
    for (std::size_t row = 0; row < map.rows; ++row) {
        ring.clear();
        for (std::size_t s = 0; s < mapSectors; ++s) {
            const MapCell& cell = map.at(row, s);
            if (cell.on < structureThresholds.least_points) continue;
            ring.push_back(means.mean_mm[row * mapSectors + s] = cell.sum_mm / static_cast<float>(cell.on));
        }
        const float middle = upperMedianInPlace(ring);
        for (std::size_t s = 0; s < mapSectors; ++s) {
            float& mean = means.mean_mm[row * mapSectors + s];
            if (std::isnan(mean)) continue;
            mean -= middle;
            weighted.push_back(std::abs(mean) * std::sqrt(static_cast<float>(map.at(row, s).on)));
        }
    }
    const double sigma = std::max(map.sigma_mm, 1e-6);
    if (!weighted.empty())
        means.scatter = std::max(1.0, madToSigma * static_cast<double>(upperMedianInPlace(weighted)) / sigma);
    return means;
}

/// Cells where most points lie on another surface, or the mean is off by more than noise and form.
std::vector<std::uint8_t> offCells(const ResidualMap& map, const CellMeans& means, double form_mm)
{
    std::vector<std::uint8_t> off(map.cells.size(), 0);
    for (std::size_t c = 0; c < off.size(); ++c) {
        const MapCell& cell = map.cells[c];
        const bool is_far = cell.far >= structureThresholds.least_far && cell.far > cell.on;
        const double mean = std::abs(static_cast<double>(means.mean_mm[c]));
        const double noise = means.scatter * map.sigma_mm / std::sqrt(std::max(1.0, static_cast<double>(cell.on)));
        off[c] = is_far || (mean > form_mm && mean > structureThresholds.sigmas * noise) ? 1 : 0;  // false for NaN
    }
    return off;
}

/// Cells that hold hardly any points where their ring does; a window of three mapSectors bridges the pitch of the rays.
std::vector<std::uint8_t> emptyCells(const ResidualMap& map)
{
    std::vector<std::uint8_t> empty(map.cells.size(), 0);
    std::vector<float> window(mapSectors), sorted;
    for (std::size_t row = 0; row < map.rows; ++row) {
        const auto points = [&](std::size_t s) {
            const MapCell& cell = map.at(row, s % mapSectors);
            return static_cast<float>(cell.on + cell.far);
        };
        for (std::size_t s = 0; s < mapSectors; ++s) window[s] = points(s + mapSectors - 1) + points(s) + points(s + 1);
        sorted = window;
        const float usual = upperMedianInPlace(sorted);
        if (usual < structureThresholds.least_usual) continue;
        for (std::size_t s = 0; s < mapSectors; ++s)
            empty[row * mapSectors + s] = window[s] <= structureThresholds.empty_share * usual ? 1 : 0;
    }
    return empty;
}

/// Does a named mark cover the place? Angles as shares of a turn.
bool isNamed(const std::vector<ShaftMark>& marks, double z_mm, double turn, double radius_mm)
{
    return std::any_of(marks.begin(), marks.end(), [&](const ShaftMark& mark) {
        if (!mark.z_start_mm || !mark.z_end_mm) return false;
        const double rim = structureThresholds.beside_mark_mm;
        if (z_mm < *mark.z_start_mm - rim || z_mm > *mark.z_end_mm + rim) return false;
        if (!mark.angle_deg || !mark.width_mm || mark.kind == MarkKind::Spline) return true;
        const double half = std::asin(std::min(1.0, *mark.width_mm / (2 * radius_mm))) + rim / radius_mm;
        return std::abs(std::remainder(turn * turn_rad - *mark.angle_deg / deg_per_rad, turn_rad)) < half;
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
    for (const std::size_t c : region) {
        const double z = map.middle_mm(c / mapSectors), turn = (static_cast<double>(c % mapSectors) + 0.5) / mapSectors;
        if (isNamed(marks, z, turn, std::max(1e-3, static_cast<double>(surface.at(z).radius_mm)))) ++named;
    }
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
    const std::vector<std::uint8_t> off = offCells(map, cellMeans(map), form_mm);
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
