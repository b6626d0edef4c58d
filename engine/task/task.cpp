#include "engine/task/task.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/io/import.h"
#include "engine/report/result_json.h"

namespace lathelier::task {

void Answered::record(const project::PanelState& state, const Sources& read, const Notes& of_result)
{
    asked = state;
    sources = read;
    notes = read.notes;
    notes.insert(notes.end(), of_result.begin(), of_result.end());
}

bool Wanted::has(const std::string& option) const
{
    return std::find(exports.begin(), exports.end(), option) != exports.end();
}

const Input* Task::input(const std::string& role) const
{
    const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const Input& one) { return one.role == role; });
    return found == inputs.end() ? nullptr : &*found;
}

Values parametersOf(const Task& task, const project::PanelState& state)
{
    Values all, reading = toValues(io::ImportOptions{});
    for (const Input& input : task.inputs)
        for (const io::FileKind* kind : input.kinds)
            for (const auto& [key, value] : kind->reading_defaults) set(reading, key, value);
    for (const Input& input : task.inputs) {
        const project::Source* const source = sourceOf(state, input.role);
        if (!input.option.empty()) set(all, input.option, source ? nameOf(*source) : std::string());
        if (!source) continue;
        for (const auto& [key, value] : source->import) set(reading, key, value);
    }
    for (const FieldInfo& field : task.fields) {
        const Value* const given = find(state.parameters, field.key);
        const Value& standard = *find(task.defaults, field.key);
        if (field.is_kept && (!given || *given == standard)) continue;
        set(all, field.key, given ? *given : standard);
    }
    for (auto& [key, value] : reading) all.emplace_back(std::move(key), std::move(value));
    return all;
}

Json resultOf(const Task& task, const project::PanelState& state, const Sources& sources, const Outcome& outcome)
{
    Json result = report::resultHead(task.key, sources.inputs, parametersOf(task, state));
    if (outcome.json) result.update(outcome.json());
    if (!outcome.errors.empty()) result["error"] = toJson(outcome.errors.front());
    result["notes"] = toJson(outcome.notes);
    return result;
}

report::Document documentOf(const Task& task, const project::PanelState& state, const Sources& sources,
                            const Outcome& outcome, const Language& language)
{
    report::Document document = outcome.report(language);
    document.inputs = sources.inputs;
    document.synthetic = sources.synthetic;
    document.results = {report::toText(resultOf(task, state, sources, outcome))};
    return document;
}

}  // namespace lathelier::task
