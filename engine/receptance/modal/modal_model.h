// Modal model of a structure with residual terms for modes outside the frequency range, and its receptance. G(f) = Σ
// (cos φ + i r sin φ)/k / (1 - r² + 2iζr) - 1/(ω² M) + 1/K, r = f/f_n, under e^(+iωt) (viscous damping; Ewins, "Modal
// Testing", 2nd ed., sections 2.4 and 4.4). φ = 0 is a real normal mode.
#pragma once

#include <complex>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/frf.h"

namespace lathelier::receptance {

/// One mode in one response.
struct ModalMode {
    double frequency_hz = 100;    ///< undamped natural frequency f_n, > 0
    double damping_ratio = 0.02;  ///< damping ratio ζ, > 0
    double stiffness_N_mm = 1e4;  ///< modal stiffness k of this pair of places; negative between points moving in
                                  ///< antiphase
    double phase_deg = 0;         ///< phase φ of the complex residue, -90 to 90
    friend bool operator==(const ModalMode&, const ModalMode&) = default;
};

const std::vector<Field<ModalMode>>& fieldsOf(const ModalMode*);

/// Contribution of modes outside the range.
struct ModalResiduals {
    double lower_mm_Ns2 = 0;  ///< 1/M: mass line of the modes below
    double upper_mm_N = 0;    ///< 1/K: compliance of the modes above
    friend bool operator==(const ModalResiduals&, const ModalResiduals&) = default;
};

struct ModalModel {
    std::vector<ModalMode> modes;   ///< within the range, frequencies ascending
    std::vector<ModalMode> beyond;  ///< at most one below and one above the range, which represent the modes there
    ModalResiduals residuals;       ///< for modes further away
    friend bool operator==(const ModalModel&, const ModalModel&) = default;
};

/// Receptance in mm/N at one frequency > 0; at 0 Hz without the mass line.
std::complex<double> receptanceOf(const ModalMode& mode, double frequency_hz);
std::complex<double> receptanceOf(const ModalModel& model, double frequency_hz);

/// The same at given frequencies.
Frf synthesised(const ModalModel& model, const std::vector<double>& frequency_hz);

}  // namespace lathelier::receptance
