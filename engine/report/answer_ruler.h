// Ruler under an answer: value with uncertainty interval relative to the limits, as positions on a line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/texts.h"
#include "engine/report/answer.h"

namespace lathelier::report {

/// Positions from 0 (left end) to 1 (right end).
struct Ruler {
    double within_from = 0;         ///< lower end of the band within the limits
    double within_to = 1;           ///< upper end of the band within the limits
    bool is_lower_limited = false;  ///< true: within_from is a limit
    bool is_upper_limited = false;  ///< true: within_to is a limit
    double value = 0;               ///< position of the answer's value
    double low = 0, high = 0;       ///< value - U and value + U; both the value where U is not known
    double start = 0, end = 1;      ///< values at the two ends, in the unit of the answer
};

/// None without a value and a limit. A value of one sign with an upper limit starts at zero.
std::optional<Ruler> rulerOf(const Answer& answer);

/// Empty where there is none.
std::string rulerSvg(const Answer& answer, const Language& language = {});

}  // namespace lathelier::report
