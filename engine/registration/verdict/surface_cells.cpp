#include "engine/registration/verdict/surface_cells.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"

namespace lathelier::registration {
namespace {

/// Size of the cells, stray points, and the noise of a mean (registration/README.md, "Thresholds").
struct SurfaceCellThresholds {
    double points_per_cell = 0.5;          ///< on average: the smallest window holds nine cells
    double finest_mm2 = 0.36;              ///< smaller cells only where their number stays small
    double usual_cells = 30000;            ///< up to so many cells are smaller
    double most_cells = 400000;            ///< for the run time
    double stray_sigmas = 6;               ///< robust standard deviations from the median of the cell
    std::size_t spread_points = 60000;     ///< about so many points, if there are as many, give the stray limit
    std::size_t largest_spread_step = 16;  ///< and at least every 16th cell
    std::size_t spread_cell_points = 4;    ///< least number of points of such a cell
    double spread_correction = 0.8;        ///< points: the median distance of n normal values is short by n / (n - 0.8)
    double few_in_cell = 3;                ///< with no more points a stray one may shift the median of a cell
    double stray_share = 0.1;              ///< of the usual number of points in a window: fewer are stray points
    double usual_window_cells = 37;        ///< of that window: the largest one (revolution_grids.h)
    double family_error_rate = 0.05;       ///< chance that any window of a perfect surface exceeds the allowance
    double prior_points = 50;              ///< weight of the overall scatter in the scatter of a window
    std::size_t least_differences = 24;    ///< second differences for a variance,
    std::size_t least_part = 4;            ///< and this part (1 / n) of the cells: across widely spaced scan lines
                                           ///< stray points are neighbours
    double coincident_mm = 1e-9;           ///< smaller deviations are rounding errors
};
constexpr SurfaceCellThresholds cellThresholds{};

constexpr std::size_t cellsPerTask = 2048;

/// Positions of the points of each cell in `order`.
struct CellOrder {
    std::vector<std::uint32_t> first;  ///< of cell i: from first[i] to first[i + 1] - 1
    std::vector<std::uint32_t> order;  ///< numbers of points
};

CellOrder sortByCell(const CellPoints& points)
{
    CellOrder sorted;
    sorted.first.assign(points.cell_count + 1, 0);
    for (const std::uint32_t c : points.cell)
        if (c != CellPoints::noCell) ++sorted.first[c + 1];
    for (std::size_t c = 0; c < points.cell_count; ++c) sorted.first[c + 1] += sorted.first[c];
    sorted.order.resize(sorted.first.back());
    std::vector<std::uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
    for (std::uint32_t i = 0; i < points.cell.size(); ++i)
        if (points.cell[i] != CellPoints::noCell) sorted.order[next[points.cell[i]]++] = i;
    return sorted;
}

double robustSigma(std::vector<float>& absolute_values)
{
    return absolute_values.empty() ? 0 : madToSigma * medianInPlace(absolute_values);
}

/// Variance of the mean of a cell times its points over the variance of a point: 1 for independent points.
double inflationAt(const CellLevel& level, double scatter_mm)
{
    double variance_inflation = 0;
    for (const auto& rows : level.rows) {
        if (rows.size() < cellThresholds.least_differences ||
            rows.size() < level.cells.size() / cellThresholds.least_part)
            continue;
        std::vector<float> sizes;
        sizes.reserve(rows.size());
        for (const auto& [a, b, c] : rows) {
            const SurfaceCell& left = level.cells[a];
            const SurfaceCell& here = level.cells[b];
            const SurfaceCell& right = level.cells[c];
            const double difference = left.mean_mm - 2 * here.mean_mm + right.mean_mm;
            const double scale = 1 / left.points + 4 / here.points + 1 / right.points;
            sizes.push_back(static_cast<float>(std::abs(difference) / std::sqrt(scale)));
        }
        const double sigma = robustSigma(sizes);
        variance_inflation = std::max(variance_inflation, sigma * sigma / (scatter_mm * scatter_mm));
    }
    return variance_inflation;
}

/// Variance inflation at each level; with too few cells that of the level before.
std::vector<double> inflationsOf(const std::vector<CellLevel>& levels, double scatter_mm)
{
    std::vector<double> seen(levels.size(), 1);
    if (scatter_mm > 0)
        for (std::size_t k = 0; k < levels.size(); ++k) seen[k] = inflationAt(levels[k], scatter_mm);
    for (std::size_t k = 1; k < seen.size(); ++k)
        if (seen[k] == 0) seen[k] = seen[k - 1];
    for (double& variance_inflation : seen) variance_inflation = std::max(variance_inflation, 1.0);
    return seen;
}

/// Variance inflation of a window `sizes` cells of this level wide: the maximum over sizes up to its own, since the
/// correlation length may exceed a cell. Linear in the logarithm of the size between levels.
double inflationOfWindow(const std::vector<double>& seen, std::size_t level, double sizes)
{
    const double last = static_cast<double>(seen.size() - 1);
    const double at = std::min(static_cast<double>(level) + std::max(0.0, std::log2(sizes)), last);
    const auto below = static_cast<std::size_t>(at);
    double variance_inflation = seen[below];
    if (below + 1 < seen.size())
        variance_inflation += (at - static_cast<double>(below)) * (seen[below + 1] - seen[below]);
    for (std::size_t k = level; k <= below; ++k) variance_inflation = std::max(variance_inflation, seen[k]);
    return variance_inflation;
}

/// Standard uncertainty of the mean of a window of this size from the reference's own noise and the registration.
double fixedSigma(const SurfaceWindows& all, const SurfaceCell& sum, double size_mm)
{
    const Eigen::Vector3d lever = sum.place_mm - all.middle_mm;
    if (!all.axis_T_reference) {
        const double shift = all.axial_sigma_mm * sum.normal.norm();
        const double turn = all.tilt_sigma * lever.cross(sum.normal).norm();
        return std::hypot(shift, turn);
    }
    const Eigen::Vector3d axis = all.axis_T_reference->linear().row(2);
    const double along = sum.normal.dot(axis);
    const double across = (sum.normal - along * axis).norm();
    const Eigen::Vector3d turn = lever.cross(sum.normal);
    double variance = std::pow(along * all.axial_sigma_mm, 2) + std::pow(across * all.radial_sigma_mm, 2) +
                      std::pow(all.tilt_sigma * (turn - turn.dot(axis) * axis).norm(), 2);
    if (sum.stretch >= 0) {
        const MeridianStretch& stretch = all.stretches[static_cast<std::size_t>(sum.stretch)];
        const double extent_mm = stretch.isFace() ? std::min(size_mm, stretch.extent_mm())
                                                  : static_cast<double>(sum.z_end_mm - sum.z_start_mm);
        const double bins = std::max(1.0, extent_mm / stretch.reference_step_mm);
        variance += std::pow(stretch.reference_sigma_mm, 2) / bins;
    }
    return std::sqrt(variance);
}

SurfaceWindow windowOf(const SurfaceCell& sum, double size_mm, double variance_inflation, const SurfaceWindows& all)
{
    const double degrees = std::max(0.0, sum.points - sum.smallest);
    const double pooled = all.scatter_mm * all.scatter_mm;
    constexpr double priorPoints = cellThresholds.prior_points;
    const double variance = (priorPoints * pooled + sum.squares_mm2) / (priorPoints + degrees);
    // Ratio of Student's quantile to the normal one at the level of the extreme of many (Peiser's expansion), since a
    // window's scatter is estimated from few points.
    const double few = 1 + (all.factor * all.factor + 1) / (4 * (priorPoints + degrees));
    SurfaceWindow window;
    window.place_mm = sum.place_mm.cast<float>();
    window.normal = sum.normal.cast<float>();
    window.z_start_mm = sum.z_start_mm;
    window.z_end_mm = sum.z_end_mm;
    window.size_mm = static_cast<float>(size_mm);
    window.points = static_cast<float>(sum.points);
    window.mean_mm = static_cast<float>(sum.mean_mm);
    window.sigma_mm = static_cast<float>(
        std::hypot(few * std::sqrt(variance_inflation * variance / sum.points), fixedSigma(all, sum, size_mm)));
    window.stretch = sum.stretch;
    return window;
}

/// The deviations of the points of cell `c`.
void deviationsOf(const CellPoints& points, const CellOrder& sorted, std::size_t c, std::vector<float>& values)
{
    values.clear();
    for (std::uint32_t k = sorted.first[c]; k < sorted.first[c + 1]; ++k)
        values.push_back(points.deviation_mm[sorted.order[k]]);
}

/// Distance from the median of a cell beyond which a point is stray, from the spread of the cells with sufficient
/// points; infinite without such cells.
double strayReach_mm(const CellPoints& points, const CellOrder& sorted, const Progress& progress)
{
    const std::size_t every = std::clamp<std::size_t>(points.cell.size() / cellThresholds.spread_points, 1,
                                                      cellThresholds.largest_spread_step);
    std::vector<float> spreads((points.cell_count + every - 1) / every, -1);  // median distance from the median
    parallelFor(spreads.size(), cellsPerTask, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<float> values;
        for (std::size_t k = begin; k < end; ++k) {
            deviationsOf(points, sorted, every * k, values);
            if (values.size() < cellThresholds.spread_cell_points) continue;
            const auto median = static_cast<float>(medianInPlace(values));
            for (float& v : values) v = std::abs(v - median);
            const auto n = static_cast<double>(values.size());
            spreads[k] = static_cast<float>(medianInPlace(values) * n / (n - cellThresholds.spread_correction));
        }
    });
    std::erase_if(spreads, [](float v) { return v < 0; });
    if (spreads.empty()) return std::numeric_limits<double>::infinity();
    return cellThresholds.stray_sigmas * robustSigma(spreads);
}

/// Number, mean and squares of the points of cell `c` within reach of its median. `values`: their deviations, which are
/// put into another order.
void sumCell(const CellPoints& points, const CellOrder& sorted, std::size_t c, std::vector<float>& values,
             CellMeans& result)
{
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    // Values that are all within reach of each other are within reach of their median: it need not be computed.
    const bool is_close = static_cast<double>(*most - *least) <= result.reach_mm;
    const double middle = is_close ? static_cast<double>(*least) : medianInPlace(values);
    SurfaceCell& cell = result.cells[c];
    double sum = 0;
    double squares = 0;
    for (std::uint32_t k = sorted.first[c]; k < sorted.first[c + 1]; ++k) {
        const double off = static_cast<double>(points.deviation_mm[sorted.order[k]]) - middle;
        if (!is_close && std::abs(off) > result.reach_mm) continue;
        result.counted[sorted.order[k]] = 1;
        cell.points += 1;
        sum += off;
        squares += off * off;
    }
    if (cell.points == 0) return;
    cell.smallest = 1;
    cell.mean_mm = middle + sum / cell.points;
    cell.squares_mm2 = std::max(0.0, squares - sum * sum / cell.points);
}

/// Standard deviation of the points about the means of their cells.
double scatterOfCells(const std::vector<SurfaceCell>& cells)
{
    double squares = 0;
    double degrees = 0;
    for (const SurfaceCell& cell : cells) {
        squares += cell.squares_mm2;
        degrees += cell.points - 1;
    }
    return degrees > 0 ? std::sqrt(squares / degrees) : 0;
}

/// Identical data: the pose and the reference have no uncertainty.
void clearUncertaintyOfSame(const std::vector<SurfaceCell>& cells, SurfaceWindows& result)
{
    const auto isZero = [](const SurfaceCell& cell) { return std::abs(cell.mean_mm) < cellThresholds.coincident_mm; };
    if (!(result.scatter_mm < cellThresholds.coincident_mm) || !std::all_of(cells.begin(), cells.end(), isZero)) return;
    result.axial_sigma_mm = result.radial_sigma_mm = result.tilt_sigma = 0;
    for (MeridianStretch& stretch : result.stretches) stretch.reference_sigma_mm = 0;
}

/// The windows about cell `c` of level `k`. `start`: where the windows of each level begin.
void addWindowsAbout(const std::vector<CellLevel>& levels, std::size_t k, std::size_t c,
                     const std::vector<std::size_t>& start, const std::vector<double>& variance_inflation,
                     SurfaceWindows& result)
{
    const CellLevel& level = levels[k];
    const std::size_t about = result.about;
    const std::size_t place = start[k] + about * c;
    SurfaceCell sum;
    std::uint32_t next = level.first[c];
    for (std::size_t w = 0; w < about; ++w) {
        const std::uint32_t cells_held = level.counts[about * c + w];
        while (next < level.first[c] + cells_held) sum.add(level.cells[level.neighbours[next++]]);
        const double fixed = level.window_mm[w];
        const double size_mm = fixed > 0 ? fixed : level.size_mm * std::sqrt(static_cast<double>(cells_held));
        SurfaceWindow& window = result.windows[place + w];
        window = windowOf(sum, size_mm, inflationOfWindow(variance_inflation, k, size_mm / level.size_mm), result);
        if (w + 1 < about)
            window.wider = static_cast<std::uint32_t>(place + w + 1);
        else if (k + 1 < levels.size())
            window.wider = static_cast<std::uint32_t>(start[k + 1] + about * std::size_t{level.parent[c]});
    }
    result.windows[place].smallest = k == 0;
}

}  // namespace

