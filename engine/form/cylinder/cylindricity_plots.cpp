#include "engine/form/cylinder/cylindricity_plots.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/report/colours.h"

namespace lathelier::form {
namespace {

report::Axis zAxis(const CylinderSurface& surface)
{
    report::Axis axis{LT_TEXT("Engine", "Along the axis, from the first data"), unit::mm};
    axis.range = Interval{surface.z_start_mm, surface.z_start_mm + surface.z_step_mm * surface.z_count};
    return axis;
}

}  // namespace

double colourLimit_um(const CylinderSurface& surface)
{
    constexpr double share = 0.99;  // share of the cells within the limit of the colour scale
    std::vector<float> sizes;
    for (const float value : surface.mean_um)
        if (!std::isnan(value)) sizes.push_back(std::abs(value));
    if (sizes.empty()) return 1;
    const float size = lowerQuantileInPlace(sizes, share);
    return report::niceLimit(size > 0 ? static_cast<double>(size) : 1.0);
}

report::ColourMap unrolledCylinder(const CylinderSurface& surface)
{
    report::ColourMap map;
    map.title = LT_TEXT("Engine", "Unrolled surface");
    map.x = zAxis(surface);
    map.y = {LT_TEXT("Engine", "Angle about the axis"), unit::deg};
    map.value = {LT_TEXT("Engine", "Deviation"), unit::um};
    map.x_from = map.x.range->from;
    map.x_to = map.x.range->to;
    map.y_to = 360;
    map.columns = surface.z_count;
    map.rows = surface.angle_count;
    const auto columns = static_cast<std::size_t>(map.columns), rows = static_cast<std::size_t>(map.rows);
    map.values.resize(columns * rows);
    for (std::size_t z = 0; z < columns; ++z)
        for (std::size_t angle = 0; angle < rows; ++angle)
            map.values[angle * columns + z] = surface.mean_um[z * rows + angle];
    map.limit = colourLimit_um(surface);
    return map;
}

report::Plot radiusAlongAxis(const CylinderSurface& surface, const CylindricityParameters& parameters)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Local radius along the axis");
    plot.x = zAxis(surface);
    plot.y = {LT_TEXT("Engine", "Deviation from the cylinder's radius"), unit::um};
    report::Curve range{LT_TEXT("Engine", "all points"), surface.z_mm, surface.highest_um, report::Curve::Style::Band,
                        surface.lowest_um};
    report::Curve mean{LT_TEXT("Engine", "local radius"), surface.z_mm, surface.mean_row_um};
    range.colour = mean.colour = report::ColourRole::Copy;
    plot.curves = {std::move(range), std::move(mean)};
    // Only the upper line of a pair appears in the legend.
    const auto addPair = [&plot](double half_um, const Text& name) {
        report::Limit limit;
        limit.place = -half_um;
        plot.limits.push_back(limit);
        limit.place = half_um;
        limit.name = name;
        plot.limits.push_back(limit);
    };
    double edge = surface.cylinder.CYLt_um / 2;
    addPair(edge, LT_TEXT("Engine", "minimum zone"));
    if (parameters.tolerance_um) {
        addPair(*parameters.tolerance_um / 2, LT_TEXT("Engine", "tolerance"));
        edge = std::max(edge, *parameters.tolerance_um / 2);
    }
    if (edge > 0) plot.y.range = Interval{-1.2 * edge, 1.2 * edge};
    return plot;
}

report::Plot centresAlongAxis(const CylinderSurface& surface)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Axis of the local circles");
    plot.x = zAxis(surface);
    plot.y = {LT_TEXT("Engine", "Centre, from the cylinder's axis"), unit::um};
    plot.curves = {{LT_TEXT("Engine", "x"), surface.z_mm, surface.centre_x_um},
                   {LT_TEXT("Engine", "y"), surface.z_mm, surface.centre_y_um, report::Curve::Style::Dashed}};
    for (report::Curve& curve : plot.curves) curve.colour = report::ColourRole::Original;
    plot.curves.back().colour = report::ColourRole::Copy;
    return plot;
}

}  // namespace lathelier::form
