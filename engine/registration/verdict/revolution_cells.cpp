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
#include "engine/registration/verdict/revolution_grids.h"
#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {
namespace {

constexpr double coarseCell_mm = 3;  // side of the cells from which the covered area is estimated
constexpr std::size_t pointsPerCellTask = 32768;
constexpr std::uint8_t noStretch = Stretches::noStretch;
constexpr std::uint32_t outsideCell = CellPoints::noCell;

/// The cells of one level by their place in the grids, and the level made of those that have points.
class GridLevel {
public:
    GridLevel(std::vector<Grid> grids, std::size_t count) : grids_(std::move(grids)), number_(count, outsideCell) {}

    /// `cells` by place in the grids.
    void fill(const std::vector<SurfaceCell>& cells, CellLevel& level)
    {
        for (std::size_t place = 0; place < cells.size(); ++place) {
            if (cells[place].points == 0) continue;
            number_[place] = static_cast<std::uint32_t>(level.cells.size());
            level.cells.push_back(cells[place]);
        }
        join(level);
    }

    /// The cells of the next level by their place, and whether that is any coarser.
    bool shrink(CellLevel& level, std::vector<Grid>& next, std::vector<SurfaceCell>& cells) const
    {
        next = grids_;
        std::size_t count = 0;
        bool coarser = false;
        for (Grid& grid : next) {
            coarser = coarser || grid.rows > 1 || grid.columns > 1;
            grid.rows = (grid.rows + 1) / 2;
            grid.columns = (grid.columns + 1) / 2;
            grid.first = count;
            count += grid.rows * grid.columns;
        }
        if (!coarser) return false;
        cells.assign(count, {});
        std::vector<std::uint32_t> parents(level.cells.size());
        forEach([&](std::size_t g, std::size_t row, std::size_t column, std::uint32_t cell) {
            const std::size_t place = next[g].first + row / 2 * next[g].columns + column / 2;
            cells[place].add(level.cells[cell]);
            parents[cell] = static_cast<std::uint32_t>(place);
        });
        std::vector<std::uint32_t> numbers(count, 0);
        std::uint32_t number = 0;
        for (std::size_t place = 0; place < count; ++place)
            if (cells[place].points > 0) numbers[place] = number++;
        for (std::uint32_t& parent : parents) parent = numbers[parent];
        level.parent = std::move(parents);
        return true;
    }

private:
    template <class Use>
    void forEach(Use use) const
    {
        for (std::size_t g = 0; g < grids_.size(); ++g)
            for (std::size_t row = 0; row < grids_[g].rows; ++row)
                for (std::size_t column = 0; column < grids_[g].columns; ++column) {
                    const std::uint32_t cell = number_[grids_[g].first + row * grids_[g].columns + column];
                    if (cell != outsideCell) use(g, row, column, cell);
                }
    }

    void join(CellLevel& level) const
    {
        level.window_mm.assign(windowCells.size(), 0);
        level.first.push_back(0);
        level.neighbours.reserve(level.cells.size() * windowCells.back());
        std::array<std::vector<std::uint32_t>, windowCells.size()> rings;
        forEach([&](std::size_t g, std::size_t row, std::size_t column, std::uint32_t cell) {
            const Grid& grid = grids_[g];
            const std::size_t begin = level.neighbours.size();
            for (std::vector<std::uint32_t>& ring : rings) ring.clear();
            forWindow(grid, row, column, [&](std::size_t place, std::size_t ring) {
                const std::uint32_t found = number_[place];
                if (found != outsideCell) rings[ring].push_back(found);
            });
            for (const std::vector<std::uint32_t>& ring : rings) {
                level.neighbours.insert(level.neighbours.end(), ring.begin(), ring.end());
                level.counts.push_back(static_cast<std::uint32_t>(level.neighbours.size() - begin));
            }
            level.first.push_back(static_cast<std::uint32_t>(level.neighbours.size()));
            const auto inRow = [&](std::size_t direction, std::size_t before, std::size_t after) {
                const std::uint32_t a = number_[before];
                const std::uint32_t b = number_[after];
                if (a != outsideCell && b != outsideCell) level.rows[direction].push_back({a, cell, b});
            };
            const std::size_t place = grid.first + row * grid.columns + column;
            if (row > 0 && row + 1 < grid.rows) inRow(0, place - grid.columns, place + grid.columns);
            if (grid.columns >= 12)
                inRow(1, column > 0 ? place - 1 : place + grid.columns - 1,
                      column + 1 < grid.columns ? place + 1 : place + 1 - grid.columns);
        });
    }

