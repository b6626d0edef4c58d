// Fit of up to eight modes to measured receptances, with residual terms for modes outside the frequency range.
//
// 1. Poles of linear fits of ascending order: what stays is structure (stabilisation.h).
// 2. Models with one term more each: from the poles that stay, from the mode that a matched filter misses most in the
//    errors of the last model (modal_scan.h), and with terms beyond the range; each refined in all parameters by Gauss
//    and Newton (modal_refine.h).
// 3. Number of modes: the least value of Schwarz's criterion 2N ln(χ²) + p ln(2N) (Ann. Stat. 6 (1978) 461) among fits
//    whose modes all are determined by the data, are seen at their own frequency, do not cancel each other and have a
//    sign that the response allows; modes without which χ² increases by less than noise may are taken out again.
//
// Weights 1/σ: the noise of the lines up to a common factor, where the response carries it; from coherence else;
// without both (a computed response) σ² = a² + b²|G|², a and b from the errors of the fit itself. Standard
// uncertainties are those of the covariance (Jᴴ W J)⁻¹ times the variance found. Several responses are fitted with
// common poles.
#pragma once

#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/receptance/modal/modal_model.h"
#include "engine/receptance/modal/stabilisation.h"

namespace lathelier::receptance {

inline constexpr int mostModes = 8;

/// Whether force and response share place and direction: residues are then positive.
enum class DrivingPoint { Automatic, Yes, No };

struct ModalParameters {
    int modes = 0;                   ///< number of modes, 1 to 8; 0: selected by the criterion
    std::vector<Interval> range_hz;  ///< frequency range used, one interval; empty: all above 0 Hz
    bool complex_residues =
        false;  ///< complex modes (phases other than 0 and 180°); also where real ones leave much more
    DrivingPoint driving_point = DrivingPoint::Automatic;  ///< Automatic: as is known of the response
    friend bool operator==(const ModalParameters&, const ModalParameters&) = default;
};

const std::vector<Field<ModalParameters>>& fieldsOf(const ModalParameters*);

/// A mode of a fit with its standard uncertainties (k = 1).
struct FittedMode {
    ModalMode mode;                            ///< frequency, damping, stiffness, phase
    double frequency_uncertainty_hz = 0;       ///< of the frequency f_n
    double damping_uncertainty = 0;            ///< of the damping ratio ζ
    double stiffness_uncertainty_N_mm = 0;     ///< of the stiffness k
    double half_power_lines = 0;               ///< measured lines in the band f_n (1 ± ζ)
    double flexibility_mm_N = 0;               ///< -min Re of this mode alone: 1/(4|k| ζ (1 + ζ)) for a real one
    double damping_stiffness_correlation = 0;  ///< of the errors of ζ and k, -1 to 1: their product is better known
                                               ///< than either
};

struct ModalFit {
    ModalParameters parameters;
    Interval range_hz;                    ///< range of the lines used
    std::size_t lines = 0;                ///< number of lines used
    ModalModel model;                     ///< fitted model
    std::vector<FittedMode> modes;        ///< modes of `model` with uncertainties, in the same order
    double lower_uncertainty_mm_Ns2 = 0;  ///< of the residual's mass line
    double upper_uncertainty_mm_N = 0;    ///< of the residual's compliance
    double error_rms_percent = 0;         ///< 100 · rms|G_fit - G| / rms|G| over the lines used that stand out of the
                                          ///< noise
    double scatter_percent = 0;           ///< the same of what no smooth curve explains: the noise
    Frf synthesised;                      ///< receptance of the model on the lines used
    std::vector<double> error_percent;    ///< 100 · |G_fit - G| / |G| by line
    std::vector<bool> stands_out;         ///< lines over which the errors are averaged
    std::vector<OrderPole> orders;        ///< poles of linear fits of ascending order
    Notes notes;                          ///< codes in modal_codes.h
};

/// A receptance to be fitted with others.
struct ResponseToFit {
    const Frf* frf = nullptr;
    bool is_driving_point = false;  ///< known to be one; false: it is not, or not known
};

/// Errors: fitNeedsReceptance, tooFewLinesToFit; valueNotUnderstood for more than one range. Throws Cancelled.
ModalFit fitModes(const Frf& frf, const ModalParameters& parameters = {}, const Progress& progress = {});

/// The same of several responses of one structure: common frequencies and damping ratios, own stiffnesses, whose signs
/// are those of the mode shape, and own residuals. One result for each, in this order, each with the notes that concern
/// it. Precondition: at least one. Errors as above.
std::vector<ModalFit> fitResponses(std::span<const ResponseToFit> responses, const ModalParameters& parameters = {},
                                   const Progress& progress = {});

/// Flexibility of one mode relevant for chatter: its least real part, sign reversed.
double flexibilityOf(const ModalMode& mode);

}  // namespace lathelier::receptance
