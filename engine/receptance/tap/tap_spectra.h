// Windows and averaged spectra of the blocks of an impact test.
#pragma once

#include <complex>
#include <vector>

#include "engine/receptance/tap/tap_hits.h"

namespace lathelier::receptance {

/// Windows of a block, from its first sample on.
struct TapWindows {
    double decay_1_s = 0;  ///< of the exponential window of both signals
    bool has_force = false;
    double force_window_s = 0;  ///< of the force, from the trigger; a cosine over half of it follows
};
/// Those of a hit. `width_s`: from trigger to the end of its last pulse.
TapWindows windowsOf(const TapParameters& parameters, double block_s, double width_s);

/// Value of the window of the force at a time from the first sample of the block; `trigger_s` likewise.
double forceWindow(const TapWindows& windows, double time_s, double trigger_s);

/// Sums over the hits used, for the lines k·rate/samples, k = 0…samples/2.
struct TapSpectra {
    std::vector<double> ff;                ///< Σ F F*
    std::vector<double> xx;                ///< Σ X X*
    std::vector<std::complex<double>> xf;  ///< Σ X F*
    std::size_t count = 0;                 ///< hits
    double left_percent = 0;               ///< mean rms of the response at the end of the block, of its peak
    bool is_left_noise = true;             ///< no more than noise
    TapWindows windows;                    ///< the longest of the force's
};
TapSpectra spectraOf(const std::vector<TapSignals>& records, const FoundHits& found, const TapParameters& parameters,
                     const Progress& progress);

}  // namespace lathelier::receptance
