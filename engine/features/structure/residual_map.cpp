#include "engine/features/structure/residual_map.h"

#include <algorithm>
#include <cmath>

namespace lathelier::features {
namespace {

/// Radii of a bore at the places of a table; empty without one.
std::vector<float> boreRadii(const Outline* bore, const SurfaceTable& surface)
{
    std::vector<float> radii;
    if (!bore) return radii;
    for (double z = surface.first_mm(); z < surface.last_mm(); z += surface.cell_mm() / 2)
        radii.push_back(static_cast<float>(boreRadius_mm(bore, z)));
    return radii;
}

}  // namespace

double boreRadius_mm(const Outline* bore, double z_mm)
{
    double nearest_mm = HUGE_VAL, radius_mm = 0;
    if (!bore) return radius_mm;
    for (const Run& run : bore->model.runs) {
        const double at = std::clamp(z_mm, run.nodes_mm.front(), run.nodes_mm.back());
        if (std::abs(z_mm - at) >= nearest_mm) continue;
        nearest_mm = std::abs(z_mm - at);
        radius_mm = radiusAt_mm(run, at);
    }
    return radius_mm;
}

SurfaceTable::SurfaceTable(const Model& model) : first_mm_(model.planes.front().z_mm)
{
    const double length = std::max(0.0, model.planes.back().z_mm - first_mm_), edge = mapThresholds.edge_mm;
    step_mm_ = std::max(mapThresholds.cell_mm, length / mapThresholds.most_cells) / mapThresholds.steps_of_cell;
    const double step = step_mm_;
    places_.resize(static_cast<std::size_t>(length / step) + 1);
    for (std::size_t r = 0; r < model.runs.size(); ++r) {
        const Run& run = model.runs[r];
        if (run.elements.front().rough) continue;
        const double from = run.nodes_mm.front() + edge, to = run.nodes_mm.back() - edge;
        std::size_t element = 0;
        const auto begin = static_cast<std::size_t>(std::max(0.0, std::ceil((from - first_mm_) / step - 0.5)));
        for (std::size_t i = begin; i < places_.size(); ++i) {
            const double z = first_mm_ + (static_cast<double>(i) + 0.5) * step;
            if (z > to) break;
            while (element + 1 < run.elements.size() && z > run.nodes_mm[element + 1]) ++element;
            const double slope = run.elements[element].slopeAt(z);
            places_[i] = {static_cast<float>(run.elements[element].radiusAt_mm(z)),
                          static_cast<float>(1 / std::sqrt(1 + slope * slope)), static_cast<std::int32_t>(r),
                          static_cast<std::int32_t>(element)};
        }
    }
}

ResidualMap residualMap(const MeridianCloud& cloud, const SurfaceTable& surface, const Model& outside,
                        const Outline* bore, const Progress& progress)
{
    constexpr std::size_t checkEvery = 1U << 16U;
    ResidualMap map;
    map.first_mm = surface.first_mm();
    map.cell_mm = surface.cell_mm();
    map.sigma_mm = outside.sigma_mm;
    map.spot_mm = outside.spot_mm;
    map.rows = static_cast<std::size_t>((surface.last_mm() - map.first_mm) / map.cell_mm) + 1;
    map.cells.resize(map.rows * mapSectors);
    map.order.resize(map.cells.size());
    const auto limit = static_cast<float>(mapThresholds.far_sigmas * map.sigma_mm + mapThresholds.far_mm);
    const std::vector<float> bore_mm = boreRadii(bore, surface);
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        if (i % checkEvery == 0) progress.check();
        const auto z = static_cast<double>(cloud.z_mm[i]);
        const SurfaceTable::Place& place = surface.at(z);
        if (place.run < 0) continue;
        if (!bore_mm.empty()) {
            const auto b = static_cast<std::size_t>((z - map.first_mm) / (map.cell_mm / 2));
            if (cloud.r_mm[i] < (place.radius_mm + bore_mm[std::min(b, bore_mm.size() - 1)]) / 2) continue;
        }
        const auto sector = static_cast<std::size_t>(cloud.turn[i] * static_cast<float>(mapSectors));
        const std::size_t index = map.rowOf(z) * mapSectors + std::min(sector, mapSectors - 1);
        MapCell& cell = map.cells[index];
        const float off = cloud.r_mm[i] - place.radius_mm;
        if (std::abs(off) > limit) {
            ++cell.far;
            cell.far_sum_mm += off;
        } else {
            ++cell.on;
            cell.sum_mm += off * place.cosine;
            cell.sine2 += 1 - place.cosine * place.cosine;
            CellOrder& order = map.order[index];
            const std::size_t part = i * filePasses / cloud.z_mm.size();
            ++order.on[part];
            order.sum_mm[part] += off * place.cosine;
        }
    }
    return map;
}

}  // namespace lathelier::features
