// Receptance of the chuck face of a machine, as springs or as a table.
//
// Deflection w and rotation θ = dw/dx of the chuck face, x from the face toward the free end; [[H, L], [L, P]] by
// reciprocity. Springs: H = 1/(k_r (1+iη)), P = 1/(k_t (1+iη)), L = 0. A table is interpolated linearly in real and
// imaginary part.
#pragma once

#include <complex>
#include <variant>
#include <vector>

#include "engine/beam/beam_receptance.h"
#include "engine/core/fields.h"

namespace lathelier::receptance {

using beam::Complex;
using beam::ReceptanceMatrix;

/// Two springs to the ground at the chuck face.
struct SpindleSprings {
    double radial_N_mm = 15000;      ///< radial stiffness k_r
    double tilt_N_mm_rad = 197.4e6;  ///< rotational stiffness k_t
    double loss_factor = 0.06;       ///< loss factor η of both springs
    friend bool operator==(const SpindleSprings&, const SpindleSprings&) = default;
};

const std::vector<Field<SpindleSprings>>& fieldsOf(const SpindleSprings*);

/// Receptances by frequency; all lists have one length.
struct SpindleTable {
    std::vector<double> frequency_hz;  ///< frequencies, ascending
    std::vector<Complex> H_mm_N;       ///< H: deflection w per force F
    std::vector<Complex> L_mm_Nmm;     ///< L: w per moment M, equal to θ per F
    std::vector<Complex> P_rad_Nmm;    ///< P: rotation θ per M
    friend bool operator==(const SpindleTable&, const SpindleTable&) = default;
};

struct SpindleReceptance {
    std::variant<SpindleSprings, SpindleTable> source;  ///< springs or table

    const SpindleSprings* springs() const { return std::get_if<SpindleSprings>(&source); }

    /// Error frequencyOutsideSpindle (`frequency_hz`, `from_hz`, `to_hz`) for a frequency outside the table.
    ReceptanceMatrix at(double frequency_hz) const;

    friend bool operator==(const SpindleReceptance&, const SpindleReceptance&) = default;
};

}  // namespace lathelier::receptance
