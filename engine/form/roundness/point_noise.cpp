#include "engine/form/roundness/point_noise.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/signal/fourier.h"
#include "engine/signal/hampel.h"
#include "engine/signal/harmonics.h"
#include "engine/signal/nonuniform_fourier.h"

namespace lathelier::form {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t leastNoisePoints = 32;
constexpr std::size_t leastHarmonics = 8;  ///< fewer: treated as an arc, by the sequence of its points
constexpr double leastLine = 8;            ///< times the mean square amplitude: noise alone once in e⁸ = 3000
constexpr double spikeSigma = 6;
constexpr double mostSpikes = 0.1;       ///< largest share of the points classified as spikes
constexpr std::size_t longestSpike = 4;  ///< longest run of points classified as a spike; longer runs are form

/// Smoothed mean square amplitude of the noise by order: clipped means over windows, robust against single lines.
struct PowerFloor {
    std::vector<double> at;  ///< mean square amplitude by order
    double level = 0;        ///< common level of all orders
    double effective = 1;    ///< number of independent values behind `level`
    bool white = true;       ///< no window differs significantly from the level
};

struct WindowMean {
    double mean = 0;
    std::size_t count = 0;
};

/// Robust mean of an exponential distribution: values above six means are clipped.
WindowMean clippedMean(const std::vector<double>& power, const std::vector<std::uint8_t>& skip, std::size_t from,
                       std::size_t to)
{
    constexpr std::size_t enough = 8192;
    const std::size_t stride = (to - from) / enough + 1;
    std::vector<double> values;
    for (std::size_t m = from; m <= to; m += stride)
        if (!skip[m]) values.push_back(power[m]);
    if (values.empty()) return {};
    const double clip = 6 * median(values) / std::log(2.0);
    double sum = 0;
    for (const double value : values) sum += std::min(value, clip);
    return {sum / static_cast<double>(values.size()) / (1 - std::exp(-6.0)), values.size()};
}

/// `power` for the orders 0…; orders 0 and 1, removed by the circle fit, are ignored. `first`: below this order the
/// floor is constant.
PowerFloor floorOf(const std::vector<double>& power, const std::vector<std::uint8_t>& skip, double first = 4)
{
    PowerFloor result;
    result.at.assign(power.size(), 0.0);
    if (power.size() < 4) return result;
    const std::size_t last = power.size() - 1;
    const WindowMean all = clippedMean(power, skip, 2, last);
    result.level = all.mean;
    result.effective = static_cast<double>(std::max<std::size_t>(all.count, 1));
    std::vector<std::pair<double, double>> knots;  // order, mean power
    WindowMean quietest, loudest;
    for (double knot = std::min(first, static_cast<double>(last) / 2); knot < 1.25 * static_cast<double>(last);
         knot *= 1.25) {
        const double order = std::min(knot, static_cast<double>(last));
        const auto from = static_cast<std::size_t>(std::max(2.0, std::min(order / 1.6, order - 4)));
        const auto to = std::min(last, static_cast<std::size_t>(std::max(order * 1.6, order + 2)));
        const WindowMean window = clippedMean(power, skip, from, to);
        if (window.count < 3) continue;
        // Increased above the mean where it is estimated from few orders: an unknown noise level must not be
        // underestimated.
        knots.emplace_back(order, window.mean * (1 + 4 / static_cast<double>(window.count)));
        if (knots.size() == 1 || window.mean < quietest.mean) quietest = window;
        if (knots.size() == 1 || window.mean > loudest.mean) loudest = window;
    }
    if (!knots.empty()) {
        const double chance =
            3 * std::sqrt(1 / static_cast<double>(quietest.count) + 1 / static_cast<double>(loudest.count));
        result.white = !(loudest.mean > quietest.mean * std::exp(chance));
    }
    if (knots.empty() || result.white) {
        std::fill(result.at.begin(), result.at.end(), result.level);
        return result;
    }
    std::size_t k = 0;
    for (std::size_t m = 0; m <= last; ++m) {
        const auto order = static_cast<double>(m);
        while (k + 1 < knots.size() && knots[k + 1].first < order) ++k;
        const auto& [a, low] = knots[k];
        const auto& [b, high] = knots[std::min(k + 1, knots.size() - 1)];
        const double share = b > a ? std::clamp((order - a) / (b - a), 0.0, 1.0) : 0;
        result.at[m] = low > 0 && high > 0 ? low * std::pow(high / low, share) : low + share * (high - low);
    }
    double sum = 0, squares = 0;
    for (std::size_t m = 2; m <= last; ++m) {
        sum += result.at[m];
        squares += result.at[m] * result.at[m];
    }
    result.level = sum / static_cast<double>(last - 1);
    result.effective = squares > 0 ? sum * sum / squares : 1;
    return result;
}

/// Squared amplitudes of the orders 0…n/2 of a sequence.
std::vector<double> periodogram(std::span<const double> values)
{
    const std::vector<Complex> spectrum = signal::FourierTransform(values.size()).forward(values);
    std::vector<double> power;
    power.reserve(spectrum.size());
    const double scale = 4 / (static_cast<double>(values.size()) * static_cast<double>(values.size()));
    for (const Complex& x : spectrum) power.push_back(scale * std::norm(x));
    return power;
}

struct StandingForm {
    std::vector<double> values;         ///< form at the points
    std::vector<std::uint8_t> is_line;  ///< 1 where the order is a significant line
};

/// The significant harmonics.
StandingForm standingOut(const PreparedProfile& prepared, const std::vector<Complex>& coefficients,
                         const Progress& progress)
{
    StandingForm form;
    std::vector<double> power;
    power.reserve(coefficients.size());
    for (const Complex& c : coefficients) power.push_back(4 * std::norm(c));
    // Form dominates the lowest orders: their noise floor is first taken from higher orders, then from the
    // non-significant lines among them.
    form.is_line.assign(coefficients.size(), 0);
    for (const double first : {10., 4.}) {
        const std::vector<double> floor = floorOf(power, form.is_line, first).at;
        for (std::size_t k = 1; k < power.size(); ++k) form.is_line[k] = power[k] > leastLine * floor[k];
    }
    std::vector<Complex> lines(coefficients.size());
    for (std::size_t k = 1; k < lines.size(); ++k)
        if (form.is_line[k]) lines[k] = coefficients[k];
    form.values = signal::fourierSeries(lines, prepared.sampling.angle_rad, progress);
    return form;
}

/// The same for an arc: lines in the sequence of its points, mirrored so that it is periodic.
StandingForm standingOutOfArc(const std::vector<double>& deviation)
{
    const std::size_t n = deviation.size();
    std::vector<double> mirrored(deviation);
    mirrored.insert(mirrored.end(), deviation.rbegin(), deviation.rend());
    const signal::FourierTransform transform(2 * n);
    std::vector<Complex> spectrum = transform.forward(mirrored);
    std::vector<double> power;
    power.reserve(spectrum.size());
    for (const Complex& x : spectrum) power.push_back(std::norm(x));
    StandingForm form;
    form.is_line.assign(power.size(), 0);
    for (const double first : {10., 4.}) {
        const PowerFloor floor = floorOf(power, form.is_line, first);
        for (std::size_t k = 0; k < power.size(); ++k) form.is_line[k] = k < 3 || power[k] > leastLine * floor.at[k];
    }
    for (std::size_t k = 0; k < spectrum.size(); ++k)
        spectrum[k] = form.is_line[k] ? spectrum[k] / static_cast<double>(2 * n) : 0;
    form.values = transform.series(spectrum);
    form.values.resize(n);
    form.is_line.clear();
    return form;
}

/// 1 at spikes. Longer runs of outlying points are form: their residual is moved into the form.
std::vector<std::uint8_t> spikesOf(std::vector<double>& form, std::vector<double>& rest, double least_um)
{
    const std::size_t n = rest.size();
    const double middle = median(rest);
    const double sigma = std::max(signal::robustSpread(rest, middle), least_um);
    std::vector<std::uint8_t> out(n), spike(n);
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) count += out[i] = std::abs(rest[i] - middle) > spikeSigma * sigma;
    if (count == 0 || count == n) return spike;
    std::size_t start = 0;
    while (out[start]) ++start;  // runs may wrap around the first point
    std::size_t spikes = 0;
    for (std::size_t i = 0; i < n;) {
        std::size_t run = 0;
        while (run < n && out[(start + i + run) % n]) ++run;
        for (std::size_t k = 0; k < run; ++k) {
            const std::size_t at = (start + i + k) % n;
            if (run <= longestSpike) {
                spike[at] = 1;
                ++spikes;
            } else {
                form[at] += rest[at];
                rest[at] = 0;
            }
        }
        i += std::max<std::size_t>(run, 1);
    }
    if (static_cast<double>(spikes) > mostSpikes * static_cast<double>(n)) std::fill(spike.begin(), spike.end(), 0);
    return spike;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
    return result;
}

