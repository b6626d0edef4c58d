// g++ 12 at -O3 takes Eigen's zero-sized temporaries for values without initialisation.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "engine/registration/verdict/general_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/scanner_spot.h"
#include "engine/registration/verdict/cube_table.h"
#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {
namespace {

/// Cells on a part of any shape (registration/README.md, "Thresholds").
struct GeneralCellThresholds {
    double smooth_cosine = 0.8;          ///< between normals; a smaller one within reach is an edge
    double same_side_cosine = 0.7;       ///< between normals of cells that may be averaged
    double cubes_across = 60;            ///< the radius of the part, for the covered area
    std::size_t most_cubes = 400000;     ///< for that
    double least_cube_mm = 1e-9;         ///< for points that are all one
    double least_edge_points = 2;        ///< of what faces elsewhere; a single point is spurious
    int most_levels = 12;                ///< of cells
    std::size_t shrinking_percent = 90;  ///< of the cells of a level: with more the next is no coarser and left out
};
constexpr GeneralCellThresholds generalCells{};

// Radius of windows, in sizes of a cell: of about 9, 13 and 21 cells.
constexpr std::array<double, 3> windowRadii_cells = {1.6, 2.1, 2.5};
constexpr double squareSidePerRadius = 1.77;  // √π: from the radius of a circle to the side of a square of its area
constexpr std::uint32_t noCell = CellPoints::noCell;
constexpr std::size_t cubesPerTask = 1024;
constexpr int sideCount = 6;

/// The points that count, with the deviation and the normal of one sense.
struct CountedPoints {
    std::vector<Eigen::Vector3d> place_mm;  ///< about the middle; of used points only
    std::vector<Eigen::Vector3f> normal;
    std::vector<float> deviation_mm;
    std::vector<std::uint32_t> number;  ///< in the copy
    Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
};

CountedPoints pointsOf(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3f>& normals,
                       const CompareResult& result)
{
    CountedPoints used;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (!result.used[i] || normals[i].squaredNorm() == 0) continue;
        // On the reference's surface, so that noise puts no point into another cell.
        used.place_mm.emplace_back(points[i] - static_cast<double>(result.deviation_mm[i]) * normals[i].cast<double>());
        used.normal.push_back(normals[i]);
        used.deviation_mm.push_back(result.deviation_mm[i]);
        used.number.push_back(i);
        used.middle_mm += used.place_mm.back();
        // Without inside and outside: of either sense the one that is positive along its largest coordinate.
        if (result.has_sign || sideOf(normals[i]) % 2 == 0) continue;
        used.normal.back() = -normals[i];
        used.deviation_mm.back() = -result.deviation_mm[i];
    }
    if (!used.place_mm.empty()) used.middle_mm /= static_cast<double>(used.place_mm.size());
    for (Eigen::Vector3d& p : used.place_mm) p -= used.middle_mm;
    return used;
}

/// The area covered by the points: from coarse cubes with a few points each, times the mean area of a plane through a
/// cube.
double areaOf(const CountedPoints& points)
{
    double size = 0;
    for (const Eigen::Vector3d& p : points.place_mm) size = std::max(size, p.norm());
    const double cube = std::max(size / generalCells.cubes_across, generalCells.least_cube_mm);
    KeyTable table(std::min(points.place_mm.size(), generalCells.most_cubes));
    std::vector<Eigen::Vector3f> normals;
    for (std::size_t i = 0; i < points.place_mm.size(); ++i) {
        const std::uint32_t cell = table.add(keyOf(cubeOf(points.place_mm[i], cube), sideOf(points.normal[i])),
                                             static_cast<std::uint32_t>(normals.size()));
        if (cell == normals.size()) normals.push_back(points.normal[i]);
        if (normals.size() >= generalCells.most_cubes) break;
    }
    // A plane cuts |nx| + |ny| + |nz| cubes for each cube's face that it measures.
    double area = 0;
    for (const Eigen::Vector3f& n : normals) area += cube * cube / static_cast<double>(n.cwiseAbs().sum());
    return area;
}

/// One level under construction: its cells with their cubes.
struct CubeLevel {
    double size_mm = 1;
    std::vector<Cube> cube;  ///< of each cell, with `side`
    std::vector<int> side;   ///< sideOf() of its normals
    KeyTable table{0};
};