void SurfaceCell::add(const SurfaceCell& other)
{
    if (points == 0) {
        *this = other;
        return;
    }
    const double share = other.points / (points + other.points);
    place_mm += share * (other.place_mm - place_mm);
    normal += share * (other.normal - normal);
    mean_mm += share * (other.mean_mm - mean_mm);
    points += other.points;
    squares_mm2 += other.squares_mm2;
    smallest += other.smallest;
    z_start_mm = std::min(z_start_mm, other.z_start_mm);
    z_end_mm = std::max(z_end_mm, other.z_end_mm);
}

double cellSize_mm(double points, double area_mm2)
{
    const double fine_mm2 = std::min(area_mm2 / cellThresholds.usual_cells, cellThresholds.finest_mm2);
    const double worth_mm2 = std::max(fine_mm2, area_mm2 / cellThresholds.most_cells);
    return std::sqrt(std::max(cellThresholds.points_per_cell * area_mm2 / std::max(points, 1.0), worth_mm2));
}

CellMeans cellMeans(const CellPoints& points, const Progress& progress)
{
    const CellOrder sorted = sortByCell(points);
    CellMeans result;
    result.reach_mm = strayReach_mm(points, sorted, progress);
    result.cells.resize(points.cell_count);
    result.counted.assign(points.cell.size(), 0);
    parallelFor(points.cell_count, cellsPerTask, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<float> values;
        for (std::size_t c = begin; c < end; ++c) {
            deviationsOf(points, sorted, c, values);
            if (!values.empty()) sumCell(points, sorted, c, values, result);
        }
    });
    return result;
}

