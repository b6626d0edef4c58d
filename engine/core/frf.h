// A frequency response function, measured or computed.
#pragma once

#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace lathelier {

/// Response per force: displacement, velocity, acceleration.
enum class FrfQuantity { Receptance, Mobility, Accelerance };

/// Complex values follow e^(+iωt), so that a driving-point receptance has Im ≤ 0. Both directions are positive the same
/// way. Lines ascend and need not be even.
struct Frf {
    std::string name;                                ///< for people
    FrfQuantity quantity = FrfQuantity::Receptance;  ///< displacement, velocity or acceleration per force
    std::vector<double> frequency_hz;                ///< of each line, ascending
    std::vector<std::complex<double>> value;         ///< mm/N, mm/s/N or mm/s²/N by `quantity`
    std::vector<double> coherence;                   ///< γ² for each line; empty: not known
    std::vector<double> noise;  ///< standard deviation of the real and of the imaginary part, in the unit of `value`,
                                ///< for each line; empty: not known, or computed without any
};

using FrfPtr = std::shared_ptr<const Frf>;

}  // namespace lathelier
