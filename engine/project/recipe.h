// A recipe: how parts of one kind are evaluated - method, limits, zones, the master - without the data of one part.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/project/project.h"

namespace lathelier::project {

/// Roles of inputs that change from part to part, by the panels' keys in the project: {"compare": {"copy"}}. The
/// further files of a role ("record.2"…) are included.
using PartInputs = std::map<std::string, std::vector<std::string>>;

/// The project without those inputs, without the serial number in its title block, and marked as a recipe: opened, it
/// begins a new project.
Project recipeOf(Project project, const PartInputs& part_inputs);

}  // namespace lathelier::project
