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
    Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();  ///< mean of the points
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< mean of the surface's unit normals
    double points = 0;                                   ///< number of points
    double mean_mm = 0;                                  ///< of their deviations
    double squares_mm2 = 0;                              ///< sum of squares about the means of the smallest cells
    double smallest = 0;                                 ///< number of smallest cells
    float z_start_mm = 0;                                ///< extent along the axis
    float z_end_mm = 0;                                  ///< likewise
    std::int32_t stretch = -1;                           ///< of the meridian

    void add(const SurfaceCell& other);
};

/// How large the smallest cells are to be for so many points on so much surface: half a dozen points each, and no
/// larger than the data ask for, but not more cells than are worth their time.
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
    /// Three cells in a row, in each of up to three directions: their second differences show the noise of means.
    std::array<std::vector<std::array<std::uint32_t, 3>>, 3> rows;
};

/// Which cell each point falls into.
struct CellPoints {
    std::span<const float> deviation_mm;  ///< of all points
    std::vector<std::uint32_t> cell;      ///< of each point; kOutside where it belongs to none
    std::size_t cell_count = 0;           ///< number of cells
    static constexpr std::uint32_t kOutside = 0xffffffff;
};

/// Cells without the points that are stray: further from the median of their cell than 6 robust standard deviations of
/// the surface.
struct CellMeans {
    std::vector<SurfaceCell> cells;  ///< number of points, mean deviation, sum of squares; the rest is for the caller
    std::vector<std::uint8_t> counted;  ///< of each point: 1 where it counts
    double reach_mm = 0;                ///< what is further from the local median is stray
};
CellMeans cellMeans(const CellPoints& points, const Progress& progress);

/// Finds cells of stray points alone: of three points or fewer and out of reach of what lies around them, or with next
/// to nothing around them.
class StrayCells {
public:
    StrayCells(const std::vector<SurfaceCell>& cells, double reach_mm);

    /// So few points that the cells around them have to say whether they are stray.
    bool isInQuestion(const SurfaceCell& cell) const;
    /// `around`: the cells of the window about it, itself included. Their order is changed.
    bool isStray(const SurfaceCell& cell, std::vector<const SurfaceCell*>& around) const;

private:
    double reach_mm_;
    double usual_;  ///< number of points of a cell
};

/// Allowance for the worst of so many windows, in standard uncertainties: Šidák's, of errors to one side or both.
/// Neighbouring windows overlap, and those about one place hold the same points: of `about` windows about each place
/// two thirds of a window count as independent, and two at least in all.
double allowanceOfWorst(std::size_t windows, std::size_t about, int sides);

/// Scatter about the local means, how alike neighbours are, and the windows of all levels with their uncertainty from
/// noise, reference and registration. Everything else of `result` has to be there.
void makeWindows(const std::vector<CellLevel>& levels, SurfaceWindows& result, const Progress& progress);

}  // namespace lathelier::registration
