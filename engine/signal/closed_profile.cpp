#include "engine/signal/closed_profile.h"

#include <cmath>
#include <complex>

#include "engine/signal/fourier.h"

namespace lathelier::signal {

double gaussianTransmission(double upr, double cutoff_upr)
{
    const double ratio = upr / cutoff_upr;
    return std::exp2(-ratio * ratio);
}

double TransmissionBand::transmission(double upr) const
{
    double result = 1;
    if (high_upr) result *= gaussianTransmission(upr, *high_upr);
    if (low_upr) result *= -std::expm1(-std::log(2.0) * (upr / *low_upr) * (upr / *low_upr));
    return result;
}

std::vector<double> filterClosed(std::span<const double> values, const TransmissionBand& band)
{
    if (values.empty() || band.isAll()) return {values.begin(), values.end()};
    const auto n = static_cast<double>(values.size());
    // The mean is subtracted so that rounding is relative to the form, not to the radius.
    double mean = 0;
    for (const double value : values) mean += value / n;
    std::vector<double> result(values.begin(), values.end());
    for (double& value : result) value -= mean;
    const FourierTransform transform(values.size());
    std::vector<std::complex<double>> spectrum = transform.forward(result);
    for (std::size_t k = 1; k < spectrum.size(); ++k) spectrum[k] *= band.transmission(static_cast<double>(k)) / n;
    spectrum[0] /= n;
    result = transform.series(spectrum);
    for (double& value : result) value += mean;
    return result;
}

}  // namespace lathelier::signal
