// Fit of up to six modes to one measured receptance, with residual terms for modes outside the range.
//
// 1. Start: a rational fraction by the iteration of Sanathanan and Koerner in partial fractions (modal_start.h), and
//    the fit with one mode less plus one at its largest error.
// 2. Refinement of all parameters by Gauss and Newton with weights (modal_refine.h).
// 3. Number of modes: the least value of Schwarz's criterion 2N ln(χ²) + p ln(2N) (Ann. Stat. 6 (1978) 461) among fits
//    whose modes all are determined by the data, are seen at their own frequency and do not cancel each other.
//
// Weights 1/σ: with coherence σ² ∝ |G|² (1-γ²)/γ², averaged over nine lines; without it σ² = a² + b²|G|², a and b from
// the errors of the fit itself. Standard uncertainties are those of the covariance (Jᴴ W J)⁻¹ times the variance found.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/receptance/modal/modal_model.h"

namespace lathelier::receptance {

inline constexpr int mostModes = 6;

struct ModalParameters {
    int modes = 0;                   ///< number of modes, 1 to 6; 0: selected by the criterion
    std::vector<Interval> range_hz;  ///< frequency range used, one interval; empty: all above 0 Hz
    bool complex_residues = false;   ///< complex modes (phases other than 0 and 180°)
    friend bool operator==(const ModalParameters&, const ModalParameters&) = default;
};

const std::vector<Field<ModalParameters>>& fieldsOf(const ModalParameters*);

/// A mode of a fit with its standard uncertainties (k = 1).
struct FittedMode {
    ModalMode mode;                         ///< frequency, damping, stiffness, phase
    double frequency_uncertainty_hz = 0;    ///< of the frequency f_n
    double damping_uncertainty = 0;         ///< of the damping ratio ζ
    double stiffness_uncertainty_N_mm = 0;  ///< of the stiffness k
    double half_power_lines = 0;            ///< measured lines in the band f_n (1 ± ζ)
    double flexibility_mm_N = 0;            ///< -min Re of this mode alone: 1/(4|k| ζ (1 + ζ)) for a real one
};

struct ModalFit {
    ModalParameters parameters;
    Interval range_hz;                    ///< range of the lines used
    std::size_t lines = 0;                ///< number of lines used
    ModalModel model;                     ///< fitted model
    std::vector<FittedMode> modes;        ///< modes of `model` with uncertainties, in the same order
    double lower_uncertainty_mm_Ns2 = 0;  ///< of the residual's mass line
    double upper_uncertainty_mm_N = 0;    ///< of the residual's compliance
    double error_rms_percent = 0;         ///< 100 · rms|G_fit - G| / rms|G| over the lines used
    Frf synthesised;                      ///< receptance of the model on the lines used
    std::vector<double> error_percent;    ///< 100 · |G_fit - G| / |G| by line
    Notes notes;                          ///< codes in modal_codes.h
};

/// Errors: fitNeedsReceptance, tooFewLinesToFit; valueNotUnderstood for more than one range. Throws Cancelled.
ModalFit fitModes(const Frf& frf, const ModalParameters& parameters = {}, const Progress& progress = {});

/// Flexibility of one mode relevant for chatter: its least real part, sign reversed.
double flexibilityOf(const ModalMode& mode);

}  // namespace lathelier::receptance
