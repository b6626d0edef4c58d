// The grids of cells on the smooth stretches of a meridian and on its faces: rows along the axis (on a face along its
// radius), columns around.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "engine/registration/revolution/meridian_line.h"
#include "engine/registration/verdict/meridian_runs.h"
#include "engine/registration/verdict/surface_windows.h"

namespace lathelier::registration {

/// A stretch with its grid of cells: rows along the axis, columns around. The rows of a face are rings of equal area.
struct Grid {
    double start_mm = 0;   ///< in z of the profile; of a face: inner radius
    double end_mm = 0;     ///< end in z of the profile; of a face: outer radius
    double radius_mm = 0;  ///< largest; of a face: in the middle
    bool is_face = false;
    std::size_t rows = 1, columns = 1;
    std::size_t first = 0;  ///< number of its first cell

    double rowHeight_mm() const { return (end_mm - start_mm) / static_cast<double>(rows); }
    /// Where a row begins: z, of a face the radius.
    double rowStart_mm(std::size_t row) const
    {
        if (!is_face) return start_mm + static_cast<double>(row) * rowHeight_mm();
        const double share = static_cast<double>(row) / static_cast<double>(rows);
        return std::sqrt(start_mm * start_mm + share * (end_mm * end_mm - start_mm * start_mm));
    }
    /// In mm².
    double cellArea() const { return rowHeight_mm() * 2 * std::numbers::pi * radius_mm / static_cast<double>(columns); }
    std::size_t cellCount() const { return rows * columns; }
};

/// The smooth stretches of a meridian between its edges, its faces, and which of them a point belongs to.
class Stretches {
public:
    /// `with_faces`: false where the axial shift is not determined, so that the deviation of a face is arbitrary.
    Stretches(const TurnedPart& part, const MeridianLine& line, bool with_faces);

    const std::vector<MeridianStretch>& list() const { return stretches_; }
    std::vector<Grid>& grids() { return grids_; }

    /// Number of the stretch for a point at (z, r), or noStretch.
    std::uint8_t find(double z, double r) const
    {
        if (const std::uint8_t face = findFace(z, r); face != noStretch) return face;
        const RadiusProfile& profile = part_.fit.profile;
        const double place = (z - profile.z_start_mm) / profile.step_mm;
        if (!(place >= 0) || place >= static_cast<double>(profile.size())) return noStretch;
        const auto bin = static_cast<std::size_t>(place);
        const auto fine = static_cast<std::size_t>(place * static_cast<double>(tablePlacesPerBin));
        std::uint8_t found = outside_[fine];
        if (!bore_.empty()) {
            const double bore = part_.fit.bore.radius_mm[bin];
            if (!std::isnan(bore) && !(r > (bore + profile.radius_mm[bin]) / 2)) found = bore_[fine];
        }
        if (found == noStretch) return found;
        const Grid& grid = grids_[found];
        return z >= grid.start_mm && z < grid.end_mm ? found : noStretch;
    }

    bool isFace(std::uint8_t stretch) const { return grids_[stretch].is_face; }

    static constexpr std::uint8_t noStretch = 255;

private:
    static constexpr std::size_t tablePlacesPerBin = 8;  ///< places of the table of stretches in one bin of the profile

    /// The face whose surface is nearer than the sides beside it.
    std::uint8_t findFace(double z, double r) const
    {
        for (const Face& face : faces_) {
            const double along = std::abs(z - face.measured->z_mm);
            if (along > face.reach_mm || r < face.measured->inner_mm || r >= face.measured->outer_mm) continue;
            const double side = std::min(r - face.inner_mm, face.outer_mm - r);
            if (std::abs(z - face.measured->zAt_mm(r)) < side) return face.stretch;
        }
        return noStretch;
    }

    struct Face {
        const MeasuredFace* measured;
        std::uint8_t stretch;
        double reach_mm;  ///< points further along the axis belong to another
        double inner_mm;  ///< radius where it meets what lies inside
        double outer_mm;  ///< radius where it meets the side
    };

    void addFaces();
    void add(const SmoothRun& run, const RadiusProfile& profile, bool is_bore);
    void addBore(const RadiusProfile& bore);
    std::vector<std::uint8_t> tableOf(bool is_bore) const;

    const TurnedPart& part_;
    const MeridianLine& line_;
    std::vector<MeridianStretch> stretches_;
    std::vector<Grid> grids_;
    std::vector<std::uint8_t> outside_, bore_;
    std::vector<Face> faces_;
};

/// Divides the grids into cells of about a size. Gives the number of cells.
std::size_t layOut(std::vector<Grid>& grids, double size_mm);

/// Number of the cell at a place along the axis (of a face along the radius) and `turn` (0…1) around it.
inline std::size_t cellOf(const Grid& grid, double along, double turn)
{
    const double share = grid.is_face ? (along * along - grid.start_mm * grid.start_mm) /
                                            (grid.end_mm * grid.end_mm - grid.start_mm * grid.start_mm)
                                      : (along - grid.start_mm) / (grid.end_mm - grid.start_mm);
    const auto row = static_cast<std::size_t>(share * static_cast<double>(grid.rows));
    const auto column = static_cast<std::size_t>(turn * static_cast<double>(grid.columns));
    return grid.first + std::min(row, grid.rows - 1) * grid.columns + std::min(column, grid.columns - 1);
}

/// Number of cells of the round windows about a cell: those whose middles lie within √2, √5, 3 and √10 cells.
inline constexpr std::array<std::size_t, 4> windowCells = {9, 21, 29, 37};

/// Calls use(place, number of the smallest of windowCells that holds it) for the cells of the largest window about a
/// cell, once round at most.
template <class Use>
void forWindow(const Grid& grid, std::size_t row, std::size_t column, Use use)
{
    const auto rows = static_cast<std::ptrdiff_t>(grid.rows);
    const auto columns = static_cast<std::ptrdiff_t>(grid.columns);
    constexpr std::ptrdiff_t reach = 3;
    const std::ptrdiff_t left = std::max(-reach, -((columns - 1) / 2));
    const std::ptrdiff_t right = std::min(reach, columns / 2);
    for (std::ptrdiff_t r = -reach; r <= reach; ++r) {
        const std::ptrdiff_t y = static_cast<std::ptrdiff_t>(row) + r;
        if (y < 0 || y >= rows) continue;
        for (std::ptrdiff_t c = left; c <= right; ++c) {
            const std::ptrdiff_t square = r * r + c * c;
            if (square > 10) continue;
            std::ptrdiff_t x = static_cast<std::ptrdiff_t>(column) + c;
            if (x < 0) x += columns;
            if (x >= columns) x -= columns;
            use(grid.first + static_cast<std::size_t>(y * columns + x),
                std::size_t{square > 2} + (square > 5) + (square > 9));
        }
    }
}

}  // namespace lathelier::registration