    std::vector<Grid> grids_;
    std::vector<std::uint32_t> number_;  ///< of the cell at each place; outsideCell where there are no points
};

/// Removes the cells that hold stray points only, and these points from `counted`.
void removeStrayPoints(const std::vector<Grid>& grids, CellMeans& means, const CellPoints& points,
                       std::vector<std::uint8_t>& counted)
{
    const StrayCells strays(means.cells, means.reach_mm);
    std::vector<std::size_t> out;
    std::vector<const SurfaceCell*> around;
    for (const Grid& grid : grids)
        for (std::size_t k = 0; k < grid.rows * grid.columns; ++k) {
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
    constexpr double shortestGap_mm = 3;  // shorter ones are the spacing of scan lines
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
            if (static_cast<double>(empty) * grid.rowHeight_mm() >= shortestGap_mm && empty < grid.rows) {
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
        for (std::size_t k = grids[g].first; k < grids[g].first + grids[g].rows * grids[g].columns; ++k)
            if (cells[k].points > 0) sum.add(cells[k]);
        if (sum.points > 0)
            faces.push_back(
                {stretches[g].start_mm, stretches[g].end_mm, static_cast<std::int32_t>(g), sum.points, sum.mean_mm});
    }
    return faces;
}

/// Rings of about `height_mm` for the form along the axis.
std::vector<SurfaceRow> ringsOf(const std::vector<Grid>& grids, const std::vector<SurfaceCell>& cells, double z_first,
                                double height_mm)
{
    std::vector<SurfaceRow> rings;
    for (std::size_t g = 0; g < grids.size(); ++g) {
        const Grid& grid = grids[g];
        if (grid.is_face) continue;
        const auto together = static_cast<std::size_t>(std::max(1.0, std::round(height_mm / grid.rowHeight_mm())));
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

}  // namespace

SurfaceWindows revolutionWindows(const TurnedPart& reference, const MeridianLine& line,
                                 const std::vector<Eigen::Vector3d>& points, const CompareResult& result,
                                 double facets_mm, const Progress& progress)
{
    constexpr double ringWidth_mm = 1;
    SurfaceWindows all;
    all.axis_T_reference = Eigen::Translation3d(0, 0, -line.zFirst_mm()) * reference.fit.axis_T_scan;
    all.facets_mm = facets_mm;
    all.has_sign = result.has_sign;
    all.middle_mm =
        reference.fit.axis_T_scan.inverse() * Eigen::Vector3d(0, 0, (line.zFirst_mm() + line.zLast_mm()) / 2);
    const AlignmentUncertainty& u = result.alignment.uncertainty;
    // Where it is not determined, faces are not judged, and the sides do not depend on it.
    all.axial_sigma_mm = std::isnan(u.axial_um) ? 0 : u.axial_um / 2000;
    all.radial_sigma_mm = u.radial_um / 2000;
    all.tilt_sigma = u.axis_deg * std::numbers::pi / 360;
    // Without a determined axial shift the position of a face depends on the initial poses.
    const Eigen::Vector3d axis = reference.fit.axis_T_scan.linear().row(2);
    const bool is_shift_known = std::none_of(
        result.alignment.free_motions.begin(), result.alignment.free_motions.end(), [&](const FreeMotion& motion) {
            return motion.kind == FreeMotion::Kind::Translation && std::abs(motion.direction.dot(axis)) > 0.1;
        });
    Stretches stretches(reference, line, is_shift_known);
    all.stretches = stretches.list();
    all.z_mm.assign(points.size(), std::numeric_limits<float>::quiet_NaN());
    if (all.stretches.empty()) return all;

    // The stretch, and the covered area: the point density of a scan from one side refers to that side.
    std::vector<Grid>& grids = stretches.grids();
    std::vector<std::atomic<bool>> has_points(layOut(grids, coarseCell_mm));
    std::vector<float> turns(points.size());
    std::vector<float> along(points.size());  // z from the first data; on a face the radius
    std::vector<std::uint8_t> stretch_of(points.size(), noStretch);
    const auto used = parallelReduce(
        points.size(), pointsPerCellTask, progress, std::size_t{0},
        [&](std::size_t begin, std::size_t end) {
            std::size_t count = 0;
            for (std::size_t i = begin; i < end; ++i) {
                if (!result.used[i]) continue;
                const Eigen::Vector3d p = reference.fit.axis_T_scan * points[i];
                all.z_mm[i] = static_cast<float>(p.z() - line.zFirst_mm());
                const double r = std::sqrt(p.x() * p.x() + p.y() * p.y());
                const std::uint8_t found = stretches.find(p.z(), r);
                if (found == noStretch) continue;
                along[i] = stretches.isFace(found) ? static_cast<float>(r) : all.z_mm[i];
                const double turn = quickTurn(p.y(), p.x());
                turns[i] = static_cast<float>(turn < 0 ? turn + 1 : turn);
                stretch_of[i] = found;
                const double place = stretches.isFace(found) ? r : p.z();
                std::atomic<bool>& seen = has_points[cellOf(grids[found], place, static_cast<double>(turns[i]))];
                if (!seen.load(std::memory_order_relaxed)) seen.store(true, std::memory_order_relaxed);
                ++count;
            }
            return count;
        },
        std::plus<>());
    double area = 0;
    for (const Grid& grid : grids)
        for (std::size_t k = grid.first; k < grid.first + grid.rows * grid.columns; ++k)
            area += has_points[k] ? grid.cellArea() : 0;
    const double size = cellSize_mm(static_cast<double>(used), area);
    CellPoints sorted{result.deviation_mm, std::vector<std::uint32_t>(points.size(), outsideCell), layOut(grids, size)};
    parallelFor(points.size(), pointsPerCellTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (const std::uint8_t found = stretch_of[i]; found != noStretch) {
                const double first = stretches.isFace(found) ? 0 : line.zFirst_mm();
                sorted.cell[i] = static_cast<std::uint32_t>(
                    cellOf(grids[found], static_cast<double>(along[i]) + first, static_cast<double>(turns[i])));
            }
    });
    CellMeans means = cellMeans(sorted, progress);
    std::vector<SurfaceCell>& cells = means.cells;
    all.counted = std::move(means.counted);
    for (std::size_t g = 0; g < grids.size(); ++g) {
        const Grid& grid = grids[g];
        const double lean = std::atan(all.stretches[g].slope);
        const double sense = all.stretches[g].is_bore ? -1 : 1;
        for (std::size_t k = 0; k < grid.rows * grid.columns; ++k) {
            SurfaceCell& cell = cells[grid.first + k];
            cell.stretch = static_cast<std::int32_t>(g);
            const std::size_t row = k / grid.columns;
            const double z = grid.rowStart_mm(row);
            const double angle =
                turn_rad * (static_cast<double>(k % grid.columns) + 0.5) / static_cast<double>(grid.columns);
            const Eigen::Vector3d radial(std::cos(angle), std::sin(angle), 0);
            if (grid.is_face) {
                const double r = (z + grid.rowStart_mm(row + 1)) / 2;
                const Eigen::Vector3d normal = all.stretches[g].facing * Eigen::Vector3d::UnitZ();
                const double at = all.stretches[g].start_mm;
                cell.place_mm = reference.fit.axis_T_scan.inverse() *
                                (r * radial + (at + line.zFirst_mm()) * Eigen::Vector3d::UnitZ());
                cell.normal = reference.fit.axis_T_scan.linear().transpose() * normal;
                cell.z_start_mm = cell.z_end_mm = static_cast<float>(at);
                continue;
            }
            const double middle = z + grid.rowHeight_mm() / 2;
            const double radius =
                grid.radius_mm - std::abs(all.stretches[g].slope) *
                                     (all.stretches[g].slope > 0 ? grid.end_mm - middle : middle - grid.start_mm);
            cell.place_mm = reference.fit.axis_T_scan.inverse() * (radius * radial + middle * Eigen::Vector3d::UnitZ());
            cell.normal = reference.fit.axis_T_scan.linear().transpose() *
                          (sense * (std::cos(lean) * radial - std::sin(lean) * Eigen::Vector3d::UnitZ()));
            cell.z_start_mm = static_cast<float>(z - line.zFirst_mm());
            cell.z_end_mm = static_cast<float>(z + grid.rowHeight_mm() - line.zFirst_mm());
        }
    }
    removeStrayPoints(grids, means, sorted, all.counted);
    removeEnds(grids, cells, sorted, all.counted);
    all.rows = ringsOf(grids, cells, line.zFirst_mm(), ringWidth_mm);
    std::erase_if(all.rows, [&](const SurfaceRow& ring) {
        return std::any_of(result.parameters.exclude_z_mm.begin(), result.parameters.exclude_z_mm.end(),
                           [&](const Interval& out) { return ring.z_start_mm < out.to && ring.z_end_mm > out.from; });
    });
    all.faces = facesOf(grids, cells, all.stretches);
    for (std::size_t i = 0; i < all.counted.size(); ++i)
        if (all.counted[i] && stretches.isFace(stretch_of[i])) all.counted[i] = 2;

    std::vector<CellLevel> levels;
    std::vector<Grid> level_grids = grids;
    for (double level_size = size;; level_size *= 2) {
        levels.emplace_back();
        levels.back().size_mm = level_size;
        GridLevel level(level_grids, cells.size());
        level.fill(cells, levels.back());
        std::vector<Grid> next;
        if (!level.shrink(levels.back(), next, cells)) break;
        level_grids = std::move(next);
    }
    makeWindows(levels, all, progress);
    return all;
}

}  // namespace lathelier::registration
