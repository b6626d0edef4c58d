#include "app/cli/task_verb.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "app/cli/help.h"
#include "app/cli/verb_answer.h"
#include "engine/core/core_codes.h"
#include "engine/report/plain_text.h"
#include "engine/task/task_codes.h"

namespace lathelier::cli {
namespace {

constexpr std::string_view dashes = "--";

std::string exportOf(const std::string& option)
{
    return option.substr(dashes.size());
}

std::string operandName(const task::Input& input)
{
    if (!input.operand.empty()) return input.operand;
    std::string name = input.role;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    return name;
}

FieldInfo fileOption(const task::Input& input)
{
    FieldInfo info;
    info.key = input.option;
    info.kind = FieldInfo::Kind::Word;
    info.label = input.label;
    info.help = input.help;
    info.required = input.required;
    return info;
}

bool isOfCommandLine(const task::Input& input)
{
    return input.takes_files && !input.in_window_only;
}

/// Does its file give a field that a window edits?
bool isField(const task::Task& task, const task::Input& input)
{
    return std::any_of(task.fields.begin(), task.fields.end(),
                       [&](const FieldInfo& field) { return task.fileOf(field) == &input; });
}

/// Names that cannot be written are refused before the computation.
void checkOutputs(const task::Task& task, const Request& request)
{
    for (const task::Export& output : task.exports) {
        const auto asked = request.outputs.find(std::string(dashes) + output.option);
        if (output.check && asked != request.outputs.end()) output.check(asked->second);
    }
}

/// Where inputs stand in each other's place, exactly one of them.
void requireOne(const task::Task& task, const project::PanelState& state)
{
    if (task.one_of.keys.empty()) return;
    const std::size_t given = givenOf(task, state).size();
    if (given == 1) return;
    std::string names;
    for (const std::string& key : task.one_of.keys) {
        const task::Input* const input = task.input(key);
        if (!names.empty()) names += ", ";
        names += !input ? optionName(key) : input->option.empty() ? operandName(*input) : optionName(input->option);
    }
    throw Error(given == 0 ? errors::oneNeeded : errors::oneOnly, {{"names", names}});
}

void runTask(const task::Task& task, const Request& request, const Progress& progress, Answer& answer)
{
    const project::PanelState state = stateOf(task, request);
    const auto sources = std::make_shared<task::Sources>();
    answer.sources = sources;
    answer.parameters = parametersOf(task, state);
    task::Wanted wanted;
    for (const auto& [option, path] : request.outputs) wanted.exports.push_back(exportOf(option));
    wanted.in_full = request.in_full;
    answer.always_strict = task.always_strict;
    checkOutputs(task, request);
    Stores stores;
    task::Outcome outcome;
    try {
        outcome = task.run(state, wanted, stores, *sources, progress);
    } catch (...) {
        answer.notes = sources->notes;
        answer.understanding = understandingOf(answer.notes);
        throw;
    }
    answer.notes = outcome.notes;
    answer.understanding = outcome.understanding;
    answer.json = outcome.json;
    if (outcome.report) answer.report = [report = outcome.report] { return report({}); };
    if (outcome.summary) answer.summary = report::toPlainText(outcome.summary({}));
    answer.pass = passed(outcome.verdict);
    for (const Error& error : outcome.errors) answer.errors.push_back(error);
    for (const auto& [option, path] : request.outputs) {
        const auto writer = outcome.writers.find(exportOf(option));
        if (writer == outcome.writers.end()) continue;
        try {
            writer->second(path, {}, progress);
        } catch (const Error& error) {  // the other files are written all the same
            answer.errors.push_back(error);
        }
    }
}

}  // namespace

Verb verbOf(const task::Task& task)
{
    Verb verb;
    verb.name = task.key;
    verb.summary = task.summary;
    verb.has_report = true;
    for (const task::Input& input : task.inputs) {
        if (!isOfCommandLine(input)) continue;
        io::unite(verb.kinds, input.kinds);
        if (input.option.empty())
            verb.operands.push_back({operandName(input), input.help.english, input.several, false, !input.required});
        else if (!isField(task, input))
            verb.parameters.push_back({fileOption(input), std::string()});
    }
    for (const FieldInfo& field : task.fields) {
        if (field.is_kept) continue;
        if (const task::Input* const file = task.fileOf(field))
            verb.parameters.push_back({fileOption(*file), Value()});
        else
            verb.parameters.push_back({field, *find(task.defaults, field.key)});
    }
    for (const task::Export& output : task.exports)
        verb.outputs.push_back({std::string(dashes) + output.option, output.help});
    verb.run = [&task](const Request& request, io::InputFiles&, const Progress& progress, Answer& answer) {
        runTask(task, request, progress, answer);
    };
    return verb;
}

project::PanelState stateOf(const task::Task& task, const Request& request)
{
    project::PanelState state;
    std::size_t operand = 0;
    for (const task::Input& input : task.inputs) {
        if (!isOfCommandLine(input)) continue;
        std::string path;
        if (input.option.empty()) {
            if (operand < request.operands.size()) path = request.operands[operand++];
            for (std::size_t number = 2; input.several && operand < request.operands.size(); ++number)
                state.inputs[project::keyOf(input.role, number)].path = request.operands[operand++];
        } else if (const Value* const given = find(request.parameters, input.option)) {
            if (const auto* const name = std::get_if<std::string>(given)) path = *name;
        }
        if (!path.empty())
            state.inputs[input.role].path = path;
        else if (input.required)
            throw Error(errors::valueNotUnderstood,
                        {{"parameter", optionName(input.option)}, {"found", ""}, {"expected", input.label}});
    }
    for (const FieldInfo& field : task.fields) {
        const Value* const given = task.fileOf(field) ? nullptr : find(request.parameters, field.key);
        if (given) set(state.parameters, field.key, *given);
    }
    for (const auto& [key, value] : request.parameters) {
        const auto is_field = [&key = key](const FieldInfo& field) { return field.key == key; };
        const auto is_input = [&key = key](const task::Input& input) { return input.option == key; };
        if (std::any_of(task.fields.begin(), task.fields.end(), is_field) ||
            std::any_of(task.inputs.begin(), task.inputs.end(), is_input))
            continue;
        for (auto& [role, source] : state.inputs) set(source.import, key, value);
    }
    requireOne(task, state);
    return state;
}

}  // namespace lathelier::cli
