// What was not understood and what was assumed, in answers and reports.
#pragma once

#include "engine/core/understanding.h"
#include "engine/report/document.h"

namespace lathelier::report {

/// With gaps that count: undecided, and in place of its sentence the places; the first ones are findings. Else
/// unchanged.
void settle(Answer& answer, const Understanding& understanding);

/// Tables of gaps and assumptions; none where there are neither.
std::optional<Section> understandingSection(const Understanding& understanding);

}  // namespace lathelier::report
