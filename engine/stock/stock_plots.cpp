#include "engine/stock/stock_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/texts.h"

namespace lathelier::stock {
namespace {

constexpr double slender = 6;  ///< smallest ratio of length to radius of a slender part

/// One region for each closed polyline.
void addRegions(report::Plot& plot, Text name, report::ColourRole colour, const StockOutline& outline)
{
    bool is_open = false;
    for (std::size_t i = 0; i < outline.z_mm.size(); ++i) {
        if (std::isnan(outline.z_mm[i])) {
            is_open = false;
            continue;
        }
        if (!is_open) {
            report::Region& region = plot.regions.emplace_back();
            if (i == 0) region.name = name;
            region.colour = colour;
            is_open = true;
        }
        plot.regions.back().x.push_back(outline.z_mm[i]);
        plot.regions.back().y.push_back(outline.x_mm[i]);
    }
}

report::Curve outlineCurve(report::Caption name, const StockOutline& outline)
{
    report::Curve curve{std::move(name), outline.z_mm, outline.x_mm};
    curve.has_readout = false;
    return curve;
}

std::string passName(std::size_t index, const StockPass& pass, const Language& language)
{
    return fill(text(LT_TEXT("Engine", "pass {pass}, line {line}"), language),
                {{"pass", static_cast<std::int64_t>(index + 1)}, {"line", pass.line}}, language);
}

/// Indices of passes with stored outline, up to `last`.
std::vector<std::size_t> keptPasses(const StockResult& result, const std::optional<std::size_t>& last)
{
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < result.passes.size() && (!last || i <= *last); ++i)
        if (result.passes[i].is_kept) kept.push_back(i);
    return kept;
}

void addPasses(report::Plot& plot, const StockResult& result, const std::vector<std::size_t>& kept,
               const Language& language)
{
    const std::size_t every = kept.size() / mostDrawnPasses + 1;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const bool is_last = k + 1 == kept.size();
        if (!is_last && k % every != 0) continue;
        const StockPass& pass = result.passes[kept[k]];
        report::Curve curve = outlineCurve(passName(kept[k], pass, language), pass.after);
        curve.thin = !is_last;
        if (!is_last && kept.size() > 8) curve.name = std::string();
        plot.curves.push_back(std::move(curve));
    }
}

/// Upper half of a machine region; unbounded ends are clipped to the chart.
void addRegion(report::Plot& plot, Text name, const ConvexPolygon& shape)
{
    const auto shown = [](double value) {
        return std::abs(value) < endless_mm ? value : std::copysign(std::numeric_limits<double>::infinity(), value);
    };
    report::Region region{name, report::ColourRole::Limit, {}, {}};
    for (const Corner& corner : shape) {
        region.x.push_back(shown(corner.z_mm));
        region.y.push_back(std::max(0.0, shown(corner.x_mm)));
    }
    plot.regions.push_back(std::move(region));
}

}  // namespace

report::Plot stockPlot(const StockResult& result, const StockPlotParts& parts, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Stock after each pass");
    plot.x = {LT_TEXT("Engine", "z from the free end"), millimetre};
    plot.y = {LT_TEXT("Engine", "Radius"), millimetre};
    // With equal scales a slender shaft would appear as a line.
    double widest_mm = 0;
    for (const double x_mm : result.before.x_mm) widest_mm = std::fmax(widest_mm, x_mm);
    plot.equal_scales = result.length_mm < slender * widest_mm;
    addRegions(plot, LT_TEXT("Engine", "stock before"), report::ColourRole::Neutral, result.before);
    const std::vector<std::size_t> kept = keptPasses(result, parts.pass);
    if (!kept.empty())
        addRegions(plot, LT_TEXT("Engine", "stock left"), report::ColourRole::Original,
                   result.passes[kept.back()].after);
    if (result.parameters.chuck)
        addRegion(plot, LT_TEXT("Engine", "chuck"), regionOf(*result.parameters.chuck, result.length_mm));
    if (result.parameters.tailstock)
        for (const ConvexPolygon& region : regionsOf(*result.parameters.tailstock))
            addRegion(plot, LT_TEXT("Engine", "tailstock"), region);
    plot.curves.push_back(outlineCurve(std::string(), result.before));
    addPasses(plot, result, kept, language);
    if (parts.path)
        for (report::Curve& curve : parts.path->curves(parts.window)) plot.curves.push_back(std::move(curve));
    for (const StockFinding& finding : result.findings) {
        if (plot.marks.size() == mostDrawnFindings) break;
        plot.marks.push_back({finding.z_mm, finding.x_mm,
                              fill(text(LT_TEXT("Engine", "line {line}: {finding}"), language),
                                   {{"line", finding.line}, {"finding", nameOf(finding.kind)}}, language)});
    }
    return plot;
}

}  // namespace lathelier::stock
