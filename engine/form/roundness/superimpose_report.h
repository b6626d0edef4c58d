// Two profiles laid on one another as a part of a report.
#pragma once

#include "engine/form/roundness/superimpose.h"
#include "engine/report/document.h"

namespace lathelier::form {

/// Two profiles laid on one another: figures, both as deviations around the first's circle, and their difference.
report::Section superimposeSection(const SuperimposeResult& result);

}  // namespace lathelier::form
