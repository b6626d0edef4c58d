// The files that a run is about to write: none may be one of its inputs, nor two of them one file.
#pragma once

#include "app/cli/arguments.h"

namespace lathelier::cli {

/// Looks at names, devices and inodes only; nothing is read. Inputs are the operands, the partner of an L-Graph
/// file, and files (or the files of a folder) that an option names. Standard output and standard error count as outputs
/// where they are files. Errors outputIsInput, outputsAreOne, valueNotUnderstood (“-” for anything but --json).
void checkOutputs(const Invocation& invocation);

}  // namespace lathelier::cli
