// Noise of measured responses: from coherence and number of averages, else from the scatter between neighbouring lines.
//
// Complex variance of a response A (as measured) by its coherence, of n averages: σ² = |A|² (1-γ²)/((n-1) γ²) (Bendat
// and Piersol, "Random Data", ch. 9, with n-1 for n since γ² is estimated from the same n); averaged over 9 lines,
// since a single estimate of the coherence scatters strongly. The fourth difference D of five neighbouring lines holds
// noise and what of the response a cubic does not follow: E|D|² = Σ c² σ², c = 1, -4, 6, -4, 1. It gives the factor
// 1/(n-1) where n is not stated (median over all lines), and σ² = a² + b²|A|² of a response without coherence (maximum
// likelihood of exponentially distributed |D|², without outliers: sharp peaks are no noise).
#pragma once

#include <optional>
#include <vector>

#include "engine/receptance/eirc/spindle_measurements.h"

namespace lathelier::receptance {

/// Source of the size of the noise, the surest first.
enum class NoiseSource {
    Averages,  ///< coherence and number of averages
    Scaled,    ///< coherence, its scale by scatter
    Scatter,   ///< scatter between neighbouring lines
    Unknown    ///< too few lines: the noise is taken as proportional to the response, its size is not known
};

struct SpindleNoise {
    std::vector<std::vector<double>> sigma_mm_N;  ///< by response and line: √(E|error|²) as a receptance; ∞: no value
    NoiseSource source = NoiseSource::Unknown;  ///< the least sure one of all responses
};

/// Precondition: the responses have common lines (spindleLines()). Lines at 0 Hz have the noise ∞.
SpindleNoise spindleNoise(const SpindleMeasurements& measurements);

const char* key(NoiseSource source);  ///< "averages" | "coherence" | "scatter" | "unknown"

}  // namespace lathelier::receptance
