#include "engine/chain/step_state.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "engine/cad/task/compare_task.h"
#include "engine/cad/task/draw_task.h"
#include "engine/cad/task/recognize_task.h"
#include "engine/cam/task/check_task.h"
#include "engine/cam/task/turn_task.h"
#include "engine/deflection/deflection_task.h"
#include "engine/receptance/task/shaft_task.h"
#include "engine/stability/task/lobes_task.h"
#include "engine/surface/task/surface_task.h"

namespace lathelier::chain {

const task::Task* taskOf(const std::string& step)
{
    static const std::map<std::string, const task::Task*> all{{"recognise", &cad::recognizeTask()},
                                                              {"draw", &cad::drawTask()},
                                                              {"machine", &receptance::shaftTask()},
                                                              {"speeds", &stability::lobesTask()},
                                                              {"program", &cam::turnTask()},
                                                              {"deflection", &deflection::deflectionTask()},
                                                              {"deflection_2", &deflection::deflectionTask()},
                                                              {"corrected_check", &cam::checkTask()},
                                                              {"copy", &cad::compareTask()},
                                                              {"surface", &surface::surfaceTask()}};
    const auto found = all.find(step);
    return found == all.end() ? nullptr : found->second;
}

std::optional<project::PanelState> stateOf(const ChainStep& step, const std::string& folder)
{
    const task::Task* const task = taskOf(step.id);
    if (!task || step.roles.empty()) return std::nullopt;
    project::PanelState state;
    for (const auto& [role, file] : step.roles)
        state.inputs[role].path = (std::filesystem::path(folder) / file).string();  // an absolute path stays as it is
    for (const auto& [key, value] : step.parameters) {
        const auto is_field = [&key = key](const FieldInfo& field) { return field.key == key; };
        const auto is_input = [&key = key](const task::Input& input) { return input.option == key; };
        if (std::any_of(task->fields.begin(), task->fields.end(), is_field)) {
            if (const Value* const usual = find(task->defaults, key); !usual || *usual != value)
                set(state.parameters, key, value);
        } else if (std::none_of(task->inputs.begin(), task->inputs.end(), is_input)) {
            for (auto& [role, source] : state.inputs) set(source.import, key, value);
        }
    }
    return state;
}

}  // namespace lathelier::chain
