// Tools of a job from the library of inserts and holders (cutting/tool_library.h): defaults for values that a job does
// not state, and remarks on what the library knows of them.
#pragma once

#include "engine/cam/job.h"
#include "engine/core/error.h"
#include "engine/cutting/tool_library.h"

namespace lathelier::cam {

/// Values that tools do not state are filled from their named insert and holder; stated values take precedence. The
/// hand of the holder sets the hand of the tool. The tools are settled. Error toolNotInLibrary.
Job withLibrary(Job job, const cutting::ToolLibrary& library = cutting::toolLibrary());

/// Notes on the values taken from the library, with source and status. Notes: toolFromLibrary.
void noteLibrary(const Job& stated, Notes& notes);

/// True if the holder outline is an assumed one of the library.
bool isHolderAssumed(const JobTool& tool);

/// Depths and feeds outside the ranges of the named inserts. Notes: outsideRange.
void noteRanges(const Job& job, Notes& notes);

/// Inserts that do not fit their holder by their codes. Notes: insertNotOfHolder.
void noteFits(const Job& job, Notes& notes);

}  // namespace lathelier::cam
