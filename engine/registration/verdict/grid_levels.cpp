#include "engine/registration/verdict/grid_levels.h"

#include <array>
#include <cstdint>

namespace lathelier::registration {
namespace {

constexpr std::uint32_t emptyPlace = CellPoints::noCell;
constexpr std::size_t leastColumns = 12;  // around, for second differences around; chosen by hand

/// The cells of one level by their place in the grids, and the level made of those that have points.
class GridLevel {
public:
    GridLevel(std::vector<Grid> grids, std::size_t count) : grids_(std::move(grids)), number_(count, emptyPlace) {}

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
                    if (cell != emptyPlace) use(g, row, column, cell);
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
                if (found != emptyPlace) rings[ring].push_back(found);
            });
            for (const std::vector<std::uint32_t>& ring : rings) {
                level.neighbours.insert(level.neighbours.end(), ring.begin(), ring.end());
                level.counts.push_back(static_cast<std::uint32_t>(level.neighbours.size() - begin));
            }
            level.first.push_back(static_cast<std::uint32_t>(level.neighbours.size()));
            const auto inRow = [&](std::size_t direction, std::size_t before, std::size_t after) {
                const std::uint32_t a = number_[before];
                const std::uint32_t b = number_[after];
                if (a != emptyPlace && b != emptyPlace) level.rows[direction].push_back({a, cell, b});
            };
            const std::size_t place = grid.first + row * grid.columns + column;
            if (row > 0 && row + 1 < grid.rows) inRow(0, place - grid.columns, place + grid.columns);
            if (grid.columns >= leastColumns)
                inRow(1, column > 0 ? place - 1 : place + grid.columns - 1,
                      column + 1 < grid.columns ? place + 1 : place + 1 - grid.columns);
        });
    }

    std::vector<Grid> grids_;
    std::vector<std::uint32_t> number_;  ///< of the cell at each place; emptyPlace where there are no points
};

}  // namespace

std::vector<CellLevel> gridLevels(std::vector<Grid> grids, std::vector<SurfaceCell> cells, double size_mm)
{
    std::vector<CellLevel> levels;
    for (double level_size_mm = size_mm;; level_size_mm *= 2) {
        levels.emplace_back();
        levels.back().size_mm = level_size_mm;
        GridLevel level(grids, cells.size());
        level.fill(cells, levels.back());
        std::vector<Grid> next;
        if (!level.shrink(levels.back(), next, cells)) return levels;
        grids = std::move(next);
    }
}

}  // namespace lathelier::registration
