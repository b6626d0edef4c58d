// The ruler under an answer: its value with the interval of its uncertainty against the limits, as lengths on a line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/texts.h"
#include "engine/report/answer.h"

namespace lathelier::report {

/// All places from 0 (left end) to 1 (right end).
struct Ruler {
    double within_from = 0;         ///< the band that the limits allow
    double within_to = 1;           ///< its end
    bool is_lower_limited = false;  ///< a limit stands at within_from
    bool is_upper_limited = false;  ///< a limit stands at within_to
    double value = 0;               ///< of the answer
    double low = 0, high = 0;       ///< value - U and value + U; both the value where U is not known
    double start = 0, end = 1;      ///< what the ends mean, in the unit of the answer
};

/// Nothing without a value and a limit: there is nothing to compare with. A value of one sign with an upper limit
/// starts at zero.
std::optional<Ruler> rulerOf(const Answer& answer);

/// Empty where there is none.
std::string rulerSvg(const Answer& answer, const Language& language = {});

}  // namespace lathelier::report
