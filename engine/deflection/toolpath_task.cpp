#include "engine/deflection/toolpath_task.h"

#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/deflection/deflection_task.h"
#include "engine/deflection/setup_file.h"
#include "engine/deflection/turning_study.h"
#include "engine/gcode/program_input.h"
#include "engine/gcode/toolpath_files.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_input.h"

namespace lathelier::deflection {
namespace {

/// Stock and tools if known; fills in the parameters of the check.
std::optional<stock::CheckedStock> takeCheckedStock(const project::PanelState& state, Stores& stores,
                                                    const Progress& progress, const gcode::ProgramTaken& taken,
                                                    task::Sources& sources, ToolpathOutcome& outcome)
{
    std::optional<Shaft> shaft;
    if (const auto setup = task::take<SetupInput>(state, setupRole, stores, progress.part(0, 0.5), sources)) {
        shaft = setup->stock;
        outcome.parameters = stockParameters(changed(setup->setup, outcome.question.changes, sources.notes));
    }
    if (auto given = task::take<io::ShaftInput>(state, stockRole, stores, progress.part(0.5, 1), sources))
        shaft = *std::move(given);
    if (!shaft && taken.item && taken.item->stock) {
        shaft = taken.item->stock;
        if (!outcome.question.changes.z_zero_mm) outcome.parameters.z_zero_mm = taken.item->z_zero_mm;
    }
    if (!shaft) return std::nullopt;
    return stock::CheckedStock{*std::move(shaft), outcome.parameters};
}

}  // namespace

const std::vector<Field<ToolpathQuestion>>& fieldsOf(const ToolpathQuestion*)
{
    using Q = ToolpathQuestion;
    static const std::vector<Field<Q>> all = [] {
        std::vector<Field<Q>> fields;
        for (const FieldInfo& info : infos<gcode::ToolpathParameters>())
            fields.push_back(within(&Q::reading, info.key));
        for (const FieldInfo& info : infos<SetupChanges>()) fields.push_back(foldedWithin(&Q::changes, info.key));
        fields.push_back(gcode::draftsField(&Q::drafts));
        return fields;
    }();
    return all;
}

ToolpathOutcome answerToolpath(const project::PanelState& state, Stores& stores, task::Sources& sources,
                               const Progress& progress)
{
    ToolpathOutcome outcome;
    outcome.question = fromValues<ToolpathQuestion>(state.parameters);
    const Progress reading = progress.part(0, 0.2, LT_TEXT("Engine", "Reading"));
    gcode::ProgramTaken taken =
        gcode::takeProgram(state, outcome.question.drafts, stores, reading.part(0, 0.5), sources);
    outcome.file = taken.name;
    outcome.item = state.inputs.at(gcode::programRole).item;
    outcome.sha256 = taken.sha256;
    outcome.file_text = gcode::toUtf8(taken.original);
    outcome.text = outcome.isDraft() ? outcome.question.drafts.front().text : outcome.file_text;
    const gcode::ToolTable tools = task::take<gcode::ToolTableInput>(state, gcode::toolsRole, stores, reading, sources)
                                       .value_or(gcode::ToolTable{});
    const std::optional<stock::CheckedStock> stock =
        takeCheckedStock(state, stores, reading.part(0.5, 1), taken, sources, outcome);
    outcome.question.reading.file_name = taken.name;
    gcode::takeSubprograms(taken.text, outcome.question.reading, tools, progress, sources);
    try {
        outcome.check = std::make_shared<const stock::ProgramCheck>(
            stock::checkProgram(std::move(taken.text), outcome.question.reading, stock, tools, progress.part(0.2, 1)));
    } catch (Error& error) {
        throw error.with("path", task::nameOf(state.inputs.at(gcode::programRole)));
    }
    Understanding of_program;
    of_program.add(outcome.check->path.understanding, task::nameOf(state.inputs.at(gcode::programRole)));
    outcome.record(state, sources, outcome.check->notes, of_program);
    set(outcome.asked.parameters, gcode::draftsKey, *find(toValues(outcome.question), gcode::draftsKey));
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const ToolpathOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    const std::shared_ptr<const stock::ProgramCheck> check = outcome->check;
    if (const std::optional<Error> error = gcode::firstError(check->path)) {
        all.errors.push_back(*error);
        all.errors.back().with("path", outcome->item.empty() ? outcome->file : outcome->item);
    } else if (check->stock) {
        all.verdict = check->stock->findings.empty() ? Verdict::Pass : Verdict::Fail;
    }
    all.json = [check] { return stock::toJson(*check); };
    all.answer = [check](const Language& language) { return stock::answer(*check, language); };
    all.summary = [check](const Language& language) {
        report::Section section = gcode::toolpathSummary(check->path, language);
        if (check->stock) section.blocks.insert(section.blocks.begin(), stock::answer(*check, language));
        return section;
    };
    all.report = [outcome](const Language& language) {
        return stock::programReport(*outcome->check, outcome->notes, language);
    };
    all.writers[rewriteExport] = [check](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, check->program.ownText());
    };
    if (!all.errors.empty()) return settled(toolpathTask(), std::move(all), outcome->understanding);
    all.writers[movesExport] = [check](const std::string& path, const Language&, const Progress& progress) {
        io::writeFile(path, [&](const io::Append& append) {
            gcode::writeMoves(check->path, [&](std::string_view step) {
                progress.check();
                append(step);
            });
        });
    };
    return settled(toolpathTask(), std::move(all), outcome->understanding);
}

const task::Task& toolpathTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "toolpath";
        made.title = LT_TEXT("Engine", "Program");
        made.question = "program";
        made.summary = "Read an NC program and give its moves; with its set-up, what the tool meets.";
        made.inputs = {gcode::programAsInput(), setupAsInput(false), stockAsInput(), gcode::toolTableAsInput()};
        task::askFor<ToolpathQuestion>(made);
        made.exports = {{movesExport, "Write the moves as FILE.csv.", LT_TEXT("Engine", "Moves of the tool (CSV)…"),
                         LT_TEXT("Engine", "Table (*.csv)"), "csv"},
                        {rewriteExport, "Write the program again as FILE, byte for byte.", {}, {}, ""}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const ToolpathOutcome>(answerToolpath(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::deflection
