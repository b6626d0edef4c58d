// Modes of a structure with what lies outside the range of frequencies, and their receptance.
// G(f) = Σ (cos φ + i r sin φ)/k / (1 - r² + 2iζr) - 1/(ω² M) + 1/K, r = f/f_n, under e^(+iωt) (viscous damping; Ewins,
// "Modal Testing", 2nd ed., sections 2.4 and 4.4). φ = 0 is a real normal mode.
#pragma once

#include <complex>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/frf.h"

namespace lathelier::receptance {

/// One mode as one response shows it.
struct ModalMode {
    double frequency_hz = 100;    ///< undamped natural frequency f_n, > 0
    double damping_ratio = 0.02;  ///< ζ, > 0
    double stiffness_N_mm = 1e4;  ///< modal stiffness k of this pair of places; negative between places out of phase
    double phase_deg = 0;         ///< φ of a complex residue, -90 to 90
    friend bool operator==(const ModalMode&, const ModalMode&) = default;
};

const std::vector<Field<ModalMode>>& fieldsOf(const ModalMode*);

/// What modes outside the range leave inside it.
struct ModalResiduals {
    double lower_mm_Ns2 = 0;  ///< 1/M of the mass line of what lies below
    double upper_mm_N = 0;    ///< 1/K, compliance of what lies above
    friend bool operator==(const ModalResiduals&, const ModalResiduals&) = default;
};

struct ModalModel {
    std::vector<ModalMode> modes;   ///< within the range, frequencies ascending
    std::vector<ModalMode> beyond;  ///< at most one below and one above the range: they stand for what lies there
    ModalResiduals residuals;       ///< for what lies further away
    friend bool operator==(const ModalModel&, const ModalModel&) = default;
};

/// Receptance in mm/N at one frequency > 0; at 0 Hz without the mass line.
std::complex<double> receptanceOf(const ModalMode& mode, double frequency_hz);
std::complex<double> receptanceOf(const ModalModel& model, double frequency_hz);

/// The same over given lines.
Frf synthesised(const ModalModel& model, const std::vector<double>& frequency_hz);

}  // namespace lathelier::receptance
