// The spindle line by line, and what the fit leaves by the noise of the measurements.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/core/progress.h"
#include "engine/receptance/eirc/spindle_lines.h"

namespace lathelier::receptance {

/// Each line is started from its linear solution (from a rigid clamp where there is none) and from the solutions of
/// both neighbours, since Gauss-Newton may converge to another minimum. Throws Cancelled.
std::vector<LineFit> fitSpindle(const SpindleLines& lines, const Progress& progress = {});

/// Of lines that are not neighbours, in a few steps: from the linear solution, where there is none from `hints`.
std::vector<LineFit> fitApart(const SpindleLines& lines, const std::vector<LineFit>& hints = {});

/// A response's share of a line's observations that the fit does not use up: 1 - h, h = |J (JᴴJ)⁻¹ Jᴴ| of its row.
double freedomOf(const SpindleLine& line, const LineResponse& response, const LineFit& fit);

/// chi² per degree of freedom up to which the noise explains what a fit leaves.
inline constexpr double explainedByNoise = 2;

/// What a fit leaves, measured by the noise.
struct FitQuality {
    std::optional<double> chi2_per_dof;                            ///< none: no degrees of freedom
    std::vector<std::optional<double>> chi2_per_dof_of_responses;  ///< in the order of the responses of a line
    double expected_rms_percent = 0;                               ///< 100·rms(error/|G|) that the noise alone leaves
};

FitQuality qualityOf(const std::vector<SpindleLine>& lines, const std::vector<LineFit>& fits);

/// Σ|w r|² over Σ(n - 3) of all lines; infinite without degrees of freedom.
double chi2PerDof(const std::vector<LineFit>& fits);

/// Number of lines where the spindle gives power away beyond its uncertainty: where an eigenvalue of Im Hs exceeds k
/// times its standard uncertainty, which is that of the noise or, where the line leaves more, of what it leaves. k
/// keeps the chance that any line of a passive spindle does so below that of 2σ (Bonferroni over the lines,
/// one-sided 2.3 %). `is_noise_known`: the weights are 1/σ, not only in proportion to it.
std::int64_t activeLines(const std::vector<LineFit>& fits, const std::vector<ScaledSpindle>& spindle,
                         bool is_noise_known);

}  // namespace lathelier::receptance
