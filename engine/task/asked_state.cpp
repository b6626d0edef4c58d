#include "engine/task/asked_state.h"

#include <algorithm>
#include <cctype>

#include "engine/core/core_codes.h"
#include "engine/task/needed.h"
#include "engine/task/task_codes.h"

namespace lathelier::task {
namespace {

/// Of an input or a field on the command line.
std::string nameOnCommandLine(const Task& task, const std::string& key)
{
    const Input* const input = task.input(key);
    return !input ? optionName(key) : input->option.empty() ? operandOf(*input) : optionName(input->option);
}

std::string namesOf(const Task& task, const std::vector<std::string>& keys)
{
    std::string names;
    for (const std::string& key : keys) names += (names.empty() ? "" : ", ") + nameOnCommandLine(task, key);
    return names;
}

/// Where inputs stand in each other's place, exactly one of them.
void requireOne(const Task& task, const project::PanelState& state)
{
    if (task.one_of.keys.empty()) return;
    const std::size_t given = givenOf(task, state).size();
    if (given == 1 || (given > 1 && task.one_of.together)) return;
    throw Error(given == 0 ? errors::oneNeeded : errors::oneOnly, {{"names", namesOf(task, task.one_of.keys)}});
}

/// Error onlyWith for what is given without that to which it belongs.
void refuseWhatSaysNothing(const Task& task, const project::PanelState& state)
{
    for (const OnlyWith& rule : task.only_with) {
        const auto given = [&](const std::string& key) { return isGiven(task, state, key); };
        if (std::any_of(rule.with.begin(), rule.with.end(), given)) continue;
        const auto idle = std::find_if(rule.keys.begin(), rule.keys.end(), given);
        if (idle != rule.keys.end())
            throw Error(errors::onlyWith,
                        {{"name", nameOnCommandLine(task, *idle)}, {"names", namesOf(task, rule.with)}});
    }
}

/// Takes the operands of an input from `next` on; all that are left where it has several.
void takeOperands(project::PanelState& state, const Input& input, const std::vector<std::string>& operands,
                  std::size_t& next)
{
    for (std::size_t number = 1; next < operands.size() && (number == 1 || input.several); ++number, ++next)
        if (!operands[next].empty()) state.inputs[project::keyOf(input.role, number)].path = operands[next];
}

}  // namespace

std::string optionName(const std::string& key)
{
    std::string result = "--" + key;
    std::replace(result.begin(), result.end(), '_', '-');
    return result;
}

std::string operandOf(const Input& input)
{
    if (!input.operand.empty()) return input.operand;
    std::string name = input.role;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    return name;
}

bool isOfCommandLine(const Input& input)
{
    return input.takes_files && !input.in_window_only;
}

project::PanelState statedState(const Task& task, const std::vector<std::string>& operands, const Values& parameters)
{
    project::PanelState state;
    std::size_t next = 0;
    for (const Input& input : task.inputs) {
        if (!isOfCommandLine(input)) continue;
        if (input.option.empty()) {
            takeOperands(state, input, operands, next);
        } else if (const Value* const given = find(parameters, input.option)) {
            const auto* const path = std::get_if<std::string>(given);
            if (path && !path->empty()) state.inputs[input.role].path = *path;
        }
    }
    for (const auto& [key, value] : parameters) {
        const auto is_field = [&key = key, &task](const FieldInfo& field) {
            return field.key == key && !task.fileOf(field);
        };
        const auto is_input = [&key = key](const Input& input) { return input.option == key; };
        if (std::any_of(task.fields.begin(), task.fields.end(), is_field))
            set(state.parameters, key, value);
        else if (std::none_of(task.inputs.begin(), task.inputs.end(), is_input))
            for (auto& [role, source] : state.inputs) set(source.import, key, value);
    }
    return state;
}

void requireComplete(const Task& task, const project::PanelState& state)
{
    for (const Input& input : task.inputs)
        if (isOfCommandLine(input) && isNeeded(task, input) && !sourceOf(state, input.role))
            throw Error(errors::valueNotUnderstood,
                        {{"parameter", optionName(input.option)}, {"found", ""}, {"expected", input.label}});
    requireOne(task, state);
    refuseWhatSaysNothing(task, state);
}

void blame(Error& error, const Task& task, const project::PanelState& state)
{
    const ErrorKind kind = error.code().kind;
    if (kind != ErrorKind::InputRejected && kind != ErrorKind::NoAnswer) return;
    const project::Source* last = nullptr;
    const Value* const role = find(error.values(), "role");
    for (const Input& input : task.inputs) {
        const project::Source* const source = input.option.empty() ? sourceOf(state, input.role) : nullptr;
        if (!source) continue;
        last = project::keysOf(state, input.role).size() > 1 ? nullptr : source;
        if (role && *role == Value(input.role)) break;
    }
    if (last) error.with("path", nameOf(*last));
}

}  // namespace lathelier::task
