// The parts of a project as a list.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/project/project.h"

namespace lathelier::project {

/// Largest number of parts of a project file.
inline constexpr std::size_t mostParts = 1000;

/// All parts in their order, the shown one at project.place. Valid until the project changes.
std::vector<const Part*> partsOf(const Project& project);
std::vector<Part*> partsOf(Project& project);

std::vector<std::string> partNames(const Project& project);

/// Shows the part at `index` < partsOf(project).size(); the shown one waits.
void showPart(Project& project, std::size_t index);

/// Adds an empty part at the end and shows it. A name that another part has is numbered: "Pin (2)".
void addPart(Project& project, const std::string& name);

/// Removes the part at `index`. In place of a shown one its successor is shown, of the last one its predecessor. The
/// only part becomes an empty one: a project has at least one.
void removePart(Project& project, std::size_t index);

/// Numbered as by addPart() where another part has the name.
void renamePart(Project& project, std::size_t index, const std::string& name);

}  // namespace lathelier::project
