// Results of roundness for statistical process control (Q-DAS).
#pragma once

#include <vector>

#include "engine/form/roundness.h"
#include "engine/io/dfq_writer.h"

namespace lathelier {

/// RONt by the four circles of each result; the limit belongs to the circle of the verdict.
QdasFile qdasFile(const std::vector<RoundnessResult>& results);

}  // namespace lathelier
