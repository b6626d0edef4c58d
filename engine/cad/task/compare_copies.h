// Further copies compared with the same reference by the parameters of the first, one after the other.
#pragma once

#include <vector>

#include "engine/cad/task/compare_task.h"

namespace lathelier::cad {

/// The sources of the further copies, in order.
std::vector<project::Source> furtherCopies(const project::PanelState& state);

/// The summary of the copy of the outcome, then those of the further ones of its state. A copy that cannot be read or
/// compared gets its error and does not stop the others. Their scans are not kept; another limit only repeats the
/// decision, in milliseconds. Throws Cancelled. Thread-safe.
std::vector<registration::CopySummary> compareCopies(const CompareOutcome& outcome, Stores& stores,
                                                     const Progress& progress);

/// Enters them into the outcome, and their files into its inputs.
void addCopies(CompareOutcome& outcome, std::vector<registration::CopySummary> copies);

}  // namespace lathelier::cad
