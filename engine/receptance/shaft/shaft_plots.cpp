#include "engine/receptance/shaft/shaft_plots.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/receptance/shaft/shaft_contour.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t mostDimensioned = 12;  ///< largest number of segments with dimensions, so that labels do not
                                             ///< overlap
constexpr double step_mm = 0.1;              ///< step of a dragged dimension
constexpr char handleStart[] = "end of segment ";

/// The wall above (sign 1) or below (-1) the axis.
report::Region wall(const ShaftContour& contour, double sign)
{
    report::Region region;
    region.colour = report::ColourRole::Original;
    region.x = contour.z_mm;
    for (const double radius_mm : contour.radius_mm) region.y.push_back(sign * radius_mm);
    for (std::size_t i = contour.z_mm.size(); i-- > 0;) {
        region.x.push_back(contour.z_mm[i]);
        region.y.push_back(sign * contour.bore_mm[i]);
    }
    return region;
}

report::Curve line(std::vector<double> x, std::vector<double> y, report::Caption name = {})
{
    report::Curve curve{std::move(name), std::move(x), std::move(y)};
    curve.has_readout = false;
    curve.colour = report::ColourRole::Original;
    for (std::size_t i = 0; i < curve.x.size(); ++i) curve.along.push_back(static_cast<double>(i));
    return curve;
}

report::Region box(report::Caption name, double from_mm, double to_mm, double low_mm, double high_mm)
{
    return {std::move(name),
            report::ColourRole::Limit,
            {from_mm, to_mm, to_mm, from_mm},
            {low_mm, low_mm, high_mm, high_mm}};
}

double radiusAt(const ShaftContour& contour, double z_mm)
{
    double radius_mm = contour.radius_mm.back();
    for (std::size_t i = contour.z_mm.size(); i-- > 0;)
        if (contour.z_mm[i] >= z_mm) radius_mm = contour.radius_mm[i];
    return radius_mm;
}

/// Jaws behind the chuck face; a wedge under each further support.
void addSupports(report::Plot& plot, const ShaftContour& contour, const ShaftHolding& holding, double length_mm)
{
    const double depth_mm = std::max(0.08 * length_mm, 0.3 * contour.largest_mm);
    const double end_mm = contour.radius_mm.back();
    const auto jaws = [&](Text name) {
        for (const double sign : {1.0, -1.0})
            plot.regions.push_back(box(sign > 0 ? name : Text{}, length_mm, length_mm + depth_mm, sign * 0.2 * end_mm,
                                       sign * 1.5 * end_mm));
    };
    if (holding.spindle)
        jaws(holding.spindle->springs() ? LT_TEXT("Engine", "spindle on springs")
                                        : LT_TEXT("Engine", "spindle, measured"));
    bool named = false;
    for (const beam::Support& support : holding.supports) {
        if (std::isinf(support.radial_N_mm) && support.z_mm == length_mm) {
            jaws(LT_TEXT("Engine", "clamped"));
            continue;
        }
        const double radius_mm = radiusAt(contour, support.z_mm), half_mm = 0.25 * depth_mm;
        for (const double sign : {1.0, -1.0}) {
            report::Region wedge;
            if (!named) wedge.name = LT_TEXT("Engine", "rest");
            named = true;
            wedge.colour = report::ColourRole::Limit;
            wedge.x = {support.z_mm, support.z_mm + half_mm, support.z_mm - half_mm};
            wedge.y = {sign * radius_mm, sign * (radius_mm + depth_mm), sign * (radius_mm + depth_mm)};
            plot.regions.push_back(std::move(wedge));
        }
    }
}

int decimalsOf(double value)
{
    return std::abs(value - std::round(value)) < 5e-4             ? 0
           : std::abs(10 * value - std::round(10 * value)) < 5e-3 ? 1
                                                                  : 2;
}

void addDimensions(report::Plot& plot, const Shaft& shaft, double largest_mm, const Language& language)
{
    const auto number = [&](double value_mm) {
        return shownNumber(value_mm, unit::mm, decimalsOf(value_mm), language);
    };
    double z_mm = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        const double start_mm = segment.start_diameter_mm, end_mm = segment.end_diameter_mm;
        const double middle_mm = z_mm + segment.length_mm / 2;
        z_mm += segment.length_mm;
        if (segment.length_mm <= 0) continue;
        std::string diameter("⌀ ");
        diameter += number(start_mm);
        if (start_mm != end_mm) diameter.append("/").append(number(end_mm));
        plot.marks.push_back({middle_mm, std::max(start_mm, end_mm) / 2, std::move(diameter)});
        plot.marks.push_back({middle_mm, -1.35 * largest_mm, number(segment.length_mm)});
        const double low_mm = -1.35 * largest_mm;
        const std::vector<double> ends_mm{z_mm - segment.length_mm, z_mm};
        for (report::Curve dimension :
             {line({z_mm, z_mm}, {-end_mm / 2, 1.1 * low_mm}), line(ends_mm, {low_mm, low_mm})}) {
            dimension.thin = true;
            dimension.colour = report::ColourRole::Neutral;
            plot.curves.push_back(std::move(dimension));
        }
    }
}

