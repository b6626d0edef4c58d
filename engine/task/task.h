// A capability described once: inputs, question, answer, exports. Command line, window and chain call the same task,
// so that a rule about its inputs (what may stand in place of what, what has precedence) holds everywhere.
//
// A room describes its task beside its engine call (deflection/deflection_task.h): a question struct with fields, the
// kinds of its inputs, one function from inputs to a typed outcome, and outcomeOf() for the callers that work with
// every task.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/json.h"
#include "engine/core/texts.h"
#include "engine/core/understanding.h"
#include "engine/report/document.h"
#include "engine/task/inputs.h"

namespace lathelier::task {

/// A file that can be written from the outcome.
struct Export {
    std::string option;      ///< of the command line, "compensate"
    std::string help;        ///< of the command line, English
    Text label;              ///< in the window's menu; empty: not there
    Text filter;             ///< of the window's file dialog, "Table (*.csv)"
    std::string suffix;      ///< usual suffix, "csv"
    bool is_cut_by = false;  ///< metal is cut by it: not written where something was not understood
    /// Of the command line, before anything is read: throws Error for a name that cannot be written. Empty: any name.
    std::function<void(const std::string& path)> check = {};
};

/// What a project keeps of an outcome, as an input of further tasks.
struct Product {
    std::string kind;                ///< of the item, "program"
    std::string part;                ///< which part of the outcome where there are several: "2" for the second clamping
    std::string name;                ///< in the project
    std::function<Values()> values;  ///< Error linesTooMany where the project cannot keep it
};

/// Writes an export; texts and numbers of pictures in this language.
using WriteExport = std::function<void(const std::string& path, const Language& language, const Progress& progress)>;

/// Whatever a caller needs of an answer without knowing its type.
struct Outcome {
    std::shared_ptr<const void> result;         ///< the typed outcome
    Notes notes;                                ///< of the readers and of the result
    Understanding understanding;                ///< what was not understood and what was assumed, likewise
    std::optional<project::PanelState> stated;  ///< the state as the command line would state it; none: as it is
    std::optional<Verdict> verdict;             ///< none: nothing to judge
    std::vector<Error> errors;                  ///< answered all the same (a program with errors has its diagnostics)
    std::function<Json()> json;  ///< keys of the result, without head and notes; none: no object in the report
    std::function<report::Answer(const Language&)> answer;
    std::function<report::Section(const Language&)> summary;
    /// Without inputs; `results` empty. None where an error leaves nothing to report.
    std::function<report::Document(const Language&)> report;
    std::map<std::string, WriteExport> writers;                     ///< by Export::option: those possible
    std::function<std::vector<Product>(const Language&)> products;  ///< those possible; none: nothing is kept
};

/// What the typed outcome of every task holds.
struct Answered {
    project::PanelState asked;    ///< inputs and parameters
    Sources sources;              ///< what was read
    Notes notes;                  ///< of the readers and of the result
    Understanding understanding;  ///< likewise

    /// `of_result`: notes of the result, behind those of the sources; `of_programs`: what their reader did not model,
    /// with paths. The verdict is settled by settled().
    void record(const project::PanelState& state, const Sources& read, const Notes& of_result,
                const Understanding& of_programs = {});
};

/// What a run is asked for besides the state of its panel.
struct Wanted {
    std::vector<std::string> exports;  ///< by Export::option: to be written after the run
    bool in_full = true;  ///< false: the summary alone is shown, what only JSON and report hold may be left out

    bool has(const std::string& option) const;
};

/// Inputs and fields of which one is needed. Where they stand in each other's place, the command line takes exactly
/// one, and of what a window keeps the first that is given is taken.
struct OneOf {
    std::vector<std::string> keys;  ///< roles and keys of fields, in this order; none: nothing of the kind
    Text label;                     ///< what they are
    bool together = false;          ///< they do not stand in each other's place
};

/// Inputs and fields that say nothing without one of others.
struct OnlyWith {
    std::vector<std::string> keys;  ///< roles and keys of fields
    std::vector<std::string> with;  ///< roles and keys of fields of which one is needed
};

struct Task {
    std::string key;       ///< of the verb and in JSON: "deflection"
    Text title;            ///< of its panel
    std::string summary;   ///< of the help page, English
    std::string question;  ///< of the window, under which its panels stand: "speed"
    std::vector<Input> inputs;
    OneOf one_of = {};
    std::vector<OnlyWith> only_with = {};  ///< the command line refuses what says nothing
    std::vector<FieldInfo> fields;         ///< of its question
    Values defaults;                       ///< of the fields
    std::vector<Export> exports;
    std::vector<std::string> products;  ///< kinds of items that it makes
    bool always_strict = false;         ///< a verdict against it is exit code 1 without --strict too
    /// Reads what `state` names and computes. `sources` receives what was read, also where an error ends the run.
    /// Errors of the readers and of the computation. Throws Cancelled. Thread-safe.
    std::function<Outcome(const project::PanelState& state, const Wanted& wanted, Stores& stores, Sources& sources,
                          const Progress& progress)>
        run;

    const Input* input(const std::string& role) const;  ///< nullptr: none
    /// The input whose file gives this field on the command line, where a window edits it: an option of the same key;
    /// nullptr: none.
    const Input* fileOf(const FieldInfo& field) const;
};

/// Whether the state has the input of this role, or a value of the field of this key that is not its default.
bool isGiven(const Task& task, const project::PanelState& state, const std::string& key);

/// Those of task.one_of that the state has, in their order.
std::vector<std::string> givenOf(const Task& task, const project::PanelState& state);

/// Fields and defaults of the question Q.
template <class Q>
void askFor(Task& task)
{
    task.fields = infos<Q>();
    task.defaults = toValues(Q{});
}

/// The outcome as it may be shown: where something that counts was not understood, its verdict, JSON, answer, summary
/// and report are undecided and name the places, and what metal is cut by is not written (Error not_modelled).
/// Otherwise the outcome itself, with what was assumed in its report.
Outcome settled(const Task& task, Outcome outcome, const Understanding& understanding);

/// All parameters of a run: files named by options, the question with its defaults, reading options. Of what a window
/// keeps only what is there.
Values parametersOf(const Task& task, const project::PanelState& state);

/// The whole object that command line and window write: head, keys of the result, `error` of an outcome answered in
/// part, notes.
Json resultOf(const Task& task, const project::PanelState& state, const Sources& sources, const Outcome& outcome);

/// The report with its inputs and the whole object as its result.
report::Document documentOf(const Task& task, const project::PanelState& state, const Sources& sources,
                            const Outcome& outcome, const Language& language = {});

}  // namespace lathelier::task
