#include "engine/registration/verdict/revolution_cells.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/revolution/quick_turn.h"
#include "engine/registration/scanner_spot.h"
#include "engine/registration/verdict/grid_levels.h"
#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {
namespace {

/// Cells on a body of revolution (registration/README.md, "Thresholds").
struct RevolutionCellThresholds {
    double coarse_cell_mm = 3;       ///< side of the cells from which the covered area is estimated
    double ring_width_mm = 1;        ///< of the rings for the form along the axis
    double shortest_gap_mm = 3;      ///< rows without points; a shorter gap is the spacing of scan lines
    double along_axis_cosine = 0.1;  ///< between a free translation and the axis: with more the shift is unknown
};
constexpr RevolutionCellThresholds revolutionCells{};

constexpr std::size_t pointsPerCellTask = 32768;
constexpr std::uint8_t noStretch = Stretches::noStretch;
constexpr std::uint32_t outsideCell = CellPoints::noCell;

/// Removes the cells that hold stray points only, and these points from `counted`.
void removeStrayPoints(const std::vector<Grid>& grids, CellMeans& means, const CellPoints& points,
                       std::vector<std::uint8_t>& counted)
{
    const StrayCells strays(means.cells, means.reach_mm);
    std::vector<std::size_t> out;
    std::vector<const SurfaceCell*> around;
    for (const Grid& grid : grids)
        for (std::size_t k = 0; k < grid.cellCount(); ++k) {
            const SurfaceCell& cell = means.cells[grid.first + k];
            if (!strays.isSparse(cell)) continue;
            around.clear();
            forWindow(grid, k / grid.columns, k % grid.columns, [&](std::size_t place, std::size_t) {
                if (means.cells[place].points > 0) around.push_back(&means.cells[place]);
            });
            if (strays.isStray(cell, around)) out.push_back(grid.first + k);
        }
    for (const std::size_t place : out) means.cells[place].points = 0;
    for (std::size_t i = 0; i < counted.size(); ++i)
        if (counted[i] && means.cells[points.cell[i]].points == 0) counted[i] = 0;
}

/// Removes what lies beside a stretch without points, and its points from `counted`: where the copy ends within the
/// reference, its own end face and the scanner's spot at its edge are no deviation of the side.
void removeEnds(const std::vector<Grid>& grids, std::vector<SurfaceCell>& cells, const CellPoints& points,
                std::vector<std::uint8_t>& counted)
{
    std::vector<bool> out(cells.size());
    for (const Grid& grid : grids) {
        if (grid.is_face) continue;
        const auto cellsOf = [&](std::size_t row) {
            const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(grid.first + row * grid.columns);
            return std::span(begin, grid.columns);
        };
        const auto edge = static_cast<std::size_t>(std::ceil(smearedEdge_mm / grid.rowHeight_mm()));  // rows
        std::size_t empty = 0;  // rows before this one
        const auto endAt = [&](std::size_t row) {
            for (std::size_t k = row; k < std::min(row + edge, grid.rows); ++k)
                std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(grid.first + k * grid.columns), grid.columns,
                            true);
        };
        for (std::size_t row = 0; row <= grid.rows; ++row) {
            const bool filled = row < grid.rows && std::ranges::any_of(cellsOf(row), [](const SurfaceCell& cell) {
                                    return cell.points > 0;
                                });
            if (row < grid.rows && !filled) {
                ++empty;
                continue;
            }
            if (static_cast<double>(empty) * grid.rowHeight_mm() >= revolutionCells.shortest_gap_mm &&
                empty < grid.rows) {
                if (filled) endAt(row);
                if (row > empty) endAt(row - empty - std::min(edge, row - empty));
            }
            empty = 0;
        }
    }
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (out[c]) cells[c].points = 0;
    for (std::size_t i = 0; i < counted.size(); ++i)
        if (counted[i] && out[points.cell[i]]) counted[i] = 0;
}

