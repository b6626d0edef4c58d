// Modes of vibration, entered by hand or of a response, and their receptance. G(f) = Σ (1 + i λ r)/k / (1 - r² + 2 i ζ
// r), r = f/f_n (viscous damping; Ewins, "Modal Testing", 2nd ed., section 2.4). λ = 0 for a real mode; a complex one,
// as loss factors that differ give it, has another. A mode of infinite frequency is a compliance without mass: 1/k.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/frf.h"
#include "engine/core/value.h"

namespace lathelier::stability {

/// One mode of the point that is cut, in the direction of the oriented receptance.
struct Mode {
    double frequency_hz = 100;    ///< undamped natural frequency f_n, > 0
    double damping_ratio = 0.03;  ///< ζ, > 0
    double stiffness_N_mm = 1e4;  ///< modal stiffness k, > 0; < 0 in a fit if force and motion have opposite sign
    double lead = 0;              ///< λ, of a complex mode

    bool hasMass() const { return std::isfinite(frequency_hz); }
    /// A peak of the response; else part of what other modes leave.
    bool isResonance() const { return hasMass() && damping_ratio < strongestDamping; }

    static constexpr double strongestDamping = 0.7;
    friend bool operator==(const Mode&, const Mode&) = default;
};

const std::vector<Field<Mode>>& fieldsOf(const Mode*);

/// Notes valueUnusual for values that are hardly meant.
void noteUnusualModes(const std::vector<Mode>& modes, Notes& notes);

/// Upper end of the lobes of modes if no speed range is stated.
inline constexpr double usualHighestSpeed_rpm = 10000;

/// How dense lines are.
struct LineDensity {
    double per_width = 16;      ///< lines in half a resonance's width ζ f_n
    double widths_around = 12;  ///< number of these widths on each side of a resonance with dense lines
    double ratio = 1.004;       ///< of neighbouring frequencies elsewhere
};

/// Ascending lines from `range_hz.from` > 0 to `range_hz.to`, dense about the modes.
std::vector<double> linesAround(const std::vector<Mode>& modes, const Interval& range_hz,
                                const LineDensity& density = {});

/// A compliance without mass.
Mode complianceMode(double compliance_mm_N);

/// Equal for equal modes only.
std::string keyOf(const std::vector<Mode>& modes);

/// The highest frequency of a resonance; of all modes with mass where there is none.
double highestFrequency(std::span<const Mode> modes);

/// Receptance in mm/N at one frequency.
std::complex<double> receptanceOf(const std::vector<Mode>& modes, double frequency_hz);

/// The receptance over lines dense enough for lobes up to `highest_speed_rpm`: from a tenth of the lowest natural
/// frequency to well above the highest, and dense about each of them.
Frf frfOf(const std::vector<Mode>& modes, double highest_speed_rpm);

}  // namespace lathelier::stability
