#include "widgets/turning/turning_state.h"

#include <algorithm>

#include "widgets/core/form/input_column.h"

namespace lathelier::turning_panel {

bool isOfJob(const std::string& key)
{
    const auto& all = fields<cam::Job>();
    return std::any_of(all.begin(), all.end(), [&](const Field<cam::Job>& field) { return field.info.key == key; });
}

bool formRules(const project::PanelState& state)
{
    const Value* const of = find(state.parameters, cam::jobOfKey);
    const auto* const stated = of ? std::get_if<std::string>(of) : nullptr;
    return cam::hasTools(state) && cam::identity(state) == (stated ? *stated : std::string());
}

void setJob(project::PanelState& state, const Values& job)
{
    for (const auto& [key, value] : job) set(state.parameters, key, value);
    set(state.parameters, cam::jobOfKey, cam::identity(state));
}

void openJob(project::PanelState& state, const std::string& path)
{
    state.inputs[cam::jobRole] = newSource(QString::fromStdString(path));
    set(state.parameters, cam::toolsKey, Rows{});
    set(state.parameters, cam::jobOfKey, std::string());
    set(state.parameters, cam::skippedKey, Rows{});
    set(state.parameters, cam::orderKey, Rows{});
}

std::vector<Text> missingInputs(const project::PanelState& state)
{
    const bool has_file = state.inputs.count(cam::jobRole) > 0;
    std::vector<Text> missing;
    if (!has_file && !cam::hasTools(state)) missing.push_back(LT_TEXT("Engine", "Job or tools"));
    if (!has_file && state.inputs.count(cam::partRole) == 0) missing.push_back(LT_TEXT("Engine", "Shaft"));
    return missing;
}

}  // namespace lathelier::turning_panel
