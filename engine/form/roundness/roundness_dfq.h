// Results of roundness for statistical process control (Q-DAS).
#pragma once

#include <string>
#include <vector>

#include "engine/form/roundness/roundness.h"
#include "engine/io/qdas/dfq.h"
#include "engine/io/qdas/dfq_writer.h"

namespace lathelier::form {

/// RONt by the four circles: one characteristic each, of which every result gives a value; results that were filtered
/// or limited otherwise have characteristics of their own. Zero is the natural lower limit, the tolerance the upper one
/// of the verdict's circle. The part is called as what the names of the results have in common. `measured` is the time
/// of each result (qdasTime()); where it is missing, the present.
io::QdasFile qdasFile(const std::vector<RoundnessResult>& results, const std::vector<std::string>& measured = {});

}  // namespace lathelier::form
