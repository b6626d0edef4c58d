// Cells of the surface in levels, each twice as large as those before, and the windows made of neighbouring cells.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/registration/verdict/surface_windows.h"

namespace lathelier::registration {

/// The points of the copy on a small piece of surface.
struct SurfaceCell {
    Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();  ///< centroid of the points, in the reference's frame
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< mean of the surface's unit normals
    double points = 0;                                   ///< number of points
    double mean_mm = 0;                                  ///< of their deviations
    double squares_mm2 = 0;                              ///< sum of squares about the means of the smallest cells
    double smallest = 0;                                 ///< number of smallest cells
    float z_start_mm = 0;                                ///< extent along the axis
    float z_end_mm = 0;
    std::int32_t stretch = -1;  ///< index of the stretch of the meridian; -1: none

    void add(const SurfaceCell& other);
};

/// How large the smallest cells are to be for so many points on so much surface: half a point each on average, no
/// larger than the point density requires, and bounded in number for the run time.
double cellSize_mm(double points, double area_mm2);

/// Cells of one size.
struct CellLevel {
    double size_mm = 0;                     ///< side of a cell
    std::vector<double> window_mm;          ///< size of each window about a cell, from small to large; 0: by its cells
    std::vector<SurfaceCell> cells;         ///< with points only
    std::vector<std::uint32_t> parent;      ///< of each cell: its place in the next level; empty in the last
    std::vector<std::uint32_t> first;       ///< neighbours of cell i: from first[i] to first[i + 1] - 1
    std::vector<std::uint32_t> neighbours;  ///< the nearest first, itself included
    std::vector<std::uint32_t> counts;      ///< of each window of each cell: how many of its neighbours it holds
    /// Triples of collinear cells in up to three directions: their second differences give the noise of the means.
    std::array<std::vector<std::array<std::uint32_t, 3>>, 3> rows;
};

/// Which cell each point falls into.
struct CellPoints {
    std::span<const float> deviation_mm;  ///< of every point of the copy
    std::vector<std::uint32_t> cell;      ///< of each point; noCell where it belongs to none
    std::size_t cell_count = 0;           ///< number of cells
    static constexpr std::uint32_t noCell = 0xffffffff;
};

/// Cells without stray points, which are further than 6 robust standard deviations of the surface from the median of
/// their cell.
struct CellMeans {
    std::vector<SurfaceCell> cells;     ///< with points, mean_mm and squares_mm2; the caller fills the other members
    std::vector<std::uint8_t> counted;  ///< of each point: 1 where it counts
    double reach_mm = 0;                ///< points further from the local median are stray
};
CellMeans cellMeans(const CellPoints& points, const Progress& progress);

/// Finds cells that hold stray points only: at most three points, and either out of reach of the neighbouring cells or
/// with hardly any neighbours.
class StrayCells {
public:
    StrayCells(const std::vector<SurfaceCell>& cells, double reach_mm);

    /// So few points that isStray() decides from the cells around.
    bool isSparse(const SurfaceCell& cell) const;
    /// `around`: the cells of the window about it, itself included. Their order is changed.
    bool isStray(const SurfaceCell& cell, std::vector<const SurfaceCell*>& around) const;

private:
    double reach_mm_;
    double usual_;  ///< number of points of a cell
};

/// Coverage factor for the extreme of `windows` windows (Šidák), with one-sided or two-sided errors. Overlapping
/// windows are correlated: the `about` windows about each place count as two thirds of an independent one; at least two
/// in all.
double coverageFactorOfWorst(std::size_t windows, std::size_t about, int sides);

/// Scatter about the local means, variance inflation by correlated neighbours, and the windows of all levels with their
/// uncertainty from noise, reference and registration. Precondition: everything else of `result` is filled.
void makeWindows(const std::vector<CellLevel>& levels, SurfaceWindows& result, const Progress& progress);

}  // namespace lathelier::registration
