#include "engine/features/marks/off_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/features/marks/mark_limits.h"

namespace lathelier::features {
namespace {

/// Radius of the bore at z, or of its run that is nearest; 0 without one.
double boreAt(const Outline* bore, double z_mm)
{
    double nearest = std::numeric_limits<double>::infinity(), radius = 0;
    if (bore)
        for (const Run& run : bore->model.runs) {
            const double at = std::clamp(z_mm, run.nodes_mm.front(), run.nodes_mm.back());
            if (std::abs(z_mm - at) < nearest) {
                nearest = std::abs(z_mm - at);
                radius = radiusAt_mm(run, at);
            }
        }
    return radius;
}

/// Cells of the outside with their points and the number of these off the model.
class OffMap {
public:
    OffMap(const MeridianCloud& cloud, const Model& model, const Outline* bore)
        : cloud_(cloud), first_mm_(model.planes.front().z_mm)
    {
        const double last_mm = model.planes.back().z_mm;
        rows_ = static_cast<std::size_t>(
            std::clamp((last_mm - first_mm_) / markLimits.cell_mm + 1, 1.0, markLimits.most_rows));
        cells_.assign(rows_ * sectors, {0, 0});
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
            const double z = static_cast<double>(cloud.z_mm[i]);
            if (z < first_mm_ || z > last_mm) continue;
            const Run* const run = smoothRunAt(model, z);
            constexpr double margin_mm = markLimits.edge_margin_mm;
            if (!run || z < run->nodes_mm.front() + margin_mm || z > run->nodes_mm.back() - margin_mm) continue;
            const double outer = radiusAt_mm(*run, z);
            if (bore && static_cast<double>(cloud.r_mm[i]) < (outer + boreAt(bore, z)) / 2) continue;
            Cell& cell = cells_[cellOf(i)];
            ++cell.points;
            if (std::abs(static_cast<double>(cloud.r_mm[i]) - outer) >
                markLimits.off_sigmas * model.sigma_mm + markLimits.off_mm) {
                ++cell.off;
                off_.push_back(static_cast<std::uint32_t>(i));
            }
        }
    }

    std::vector<OffRegion> regions() const
    {
        std::vector<OffRegion> regions;
        std::vector<int> label(cells_.size(), -1);
        for (std::size_t seed = 0; seed < cells_.size(); ++seed)
            if (label[seed] < 0 && isOff(seed)) {
                regions.emplace_back();
                regions.back().cells = fill(seed, static_cast<int>(regions.size()) - 1, label);
            }
        const std::vector<int> with_rim = withRim(label);
        for (const std::uint32_t i : off_)
            if (const int region = with_rim[cellOf(i)]; region >= 0)
                regions[static_cast<std::size_t>(region)].points.push_back(i);
        std::erase_if(regions, [](const OffRegion& region) {
            return region.cells < markLimits.least_cells || region.points.size() < markLimits.least_points;
        });
        return regions;
    }

private:
    struct Cell {
        std::uint32_t points = 0, off = 0;
    };
    static constexpr std::size_t sectors = markLimits.sectors;

    std::size_t cellOf(std::size_t i) const
    {
        const auto row =
            static_cast<std::size_t>((static_cast<double>(cloud_.z_mm[i]) - first_mm_) / markLimits.cell_mm);
        const auto sector =
            std::min(sectors - 1, static_cast<std::size_t>(cloud_.turn[i] * static_cast<float>(sectors)));
        return std::min(row, rows_ - 1) * sectors + sector;
    }

    bool isOff(std::size_t c) const
    {
        return cells_[c].off >= markLimits.least_off_points && 2 * cells_[c].off > cells_[c].points;
    }

    /// Cells beside one; itself in place of those beyond the ends.
    std::array<std::size_t, 4> neighboursOf(std::size_t c) const
    {
        const std::size_t row = c / sectors, sector = c % sectors;
        return {row * sectors + (sector + 1) % sectors, row * sectors + (sector + sectors - 1) % sectors,
                row + 1 < rows_ ? c + sectors : c, row > 0 ? c - sectors : c};
    }

    /// Labels the cells connected with the seed; returns their number.
    std::size_t fill(std::size_t seed, int number, std::vector<int>& label) const
    {
        std::size_t count = 0;
        std::vector<std::size_t> open{seed};
        label[seed] = number;
        while (!open.empty()) {
            const std::size_t c = open.back();
            open.pop_back();
            ++count;
            for (const std::size_t n : neighboursOf(c))
                if (label[n] < 0 && isOff(n)) {
                    label[n] = number;
                    open.push_back(n);
                }
        }
        return count;
    }

    /// Cells beside a region hold its rim.
    std::vector<int> withRim(const std::vector<int>& label) const
    {
        std::vector<int> rim = label;
        for (std::size_t c = 0; c < cells_.size(); ++c)
            for (const std::size_t n : neighboursOf(c))
                if (rim[c] < 0) rim[c] = label[n];
        return rim;
    }

    const MeridianCloud& cloud_;
    double first_mm_;
    std::size_t rows_ = 1;
    std::vector<Cell> cells_;         ///< row by row
    std::vector<std::uint32_t> off_;  ///< indices of the points off the model
};

}  // namespace

const Run* smoothRunAt(const Model& model, double z_mm)
{
    for (const Run& run : model.runs)
        if (z_mm > run.nodes_mm.front() && z_mm < run.nodes_mm.back())
            return run.elements.front().rough ? nullptr : &run;
    return nullptr;
}

std::vector<OffRegion> offRegions(const MeridianCloud& cloud, const Model& model, const Outline* bore)
{
    return OffMap(cloud, model, bore).regions();
}

}  // namespace lathelier::features
