#include "engine/surface/stripes.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "engine/surface/spectrum.h"

namespace lathelier::surface {
namespace {

using std::numbers::pi;

/// The part of a line within the picture. `point`: on it; `along`: its direction.
std::optional<Stripe> clipped(Vector point, Vector along, double width, double height)
{
    double from = -1e300, to = 1e300;
    const auto within = [&](double start, double step, double most) {
        if (std::abs(step) < 1e-12) return start >= 0 && start <= most;
        const double a = -start / step, b = (most - start) / step;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
        return true;
    };
    if (!within(point.x, along.x, width) || !within(point.y, along.y, height) || from >= to) return std::nullopt;
    return Stripe{point + from * along, point + to * along};
}

}  // namespace

double phaseOf(const Grid& flat, Vector frequency)
{
    const std::vector<double> across = hann(flat.columns), down = hann(flat.rows);
    const std::complex<double> step = std::polar(1.0, -2 * pi * frequency.x);
    std::complex<double> sum = 0;
    for (int y = 0; y < flat.rows; ++y) {
        std::complex<double> turn = std::polar(1.0, -2 * pi * frequency.y * y), line = 0;
        const float* row = flat.row(y);
        for (int x = 0; x < flat.columns; ++x) {
            line += across[static_cast<std::size_t>(x)] * double(row[x]) * turn;
            turn *= step;
        }
        sum += down[static_cast<std::size_t>(y)] * line;
    }
    const double turns = std::arg(sum) / (2 * pi);
    return turns < 0 ? turns + 1 : turns;
}

std::vector<Stripe> stripesOf(Vector frequency, double phase, double width, double height)
{
    std::vector<Stripe> stripes;
    const double size = length(frequency);
    if (!(size > 0)) return stripes;
    // k·x at the corners gives the range of crests in the picture; x counts from the middle of the first pixel.
    const Vector half{0.5, 0.5};
    double low = 1e300, high = -1e300;
    for (const double x : {0.0, width})
        for (const double y : {0.0, height}) {
            const double turns = dot(frequency, Vector{x, y} - half) + phase;
            low = std::min(low, turns);
            high = std::max(high, turns);
        }
    if (high - low > mostStripes) return stripes;
    const Vector along{-frequency.y / size, frequency.x / size};
    for (double crest = std::ceil(low); crest <= high; ++crest) {
        const Vector point = half + ((crest - phase) / (size * size)) * frequency;
        if (const auto stripe = clipped(point, along, width, height)) stripes.push_back(*stripe);
    }
    return stripes;
}

}  // namespace lathelier::surface
