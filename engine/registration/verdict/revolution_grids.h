// The grids of cells on the smooth stretches of a meridian: rows along the axis, columns around.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/registration/revolution/meridian_line.h"
#include "engine/registration/verdict/meridian_runs.h"
#include "engine/registration/verdict/surface_windows.h"

namespace lathelier::registration {

/// A stretch with its grid of cells: rows along the axis, columns around.
struct Grid {
    double start_mm = 0;   ///< in z of the profile
    double end_mm = 0;     ///< likewise
    double radius_mm = 0;  ///< largest
    std::size_t rows = 1, columns = 1;
    std::size_t first = 0;  ///< number of its first cell

    double rowHeight_mm() const { return (end_mm - start_mm) / static_cast<double>(rows); }
};

/// The smooth stretches of a meridian between its edges, and which of them a point belongs to.
class Stretches {
public:
    Stretches(const TurnedPart& part, const MeridianLine& line);

    const std::vector<MeridianStretch>& list() const { return stretches_; }
    std::vector<Grid>& grids() { return grids_; }

    /// Number of the stretch for a point at (z, r), or kNoStretch.
    std::uint8_t find(double z, double r) const
    {
        const RadiusProfile& profile = part_.fit.profile;
        const double place = (z - profile.z_start_mm) / profile.step_mm;
        if (!(place >= 0) || place >= static_cast<double>(profile.size())) return kNoStretch;
        const auto bin = static_cast<std::size_t>(place);
        const auto fine = static_cast<std::size_t>(place * static_cast<double>(kFine));
        std::uint8_t found = outside_[fine];
        if (!bore_.empty()) {
            const double bore = part_.fit.bore.radius_mm[bin];
            if (!std::isnan(bore) && !(r > (bore + profile.radius_mm[bin]) / 2)) found = bore_[fine];
        }
        if (found == kNoStretch) return found;
        const Grid& grid = grids_[found];
        return z >= grid.start_mm && z < grid.end_mm ? found : kNoStretch;
    }

    static constexpr std::uint8_t kNoStretch = 255;

private:
    static constexpr std::size_t kFine = 8;  ///< places of the table of stretches in one bin of the profile

    void add(const SmoothRun& run, const RadiusProfile& profile, bool is_bore);
    void addBore(const RadiusProfile& bore);
    std::vector<std::uint8_t> tableOf(bool is_bore) const;

    const TurnedPart& part_;
    const MeridianLine& line_;
    std::vector<MeridianStretch> stretches_;
    std::vector<Grid> grids_;
    std::vector<std::uint8_t> outside_, bore_;
};

/// Divides the grids into cells of about a size. Gives the number of cells.
std::size_t layOut(std::vector<Grid>& grids, double size_mm);

/// Number of the cell at a place along the axis and `turn` (0…1) around it.
inline std::size_t cellOf(const Grid& grid, double z, double turn)
{
    const auto row =
        static_cast<std::size_t>((z - grid.start_mm) / (grid.end_mm - grid.start_mm) * static_cast<double>(grid.rows));
    const auto column = static_cast<std::size_t>(turn * static_cast<double>(grid.columns));
    return grid.first + std::min(row, grid.rows - 1) * grid.columns + std::min(column, grid.columns - 1);
}

/// Calls use(place, is one of the nearest 9) for the cells of the window about a cell, once round at most.
template <class Use>
void forWindow(const Grid& grid, std::size_t row, std::size_t column, Use use)
{
    const auto rows = static_cast<std::ptrdiff_t>(grid.rows);
    const auto columns = static_cast<std::ptrdiff_t>(grid.columns);
    const std::ptrdiff_t left = std::max<std::ptrdiff_t>(-2, -((columns - 1) / 2));
    const std::ptrdiff_t right = std::min<std::ptrdiff_t>(2, columns / 2);
    for (std::ptrdiff_t r = -2; r <= 2; ++r) {
        const std::ptrdiff_t y = static_cast<std::ptrdiff_t>(row) + r;
        if (y < 0 || y >= rows) continue;
        for (std::ptrdiff_t c = left; c <= right; ++c) {
            if (r * r + c * c > 5) continue;
            std::ptrdiff_t x = static_cast<std::ptrdiff_t>(column) + c;
            if (x < 0) x += columns;
            if (x >= columns) x -= columns;
            use(grid.first + static_cast<std::size_t>(y * columns + x), r * r <= 1 && c * c <= 1);
        }
    }
}

}  // namespace lathelier::registration