/// The neighbours of one cell: by rings, and along each coordinate those before and behind it.
struct CubeNeighbours {
    std::array<std::vector<std::uint32_t>, windowRadii_cells.size()> rings;
    std::array<std::array<std::uint32_t, 2>, 3> row{};
};

/// Which sides have a cell in each cube. Most cubes about a surface are empty: looked up once for all sides.
class OccupiedCubes {
public:
    explicit OccupiedCubes(const CubeLevel& cubes) : table_(cubes.cube.size())
    {
        for (std::size_t c = 0; c < cubes.cube.size(); ++c) {
            const std::uint32_t number = table_.add(keyOf(cubes.cube[c], 0), static_cast<std::uint32_t>(sides_.size()));
            if (number == sides_.size()) sides_.push_back(0);
            sides_[number] = static_cast<std::uint8_t>(sides_[number] | 1U << static_cast<unsigned>(cubes.side[c]));
        }
    }

    /// One bit for each side.
    std::uint8_t sidesOf(const Cube& cube) const
    {
        const std::uint32_t held = table_.find(keyOf(cube, 0));
        return held == noCell ? 0 : sides_[held];
    }

private:
    KeyTable table_;
    std::vector<std::uint8_t> sides_;
};

CubeNeighbours cubeNeighboursOf(std::size_t c, const CubeLevel& cubes, const OccupiedCubes& occupied,
                                const std::vector<SurfaceCell>& cells)
{
    const SurfaceCell& here = cells[c];
    const Cube& cube = cubes.cube[c];
    CubeNeighbours mine;
    const auto look = [&](const Cube& at) {
        const std::uint8_t sides = occupied.sidesOf(at);
        for (int side = 0; side < sideCount && sides != 0; ++side) {
            if ((side ^ 1) == cubes.side[c] || (sides >> side & 1) == 0) continue;
            const std::uint32_t other = cubes.table.find(keyOf(at, side));
            const SurfaceCell& there = cells[other];
            if (here.normal.dot(there.normal) <
                generalCells.same_side_cosine * here.normal.norm() * there.normal.norm())
                continue;
            const double distance = (here.place_mm - there.place_mm).norm();
            const auto ring = std::upper_bound(windowRadii_cells.begin(), windowRadii_cells.end(),
                                               other == c ? 0 : distance / cubes.size_mm);
            if (ring != windowRadii_cells.end())
                mine.rings[static_cast<std::size_t>(ring - windowRadii_cells.begin())].push_back(other);
        }
    };
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z) look({cube[0] + x, cube[1] + y, cube[2] + z});
    for (std::size_t a = 0; a < 3; ++a) {
        Cube before = cube;
        Cube after = cube;
        --before[a];
        ++after[a];
        mine.row[a] = {cubes.table.find(keyOf(before, cubes.side[c])), cubes.table.find(keyOf(after, cubes.side[c]))};
    }
    return mine;
}

/// Joins the cells of a level to windows.
void joinCubes(const CubeLevel& cubes, CellLevel& level, const Progress& progress)
{
    const std::size_t count = level.cells.size();
    std::vector<CubeNeighbours> found(count);
    const OccupiedCubes occupied(cubes);
    parallelFor(count, cubesPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) found[c] = cubeNeighboursOf(c, cubes, occupied, level.cells);
    });
    for (const double radius : windowRadii_cells)
        level.window_mm.push_back(squareSidePerRadius * radius * cubes.size_mm);
    level.first.push_back(0);
    for (std::uint32_t c = 0; c < count; ++c) {
        const CubeNeighbours& mine = found[c];
        for (const std::vector<std::uint32_t>& ring : mine.rings) {
            level.neighbours.insert(level.neighbours.end(), ring.begin(), ring.end());
            level.counts.push_back(static_cast<std::uint32_t>(level.neighbours.size() - level.first.back()));
        }
        level.first.push_back(static_cast<std::uint32_t>(level.neighbours.size()));
        for (std::size_t a = 0; a < 3; ++a)
            if (static_cast<int>(a) != cubes.side[c] / 2 && mine.row[a][0] != noCell && mine.row[a][1] != noCell)
                level.rows[a].push_back({mine.row[a][0], c, mine.row[a][1]});
    }
}

