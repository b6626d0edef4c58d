#include "widgets/core/panel/task_panel.h"

#include <algorithm>

#include "engine/core/core_codes.h"
#include "engine/task/edited_segments.h"
#include "engine/task/needed.h"
#include "engine/task/task_codes.h"
#include "widgets/core/form/input_column.h"

namespace lathelier {

std::vector<InputRole> rolesOf(const task::Task& task, const std::vector<std::string>& roles)
{
    std::vector<InputRole> all;
    for (const std::string& role : roles) {
        const task::Input& input = *task.input(role);
        InputRole made;
        made.role = input.role;
        made.label = input.label;
        made.hint = input.help;
        made.required = task::isNeeded(task, input);
        made.several = input.several;
        made.kinds = input.kinds;
        made.item_kind = input.item_kind;
        all.push_back(std::move(made));
    }
    return all;
}

PanelInputs inputsOf(const task::Task& task, const std::vector<std::string>& roles,
                     const std::vector<std::string>& unfolded, bool rest, Text invitation,
                     const std::vector<std::string>& without)
{
    PanelInputs inputs;
    inputs.roles = rolesOf(task, roles);
    inputs.defaults = task.defaults;
    inputs.invitation = invitation;
    for (const std::string& key : unfolded)
        for (const FieldInfo& info : task.fields)
            if (info.key == key) {
                inputs.fields.push_back(info);
                inputs.fields.back().advanced = false;
            }
    if (!rest) return inputs;
    for (const FieldInfo& info : task.fields) {
        const auto isOf = [&info](const std::vector<std::string>& keys) {
            return std::find(keys.begin(), keys.end(), info.key) != keys.end();
        };
        if (isOf(unfolded) || isOf(without) || info.is_kept) continue;
        inputs.fields.push_back(info);
        inputs.fields.back().advanced = true;
    }
    return inputs;
}

void foldAllBut(PanelInputs& inputs, const std::vector<std::string>& unfolded)
{
    for (FieldInfo& info : inputs.fields)
        info.advanced = std::find(unfolded.begin(), unfolded.end(), info.key) == unfolded.end();
}

PanelFacts factsOf(const task::Task& task, const char* id, const char* icon, const std::vector<std::string>& roles,
                   const task::Wanted& wanted, const Values& begins_with)
{
    PanelFacts facts;
    facts.id = id;
    facts.task = &task;
    facts.begins_with = begins_with;
    facts.title = task.title;
    facts.icon = icon;
    facts.question = questionOf(task.question);
    facts.roles = rolesOf(task, roles);
    facts.kinds = kindsOf(facts.roles);
    for (const InputRole& role : facts.roles)
        if (task.input(role.role)->is_of_part) facts.part_inputs.push_back(role.role);
    for (const InputRole& role : facts.roles)
        if (!role.item_kind.empty()) facts.item_inputs.emplace(role.item_kind, role.role);
    if (!task.one_of.keys.empty())
        facts.missing = [&task, required = missingOf(facts.roles)](const project::PanelState& state) {
            std::vector<Text> labels = required(state);
            if (givenOf(task, state).empty()) labels.push_back(task.one_of.label);
            return labels;
        };
    if (!task.one_of.keys.empty())
        facts.has_work = [&task](const project::PanelState& state) {
            return !state.inputs.empty() || !givenOf(task, state).empty();
        };
    facts.report = [&task, wanted, begins_with](const project::PanelState& state, Stores& stores,
                                                task::Sources& sources, const Language& language,
                                                const Progress& progress) {
        const project::PanelState asked = filledWith(state, begins_with);
        const task::Outcome outcome = task.run(asked, wanted, stores, sources, progress);
        if (!outcome.report) throw Error(outcome.errors.front());
        return documentOf(task, asked, sources, outcome, language);
    };
    return facts;
}

project::PanelState filledWith(project::PanelState state, const Values& values)
{
    for (const auto& [key, value] : values)
        if (!find(state.parameters, key)) set(state.parameters, key, value);
    return state;
}

void openShaft(project::PanelState& state, const std::string& role, const std::string& path)
{
    state.inputs[role] = newSource(QString::fromStdString(path));
    set(state.parameters, task::segmentsKey, Rows{});
}

void assignByKind(project::PanelState& state, const std::vector<InputRole>& roles, const std::vector<FoundFile>& files)
{
    for (const FoundFile& file : files) {
        const auto takes = [&](const InputRole& role) {
            return std::find(role.kinds.begin(), role.kinds.end(), file.kind) != role.kinds.end();
        };
        const auto found = std::find_if(roles.begin(), roles.end(), takes);
        const InputRole& role = found == roles.end() ? roles.back() : *found;
        state.inputs[role.role] = newSource(QString::fromStdString(file.path));
    }
}

Worker::Job readingOf(const task::Task& task, const project::PanelState& state, std::shared_ptr<Stores> stores)
{
    return [&task, state, stores = std::move(stores)](const Progress& progress) -> std::shared_ptr<const void> {
        const Progress part = progress.part(0, 1, LT_TEXT("Engine", "Reading"));
        for (const task::Input& input : task.inputs) input.read(state, *stores, part);
        return nullptr;
    };
}

Error neededBy(const task::Task& task, const Error& error)
{
    const Value* const found = find(error.values(), "found");
    const Value* const parameter = find(error.values(), "parameter");
    if (!(error.code() == errors::valueNotUnderstood) || !found || !std::holds_alternative<std::monostate>(*found) ||
        !parameter)
        return error;
    for (const FieldInfo& field : task.fields)
        if (*parameter == Value(field.key)) return Error(errors::oneNeeded, {{"names", field.label}});
    return error;
}

std::optional<task::Product> productOf(const task::Outcome& outcome, const std::string& kind, const std::string& part)
{
    if (!outcome.products) return std::nullopt;
    for (const task::Product& product : outcome.products(screenLanguage()))
        if (product.kind == kind && product.part == part) return product;
    return std::nullopt;
}

std::vector<PanelExport> exportsOf(const task::Task& task, const std::shared_ptr<const task::Outcome>& outcome)
{
    std::vector<PanelExport> all;
    for (const task::Export& one : task.exports) {
        const auto writer = outcome->writers.find(one.option);
        if (one.label.empty() || writer == outcome->writers.end()) continue;
        all.push_back({screenText(one.label), screenText(one.filter), QString::fromStdString(one.suffix),
                       [outcome, write = writer->second](const QString& path) {
                           write(path.toStdString(), screenLanguage(), {});
                       }});
    }
    return all;
}

}  // namespace lathelier
