#include "engine/deflection/deflection_plots.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/deflection/deflection_quantities.h"
#include "engine/report/quantity_table.h"

namespace lathelier::deflection {
namespace {

constexpr double gapFactor = 4;  ///< points more than this many typical steps apart are separated by a gap

report::Plot alongZ(Text title, Text quantity, Text unit)
{
    report::Plot plot;
    plot.title = title;
    plot.x = {LT_TEXT("Engine", "z from the free end"), unit::mm};
    plot.y = {quantity, unit};
    return plot;
}

/// Interrupted where the tool does not cut.
report::Curve curveOf(report::Caption name, const std::vector<double>& z_mm, const std::vector<double>& values,
                      const std::vector<std::size_t>& gaps = {})
{
    report::Curve curve;
    curve.name = std::move(name);
    curve.x.reserve(z_mm.size());
    curve.y.reserve(z_mm.size());
    const double usual_mm = z_mm.size() > 1 ? (z_mm.back() - z_mm.front()) / static_cast<double>(z_mm.size() - 1) : 0;
    for (std::size_t i = 0; i < z_mm.size(); ++i) {
        if (i > 0 &&
            (z_mm[i] - z_mm[i - 1] > gapFactor * usual_mm || std::binary_search(gaps.begin(), gaps.end(), i))) {
            curve.x.push_back((z_mm[i] + z_mm[i - 1]) / 2);
            curve.y.push_back(notANumber);
        }
        curve.x.push_back(z_mm[i]);
        curve.y.push_back(values[i]);
    }
    return curve;
}

std::string passName(std::size_t index, const PassResult& pass, const Language& language)
{
    return fill(text(LT_TEXT("Engine", "pass {pass}, line {line}"), language),
                {{"pass", static_cast<std::int64_t>(index + 1)}, {"line", pass.line}}, language);
}

}  // namespace

report::Plot errorPlot(const DeflectionResult& result, const ErrorPlotParts& parts, const Language& language)
{
    report::Plot plot =
        alongZ(LT_TEXT("Engine", "Diameter error along the work"), LT_TEXT("Engine", "Diameter error"), micrometre);
    if (parts.band) {
        report::Curve band{LT_TEXT("Engine", "95 % of the samples"), parts.band->z_mm, parts.band->high_um};
        band.style = report::Curve::Style::Band;
        band.y_low = parts.band->low_um;
        band.colour = report::ColourRole::Neutral;
        band.has_readout = false;
        plot.curves.push_back(std::move(band));
    }
    const bool several = result.passes.size() > 1;
    for (std::size_t i = 0; several && i < result.passes.size(); ++i) {
        report::Curve curve =
            curveOf(passName(i, result.passes[i], language), result.passes[i].z_mm, result.passes[i].diameter_error_um);
        curve.style = report::Curve::Style::Dashed;
        plot.curves.push_back(std::move(curve));
    }
    const auto add = [&](report::Caption name, const FinalContour& contour) {
        plot.curves.push_back(curveOf(std::move(name), contour.z_mm, contour.diameter_error_um, contour.gaps));
    };
    add(LT_TEXT("Engine", "predicted"), result.final);
    if (parts.corrected) add(LT_TEXT("Engine", "corrected program"), parts.corrected->after);
    if (!parts.measured.empty()) {
        report::Curve points{LT_TEXT("Engine", "measured"), {}, {}};
        points.style = report::Curve::Style::Points;
        points.colour = report::ColourRole::Mark;
        for (const ComparedDiameter& one : parts.measured) {
            points.x.push_back(one.z_mm);
            points.y.push_back(one.measured_um);
        }
        plot.curves.push_back(std::move(points));
    }
    if (parts.tolerance_um)
        for (const double sign : {1.0, -1.0}) {
            report::Limit& limit = plot.limits.emplace_back();
            limit.place = sign * *parts.tolerance_um;
            if (sign > 0) limit.name = LT_TEXT("Engine", "tolerance");
        }
    return plot;
}

report::Plot forcesPlot(const PassResult& pass)
{
    report::Plot plot = alongZ(LT_TEXT("Engine", "Cutting forces"), LT_TEXT("Engine", "Force"), unit::newton);
    plot.curves = {curveOf(LT_TEXT("Engine", "F_t, along the cutting speed"), pass.z_mm, pass.F_t_N),
                   curveOf(LT_TEXT("Engine", "F_f, along the feed"), pass.z_mm, pass.F_f_N),
                   curveOf(LT_TEXT("Engine", "F_ap, radial"), pass.z_mm, pass.F_ap_N)};
    return plot;
}

report::Plot powerPlot(const DeflectionResult& result, double cutting_speed_m_min, const Language& language)
{
    report::Plot plot = alongZ(LT_TEXT("Engine", "Cutting power"), LT_TEXT("Engine", "Power"), LT_TEXT("Engine", "kW"));
    for (std::size_t i = 0; i < result.passes.size(); ++i) {
        std::vector<double> powers = result.passes[i].F_t_N;
        for (double& value : powers) value *= cutting_speed_m_min / 60 / 1000;
        plot.curves.push_back(curveOf(passName(i, result.passes[i], language), result.passes[i].z_mm, powers));
    }
    return plot;
}

report::Plot depthPlot(const DeflectionResult& result, const Language& language)
{
    report::Plot plot = alongZ(LT_TEXT("Engine", "Depth of cut"), LT_TEXT("Engine", "Depth"), millimetre);
    for (std::size_t i = 0; i < result.passes.size(); ++i)
        plot.curves.push_back(
            curveOf(passName(i, result.passes[i], language), result.passes[i].z_mm, result.passes[i].depth_mm));
    return plot;
}

report::Plot shapePlot(const DeflectedShape& shape)
{
    report::Plot plot = alongZ(LT_TEXT("Engine", "Bent axis of the work"), LT_TEXT("Engine", "Deflection"), micrometre);
    plot.curves = {report::Curve{LT_TEXT("Engine", "toward the tool"), shape.z_mm, shape.x_um},
                   report::Curve{LT_TEXT("Engine", "along the cutting speed"), shape.z_mm, shape.y_um}};
    report::Handle handle;
    handle.key = toolKey;
    handle.kind = report::Handle::Kind::Vertical;
    handle.x = shape.tool_z_mm;
    handle.name = LT_TEXT("Engine", "tool");
    if (!shape.z_mm.empty()) handle.x_range = Interval{shape.z_mm.front(), shape.z_mm.back()};
    plot.handles.push_back(std::move(handle));
    return plot;
}

report::Plot feedPlot(const FeedResult& result)
{
    report::Plot plot =
        alongZ(LT_TEXT("Engine", "Feed that holds the tolerance"), LT_TEXT("Engine", "Feed"), unit::mm_rev);
    plot.curves = {curveOf(LT_TEXT("Engine", "feed of the last pass"), result.z_mm, result.feed_mm_rev)};
    return plot;
}

report::Table sensitivityTable(const std::vector<Sensitivity>& swings)
{
    return report::listTable<Sensitivity>(
        LT_TEXT("Engine", "Sensitivities"), swings,
        {"influence_name", "max_um_minus", "max_um_plus", "mean_abs_um_minus", "mean_abs_um_plus"});
}

report::Table diameterTable(const IdentificationResult& result)
{
    return report::listTable<ComparedDiameter>(
        LT_TEXT("Engine", "Predicted and measured"), result.diameters,
        {"z_mm", "measured_um", "before_um", "after_um", "uncertainty_um", "E_n"});
}

report::Table robustnessTable(const std::vector<RobustnessRow>& rows)
{
    return report::listTable<RobustnessRow>(
        LT_TEXT("Engine", "The corrected program on other machines"), rows,
        {"plant_name", "mean_abs_before_um", "mean_abs_after_um", "max_after_um", "reduction_percent"});
}

report::Plot correctionPlot(const CompensationResult& result, const Language& language)
{
    report::Plot plot =
        alongZ(LT_TEXT("Engine", "Correction of the program"), LT_TEXT("Engine", "Correction on diameter"), micrometre);
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
        report::Curve curve;
        curve.name = fill(text(LT_TEXT("Engine", "pass {pass}"), language),
                          {{"pass", static_cast<std::int64_t>(i + 1)}}, language);
        for (const CorrectedNode& node : result.runs[i].nodes)
            if (node.in_material) {
                curve.x.push_back(node.z_mm);
                curve.y.push_back(node.correction_um());
            }
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

}  // namespace lathelier::deflection