/// Adds the least-squares fit of `rest` to the coefficients.
void refine(const PreparedProfile& prepared, const std::vector<double>& rest, const std::vector<std::uint8_t>& isLine,
            std::vector<Complex>& coefficients, const Progress& progress)
{
    double total = 0;
    std::vector<double> weighted(rest.size());
    for (std::size_t i = 0; i < rest.size(); ++i) {
        weighted[i] = prepared.sampling.weight[i] * rest[i];
        total += prepared.sampling.weight[i];
    }
    const std::vector<Complex> sums =
        signal::fourierSums(prepared.sampling.angle_rad, weighted, static_cast<int>(coefficients.size()) - 1, progress);
    for (std::size_t k = 1; k < coefficients.size(); ++k)
        coefficients[k] = (isLine[k] ? coefficients[k] : 0) + sums[k] / total;
}

/// Largest quantisation step of which all differences of `value(point)` are multiples; 0 below `least`.
template <class ValueOf>
double commonStep(const Profile& profile, double least, ValueOf value)
{
    const double rounding = 0.02 * least;
    double step = 0;
    std::optional<double> first;
    for (const Eigen::Vector2d& point : profile.points_mm) {
        if (!point.allFinite()) continue;
        if (!first) first = value(point);
        double a = std::abs(value(point) - *first);
        if (a <= rounding) continue;
        if (step == 0) {
            step = a;
            continue;
        }
        double b = step;
        while (a > rounding) {  // Euclid, with rounding
            const double rest = std::abs(std::remainder(b, a));
            b = a;
            a = rest;
        }
        step = b;
        if (step < least) return 0;
    }
    return step;
}

}  // namespace

