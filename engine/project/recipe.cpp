#include "engine/project/recipe.h"

#include <algorithm>

#include "engine/project/input_key.h"
#include "engine/project/parts.h"

namespace lathelier::project {

Project recipeOf(Project project, const PartInputs& part_inputs)
{
    for (Part* part : partsOf(project)) {
        for (auto& [id, panel] : part->panels) {
            const auto roles = part_inputs.find(id);
            if (roles == part_inputs.end()) continue;
            std::erase_if(panel.inputs, [&](const auto& input) {
                return std::any_of(roles->second.begin(), roles->second.end(),
                                   [&](const std::string& role) { return belongsTo(input.first, role); });
            });
        }
        std::erase_if(part->title_block, [](const auto& entry) { return entry.first == "serial"; });
    }
    project.recipe = true;
    return project;
}

}  // namespace lathelier::project
