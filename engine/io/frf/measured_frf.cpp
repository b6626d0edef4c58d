#include "engine/io/frf/measured_frf.h"

#include <numbers>

namespace lathelier::io {

Frf toReceptance(const Frf& frf)
{
    if (frf.quantity == FrfQuantity::Receptance) return frf;
    Frf result;
    result.name = frf.name;
    for (std::size_t i = 0; i < frf.frequency_hz.size(); ++i) {
        if (!(frf.frequency_hz[i] > 0)) continue;
        const std::complex<double> iw(0, 2 * std::numbers::pi * frf.frequency_hz[i]);
        result.frequency_hz.push_back(frf.frequency_hz[i]);
        const std::complex<double> divisor = frf.quantity == FrfQuantity::Mobility ? iw : iw * iw;
        result.value.push_back(frf.value[i] / divisor);
        if (!frf.noise.empty()) result.noise.push_back(frf.noise[i] / std::abs(divisor));
        if (!frf.coherence.empty()) result.coherence.push_back(frf.coherence[i]);
    }
    return result;
}

bool isDrivingPoint(const MeasuredFrf& measured)
{
    return measured.response_node != 0 && measured.response_node == measured.reference_node &&
           measured.response_direction != 0 && measured.response_direction == measured.reference_direction;
}

double activeLines_percent(const Frf& frf)
{
    double active = 0, all = 0;
    for (const std::complex<double>& value : toReceptance(frf).value) {
        active += value.imag() > 0 ? 1 : 0;
        all += value.imag() != 0 ? 1 : 0;
    }
    return all > 0 ? 100 * active / all : 0;
}

}  // namespace lathelier::io
