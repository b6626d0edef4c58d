#include "engine/project/recipe.h"

#include <algorithm>

#include "engine/project/input_key.h"

namespace lathelier::project {

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