void addHandles(report::Plot& plot, const Shaft& shaft)
{
    double z_mm = 0;
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) {
        const double start_mm = z_mm;
        z_mm += shaft.segments[i].length_mm;
        report::Handle handle{handleStart + std::to_string(i + 1), report::Handle::Kind::Point, z_mm,
                              shaft.segments[i].end_diameter_mm / 2};
        const bool last = i + 1 == shaft.segments.size();
        handle.x_range =
            Interval{start_mm + step_mm, last ? 3 * z_mm : z_mm + shaft.segments[i + 1].length_mm - step_mm};
        if (handle.x_range->to < handle.x_range->from) handle.x_range = Interval{z_mm, z_mm};
        handle.y_range = Interval{shaft.segments[i].bore_diameter_mm / 2 + step_mm, 10 * std::max(1.0, handle.y)};
        plot.handles.push_back(std::move(handle));
    }
}

double rounded(double value)
{
    return std::round(value / step_mm) / std::round(1 / step_mm);
}

}  // namespace

report::Plot shaftDrawing(const Shaft& shaft, const ShaftHolding& holding, bool handles, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Shaft");
    plot.x = {LT_TEXT("Engine", "z from the free end"), unit::mm};
    plot.y = {LT_TEXT("Engine", "Radius"), unit::mm};
    plot.equal_scales = true;
    const ShaftContour contour = contourOf(shaft);
    if (contour.z_mm.empty()) return plot;
    const double length_mm = shaft.length_mm();
    for (const double sign : {1.0, -1.0}) plot.regions.push_back(wall(contour, sign));
    addSupports(plot, contour, holding, length_mm);
    for (const double sign : {1.0, -1.0}) {
        std::vector<double> z_mm = contour.z_mm, radius_mm;
        for (const double radius : contour.radius_mm) radius_mm.push_back(sign * radius);
        z_mm.insert(z_mm.begin(), 0);
        radius_mm.insert(radius_mm.begin(), 0);
        z_mm.push_back(length_mm);
        radius_mm.push_back(0);
        plot.curves.push_back(line(std::move(z_mm), std::move(radius_mm)));
    }
    const double over_mm = 0.05 * length_mm;
    report::Curve axis = line({-over_mm, length_mm + over_mm}, {0, 0});
    axis.style = report::Curve::Style::Dashed;
    axis.colour = report::ColourRole::Neutral;
    plot.curves.push_back(std::move(axis));
    if (shaft.segments.size() > mostDimensioned) return plot;
    addDimensions(plot, shaft, contour.largest_mm, language);
    if (handles) addHandles(plot, shaft);
    return plot;
}

std::optional<std::size_t> segmentOfHandle(const std::string& key)
{
    const std::string start(handleStart);
    if (!key.starts_with(start)) return std::nullopt;
    return static_cast<std::size_t>(std::stoul(key.substr(start.size()))) - 1;
}

Shaft dragged(Shaft shaft, std::size_t index, double z_mm, double radius_mm)
{
    if (index >= shaft.segments.size()) return shaft;
    ShaftSegment& segment = shaft.segments[index];
    double start_mm = 0;
    for (std::size_t i = 0; i < index; ++i) start_mm += shaft.segments[i].length_mm;
    double length_mm = std::max(step_mm, rounded(z_mm - start_mm));
    if (index + 1 < shaft.segments.size()) {
        ShaftSegment& next = shaft.segments[index + 1];
        const double both_mm = segment.length_mm + next.length_mm;
        if (both_mm > 2 * step_mm) {
            length_mm = std::min(length_mm, both_mm - step_mm);
            next.length_mm = both_mm - length_mm;
        } else {
            length_mm = segment.length_mm;
        }
    }
    const bool cylinder = segment.start_diameter_mm == segment.end_diameter_mm && !segment.arc_radius_mm;
    segment.length_mm = length_mm;
    segment.end_diameter_mm = std::max(rounded(2 * radius_mm), segment.bore_diameter_mm + 2 * step_mm);
    if (cylinder) segment.start_diameter_mm = segment.end_diameter_mm;
    return shaft;
}

report::Plot modeShapesPlot(const ShaftStudy& study, double swing, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Mode shapes");
    plot.x = {LT_TEXT("Engine", "z from the free end"), unit::mm};
    plot.y = {LT_TEXT("Engine", "Deflection, largest 1"), Text{}};
    plot.y.range = Interval{-1.1, 1.1};
    for (std::size_t i = 0; i < study.modes.size(); ++i) {
        const beam::ModeShape& mode = study.modes[i];
        report::Curve curve{
            fill(text(LT_TEXT("Engine", "{mode}: {frequency} Hz"), language),
                 {{"mode", static_cast<std::int64_t>(i + 1)}, {"frequency", fixed(mode.frequency_hz, 1, language)}},
                 language),
            study.places_z_mm,
            {}};
        curve.y.reserve(mode.deflection.size());
        for (const double deflection : mode.deflection) curve.y.push_back(swing * deflection);
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

}  // namespace lathelier::receptance
