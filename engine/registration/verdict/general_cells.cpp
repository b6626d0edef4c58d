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
#include "engine/registration/scanner_spot.h"
#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {
namespace {

using Cube = std::array<std::int32_t, 3>;

constexpr double smoothCellCosine = 0.8;  // cosine between normals; a smaller one within a cell is an edge
constexpr double sameSideCosine = 0.7;    // cosine between normals of cells that may be averaged
// Radius of windows, in sizes of a cell: of about 9, 13 and 21 cells.
constexpr std::array<double, 3> windowRadii_cells = {1.6, 2.1, 2.5};
constexpr double squareSidePerRadius = 1.77;  // √π: from the radius of a circle to the side of a square of its area
constexpr int mostLevels = 12;
constexpr std::uint32_t noCell = CellPoints::noCell;

/// Where a normal points, as one of six sides (three where the deviation has no sign: then 0, 2, 4).
int sideOf(const Eigen::Vector3f& normal)
{
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return static_cast<int>(2 * axis) + (normal[axis] < 0 ? 1 : 0);
}

/// 20 bits for each coordinate, 3 for the side.
std::uint64_t keyOf(const Cube& cube, int side)
{
    std::uint64_t key = 0;
    for (const std::int32_t c : cube) key = key << 20 | (static_cast<std::uint32_t>(c + (1 << 19)) & 0xfffffU);
    return key << 3 | static_cast<std::uint64_t>(side);
}

/// Hash table from keys to consecutive numbers (open addressing).
class KeyTable {
public:
    explicit KeyTable(std::size_t most)
    {
        std::size_t size = 16;
        while (size < 2 * most) size *= 2;
        slots_.assign(size, {emptySlot, noCell});
    }

    std::uint32_t find(std::uint64_t key) const { return slots_[place(key)].second; }
    /// The number of the key, `next` when it is new.
    std::uint32_t add(std::uint64_t key, std::uint32_t next)
    {
        auto& slot = slots_[place(key)];
        if (slot.first == emptySlot) slot = {key, next};
        return slot.second;
    }

private:
    static constexpr std::uint64_t emptySlot = ~std::uint64_t{0};

    std::size_t place(std::uint64_t key) const
    {
        std::size_t at = (key * 0x9e3779b97f4a7c15ULL >> 20) & (slots_.size() - 1);
        while (slots_[at].first != emptySlot && slots_[at].first != key) at = (at + 1) & (slots_.size() - 1);
        return at;
    }

