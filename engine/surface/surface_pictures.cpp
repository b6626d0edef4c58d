#include "engine/surface/surface_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/units.h"
#include "engine/report/svg.h"
#include "engine/surface/picture_comparison.h"
#include "engine/surface/preparation.h"
#include "engine/surface/stripes.h"
#include "engine/surface/surface_plots.h"

namespace lathelier::surface {
namespace {

constexpr double sheet = 720;   // width in SVG units
constexpr int widest_px = 900;  // largest width of an embedded picture
constexpr double closest = 5;   // smallest distance of drawn lines in SVG units
constexpr double textSize = 13;
constexpr double tallest = 900;  // SVG units

Grid shrunk(const Grid& grid)
{
    return grid.columns > widest_px ? reduced(grid, double(grid.columns) / widest_px) : grid;
}

std::string hexOf(const report::ChartColour& colour, std::size_t position = 0)
{
    return report::hex(report::colourOf(colour, position));
}

void scaleBar(report::Svg& svg, double mm_per_unit, double right, double bottom, const Language& language)
{
    const double mm = roundBelow(0.25 * sheet * mm_per_unit), units = mm / mm_per_unit;
    const Text unit = unit::mm, shown = shownUnit(unit, language).unit;
    svg.rect(right - units - 16, bottom - 34, units + 12, 30, "#ffffff");
    svg.rect(right - units - 10, bottom - 12, units, 4, "#000000");
    svg.text(right - 10 - units / 2, bottom - 17, report::Svg::Anchor::Middle, textSize,
             shownNumber(mm, unit, mm < 1 ? 2 : 0, language) + " " + text(shown.empty() ? unit : shown, language));
}

/// A labelled band of lines with the given pitch across the picture.
void ruler(report::Svg& svg, const std::string& name, double pitch, double lean, double top, double width,
           std::string_view colour)
{
    constexpr double tall = 14;
    svg.rect(0, top, width, tall + 18, "#ffffff");
    if (pitch >= closest)
        for (double x = pitch / 2; x < width; x += pitch)
            svg.line(x, top + 18, x + tall * lean, top + 18 + tall, colour, 1.4);
    svg.text(6, top + 13, report::Svg::Anchor::Start, textSize, name);
}

}  // namespace

double roundBelow(double largest)
{
    const double power = std::pow(10, std::floor(std::log10(largest)));
    for (const double step : {5.0, 2.0})
        if (step * power <= largest) return step * power;
    return power;
}

std::string markedPictureSvg(const ImageMarks& image, const SurfaceParameters& parameters, const Language& language)
{
    const SurfaceView& view = image.view;
    const Grid& flat = view.flat;
    double units = sheet / flat.columns;  // SVG units per pixel
    if (flat.rows * units > tallest) units = tallest / flat.rows;
    const double width = flat.columns * units, height = flat.rows * units;
    const double mm_per_unit = view.px_per_px * image.mm_per_px.value_or(0) / units;
    const bool has_feed_ruler = parameters.feed_mm_rev && mm_per_unit > 0;
    const double rulers = image.feed_marks ? (has_feed_ruler ? 68 : 34) : 0;
    report::Svg svg(sheet, height + rulers, text(LT_TEXT("Engine", "Picture without its uneven light"), language));
    svg.png(0, 0, width, height, report::encodePng(greyOf(shrunk(flat), -flatRange, flatRange)));
    const auto draw = [&](const std::optional<Vector>& wave, const std::string& colour, double line, double opacity) {
        if (!wave || units / length(*wave) < closest) return;
        std::string path;
        for (const auto& [a, b] : stripesOf(*wave, phaseOf(flat, *wave), flat.columns, flat.rows))
            for (const auto& [letter, at] : {std::pair{'M', a}, std::pair{'L', b}}) {
                path += letter;
                path += report::coordinate(at.x * units);
                path += ' ';
                path += report::coordinate(at.y * units);
            }
        svg.path(path, colour, line, "none", opacity);
    };
    draw(view.feed, hexOf(0), 0.8, 0.7);
    draw(view.bands, hexOf(1, 1), 2, 0.9);
    if (mm_per_unit > 0) scaleBar(svg, mm_per_unit, width, height, language);
    if (!image.feed_marks || !view.feed) return svg.finish();
    const double lean = view.feed->x != 0 ? -view.feed->y / view.feed->x : 0;
    const double pitch = units / length(*view.feed) / std::max(0.2, std::abs(std::cos(std::atan(lean))));
    ruler(svg, text(LT_TEXT("Engine", "marks found"), language), pitch, lean, height, width, hexOf(0));
    if (has_feed_ruler)
        ruler(svg, text(LT_TEXT("Engine", "feed"), language),
              *parameters.feed_mm_rev / mm_per_unit / std::max(0.2, std::abs(std::cos(std::atan(lean)))), lean,
              height + 34, width, hexOf(report::ColourRole::Limit));
    return svg.finish();
}

std::string comparisonSvg(const SurfaceResult& result, const std::vector<std::string>& names, const Language& language)
{
    const AlignedPictures both = aligned({result.images.begin(), result.images.begin() + 2},
                                         result.comparison ? result.comparison->shift : Vector{});
    constexpr double gap = 12;
    const Grid& size = both.pictures[0];
    const double units = std::min((sheet - gap) / 2 / size.columns, tallest / size.rows);
    const double width = size.columns * units, height = size.rows * units;
    report::Svg svg(sheet, height + 24, text(LT_TEXT("Engine", "Before and after"), language));
    for (std::size_t i = 0; i < 2; ++i) {
        const double left = static_cast<double>(i) * (width + gap);
        svg.png(left, 0, width, height, report::encodePng(greyOf(shrunk(both.pictures[i]), -flatRange, flatRange)));
        svg.text(left + width / 2, height + 17, report::Svg::Anchor::Middle, textSize,
                 i < names.size() ? names[i] : std::string());
    }
    if (both.mm_per_px > 0) scaleBar(svg, both.mm_per_px / units, 2 * width + gap, height, language);
    return svg.finish();
}

}  // namespace lathelier::surface
