// Residuals of the points over the surface of a fitted outline, in cells along z and around the axis: what the model
// leaves, place by place.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/core/progress.h"
#include "engine/features/outline/outline.h"

namespace lathelier::features {

/// Thresholds of the map.
struct MapThresholds {
    double cell_mm = 1;        ///< along z; a tenth of the shortest seat that is judged
    double most_cells = 5000;  ///< along z: those of a longer part are longer
    int steps_of_cell = 50;    ///< of the tabulated radius; at a slope of 45° 10 µm, a fifth of the usual noise
    int sectors = 144;         ///< around the axis, as of the walls: 2.5°
    double edge_mm = 0.4;      ///< beside the planes of a run: the spot and the lean of rays blur the wall there
    double far_sigmas = 5;     ///< points beyond this and `far_mm` lie on another surface
    double far_mm = 0.1;       ///< likewise: waviness and steps of the walls of ordinary scans
};
inline constexpr MapThresholds mapThresholds{};
inline constexpr auto mapSectors = static_cast<std::size_t>(mapThresholds.sectors);

/// Radius of an outline by z, tabulated; nothing in gaps, in rough zones and beside planes.
class SurfaceTable {
public:
    explicit SurfaceTable(const Model& model);

    struct Place {
        float radius_mm = 0;       ///< of the model
        float cosine = 1;          ///< of the angle between the normal and the radius
        std::int32_t run = -1;     ///< index into Model::runs; -1: no wall
        std::int32_t element = 0;  ///< index into its elements
    };
    /// The place at z; run -1 outside.
    const Place& at(double z_mm) const
    {
        const double index = (z_mm - first_mm_) / step_mm_;
        if (!(index >= 0) || index >= static_cast<double>(places_.size())) return nowhere_;
        return places_[static_cast<std::size_t>(index)];
    }
    double first_mm() const { return first_mm_; }
    double last_mm() const { return first_mm_ + step_mm_ * static_cast<double>(places_.size()); }
    double cell_mm() const { return mapThresholds.steps_of_cell * step_mm_; }  ///< of a map of this surface, along z

private:
    double first_mm_ = 0, step_mm_ = 0;
    std::vector<Place> places_;
    Place nowhere_;
};

/// Points of one cell.
struct MapCell {
    std::uint32_t on = 0;   ///< number of points on the wall
    std::uint32_t far = 0;  ///< number of points on another surface
    float sum_mm = 0;       ///< sum of the residuals of those on the wall, along the normal
    float sine2 = 0;        ///< sum of sin² of the angle between normal and radius, of the same points
    float far_sum_mm = 0;   ///< sum of the residuals of the others, along the radius
};

inline constexpr std::size_t filePasses = 4;  ///< parts of the file, in the order of its points

/// Points of one cell on the wall by parts of the file.
struct CellOrder {
    std::array<std::uint32_t, filePasses> on{};
    std::array<float, filePasses> sum_mm{};

    double total_mm() const
    {
        double sum = 0;
        for (const float one : sum_mm) sum += static_cast<double>(one);
        return sum;
    }
};

struct ResidualMap {
    double first_mm = 0;           ///< z of the first row of cells, in the frame of the outline
    double cell_mm = 1;            ///< length of a cell along z
    std::size_t rows = 0;          ///< number of rows of cells
    std::vector<MapCell> cells;    ///< by row, then sector
    std::vector<CellOrder> order;  ///< of the same cells
    double sigma_mm = 0;           ///< noise of single points
    double spot_mm = 0;            ///< a point is read anywhere within this width along z

    /// Standard deviation of the mean residual of a cell from both; the spot counts on slopes.
    double noise_mm(const MapCell& cell) const
    {
        const double n = std::max(1.0, static_cast<double>(cell.on));
        return std::sqrt(sigma_mm * sigma_mm * n + spot_mm * spot_mm / 12 * static_cast<double>(cell.sine2)) / n;
    }
    const MapCell& at(std::size_t row, std::size_t sector) const { return cells[row * mapSectors + sector]; }
    std::size_t rowOf(double z_mm) const { return static_cast<std::size_t>((z_mm - first_mm) / cell_mm); }
    double middle_mm(std::size_t row) const { return first_mm + (static_cast<double>(row) + 0.5) * cell_mm; }
};

/// The map of the outside. `bore`: points nearer to its radius than to that of the outside are none of it; nullptr
/// without one. Throws Cancelled.
ResidualMap residualMap(const MeridianCloud& cloud, const SurfaceTable& surface, const Model& outside,
                        const Outline* bore, const Progress& progress = {});

/// Radius of the bore at z, or of its run that is nearest; 0 without one.
double boreRadius_mm(const Outline* bore, double z_mm);

}  // namespace lathelier::features