StrayCells::StrayCells(const std::vector<SurfaceCell>& cells, double reach_mm) : reach_mm_(reach_mm), usual_(0)
{
    std::vector<float> counts;
    for (const SurfaceCell& cell : cells)
        if (cell.points > 0) counts.push_back(static_cast<float>(cell.points));
    if (!counts.empty()) usual_ = medianInPlace(counts);
}

bool StrayCells::isSparse(const SurfaceCell& cell) const
{
    return cell.points > 0 && cell.points <= cellThresholds.few_in_cell;
}

bool StrayCells::isStray(const SurfaceCell& cell, std::vector<const SurfaceCell*>& around) const
{
    double all = 0;
    for (const SurfaceCell* other : around) all += other->points;
    if (all < cellThresholds.stray_share * cellThresholds.usual_window_cells * usual_) return true;
    std::sort(around.begin(), around.end(),
              [](const SurfaceCell* a, const SurfaceCell* b) { return a->mean_mm < b->mean_mm; });
    double half = 0;
    std::size_t middle = 0;
    while (middle + 1 < around.size() && (half += around[middle]->points) < all / 2) ++middle;
    return std::abs(cell.mean_mm - around[middle]->mean_mm) > reach_mm_;
}

double coverageFactorOfWorst(std::size_t windows, std::size_t about, int sides)
{
    const double independent = std::max(2.0, 2 * static_cast<double>(windows) / static_cast<double>(3 * about));
    const double single = -std::expm1(std::log1p(-cellThresholds.family_error_rate) / independent);
    return std::max(2.0, std::numbers::sqrt2 * boost::math::erfc_inv(2 * single / sides));
}

void makeWindows(const std::vector<CellLevel>& levels, SurfaceWindows& result, const Progress& progress)
{
    result.windows.clear();
    if (levels.empty() || levels.front().cells.empty()) return;
    result.scatter_mm = scatterOfCells(levels.front().cells);
    clearUncertaintyOfSame(levels.front().cells, result);
    const std::vector<double> variance_inflation = inflationsOf(levels, result.scatter_mm);
    result.variance_inflation.clear();
    for (std::size_t k = 0; k < levels.size(); ++k)
        result.variance_inflation.emplace_back(levels[k].size_mm, variance_inflation[k]);

    const std::size_t about = levels.front().window_mm.size();
    result.about = static_cast<std::uint32_t>(about);
    std::vector<std::size_t> start;
    std::size_t count = 0;
    for (const CellLevel& level : levels) {
        start.push_back(count);
        count += about * level.cells.size();
    }
    result.windows.resize(count);
    result.factor = coverageFactorOfWorst(count, about, 2);
    for (std::size_t k = 0; k < levels.size(); ++k)
        parallelFor(levels[k].cells.size(), cellsPerTask, progress, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c) addWindowsAbout(levels, k, c, start, variance_inflation, result);
        });
}

}  // namespace lathelier::registration