    std::vector<std::pair<std::uint64_t, std::uint32_t>> slots_;
};

Cube cubeOf(const Eigen::Vector3d& place, double size)
{
    Cube cube{};
    for (int a = 0; a < 3; ++a)
        cube[static_cast<std::size_t>(a)] =
            static_cast<std::int32_t>(std::clamp(std::floor(place[a] / size), -500000.0, 500000.0));
    return cube;
}

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
    const double cube = std::max(size / 60, 1e-9);
    KeyTable table(std::min<std::size_t>(points.place_mm.size(), 400000) + 16);
    std::vector<Eigen::Vector3f> normals;
    for (std::size_t i = 0; i < points.place_mm.size(); ++i) {
        const std::uint32_t cell = table.add(keyOf(cubeOf(points.place_mm[i], cube), sideOf(points.normal[i])),
                                             static_cast<std::uint32_t>(normals.size()));
        if (cell == normals.size()) normals.push_back(points.normal[i]);
        if (normals.size() >= 400000) break;
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

void joinCubes(const CubeLevel& cubes, CellLevel& level, const Progress& progress)
{
    const std::size_t count = level.cells.size();
    struct Found {
        std::array<std::vector<std::uint32_t>, windowRadii_cells.size()> rings;
        std::array<std::array<std::uint32_t, 2>, 3> row{};
    };
    std::vector<Found> found(count);
    KeyTable occupied(count + 16);  // most cubes about a surface are empty: looked up once for all sides
    std::vector<std::uint8_t> sides;
    for (std::size_t c = 0; c < count; ++c) {
        const std::uint32_t number = occupied.add(keyOf(cubes.cube[c], 0), static_cast<std::uint32_t>(sides.size()));
        if (number == sides.size()) sides.push_back(0);
        sides[number] = static_cast<std::uint8_t>(sides[number] | 1U << static_cast<unsigned>(cubes.side[c]));
    }
    parallelFor(count, 1024, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            const SurfaceCell& here = level.cells[c];
            const Cube& cube = cubes.cube[c];
            Found& mine = found[c];
            const auto look = [&](const Cube& at) {
                const std::uint32_t held = occupied.find(keyOf(at, 0));
                if (held == noCell) return;
                for (int side = 0; side < 6; ++side) {
                    if ((side ^ 1) == cubes.side[c] || (sides[held] >> side & 1) == 0) continue;
                    const std::uint32_t other = cubes.table.find(keyOf(at, side));
                    const SurfaceCell& there = level.cells[other];
                    if (here.normal.dot(there.normal) < sameSideCosine * here.normal.norm() * there.normal.norm())
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
                mine.row[a] = {cubes.table.find(keyOf(before, cubes.side[c])),
                               cubes.table.find(keyOf(after, cubes.side[c]))};
            }
        }
    });
    for (const double radius : windowRadii_cells)
        level.window_mm.push_back(squareSidePerRadius * radius * cubes.size_mm);
    level.first.push_back(0);
    for (std::uint32_t c = 0; c < count; ++c) {
        const Found& mine = found[c];
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
    KeyTable table(cells.size() + 1);
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
        for (int k = 0; k < 27 * 6 && !is_edge[c]; ++k) {
            const Cube at{cube[0] + k / 6 % 3 - 1, cube[1] + k / 18 % 3 - 1, cube[2] + k / 54 - 1};
            const std::uint32_t other = table.find(keyOf(at, k % 6));
            if (other == noCell || points[other] < 2) continue;
            const double cosine =
                normals[other].dot(cells[c].normal) / (normals[other].norm() * cells[c].normal.norm());
            is_edge[c] = cosine < smoothCellCosine &&
                         cosine > -smoothCellCosine;  // opposite normals belong to the two sides of a thin wall
        }
    }
    return is_edge;
}

/// The cells that have points, in `level`.
CubeLevel keepFilled(const std::vector<SurfaceCell>& cells, const CubeLevel& cubes, CellLevel& level)
{
    CubeLevel kept;
    kept.size_mm = cubes.size_mm;
    kept.table = KeyTable(cells.size() + 16);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (cells[c].points == 0) continue;
        kept.table.add(keyOf(cubes.cube[c], cubes.side[c]), static_cast<std::uint32_t>(level.cells.size()));
        kept.cube.push_back(cubes.cube[c]);
        kept.side.push_back(cubes.side[c]);
        level.cells.push_back(cells[c]);
    }
    return kept;
}

}  // namespace