/// Cells with neighbours that face elsewhere within `reach`: the edges of the part.
std::vector<bool> edgeCells(const std::vector<SurfaceCell>& cells, const std::vector<int>& sides, double reach_mm)
{
    KeyTable table(cells.size());
    std::vector<Eigen::Vector3d> normals;
    std::vector<double> points;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const std::uint32_t number =
            table.add(keyOf(cubeOf(cells[c].place_mm, reach_mm), sides[c]), static_cast<std::uint32_t>(normals.size()));
        if (number == normals.size()) {
            normals.emplace_back(0, 0, 0);
            points.push_back(0);
        }
        normals[number] += cells[c].points * cells[c].normal;
        points[number] += cells[c].points;
    }
    std::vector<bool> is_edge(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Cube cube = cubeOf(cells[c].place_mm, reach_mm);
        for (int k = 0; k < 27 * sideCount && !is_edge[c]; ++k) {  // each side of the cubes around
            const int at = k / sideCount;
            const Cube near{cube[0] + at % 3 - 1, cube[1] + at / 3 % 3 - 1, cube[2] + at / 9 - 1};
            const std::uint32_t other = table.find(keyOf(near, k % sideCount));
            if (other == noCell || points[other] < generalCells.least_edge_points) continue;
            const double cosine =
                normals[other].dot(cells[c].normal) / (normals[other].norm() * cells[c].normal.norm());
            // Opposite normals belong to the two sides of a thin wall.
            is_edge[c] = cosine < generalCells.smooth_cosine && cosine > -generalCells.smooth_cosine;
        }
    }
    return is_edge;
}

/// The cells that have points, in `level`.
CubeLevel keepFilled(const std::vector<SurfaceCell>& cells, const CubeLevel& cubes, CellLevel& level)
{
    CubeLevel kept;
    kept.size_mm = cubes.size_mm;
    kept.table = KeyTable(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (cells[c].points == 0) continue;
        kept.table.add(keyOf(cubes.cube[c], cubes.side[c]), static_cast<std::uint32_t>(level.cells.size()));
        kept.cube.push_back(cubes.cube[c]);
        kept.side.push_back(cubes.side[c]);
        level.cells.push_back(cells[c]);
    }
    return kept;
}

/// The smallest cells: cubes by the sides of their normals.
struct SmallestCubes {
    CubeLevel cubes;
    CellPoints points;              ///< which cell each point falls into
    std::vector<SurfaceCell> sums;  ///< of each cell: number of points, sums of places and normals
};

SmallestCubes smallestCubes(const CountedPoints& used)
{
    const std::size_t count = used.place_mm.size();
    SmallestCubes found{{}, {used.deviation_mm, std::vector<std::uint32_t>(count), 0}, {}};
    CubeLevel& cubes = found.cubes;
    cubes.size_mm = cellSize_mm(static_cast<double>(count), areaOf(used));
    cubes.table = KeyTable(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Cube cube = cubeOf(used.place_mm[i], cubes.size_mm);
        const int side = sideOf(used.normal[i]);
        const std::uint32_t cell = cubes.table.add(keyOf(cube, side), static_cast<std::uint32_t>(found.sums.size()));
        if (cell == found.sums.size()) {
            found.sums.emplace_back();
            cubes.cube.push_back(cube);
            cubes.side.push_back(side);
        }
        found.points.cell[i] = cell;
        found.sums[cell].points += 1;
        found.sums[cell].place_mm += used.place_mm[i];
        found.sums[cell].normal += used.normal[i].cast<double>();
    }
    found.points.cell_count = found.sums.size();
    return found;
}

/// Takes the points from the cells that hold stray points only. `level`: the cells that have points, joined.
void removeStrayCells(const CellLevel& level, double reach_mm, std::vector<SurfaceCell>& cells)
{
    const StrayCells strays(level.cells, reach_mm);
    std::vector<const SurfaceCell*> around;
    for (std::size_t c = 0, number = 0; c < cells.size(); ++c) {
        if (cells[c].points == 0) continue;
        const std::size_t here = number++;
        if (!strays.isSparse(cells[c])) continue;
        around.clear();
        for (std::uint32_t k = level.first[here]; k < level.first[here + 1]; ++k)
            around.push_back(&level.cells[level.neighbours[k]]);
        if (strays.isStray(cells[c], around)) cells[c].points = 0;
    }
}

