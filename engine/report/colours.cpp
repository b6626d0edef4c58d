#include "engine/report/colours.h"

#include <algorithm>
#include <cmath>

namespace lathelier {
namespace {

struct Oklab {
    double lightness;
    double a;
    double b;
};

constexpr Oklab blueEnd{0.43, -0.020, -0.170};
constexpr Oklab middle{0.905, 0, 0};
constexpr Oklab redEnd{0.46, 0.165, 0.080};

constexpr Oklab insideMiddle{0.83, -0.095, 0.040};
constexpr double insideBlueYellow = 0.060;  ///< from the middle to either end

/// Where the scale starts just outside a tolerance band (share of the plain scale).
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

}  // namespace

Rgb divergingColour(double share)
{
    const double t = std::isnan(share) ? 0 : std::clamp(share, -1.0, 1.0);
    const Oklab& end = t < 0 ? blueEnd : redEnd;
    const double w = std::abs(t);
    return toRgb({middle.lightness + w * (end.lightness - middle.lightness), middle.a + w * (end.a - middle.a),
                  middle.b + w * (end.b - middle.b)});
}

Rgb insideColour(double share)
{
    const double t = std::isnan(share) ? 0 : std::clamp(share, -1.0, 1.0);
    return toRgb({insideMiddle.lightness, insideMiddle.a, insideMiddle.b + t * insideBlueYellow});
}

Rgb DeviationColours::operator()(double value) const
{
    if (!tolerance) return divergingColour(value / limit);
    const double beyond = std::abs(value) - *tolerance;
    if (!(beyond > 0)) return insideColour(*tolerance > 0 ? value / *tolerance : 0);
    const double room = limit - *tolerance;
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

}  // namespace lathelier
