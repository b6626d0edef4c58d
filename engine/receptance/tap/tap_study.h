// An impact test with its signals over time, thinned for drawing.
#pragma once

#include <vector>

#include "engine/receptance/tap/tap.h"

namespace lathelier::receptance {

/// A signal over time: at most `most` points, in each step the least and the largest value.
struct TapTrace {
    std::vector<double> time_s;
    std::vector<double> value;
};
TapTrace traceOf(const std::vector<double>& values, double rate_hz, double start_s, std::size_t most);

struct TapStudy {
    TapResult result;
    std::vector<std::string> names;  ///< of the records, without folder
    std::vector<double> shift_s;     ///< of each record in the charts: several stand one behind another
    std::vector<TapTrace> force;     ///< N, by record, shifted
    std::vector<TapTrace> motion;    ///< mm, mm/s or mm/s²
    std::vector<double> largest;     ///< of the motion in the block of each hit

    double shiftedTime_s(const TapHit& hit) const { return hit.time_s + shift_s[hit.record]; }
};

TapStudy studyTaps(const std::vector<TapSignals>& records, std::vector<std::string> names, TapResult result);

}  // namespace lathelier::receptance
