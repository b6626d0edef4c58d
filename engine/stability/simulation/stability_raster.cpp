#include "engine/stability/simulation/stability_raster.h"

#include <atomic>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/stability/simulation/growth.h"
#include "engine/stability/simulation/simulation.h"

namespace lathelier::stability {
namespace {

constexpr double rasterStepsPerPeriod = 24;  ///< gives the growth to a few parts in a thousand
constexpr int warmUp = 14;                   ///< revolutions
constexpr int rasterSnapshots = 8;           ///< revolutions
constexpr double shownGrowth = 0.5;          ///< |ln growth| at the ends of the colour scale

void require(bool fine, const char* parameter, Text expected)
{
    if (!fine)
        throw Error(errors::valueNotUnderstood, {{"parameter", parameter}, {"found", Value()}, {"expected", expected}});
}

void checkRaster(const std::vector<Mode>& modes, const RasterParameters& p)
{
    require(!modes.empty(), "mode", LT_TEXT("Engine", "at least one mode"));
    require(p.columns >= 2 && p.rows >= 2, "columns", LT_TEXT("Engine", "at least two columns and rows"));
    require(p.speed_rpm.from > 0 && p.speed_rpm.to > p.speed_rpm.from, "speed_rpm",
            LT_TEXT("Engine", "a range such as 1000:4000"));
    require(p.depth_mm.from >= 0 && p.depth_mm.to > p.depth_mm.from, "depth_mm",
            LT_TEXT("Engine", "a range such as 0:1"));
    require(!p.process_damping_N_mm || (p.diameter_mm && *p.diameter_mm > 0), "diameter_mm",
            LT_TEXT("Engine", "the diameter for the process damping"));
}

}  // namespace

RasterResult stabilityRaster(const std::vector<Mode>& modes, const RasterParameters& p, const Progress& progress)
{
    checkRaster(modes, p);
    RasterResult result;
    result.parameters = p;
    result.speed_rpm.reserve(static_cast<std::size_t>(p.columns));
    for (int i = 0; i < p.columns; ++i)
        result.speed_rpm.push_back(p.speed_rpm.from + (p.speed_rpm.to - p.speed_rpm.from) * i / (p.columns - 1));
    result.depth_mm.reserve(static_cast<std::size_t>(p.rows));
    for (int i = 0; i < p.rows; ++i)
        result.depth_mm.push_back(p.depth_mm.from + (p.depth_mm.to - p.depth_mm.from) * (i + 0.5) / p.rows);
    const std::size_t columns = result.speed_rpm.size(), rows = result.depth_mm.size();
    result.growth.resize(columns * rows);
    std::atomic<std::size_t> done{0};
    parallelFor(columns, 1, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<CutForces> cuts(rows);
        for (std::size_t column = begin; column < end; ++column) {
            const double speed_rpm = result.speed_rpm[column];
            for (std::size_t row = 0; row < rows; ++row) {
                const double depth_mm = result.depth_mm[row];
                cuts[row] = {p.cutting_coefficient_N_mm2 * depth_mm, 0, p.direction_factor};
                if (p.process_damping_N_mm)
                    cuts[row].damping_N_s_mm =
                        dampingOfCut(*p.process_damping_N_mm, depth_mm, *p.diameter_mm, speed_rpm);
            }
            GrowthEffort effort;
            effort.steps = static_cast<int>(stepsOfRevolution(modes, 60 / speed_rpm, rasterStepsPerPeriod));
            effort.warm_up = warmUp;
            effort.snapshots = rasterSnapshots;
            const std::vector<Growth> growths = growthsOf(modes, cuts, 60 / speed_rpm, effort, progress.quiet());
            for (std::size_t row = 0; row < rows; ++row)
                result.growth[row * columns + column] = static_cast<float>(growths[row].per_revolution);
            progress.report(static_cast<double>(++done) / static_cast<double>(columns));
        }
    });
    return result;
}

report::ColourMap rasterMap(const RasterResult& result)
{
    const RasterParameters& p = result.parameters;
    report::ColourMap map;
    map.title = LT_TEXT("Engine", "Growth of the vibration per revolution");
    map.x = {LT_TEXT("Engine", "Spindle speed"), unit::rpm};
    map.y = {LT_TEXT("Engine", "Depth of cut"), unit::mm};
    map.value = {LT_TEXT("Engine", "Natural logarithm of the growth"), Text{}};
    const double half = (p.speed_rpm.to - p.speed_rpm.from) / (p.columns - 1) / 2;
    map.x_from = p.speed_rpm.from - half;
    map.x_to = p.speed_rpm.to + half;
    map.y_from = p.depth_mm.from;
    map.y_to = p.depth_mm.to;
    map.columns = p.columns;
    map.rows = p.rows;
    map.limit = shownGrowth;
    map.values.reserve(result.growth.size());
    for (const float growth : result.growth) map.values.push_back(std::log(growth));
    return map;
}

}  // namespace lathelier::stability