/// The mean of each face.
std::vector<SurfaceRow> facesOf(const std::vector<Grid>& grids, const std::vector<SurfaceCell>& cells,
                                const std::vector<MeridianStretch>& stretches)
{
    std::vector<SurfaceRow> faces;
    for (std::size_t g = 0; g < grids.size(); ++g) {
        if (!grids[g].is_face) continue;
        SurfaceCell sum;
        for (std::size_t k = grids[g].first; k < grids[g].first + grids[g].cellCount(); ++k)
            if (cells[k].points > 0) sum.add(cells[k]);
        if (sum.points > 0)
            faces.push_back(
                {stretches[g].start_mm, stretches[g].end_mm, static_cast<std::int32_t>(g), sum.points, sum.mean_mm});
    }
    return faces;
}

/// Rings for the form along the axis.
std::vector<SurfaceRow> ringsOf(const std::vector<Grid>& grids, const std::vector<SurfaceCell>& cells, double z_first)
{
    std::vector<SurfaceRow> rings;
    for (std::size_t g = 0; g < grids.size(); ++g) {
        const Grid& grid = grids[g];
        if (grid.is_face) continue;
        const auto together =
            static_cast<std::size_t>(std::max(1.0, std::round(revolutionCells.ring_width_mm / grid.rowHeight_mm())));
        for (std::size_t row = 0; row < grid.rows; row += together) {
            const std::size_t end = std::min(grid.rows, row + together);
            SurfaceCell sum;
            for (std::size_t place = grid.first + row * grid.columns; place < grid.first + end * grid.columns; ++place)
                if (cells[place].points > 0) sum.add(cells[place]);
            rings.push_back({grid.start_mm + static_cast<double>(row) * grid.rowHeight_mm() - z_first,
                             grid.start_mm + static_cast<double>(end) * grid.rowHeight_mm() - z_first,
                             static_cast<std::int32_t>(g), sum.points, sum.mean_mm});
        }
    }
    return rings;
}

/// Whether the shift along `axis` is determined: else the position of a face depends on the initial poses.
bool isShiftKnown(const std::vector<FreeMotion>& free_motions, const Eigen::Vector3d& axis)
{
    return std::none_of(free_motions.begin(), free_motions.end(), [&](const FreeMotion& motion) {
        return motion.kind == FreeMotion::Kind::Translation &&
               std::abs(motion.direction.dot(axis)) > revolutionCells.along_axis_cosine;
    });
}

/// Frame and uncertainty of the registration, as standard uncertainties.
SurfaceWindows emptyWindows(const TurnedPart& reference, const MeridianLine& line, const CompareResult& result,
                            double facets_mm)
{
    SurfaceWindows all;
    all.axis_T_reference = Eigen::Translation3d(0, 0, -line.zFirst_mm()) * reference.fit.axis_T_scan;
    all.facets_mm = facets_mm;
    all.has_sign = result.has_sign;
    all.middle_mm =
        reference.fit.axis_T_scan.inverse() * Eigen::Vector3d(0, 0, (line.zFirst_mm() + line.zLast_mm()) / 2);
    const AlignmentUncertainty& u = result.alignment.uncertainty;
    // Where it is not determined, faces are not judged, and the sides do not depend on it.
    all.axial_sigma_mm = std::isnan(u.axial_um) ? 0 : u.axial_um / (2 * um_per_mm);
    all.radial_sigma_mm = u.radial_um / (2 * um_per_mm);
    all.tilt_sigma = u.axis_deg * std::numbers::pi / 360;
    return all;
}

/// Where the points of the copy lie on the stretches.
struct StretchPlaces {
    std::vector<float> turn;            ///< about the axis, 0…1
    std::vector<float> along;           ///< z from the first data; on a face the radius
    std::vector<std::uint8_t> stretch;  ///< noStretch: on none
    std::size_t used = 0;               ///< number of points on a stretch
    double area_mm2 = 0;                ///< that they cover: the density of a scan from one side refers to that side
};

