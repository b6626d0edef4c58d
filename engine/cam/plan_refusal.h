// A plan whose written program the check refuses: what is said of it, which operations another plan leaves out, and the
// text that is kept for reading.
#pragma once

#include <string>
#include <vector>

#include "engine/cam/plan.h"

namespace lathelier::cam {

/// The operation that a line of the program belongs to; null: none.
const PlannedOperation* operationAt(const SetupPlan& setup, std::int64_t line);

/// Rest operations that findings of the check belong to. A further plan without them may be sound.
std::vector<DroppedOperation> faultyRestOperations(const TurningPlan& plan);

/// Error programRefused, where the plan is refused: the first finding with its operation, tool and place, and all of
/// them as rows.
void throwIfRefused(const TurningPlan& plan);

/// The text with the same lines, that no control runs: its first line stops and ends the program. Controls skip what
/// stands before the first end of a block ("%"), so the second line is replaced as well there.
std::string stoppedText(const std::string& program);

/// A refused program's name beside the one it was planned for: "p.nc.refused".
std::string refusedPath(const std::string& path);

}  // namespace lathelier::cam
