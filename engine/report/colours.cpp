#include "engine/report/colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lathelier::report {
namespace {

struct Oklab {
    double lightness;
    double a;
    double b;
};

constexpr Oklab blueEnd{0.43, -0.020, -0.170};
constexpr Oklab middleColour{0.905, 0, 0};
constexpr Oklab redEnd{0.46, 0.165, 0.080};

constexpr Oklab insideMiddle{0.83, -0.095, 0.040};
constexpr double insideBlueYellow = 0.060;  ///< Oklab a/b offset from the middle to either end of the band

/// Position in the plain scale of values just outside a tolerance band.
constexpr double outsideStart = 0.6;

std::uint8_t encode(double linear)
{
    const double x = std::clamp(linear, 0.0, 1.0);
    const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * s));
}

Rgb toRgb(const Oklab& c)
{
    const double l = std::pow(c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
    const double m = std::pow(c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
    const double s = std::pow(c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
    return {encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

constexpr std::array<Rgb, 7> series{{{0x00, 0x72, 0xb2},
                                     {0xd5, 0x5e, 0x00},
                                     {0x00, 0x9e, 0x73},
                                     {0xcc, 0x79, 0xa7},
                                     {0x56, 0xb4, 0xe9},
                                     {0xe6, 0x9f, 0x00},
                                     {0x78, 0x78, 0x78}}};

/// Variant for a dark background.
Rgb lightened(const Rgb& c)
{
    const auto part = [](int value) { return static_cast<std::uint8_t>(std::lround(value + 0.3 * (255 - value))); };
    return {part(c.red), part(c.green), part(c.blue)};
}

}  // namespace

Rgb colourOf(const ChartColour& colour, std::size_t position, Ground ground)
{
    const bool dark = ground == Ground::Dark;
    const auto shown = [&](const Rgb& onLight) { return dark ? lightened(onLight) : onLight; };
    switch (colour.role) {
        case ColourRole::Series: break;
        case ColourRole::Original: return shown({31, 119, 180});
        case ColourRole::Copy: return shown({214, 39, 40});
        case ColourRole::Excess: return divergingColour(0.9);
        case ColourRole::Missing: return divergingColour(-0.9);
        case ColourRole::Within: return insideColour(0);
        case ColourRole::Stable: return shown(series[2]);
        case ColourRole::Unstable: return shown(series[1]);
        case ColourRole::Neutral: return {128, 128, 128};
        case ColourRole::Limit: return dark ? Rgb{255, 176, 64} : Rgb{176, 88, 0};
        case ColourRole::Mark: return dark ? Rgb{255, 105, 180} : Rgb{170, 0, 110};
    }
    const std::size_t number = colour.number >= 0 ? static_cast<std::size_t>(colour.number) : position;
    return shown(series[number % series.size()]);
}

Rgb divergingColour(double share)
{
    const double t = std::isnan(share) ? 0 : std::clamp(share, -1.0, 1.0);
    const Oklab& end = t < 0 ? blueEnd : redEnd;
    const double w = std::abs(t);
    return toRgb({middleColour.lightness + w * (end.lightness - middleColour.lightness),
                  middleColour.a + w * (end.a - middleColour.a), middleColour.b + w * (end.b - middleColour.b)});
}

Rgb insideColour(double share)
{
    const double t = std::isnan(share) ? 0 : std::clamp(share, -1.0, 1.0);
    return toRgb({insideMiddle.lightness, insideMiddle.a, insideMiddle.b + t * insideBlueYellow});
}

Rgb DeviationColours::operator()(double value) const
{
    if (!tolerance && steps > 0 && std::isfinite(value)) {
        const double share = std::clamp(value / endOf(value), -1.0, 1.0);
        return divergingColour(std::round(share * steps) / steps);
    }
    if (!tolerance) return divergingColour(value / endOf(value));
    const double beyond = std::abs(value) - *tolerance;
    if (!(beyond > 0)) return insideColour(*tolerance > 0 ? value / *tolerance : 0);
    const double room = endOf(value) - *tolerance;
    const double share = room > 0 ? outsideStart + (1 - outsideStart) * std::min(1.0, beyond / room) : 1.0;
    return divergingColour(std::copysign(share, value));
}

double niceLimit(double largest_mm)
{
    if (!(largest_mm > 0) || !std::isfinite(largest_mm)) return 1;
    const double decade = std::pow(10.0, std::floor(std::log10(largest_mm)));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (step * decade >= largest_mm * (1 - 1e-9)) return step * decade;
    return 10 * decade;
}

}  // namespace lathelier::report