/// Fills `z_mm` with the place of every used point along the axis.
StretchPlaces stretchPlacesOf(const TurnedPart& reference, const MeridianLine& line,
                              const std::vector<Eigen::Vector3d>& points, const CompareResult& result,
                              Stretches& stretches, std::vector<float>& z_mm, const Progress& progress)
{
    const std::size_t count = points.size();
    StretchPlaces places{std::vector<float>(count), std::vector<float>(count),
                         std::vector<std::uint8_t>(count, noStretch)};
    std::vector<Grid>& grids = stretches.grids();
    std::vector<std::atomic<bool>> has_points(layOut(grids, revolutionCells.coarse_cell_mm));
    places.used = parallelReduce(
        count, pointsPerCellTask, progress, std::size_t{0},
        [&](std::size_t begin, std::size_t end) {
            std::size_t used = 0;
            for (std::size_t i = begin; i < end; ++i) {
                if (!result.used[i]) continue;
                const Eigen::Vector3d p = reference.fit.axis_T_scan * points[i];
                z_mm[i] = static_cast<float>(p.z() - line.zFirst_mm());
                const double r = std::sqrt(p.x() * p.x() + p.y() * p.y());
                const std::uint8_t found = stretches.find(p.z(), r);
                if (found == noStretch) continue;
                places.along[i] = stretches.isFace(found) ? static_cast<float>(r) : z_mm[i];
                const double turn = quickTurn(p.y(), p.x());
                places.turn[i] = static_cast<float>(turn < 0 ? turn + 1 : turn);
                places.stretch[i] = found;
                const double place = stretches.isFace(found) ? r : p.z();
                std::atomic<bool>& seen = has_points[cellOf(grids[found], place, static_cast<double>(places.turn[i]))];
                if (!seen.load(std::memory_order_relaxed)) seen.store(true, std::memory_order_relaxed);
                ++used;
            }
            return used;
        },
        std::plus<>());
    for (const Grid& grid : grids)
        for (std::size_t k = grid.first; k < grid.first + grid.cellCount(); ++k)
            places.area_mm2 += has_points[k] ? grid.cellArea() : 0;
    return places;
}

/// The cell of each point; the grids are divided anew, into cells of about `size_mm`.
CellPoints cellPointsOf(const StretchPlaces& places, const CompareResult& result, Stretches& stretches, double z_first,
                        double size_mm, const Progress& progress)
{
    const std::vector<Grid>& grids = stretches.grids();
    CellPoints sorted{result.deviation_mm, std::vector<std::uint32_t>(places.stretch.size(), outsideCell),
                      layOut(stretches.grids(), size_mm)};
    parallelFor(places.stretch.size(), pointsPerCellTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (const std::uint8_t found = places.stretch[i]; found != noStretch) {
                const double first = stretches.isFace(found) ? 0 : z_first;
                sorted.cell[i] = static_cast<std::uint32_t>(cellOf(
                    grids[found], static_cast<double>(places.along[i]) + first, static_cast<double>(places.turn[i])));
            }
    });
    return sorted;
}

/// Places the cells on the reference's surface.
class CellPlacer {
public:
    CellPlacer(const Eigen::Isometry3d& axis_T_scan, double z_first)
        : scanToAxis_(axis_T_scan), axisToScan_(axis_T_scan.inverse()), zFirst_mm_(z_first)
    {
    }

    /// The cells of one grid, with their places, normals and extents. `number`: of the stretch.
    void place(const Grid& grid, const MeridianStretch& stretch, std::int32_t number,
               std::vector<SurfaceCell>& cells) const
    {
        const double lean = std::atan(stretch.slope);
        for (std::size_t k = 0; k < grid.cellCount(); ++k) {
            SurfaceCell& cell = cells[grid.first + k];
            cell.stretch = number;
            const double angle =
                turn_rad * (static_cast<double>(k % grid.columns) + 0.5) / static_cast<double>(grid.columns);
            const Eigen::Vector3d radial(std::cos(angle), std::sin(angle), 0);
            if (grid.is_face)
                placeOnFace(grid, stretch, k / grid.columns, radial, cell);
            else
                placeOnSide(grid, stretch, k / grid.columns, radial, lean, cell);
        }
    }

private:
    void placeOnFace(const Grid& grid, const MeridianStretch& stretch, std::size_t row, const Eigen::Vector3d& radial,
                     SurfaceCell& cell) const
    {
        const double r = (grid.rowStart_mm(row) + grid.rowStart_mm(row + 1)) / 2;
        const double at = stretch.start_mm;
        const Eigen::Vector3d normal = stretch.facing * Eigen::Vector3d::UnitZ();
        cell.place_mm = axisToScan_ * (r * radial + (at + zFirst_mm_) * Eigen::Vector3d::UnitZ());
        cell.normal = scanToAxis_.linear().transpose() * normal;
        cell.z_start_mm = cell.z_end_mm = static_cast<float>(at);
    }