SurfaceWindows generalWindows(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3f>& normals,
                              const CompareResult& result, const Progress& progress)
{
    SurfaceWindows all;
    all.has_sign = result.has_sign;
    const AlignmentUncertainty& u = result.alignment.uncertainty;
    all.axial_sigma_mm = u.axial_um / 2000;
    all.tilt_sigma = u.axis_deg * std::numbers::pi / 360;
    const CountedPoints used = pointsOf(points, normals, result);
    all.middle_mm = used.middle_mm;
    if (used.place_mm.empty()) return all;

    const double size = cellSize_mm(static_cast<double>(used.place_mm.size()), areaOf(used));
    CubeLevel cubes;
    cubes.size_mm = size;
    cubes.table = KeyTable(used.place_mm.size() + 16);
    CellPoints sorted{used.deviation_mm, std::vector<std::uint32_t>(used.place_mm.size()), 0};
    std::vector<SurfaceCell> sums;
    for (std::size_t i = 0; i < used.place_mm.size(); ++i) {
        const Cube cube = cubeOf(used.place_mm[i], size);
        const int side = sideOf(used.normal[i]);
        const std::uint32_t cell = cubes.table.add(keyOf(cube, side), static_cast<std::uint32_t>(sums.size()));
        if (cell == sums.size()) {
            sums.emplace_back();
            cubes.cube.push_back(cube);
            cubes.side.push_back(side);
        }
        sorted.cell[i] = cell;
        sums[cell].points += 1;
        sums[cell].place_mm += used.place_mm[i];
        sums[cell].normal += used.normal[i].cast<double>();
    }
    sorted.cell_count = sums.size();
    CellMeans means = cellMeans(sorted, progress);
    std::vector<SurfaceCell>& cells = means.cells;
    all.counted.assign(points.size(), 0);
    for (std::size_t i = 0; i < used.number.size(); ++i) all.counted[used.number[i]] = means.counted[i];
    for (std::size_t c = 0; c < cells.size(); ++c) {
        cells[c].place_mm = sums[c].place_mm / sums[c].points;
        cells[c].normal = sums[c].normal / sums[c].points;
    }
    const std::vector<bool> is_edge = edgeCells(cells, cubes.side, std::max(smearedEdge_mm, size));

    for (std::size_t c = 0; c < cells.size(); ++c)
        if (is_edge[c]) cells[c].points = 0;
    std::vector<CellLevel> levels(1);
    CubeLevel kept = keepFilled(cells, cubes, levels[0]);
    joinCubes(kept, levels[0], progress);
    const StrayCells strays(levels[0].cells, means.reach_mm);
    std::vector<const SurfaceCell*> around;
    for (std::size_t c = 0, number = 0; c < cells.size(); ++c) {
        if (cells[c].points == 0) continue;
        const std::size_t here = number++;
        if (!strays.isSparse(cells[c])) continue;
        around.clear();
        for (std::uint32_t k = levels[0].first[here]; k < levels[0].first[here + 1]; ++k)
            around.push_back(&levels[0].cells[levels[0].neighbours[k]]);
        if (strays.isStray(cells[c], around)) cells[c].points = 0;
    }
    for (std::size_t i = 0; i < used.number.size(); ++i)
        if (cells[sorted.cell[i]].points == 0) all.counted[used.number[i]] = 0;
    levels[0] = {};
    kept = keepFilled(cells, cubes, levels[0]);
    for (int k = 0; k < mostLevels; ++k) {
        CellLevel& level = levels.back();
        level.size_mm = kept.size_mm;
        joinCubes(kept, level, progress);
        CubeLevel next;
        next.size_mm = 2 * kept.size_mm;
        next.table = KeyTable(level.cells.size() + 16);
        CellLevel coarser;
        for (std::size_t c = 0; c < level.cells.size(); ++c) {
            const Cube& cube = kept.cube[c];
            const Cube half{cube[0] >> 1, cube[1] >> 1, cube[2] >> 1};
            const std::uint32_t parent =
                next.table.add(keyOf(half, kept.side[c]), static_cast<std::uint32_t>(coarser.cells.size()));
            if (parent == coarser.cells.size()) {
                coarser.cells.emplace_back();
                next.cube.push_back(half);
                next.side.push_back(kept.side[c]);
            }
            coarser.cells[parent].add(level.cells[c]);
            level.parent.push_back(parent);
        }
        if (coarser.cells.size() * 10 > level.cells.size() * 9 || k + 1 == mostLevels) {
            level.parent.clear();
            break;
        }
        kept = std::move(next);
        levels.push_back(std::move(coarser));
    }
    all.middle_mm = Eigen::Vector3d::Zero();  // the places are about the middle until the windows are made
    makeWindows(levels, all, progress);
    all.middle_mm = used.middle_mm;
    for (SurfaceWindow& window : all.windows) window.place_mm += used.middle_mm.cast<float>();
    return all;
}

}  // namespace lathelier::registration