double resolutionOf(const Profile& profile)
{
    constexpr double least_mm = 2e-5;
    const auto finite = std::count_if(profile.points_mm.begin(), profile.points_mm.end(),
                                      [](const Eigen::Vector2d& point) { return point.allFinite(); });
    if (finite < 3) return 0;
    // Few values can share a large step by chance: only steps small against the range are accepted.
    const auto step = [&](auto value) {
        const double found = commonStep(profile, least_mm, value);
        if (!(found > 0)) return 0.0;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Eigen::Vector2d& point : profile.points_mm)
            if (point.allFinite()) {
                low = std::min(low, value(point));
                high = std::max(high, value(point));
            }
        return found < 0.5 * (high - low) ? found : 0.0;
    };
    const double radial = step([](const Eigen::Vector2d& point) { return point.norm(); });
    if (radial > 0) return radial;
    const double across = step([](const Eigen::Vector2d& point) { return point.x(); });
    return across > 0 ? std::max(across, step([](const Eigen::Vector2d& point) { return point.y(); })) : 0;
}

PointNoise estimateNoise(const PreparedProfile& prepared, const std::vector<signal::Harmonic>& harmonics,
                         double resolution_mm, std::optional<double> stated_um, const Progress& progress)
{
    PointNoise noise;
    const std::size_t n = prepared.distance_mm.size();
    std::vector<double> deviation;
    deviation.reserve(n);
    for (const double distance : prepared.distance_mm) deviation.push_back(1000 * (distance - prepared.radius_mm));
    noise.resolution_um = 1000 * resolution_mm;
    const double rounding_um = noise.resolution_um / std::sqrt(12.0);

    const bool arc = harmonics.size() < leastHarmonics;
    std::vector<Complex> coefficients(harmonics.size() + 1);
    for (const signal::Harmonic& h : harmonics)
        coefficients[static_cast<std::size_t>(h.upr)] = std::polar(h.amplitude / 2, -h.phase_rad);
    StandingForm form = arc ? standingOutOfArc(deviation) : standingOut(prepared, coefficients, progress);
    std::vector<double> rest = difference(deviation, form.values);
    std::vector<std::uint8_t> spike = spikesOf(form.values, rest, rounding_um);
    const auto withoutSpikes = [&] {
        std::vector<double> clean = rest;
        for (std::size_t i = 0; i < n; ++i)
            if (spike[i]) clean[i] = 0;
        return clean;
    };
    if (!arc && std::count(spike.begin(), spike.end(), 1) > 0) {
        refine(prepared, withoutSpikes(), form.is_line, coefficients, progress);
        form = standingOut(prepared, coefficients, progress);
        rest = difference(deviation, form.values);
        spike = spikesOf(form.values, rest, rounding_um);
    }
    progress.check();
    noise.form_um = std::move(form.values);

    if (stated_um) {
        noise.sigma_um = noise.beyond_rounding_um = *stated_um;
        noise.resolution_um = 0;
        const double floor = std::sqrt(leastLine * 4 / static_cast<double>(n)) * *stated_um;
        noise.floor_um.assign(harmonics.size(), floor);
        return noise;
    }
    if (n < leastNoisePoints) {
        noise.sigma_um = notANumber;
        noise.floor_um.assign(harmonics.size(), 0);
        return noise;
    }
    const std::vector<double> power = periodogram(withoutSpikes());
    std::vector<std::uint8_t> skip(power.size());
    for (std::size_t k = 0; k < std::min(skip.size(), form.is_line.size()); ++k) skip[k] = form.is_line[k];
    PowerFloor floor = floorOf(power, skip);
    noise.relative_u = 0.5 / std::sqrt(floor.effective);
    if (!floor.white) {
        noise.correlation_points = std::max(1.0, floor.at[2] / floor.level);
        noise.power_um2 = floor.at;
    }
    // Scatter of the residuals beyond quantisation, which is simulated separately.
    const double shown = std::sqrt(floor.level * static_cast<double>(n) / 4);
    noise.beyond_rounding_um = std::sqrt(std::max(0.0, shown * shown - rounding_um * rounding_um));
    noise.sigma_um = std::max(shown, rounding_um);
    const double least = 4 * rounding_um * rounding_um / static_cast<double>(n);
    for (double& value : floor.at) value = std::max(value, least);
    for (std::size_t i = 0; i < n; ++i)
        if (spike[i]) noise.spikes_um.push_back(rest[i]);
    for (std::size_t k = 1; k <= harmonics.size(); ++k)
        noise.floor_um.push_back(std::sqrt(leastLine * floor.at[std::min(k, floor.at.size() - 1)]));
    return noise;
}

}  // namespace lathelier::form
