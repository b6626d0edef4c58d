// The files that a run is about to write: none may be one of its inputs, nor two of them one file.
#pragma once

#include "app/cli/arguments.h"

namespace lathelier::cli {

/// Looks at names, devices and inodes only; nothing is read. Inputs are the operands, the partner of an L-Graph
/// file, and files (or the files of a folder) that an option names. Standard output and standard error count as outputs
/// where they are files. Errors outputIsInput, outputsAreOne, valueNotUnderstood (“-” for anything but --json).
void checkOutputs(const Invocation& invocation);

/// Files that are reached in another way (named in an input, found beside it) are known once they are read: from now on
/// the first output that is written is refused with outputIsInput where any output is a file that was read.
void watchOutputs(const Invocation& invocation);

}  // namespace lathelier::cli
