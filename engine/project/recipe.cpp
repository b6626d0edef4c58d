#include "engine/project/recipe.h"

#include <algorithm>

namespace lathelier::project {
namespace {

/// "record" and "record.2", not "recorder".
bool belongsTo(const std::string& input, const std::string& role)
{
    return input == role || input.starts_with(role + ".");
}

}  // namespace

Project recipeOf(Project project, const PartInputs& part_inputs)
{
    for (auto& [id, panel] : project.panels) {
        const auto roles = part_inputs.find(id);
        if (roles == part_inputs.end()) continue;
        std::erase_if(panel.inputs, [&](const auto& input) {
            return std::any_of(roles->second.begin(), roles->second.end(),
                               [&](const std::string& role) { return belongsTo(input.first, role); });
        });
    }
    std::erase_if(project.title_block, [](const auto& entry) { return entry.first == "serial"; });
    project.recipe = true;
    return project;
}

}  // namespace lathelier::project
