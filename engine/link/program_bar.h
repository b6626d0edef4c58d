// D and L of a bar from the NC program that turns it, read by the reader of all tasks.
#pragma once

#include <string>

#include "engine/core/progress.h"
#include "engine/link/assistant.h"

namespace lathelier::link {

/// D: the greatest diameter that a feed move reaches, or at which one along the axis begins (any one, where none is
/// along it); L: from the least to the greatest z of feed moves, where they begin too, and the clearance. Errors: those
/// of the reader; linkProgramNotWhole where a word could move the tool and was not understood, or a variable is read
/// that the program does not set; linkProgramEmpty where nothing is turned. Throws Cancelled.
ProgramBar barOfProgram(const std::string& path, const OfProgram& asked, const Progress& progress);

}  // namespace lathelier::link
