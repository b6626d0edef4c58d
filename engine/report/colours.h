// Common palette of screen and paper: colour roles, and the colour scale of signed deviations. Deviations: one rule for
// the 3-D view, the unrolled map and the report. Blue - light grey - red, evenly spaced in Oklab (B. Ottosson, "A
// perceptual color space for image processing", 2020), so that equal steps of the value are perceived as equal, also
// with most colour vision deficiencies. Inside a tolerance band light greens are used, which differ from blue and red
// in lightness as well as hue.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace lathelier::report {

struct Rgb {
    std::uint8_t red = 0;    ///< 0 to 255
    std::uint8_t green = 0;  ///< 0 to 255
    std::uint8_t blue = 0;   ///< 0 to 255
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Role of a line or an area of a chart.
enum class ColourRole : std::uint8_t {
    Series,    ///< one of several: a series distinguishable with colour vision deficiencies (Okabe and Ito), by number
    Original,  ///< compared parts
    Copy,
    Excess,  ///< deviations: material in excess, missing, within the tolerance
    Missing,
    Within,
    Stable,  ///< regions
    Unstable,
    Neutral,
    Limit,  ///< tolerances and other limits, and the handles that move them
    Mark,   ///< a place that was picked
};

struct ChartColour {
    ColourRole role = ColourRole::Series;
    int number = -1;  ///< of a series; -1: by its position in the chart

    ChartColour() = default;
    ChartColour(ColourRole meaning) : role(meaning) {}
    ChartColour(int series) : number(series) {}
};

enum class Ground : std::uint8_t { Light, Dark };  ///< background; paper is light

Rgb colourOf(const ChartColour& colour, std::size_t position = 0, Ground ground = Ground::Light);

/// The plain diverging scale: -1 is blue (material missing), 0 light grey, +1 red (material in excess). Values beyond
/// are drawn as the ends. NaN is not drawn by callers; here it gives the colour of 0.
Rgb divergingColour(double share);

/// Inside the tolerance: green of one lightness, from bluish (share -1) to yellowish (+1), so that the form of the
/// error stays visible within tolerance.
Rgb insideColour(double share);

/// Contours on each side of the middle one, of all surfaces that are coloured in steps.
inline constexpr int contourSteps = 6;

/// Colour scale from least() to limit, green where |value| <= tolerance, if there is one. Outside the band the colours
/// start at a saturated blue and red, to distinguish just outside from just inside.
struct DeviationColours {
    double limit = 1;                   ///< upper end of the scale, > 0
    std::optional<double> tolerance{};  ///< half width of the green band, >= 0
    /// Contours without a tolerance: number of steps on each side of a middle one about 0. 0: continuous colours.
    int steps = 0;
    std::optional<double> marked{};  ///< limit marked in the scale at both signs, without effect on the colours
    std::optional<double> lower{};   ///< extent of the scale below 0, > 0; none: as above 0

    double least() const { return -lower.value_or(limit); }                    ///< lower end of the scale
    double endOf(double value) const { return value < 0 ? -least() : limit; }  ///< distance of that side's end from 0
    Rgb operator()(double value) const;
    friend bool operator==(const DeviationColours&, const DeviationColours&) = default;
};

/// A readable limit for data whose largest interesting |value| is `largest_mm`: 1, 1.5, 2, 3, 4, 5, 6 or 8 × 10^n, not
/// below it.
double niceLimit(double largest_mm);

}  // namespace lathelier::report