    void placeOnSide(const Grid& grid, const MeridianStretch& stretch, std::size_t row, const Eigen::Vector3d& radial,
                     double lean, SurfaceCell& cell) const
    {
        const double sense = stretch.is_bore ? -1 : 1;
        const double z = grid.rowStart_mm(row);
        const double middle = z + grid.rowHeight_mm() / 2;
        const double radius = grid.radius_mm - std::abs(stretch.slope) *
                                                   (stretch.slope > 0 ? grid.end_mm - middle : middle - grid.start_mm);
        cell.place_mm = axisToScan_ * (radius * radial + middle * Eigen::Vector3d::UnitZ());
        cell.normal = scanToAxis_.linear().transpose() *
                      (sense * (std::cos(lean) * radial - std::sin(lean) * Eigen::Vector3d::UnitZ()));
        cell.z_start_mm = static_cast<float>(z - zFirst_mm_);
        cell.z_end_mm = static_cast<float>(z + grid.rowHeight_mm() - zFirst_mm_);
    }

    Eigen::Isometry3d scanToAxis_, axisToScan_;
    double zFirst_mm_;
};

}  // namespace

SurfaceWindows revolutionWindows(const TurnedPart& reference, const MeridianLine& line,
                                 const std::vector<Eigen::Vector3d>& points, const CompareResult& result,
                                 double facets_mm, const Progress& progress)
{
    SurfaceWindows all = emptyWindows(reference, line, result, facets_mm);
    const Eigen::Vector3d axis = reference.fit.axis_T_scan.linear().row(2);
    Stretches stretches(reference, line, isShiftKnown(result.alignment.free_motions, axis));
    all.stretches = stretches.list();
    all.z_mm.assign(points.size(), std::numeric_limits<float>::quiet_NaN());
    if (all.stretches.empty()) return all;

    const StretchPlaces places = stretchPlacesOf(reference, line, points, result, stretches, all.z_mm, progress);
    const double size_mm = cellSize_mm(static_cast<double>(places.used), places.area_mm2);
    const CellPoints sorted = cellPointsOf(places, result, stretches, line.zFirst_mm(), size_mm, progress);
    const std::vector<Grid>& grids = stretches.grids();
    CellMeans means = cellMeans(sorted, progress);
    all.counted = std::move(means.counted);
    const CellPlacer placer(reference.fit.axis_T_scan, line.zFirst_mm());
    for (std::size_t g = 0; g < grids.size(); ++g)
        placer.place(grids[g], all.stretches[g], static_cast<std::int32_t>(g), means.cells);
    removeStrayPoints(grids, means, sorted, all.counted);
    removeEnds(grids, means.cells, sorted, all.counted);
    all.rows = ringsOf(grids, means.cells, line.zFirst_mm());
    std::erase_if(all.rows, [&](const SurfaceRow& ring) {
        return std::any_of(result.parameters.exclude_z_mm.begin(), result.parameters.exclude_z_mm.end(),
                           [&](const Interval& out) { return ring.z_start_mm < out.to && ring.z_end_mm > out.from; });
    });
    all.faces = facesOf(grids, means.cells, all.stretches);
    for (std::size_t i = 0; i < all.counted.size(); ++i)
        if (all.counted[i] && stretches.isFace(places.stretch[i])) all.counted[i] = 2;
    makeWindows(gridLevels(grids, std::move(means.cells), size_mm), all, progress);
    return all;
}

}  // namespace lathelier::registration
