// What a verb of the command line is: its operands, its options, and the engine call behind it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/fields.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"
#include "engine/io/file_kind.h"
#include "engine/io/input_files.h"
#include "engine/report/document.h"
#include "engine/task/task.h"

namespace lathelier::cli {

/// A positional argument.
struct Operand {
    std::string name;  ///< as help shows it, "REFERENCE"
    std::string help;
    bool repeated = false;
    bool is_output = false;                     ///< a place to write to, no input
    bool optional = false;                      ///< may be left out; it is the last one then
    std::vector<std::string> replaced_by = {};  ///< keys of options of which one is needed where it is left out
};

/// An option made from a described field: key `tolerance_mm` becomes `--tolerance-mm`.
struct Option {
    FieldInfo info;
    Value standard;          ///< the value when the option is not given
    bool is_output = false;  ///< names a place to write to, whose files are no inputs
};

/// An option that names a file to write besides the usual ones.
struct OutputOption {
    std::string name;  ///< "--deviations"
    std::string help;
};

/// Writes numbers as a table, wherever a verb does.
inline constexpr const char* tableOption = "--csv";

/// Request of a verb. `parameters` holds every option by key, defaults included.
struct Request {
    std::vector<std::string> operands;
    Values parameters;
    std::map<std::string, std::string> outputs;  ///< by option name, only those given
    bool in_full = false;                        ///< JSON or a report is asked for: more than the summary holds
    std::set<std::string> typed = {};            ///< keys of the parameters that are no defaults
};

/// Answer of a verb; filled step by step, so that notes survive an error. JSON and report are built when asked for.
struct Answer {
    std::function<Json()> json;                ///< the verb's own result keys, an object
    std::function<report::Document()> report;  ///< empty for verbs without one
    std::string summary;                       ///< readable summary
    Notes notes;
    Understanding understanding;                   ///< of a task; else what the notes state
    std::vector<Error> errors;                     ///< inputs refused while others could be answered
    std::optional<bool> pass;                      ///< the verdict, where there is one
    bool is_reported = false;                      ///< the report is written in spite of the errors
    bool always_strict = false;                    ///< a verdict against it is exit code 1 even without --strict
    std::shared_ptr<const task::Sources> sources;  ///< of a task: what it read; null: the inputs of the run
    Values parameters;                             ///< of a task: all of them; empty: those of the request
};

struct Verb {
    std::string name;
    std::string summary;
    std::vector<Operand> operands;
    std::vector<Option> parameters;
    io::FileKinds kinds;  ///< of files that it reads: their reading options are options of the verb
    std::vector<OutputOption> outputs;
    bool has_report = false;
    std::function<void(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)> run;
    const task::Task* task = nullptr;  ///< that it was made from; null: none
};

/// Options that settle what the input files of a verb leave open.
std::vector<Option> readingOptions(const Verb& verb);

/// Fills the answer with a computed result: its notes behind those of the files, JSON, report, verdict (of a result
/// that has one), summary. The
/// report shows the notes of the files as well. `json`, `report` and `summary` are functions of the result.
template <class Result, class MakeJson, class MakeReport, class Summarise>
void answerWith(Answer& answer, const std::shared_ptr<Result>& result, MakeJson json, MakeReport report,
                Summarise summary)
{
    answer.notes.insert(answer.notes.end(), result->notes.begin(), result->notes.end());
    result->notes = answer.notes;
    answer.json = [result, json] { return json(*result); };
    answer.report = [result, report] { return report(*result); };
    if constexpr (requires { result->verdict; }) answer.pass = passed(result->verdict);
    answer.summary = summary(*result);
}

/// The options of a parameter struct, with the defaults of a fresh one.
template <class P>
std::vector<Option> optionsOf()
{
    std::vector<Option> result;
    for (const Field<P>& field : fields<P>()) result.push_back({field.info, field.get(P{})});
    return result;
}

/// Error valueNotUnderstood of an option or operand.
[[noreturn]] void refuseOption(const char* name, const std::string& found, Text expected);

/// All verbs, in the order of the help page.
const std::vector<Verb>& verbs();

}  // namespace lathelier::cli
