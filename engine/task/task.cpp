#include "engine/task/task.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/io/import.h"
#include "engine/report/result_json.h"
#include "engine/report/understanding_report.h"
#include "engine/task/needed.h"

namespace lathelier::task {

namespace {

void settleAll(report::Section& section, const Understanding& understanding)
{
    for (report::Block& block : section.blocks)
        if (auto* const answer = std::get_if<report::Answer>(&block)) settle(*answer, understanding);
}

}  // namespace

void Answered::record(const project::PanelState& state, const Sources& read, const Notes& of_result,
                      const Understanding& of_programs)
{
    asked = state;
    sources = read;
    notes = read.notes;
    notes.insert(notes.end(), of_result.begin(), of_result.end());
    understanding = of_programs;
    understanding.add(understandingOf(notes));
    std::optional<Verdict> verdict;
    settle(understanding, verdict, notes);
}

Outcome settled(const Task& task, Outcome outcome, const Understanding& understanding)
{
    outcome.understanding = understanding;
    const auto shared = std::make_shared<const Understanding>(understanding);
    if (outcome.report)
        outcome.report = [shared, inner = outcome.report](const Language& language) {
            report::Document document = inner(language);
            for (report::Section& section : document.sections) settleAll(section, *shared);
            if (auto section = report::understandingSection(*shared)) document.sections.push_back(*std::move(section));
            return document;
        };
    if (understanding.isWhole()) return outcome;
    outcome.verdict = Verdict::Undecided;
    if (outcome.answer)
        outcome.answer = [shared, inner = outcome.answer](const Language& language) {
            report::Answer answer = inner(language);
            settle(answer, *shared);
            return answer;
        };
    if (outcome.summary)
        outcome.summary = [shared, inner = outcome.summary](const Language& language) {
            report::Section section = inner(language);
            settleAll(section, *shared);
            return section;
        };
    for (const Export& written : task.exports) {
        const auto writer = outcome.writers.find(written.option);
        if (written.is_cut_by && writer != outcome.writers.end())
            writer->second = [shared](const std::string&, const Language&, const Progress&) {
                requireUnderstood(*shared);
            };
    }
    outcome.products = {};
    return outcome;
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

const Input* Task::fileOf(const FieldInfo& field) const
{
    const auto found =
        std::find_if(inputs.begin(), inputs.end(), [&](const Input& one) { return one.option == field.key; });
    return found == inputs.end() ? nullptr : &*found;
}

bool isGiven(const Task& task, const project::PanelState& state, const std::string& key)
{
    if (sourceOf(state, key)) return true;
    const Value* const value = find(state.parameters, key);
    const Value* const usual = find(task.defaults, key);
    return value && usual && *value != *usual;
}

std::vector<std::string> givenOf(const Task& task, const project::PanelState& state)
{
    std::vector<std::string> given;
    for (const std::string& key : task.one_of.keys)
        if (isGiven(task, state, key)) given.push_back(key);
    return given;
}

Values parametersOf(const Task& task, const project::PanelState& state)
{
    Values all, reading = toValues(io::ImportOptions{});
    for (const Input& input : task.inputs) {
        if (input.in_window_only && !sourceOf(state, input.role)) continue;
        for (const io::FileKind* kind : input.kinds)
            for (const auto& [key, value] : kind->reading_defaults) set(reading, key, value);
    }
    for (const Input& input : task.inputs) {
        const project::Source* const source = sourceOf(state, input.role);
        if (!input.option.empty() && !givesField(task, input))
            set(all, input.option, source ? nameOf(*source) : std::string());
        if (!source) continue;
        for (const auto& [key, value] : source->import) set(reading, key, value);
    }
    for (const FieldInfo& field : task.fields) {
        const Value* const given = find(state.parameters, field.key);
        const Value& standard = *find(task.defaults, field.key);
        if (field.is_kept && (!given || *given == standard)) continue;
        if (const Input* const file = task.fileOf(field)) {
            const project::Source* const source = sourceOf(state, file->role);
            const bool is_edited = given && *given != standard;
            set(all, field.key, source ? Value(nameOf(*source)) : is_edited ? *given : Value());
            continue;
        }
        set(all, field.key, given ? *given : standard);
    }
    for (auto& [key, value] : reading) all.emplace_back(std::move(key), std::move(value));
    return all;
}

Json resultOf(const Task& task, const project::PanelState& state, const Sources& sources, const Outcome& outcome)
{
    Json result = report::resultHead(task.key, sources.inputs, parametersOf(task, outcome.stated.value_or(state)));
    if (outcome.json) result.update(outcome.json());
    report::addRemarks(result, outcome.understanding, outcome.errors, outcome.notes);
    return result;
}

report::Document documentOf(const Task& task, const project::PanelState& state, const Sources& sources,
                            const Outcome& outcome, const Language& language)
{
    report::Document document = outcome.report(language);
    document.inputs = sources.inputs;
    document.synthetic = sources.synthetic;
    if (outcome.json) document.results = {report::toText(resultOf(task, state, sources, outcome))};
    return document;
}

}  // namespace lathelier::task
