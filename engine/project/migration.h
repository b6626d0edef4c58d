// Project files of older format versions.
#pragma once

#include <vector>

#include "engine/core/json.h"

namespace lathelier::project {

/// The format version this program writes. Increment it and add a step whenever an older program would misread the
/// file.
inline constexpr int projectVersion = 7;

/// Turns one format version into the next.
using MigrationStep = void (*)(Json&);

/// The steps of this program: the first turns version 1 into 2, and so on. Version 1 is the first one; 2 has items, and
/// inputs that are items; 3 what panels show; 4 a title block; 5 states the tools of a job under the keys of
/// core/tool.h; 6 has the keys of the command line; 7 has several parts and a shop.
const std::vector<MigrationStep>& migrationSteps();

/// Applies the steps from version `from` on and sets "version" to where they lead.
void migrate(Json& json, int from, const std::vector<MigrationStep>& steps);

}  // namespace lathelier::project