/// The cells of the next level: cubes of twice the size. Fills the parents in `level`.
CubeLevel coarserCubes(const CubeLevel& cubes, CellLevel& level, CellLevel& coarser)
{
    CubeLevel next;
    next.size_mm = 2 * cubes.size_mm;
    next.table = KeyTable(level.cells.size());
    for (std::size_t c = 0; c < level.cells.size(); ++c) {
        const Cube& cube = cubes.cube[c];
        const Cube half{cube[0] >> 1, cube[1] >> 1, cube[2] >> 1};
        const std::uint32_t parent =
            next.table.add(keyOf(half, cubes.side[c]), static_cast<std::uint32_t>(coarser.cells.size()));
        if (parent == coarser.cells.size()) {
            coarser.cells.emplace_back();
            next.cube.push_back(half);
            next.side.push_back(cubes.side[c]);
        }
        coarser.cells[parent].add(level.cells[c]);
        level.parent.push_back(parent);
    }
    return next;
}

/// The cells that have points, joined to windows, and the levels above.
std::vector<CellLevel> cubeLevels(const std::vector<SurfaceCell>& cells, const CubeLevel& cubes,
                                  const Progress& progress)
{
    std::vector<CellLevel> levels(1);
    CubeLevel kept = keepFilled(cells, cubes, levels[0]);
    for (int k = 0;; ++k) {
        CellLevel& level = levels.back();
        level.size_mm = kept.size_mm;
        joinCubes(kept, level, progress);
        CellLevel coarser;
        CubeLevel next = coarserCubes(kept, level, coarser);
        if (coarser.cells.size() * 100 > level.cells.size() * generalCells.shrinking_percent ||
            k + 1 == generalCells.most_levels) {
            level.parent.clear();
            return levels;
        }
        kept = std::move(next);
        levels.push_back(std::move(coarser));
    }
}

}  // namespace

SurfaceWindows generalWindows(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3f>& normals,
                              const CompareResult& result, const Progress& progress)
{
    SurfaceWindows all;
    all.has_sign = result.has_sign;
    const AlignmentUncertainty& u = result.alignment.uncertainty;
    all.axial_sigma_mm = u.axial_um / (2 * um_per_mm);
    all.tilt_sigma = u.axis_deg * std::numbers::pi / 360;
    const CountedPoints used = pointsOf(points, normals, result);
    all.middle_mm = used.middle_mm;
    if (used.place_mm.empty()) return all;

    const SmallestCubes smallest = smallestCubes(used);
    const CubeLevel& cubes = smallest.cubes;
    CellMeans means = cellMeans(smallest.points, progress);
    std::vector<SurfaceCell>& cells = means.cells;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        cells[c].place_mm = smallest.sums[c].place_mm / smallest.sums[c].points;
        cells[c].normal = smallest.sums[c].normal / smallest.sums[c].points;
    }
    const std::vector<bool> is_edge = edgeCells(cells, cubes.side, std::max(smearedEdge_mm, cubes.size_mm));
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (is_edge[c]) cells[c].points = 0;
    CellLevel with_strays;
    joinCubes(keepFilled(cells, cubes, with_strays), with_strays, progress);
    removeStrayCells(with_strays, means.reach_mm, cells);
    all.counted.assign(points.size(), 0);
    for (std::size_t i = 0; i < used.number.size(); ++i)
        if (cells[smallest.points.cell[i]].points > 0) all.counted[used.number[i]] = means.counted[i];

    all.middle_mm = Eigen::Vector3d::Zero();  // the places are about the middle until the windows are made
    makeWindows(cubeLevels(cells, cubes, progress), all, progress);
    all.middle_mm = used.middle_mm;
    for (SurfaceWindow& window : all.windows) window.place_mm += used.middle_mm.cast<float>();
    return all;
}

}  // namespace lathelier::registration
