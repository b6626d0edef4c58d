// The setup sheet of a planned turning program: what the person at the machine needs to set it up. Part, stock, and for
// each clamping how the work is held, the zero point, the program with its digest, the tools, the operations in their
// order, and the stops with what is done there; then what stays, what is not made, and what was assumed.
#pragma once

#include "engine/cam/task/turn_task.h"
#include "engine/report/document.h"

namespace lathelier::cam {

/// Calls of tools, sense of the spindle and stops are read from the texts of the programs, as they are written; the
/// files are named where they were written. Precondition: the programs may be written (requireWritable()).
report::Document setupSheet(const TurnOutcome& outcome, const Language& language = {});

/// Writes it as HTML. Errors: those of requireWritable(); fileNotWritable.
void writeSetupSheet(const TurnOutcome& outcome, const std::string& path, const Language& language = {});

}  // namespace lathelier::cam
