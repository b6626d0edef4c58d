#include "engine/io/frf/frf_sense.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lathelier::io {
namespace {

using Complex = std::complex<double>;

constexpr double ofThePeak = 0.5;       ///< least share of the peak of lines that belong to its circle
constexpr std::size_t fewestAside = 2;  ///< lines on either side that belong to it at least
constexpr std::size_t mostPoints = 16;  ///< of the polygon: lines are averaged, which removes noise
constexpr double standsOut = 3;         ///< least ratio of the peak to the median line
constexpr double leastAgreeing = 0.85;  ///< least share of corners that turn one way
constexpr double leastRound = 0.3;      ///< least roundness of the polygon; that of a circle is 1
constexpr double leastPart = 0.3;       ///< least share of Im of the receptance in its magnitude

struct LineRange {
    std::size_t begin = 0, end = 0;
};

/// The lines of the strongest resonance in what was measured, whose noise is even. A single high line is none. Empty:
/// nothing stands out.
LineRange strongest(const std::vector<Complex>& values, std::size_t& peak)
{
    const std::size_t count = values.size();
    std::vector<double> sizes(count);
    std::transform(values.begin(), values.end(), sizes.begin(), [](const Complex& value) { return std::abs(value); });
    double highest = 0;
    for (std::size_t i = 1; i + 1 < count; ++i)
        if (const double least = std::min({sizes[i - 1], sizes[i], sizes[i + 1]}); least > highest)
            highest = least, peak = i;
    const double limit = ofThePeak * sizes[peak];
    LineRange range{peak, peak + 1};
    while (range.begin > 0 && (peak - range.begin < fewestAside || sizes[range.begin - 1] > limit)) --range.begin;
    while (range.end < count && (range.end - peak <= fewestAside || sizes[range.end] > limit)) ++range.end;
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(count / 2), sizes.end());
    return highest > standsOut * sizes[count / 2] ? range : LineRange{};
}

/// Averages of lines of the range.
std::vector<Complex> pathOf(const std::vector<Complex>& values, const LineRange& range)
{
    const std::size_t width = (range.end - range.begin + mostPoints - 1) / mostPoints;
    std::vector<Complex> path;
    for (std::size_t i = range.begin; i < range.end; i += width) {
        const std::size_t end = std::min(i + width, range.end);
        Complex sum = 0;
        for (std::size_t k = i; k < end; ++k) sum += values[k];
        path.push_back(sum / static_cast<double>(end - i));
    }
    return path;
}

double cross(const Complex& a, const Complex& b)
{
    return a.real() * b.imag() - a.imag() * b.real();
}

/// 4π times the area within a closed path over the square of its length, positive anticlockwise: ±1 for a circle, near
/// 0 for a path back and forth. 0 where its corners turn both ways, as those of noise do.
double circleShape(const std::vector<Complex>& path)
{
    double area = 0, length = 0, left = 0;
    const std::size_t count = path.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Complex a = path[i], b = path[(i + 1) % count], c = path[(i + 2) % count];
        area += 0.5 * cross(a - path[0], b - path[0]);
        length += std::abs(b - a);
        left += cross(b - a, c - b) > 0 ? 1 : 0;
    }
    const double agree = std::max(left, static_cast<double>(count) - left);
    if (!(length > 0) || agree < leastAgreeing * static_cast<double>(count)) return 0;
    return 4 * std::numbers::pi * area / (length * length);
}

}  // namespace

FrfSense senseOf(const Frf& frf)
{
    FrfSense sense;
    if (frf.value.size() < 2 * fewestAside + 1) return sense;
    std::size_t peak = 1;
    const LineRange range = strongest(frf.value, peak);
    if (range.end - range.begin < 2 * fewestAside + 1) return sense;
    sense.frequency_hz = frf.frequency_hz[peak];
    const double round = circleShape(pathOf(frf.value, range));
    if (!(std::abs(round) > leastRound)) return sense;
    sense.is_conjugated = round > 0;
    double imaginary = 0, size = 0;
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const Complex value = round > 0 ? std::conj(frf.value[i]) : frf.value[i];
        // The receptance but for a positive factor: divided by iω, by -ω².
        const Complex receptance = frf.quantity == FrfQuantity::Receptance ? value
                                   : frf.quantity == FrfQuantity::Mobility ? value * Complex(0, -1)
                                                                           : -value;
        imaginary += receptance.imag();
        size += std::abs(receptance);
    }
    if (std::abs(imaginary) > leastPart * size) sense.is_turned = imaginary > 0;
    return sense;
}

}  // namespace lathelier::io
