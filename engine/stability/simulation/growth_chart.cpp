#include "engine/stability/simulation/growth_chart.h"

#include "engine/core/texts.h"

namespace lathelier::stability {
namespace {

void setGround(report::Plot& plot, const RasterResult* raster)
{
    if (!raster) return;
    plot.ground = rasterMap(*raster);
    plot.regions.clear();
    plot.remark = LT_TEXT("Engine", "red: the vibration grows, blue: it dies out");
}

}  // namespace

report::Plot growthChart(const LobeResult& lobes, const RasterResult* raster, const OperatingPoint& point,
                         const Language& language)
{
    report::Plot plot = lobesPlot(lobes, {nullptr, nullptr, point}, language);
    setGround(plot, raster);
    return plot;
}

report::Plot comparisonChart(const LobeResult& exact, const LobeResult& published, const RasterResult* raster,
                             const OperatingPoint& point, const Language& language)
{
    report::Plot plot = lobesPlot(exact, {nullptr, nullptr, point}, language);
    plot.title = LT_TEXT("Engine", "Published relation against the exact one");
    plot.regions.clear();
    plot.marks.clear();
    plot.curves = {{LT_TEXT("Engine", "exact limit"), exact.limit.speed_rpm, exact.limit.depth_mm},
                   {LT_TEXT("Engine", "limit as published, N = 60 f/k"), published.limit.speed_rpm,
                    published.limit.depth_mm, report::Curve::Style::Dashed}};
    plot.curves.front().colour = report::ColourRole::Limit;
    setGround(plot, raster);
    return plot;
}

}  // namespace lathelier::stability
