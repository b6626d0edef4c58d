// One palette for the screen and for paper: what a colour says, and the colours of signed deviations.
// Deviations: one rule for the 3-D view, the unrolled map and the report. Blue - light grey - red, evenly spaced in
// Oklab (B. Ottosson, "A perceptual color space for image processing", 2020), so that equal steps of the value look
// equally large, also to most colour-blind people. Inside a tolerance band the colours are light greens that are told
// from blue and red by lightness as well as by hue.
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

/// What a line or an area of a chart stands for.
enum class ColourRole : std::uint8_t {
    Series,    ///< one of several: a row that colour-blind eyes can tell apart (Okabe and Ito), by number
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
    ColourRole role = ColourRole::Series;  ///< what the colour stands for
    int number = -1;                       ///< of a series; -1: by its position in the chart

    ChartColour() = default;
    ChartColour(ColourRole meaning) : role(meaning) {}
    ChartColour(int series) : number(series) {}
};

enum class Ground : std::uint8_t { Light, Dark };  ///< that is drawn on; paper is light

Rgb colourOf(const ChartColour& colour, std::size_t position = 0, Ground ground = Ground::Light);

/// The plain diverging scale: -1 is blue (material missing), 0 light grey, +1 red (material in excess). Values beyond
/// are drawn as the ends. NaN is not drawn by callers; here it gives the colour of 0.
Rgb divergingColour(double share);

/// Inside the tolerance: green of one lightness, from bluish (share -1) to yellowish (+1), so that the form of the
/// error stays visible where all is well.
Rgb insideColour(double share);

/// What is drawn from least() to limit, and green where |value| <= tolerance, if there is one.
/// Outside the band the colours start at a clear blue and red, so that "just outside" does not look like "just inside".
struct DeviationColours {
    double limit = 1;                   ///< upper end of the scale, > 0
    std::optional<double> tolerance{};  ///< >= 0
    /// Contours without a tolerance: so many steps on each side of a middle one about 0. 0: the colours run into each
    /// other.
    int steps = 0;
    std::optional<double> marked{};  ///< a limit that the scale shows as lines at both signs, and that colours nothing
    std::optional<double> lower{};   ///< how far the scale goes below 0, > 0; none: as far as above

    double least() const { return -lower.value_or(limit); }                    ///< lower end of the scale
    double endOf(double value) const { return value < 0 ? -least() : limit; }  ///< distance of that side's end from 0
    Rgb operator()(double value) const;
    friend bool operator==(const DeviationColours&, const DeviationColours&) = default;
};

/// A readable limit for data whose largest interesting |value| is `largest_mm`: 1, 1.5, 2, 3, 4, 5, 6 or 8 × 10^n, not
/// below it.
double niceLimit(double largest_mm);

}  // namespace lathelier::report
