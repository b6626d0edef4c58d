// Results of roundness for statistical process control (Q-DAS).
#pragma once

#include <string>
#include <vector>

#include "engine/form/roundness/roundness.h"
#include "engine/io/qdas/dfq.h"
#include "engine/io/qdas/dfq_writer.h"

namespace lathelier::form {

/// RONt by the four circles: one characteristic each, of which every result gives a value; results with another filter
/// or limit have separate characteristics. Zero is the natural lower limit, the tolerance the upper one of the
/// verdict's circle. The part name is the common prefix of the names of the results. `measured` is the time of each
/// result (qdasTime()); the current time where it is missing.
io::QdasFile qdasFile(const std::vector<RoundnessResult>& results, const std::vector<std::string>& measured = {});

}  // namespace lathelier::form
