#include "engine/signal/closed_filter.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "engine/signal/angular_sampling.h"
#include "engine/signal/fourier.h"
#include "engine/signal/fourier_fit.h"
#include "engine/signal/nonuniform_fourier.h"

namespace lathelier::signal {
namespace {

using Complex = std::complex<double>;

/// Transmission treated as zero: 2^-36 at six cut-offs.
constexpr double gone = 6;
/// Orders required in a series, in cut-offs, for negligible truncation: 2^-9 passes there.
constexpr double neededOrders = 3;

double meanOf(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Gaussian regression of order one: at each point the straight line that fits its neighbours best under the Gaussian's
/// weights. The five weighted sums are convolutions, taken as Fourier series: with the weight g = e^{-x²/4a}, of
/// spectrum e^{-ak²}, the weight x·g is -2a g' and x²·g is 4a² g'' + 2a g.
std::vector<double> regressed(const AngularSampling& sampling, const std::vector<double>& values, double cutoff_upr,
                              const Progress& progress)
{
    const double a = std::log(2.0) / (cutoff_upr * cutoff_upr);
    const int limit = std::max(1, static_cast<int>(std::ceil(gone * cutoff_upr)));
    std::vector<double> weighted(values.size());
    for (std::size_t j = 0; j < values.size(); ++j) weighted[j] = sampling.weight[j] * values[j];
    const std::vector<Complex> ones = fourierSums(sampling.angle_rad, sampling.weight, limit, progress);
    const std::vector<Complex> sums = fourierSums(sampling.angle_rad, weighted, limit, progress);
    const auto moment = [&](const std::vector<Complex>& spectrum, int power) {
        std::vector<Complex> product(spectrum.size());
        for (std::size_t k = 0; k < product.size(); ++k) {
            const auto order = static_cast<double>(k);
            const double g = std::exp(-a * order * order);
            // moments of (θ_j - θ), the negative of the Gaussian's argument
            const Complex factor = power == 0   ? Complex(g)
                                   : power == 1 ? Complex(0, 2 * a * order * g)
                                                : Complex((2 * a - 4 * a * a * order * order) * g);
            product[k] = spectrum[k] * factor;
        }
        return fourierSeries(product, sampling.angle_rad, progress);
    };
    const std::vector<double> s0 = moment(ones, 0), s1 = moment(ones, 1), s2 = moment(ones, 2);
    const std::vector<double> v0 = moment(sums, 0), v1 = moment(sums, 1);
    std::vector<double> result(values.size());
    for (std::size_t j = 0; j < values.size(); ++j) {
        // An isolated point between two gaps has no slope: regularised, so that the result is its value.
        const double spread = s2[j] + 1e-6 * a * s0[j];
        result[j] = (spread * v0[j] - s1[j] * v1[j]) / (spread * s0[j] - s1[j] * s1[j]);
    }
    return result;
}

/// Band-pass by regression: the output of the long-wave pass minus its longer waves.
std::vector<double> bandByRegression(const AngularSampling& sampling, std::vector<double> values,
                                     const TransmissionBand& band, const Progress& progress)
{
    if (band.high_upr) values = regressed(sampling, values, *band.high_upr, progress);
    if (!band.low_upr) return values;
    const std::vector<double> longer = regressed(sampling, values, *band.low_upr, progress);
    const double size = meanOf(longer);
    for (std::size_t j = 0; j < values.size(); ++j) values[j] += size - longer[j];
    return values;
}

}  // namespace

FilteredValues filterClosedAt(std::span<const double> angle_rad, std::span<const double> values,
                              const TransmissionBand& band)
{
    if (values.size() < 3 || band.isAll()) return {{values.begin(), values.end()}};
    const AngularSampling sampling = sampleAngles(angle_rad);
    FilteredValues result = filterClosedAt(sampling, inOrder(sampling, values), band);
    const std::vector<double> ordered = std::move(result.values);
    result.values.resize(ordered.size());
    for (std::size_t j = 0; j < ordered.size(); ++j) result.values[sampling.order[j]] = ordered[j];
    return result;
}

FilteredValues filterClosedAt(const AngularSampling& sampling, std::vector<double> values, const TransmissionBand& band,
                              const Progress& progress)
{
    if (values.size() < 3 || band.isAll()) return {std::move(values)};
    const double cutoff_upr = std::max(band.high_upr.value_or(0), band.low_upr.value_or(0));
    return ClosedFilter(sampling, std::move(values), cutoff_upr)(band, progress);
}

ClosedFilter::ClosedFilter(const AngularSampling& sampling, std::vector<double> values, double largest_cutoff_upr)
    : sampling_(sampling), values_(std::move(values)), largestCutoff_upr_(largest_cutoff_upr)
{
    if (values_.size() < 3 || sampling.uniform) return;
    mean_ = meanOf(values_);
    for (double& value : values_) value -= mean_;
}

FilteredValues ClosedFilter::operator()(const TransmissionBand& band, const Progress& progress)
{
    FilteredValues result;
    if (values_.size() < 3 || band.isAll()) {
        result.values = values_;
    } else if (sampling_.uniform) {
        return {filterClosed(values_, band)};
    } else {
        const bool series = bySeries(band, progress, result.values);
        result.method = series ? FilterMethod::Series : FilterMethod::Regression;
        if (!series) result.values = bandByRegression(sampling_, values_, band, progress);
        if (!band.low_upr) {
            // A long-wave pass is a mean of neighbours: where the fit beside a gap or corner exceeds their range, it is
            // clamped.
            const auto [least, greatest] = std::minmax_element(values_.begin(), values_.end());
            for (double& value : result.values) value = std::clamp(value, *least, *greatest);
        }
    }
    for (double& value : result.values) value += mean_;
    return result;
}

/// Band-filtered series fitted to the values; empty when the spacing does not determine the required orders. For a
/// short-wave pass: the removed part.
std::vector<Complex> ClosedFilter::passed(const TransmissionBand& band, const Progress& progress)
{
    if (sampling_.gaps > 0) return {};
    const int most = static_cast<int>(sampling_.different - 1) / 2;  // orders determined by even spacing
    const auto limitFor = [most](double cutoff_upr) {
        return std::min(most, static_cast<int>(std::ceil(gone * cutoff_upr)));
    };
    const double cutoff_upr = std::max(band.high_upr.value_or(0), band.low_upr.value_or(0));
    const int limit = limitFor(cutoff_upr);
    const int needed = std::min(limit - limit / 8, static_cast<int>(std::ceil(neededOrders * cutoff_upr)));
    if (fit_.empty())
        fit_ = fitFourier(sampling_, values_, limitFor(std::max(largestCutoff_upr_, cutoff_upr)), progress);
    if (static_cast<int>(fit_.size()) <= needed) return {};
    std::vector<Complex> series(fit_.begin(),
                                fit_.begin() + std::min<std::ptrdiff_t>(std::ssize(fit_), std::ptrdiff_t{limit} + 1));
    for (std::size_t k = 1; k < series.size(); ++k) {
        const auto order = static_cast<double>(k);
        series[k] *= band.high_upr ? band.transmission(order) : gaussianTransmission(order, *band.low_upr);
    }
    return series;
}

/// Filters the fitted series; false when it is not applicable.
bool ClosedFilter::bySeries(const TransmissionBand& band, const Progress& progress, std::vector<double>& result)
{
    const std::vector<Complex> series = passed(band, progress);
    if (series.empty()) return false;
    result = fourierSeries(series, sampling_.angle_rad, progress);
    // A short-wave pass subtracts the longer waves from the values, so that the series need not contain the shorter
    // ones.
    if (!band.high_upr)
        for (std::size_t j = 0; j < result.size(); ++j) result[j] = values_[j] - result[j] + series[0].real();
    return true;
}

std::optional<std::vector<double>> ClosedFilter::even(const TransmissionBand& band, std::size_t count,
                                                      const Progress& progress)
{
    if (sampling_.uniform || values_.size() < 3 || !band.high_upr) return std::nullopt;
    std::vector<Complex> series = passed(band, progress);
    const FourierTransform transform(quickTransformLength(count));
    if (series.empty() || series.size() > transform.length() / 2) return std::nullopt;
    series.resize(transform.length() / 2 + 1);
    std::vector<double> result = transform.series(series);
    const auto [least, greatest] = std::minmax_element(values_.begin(), values_.end());
    for (double& value : result) value = (band.low_upr ? value : std::clamp(value, *least, *greatest)) + mean_;
    return result;
}

}  // namespace lathelier::signal
