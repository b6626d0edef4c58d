#include "engine/deflection/deflection_task.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/deflection_plots.h"
#include "engine/deflection/setup_file.h"
#include "engine/gcode/program_input.h"
#include "engine/gcode/program_item.h"
#include "engine/gcode/program_item_codes.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_input.h"
#include "engine/receptance/spindle/spindle_input.h"
#include "engine/report/chart_csv.h"

namespace lathelier::deflection {
namespace {

/// What the inputs state, by precedence.
HeldSetup takeMachine(const project::PanelState& state, const SetupChanges& changes, Stores& stores,
                      const Progress& progress, task::Sources& sources)
{
    HeldSetup stated = *task::take<SetupInput>(state, setupRole, stores, progress.part(0, 0.3), sources);
    if (!state.inputs.at(setupRole).item.empty()) noteSprings(stated.setup, sources.notes);
    if (auto stock = task::take<io::ShaftInput>(state, stockRole, stores, progress.part(0.3, 0.6), sources)) {
        stated.stock = *std::move(stock);
        const bool is_item = !state.inputs.at(stockRole).item.empty();
        if (is_item && stated.stock->material && changes.material == statedChoice) {
            stated.setup.material.elastic = *stated.stock->material;
            sources.notes.push_back(
                {notes::materialOfShaft, {{"modulus_MPa", stated.setup.material.elastic.elastic_modulus_MPa}}});
        }
    }
    if (const auto chuck =
            task::take<receptance::SpindleInput>(state, spindleRole, stores, progress.part(0.6, 1), sources)) {
        if (const receptance::SpindleSprings* springs = chuck->springs()) {
            stated.setup.chuck.radial_N_mm = springs->radial_N_mm;
            stated.setup.chuck.tilt_N_mm_rad = springs->tilt_N_mm_rad;
        } else {
            sources.notes.push_back({notes::spindleHasNoSprings, {}});
        }
    }
    return stated;
}

TurningJob jobOf(const project::PanelState& state, Stores& stores, const Progress& progress, task::Sources& sources,
                 DeflectionOutcome& outcome)
{
    HeldSetup stated = takeMachine(state, outcome.question.changes, stores, progress.part(0, 0.3), sources);
    gcode::ProgramTaken taken =
        gcode::takeProgram(state, outcome.question.drafts, stores, progress.part(0.3, 0.5), sources);
    const gcode::ToolTable tools = task::take<gcode::ToolTableInput>(state, gcode::toolsRole, stores, progress, sources)
                                       .value_or(gcode::ToolTable{});
    outcome.program = taken.item;
    outcome.program_sha256 = io::sha256(taken.text);
    if (!stated.stock && taken.item && taken.item->stock) {
        stated.stock = taken.item->stock;
        if (!outcome.question.changes.z_zero_mm) stated.setup.z_zero_mm = taken.item->z_zero_mm;
        sources.notes.push_back({notes::barOfProgram, {{"length_mm", stated.stock->length_mm()}}});
    }
    if (!stated.stock) throw Error(errors::stockMissing, {{"path", task::nameOf(state.inputs.at(setupRole))}});
    const std::string name = task::nameOf(state.inputs.at(gcode::programRole));
    outcome.question.reading.file_name = name;
    gcode::takeSubprograms(taken.text, outcome.question.reading, tools, progress, sources);
    gcode::ProgramRun run = gcode::runProgram(std::move(taken.text), name, outcome.question.reading, tools,
                                              progress.part(0.5, 1, LT_TEXT("Engine", "Reading")));
    return turningJob(std::move(run.program), std::move(run.path), *std::move(stated.stock),
                      changed(std::move(stated.setup), outcome.question.changes, sources.notes), tools);
}

}  // namespace

task::Input setupAsInput(bool required)
{
    task::Input input =
        task::input<SetupInput>(setupRole, setupRole, LT_TEXT("Engine", "Set-up"),
                                LT_TEXT("Engine", "Machine, tool, material and stock, from SETUP.json."));
    input.required = required;
    return input;
}

/// The corrected text with its intended offset from the programmed contour.
gcode::ProgramItem correctedProgram(const DeflectionOutcome& outcome)
{
    const CorrectedProgram& corrected = *outcome.study->corrected;
    gcode::ProgramItem item;
    item.text = gcode::toUtf8(corrected.text);
    if (outcome.program) item.clamping = outcome.program->clamping;
    item.corrected_from = outcome.program_sha256;
    item.z_zero_mm = outcome.job->setup.z_zero_mm;
    std::vector<gcode::CorrectedCorner> corners;
    for (const CorrectedRun& run : corrected.compensation.runs)
        for (const CorrectedNode& node : run.nodes)
            corners.push_back({node.z_mm - item.z_zero_mm, node.x_mm - node.programmed_mm});
    item.correction = gcode::correctionOf(corners);
    return item;
}

/// The set-up as changed, with the stock that was taken: named as it is found from the file that is written.
TurningSetup setupBeside(const DeflectionOutcome& outcome, const std::string& path)
{
    namespace fs = std::filesystem;
    TurningSetup setup = outcome.job->setup;
    const project::Source* const stock = task::sourceOf(outcome.asked, stockRole);
    fs::path found;
    if (stock && stock->item.empty())
        found = stock->path;
    else if (!setup.stock.empty())
        found = fs::path(outcome.asked.inputs.at(setupRole).path).parent_path() / setup.stock;
    if (found.empty()) return setup;
    const fs::path folder = fs::absolute(path).parent_path();
    setup.stock = fs::absolute(found).lexically_proximate(folder).generic_string();
    return setup;
}

/// Named after the original program.
task::Product correctedProduct(const std::shared_ptr<const DeflectionOutcome>& outcome, const Language& language)
{
    const project::Source& source = outcome->asked.inputs.at(gcode::programRole);
    const std::string of = source.item.empty() ? std::filesystem::path(source.path).stem().string() : source.item;
    return {gcode::correctedItem,
            {},
            fill(text(LT_TEXT("Engine", "{program}, corrected"), language), {{"program", of}}),
            [outcome] { return gcode::toValues(correctedProgram(*outcome)); }};
}

task::Input stockAsInput()
{
    return task::optionalInput<io::ShaftInput>(
        stockRole, "stock", LT_TEXT("Engine", "Stock"),
        LT_TEXT("Engine", "A stock file or SHAFT.json, instead of the one in the set-up."));
}

task::Input spindleAsInput()
{
    return task::optionalInput<receptance::SpindleInput>(
        spindleRole, spindleRole, LT_TEXT("Engine", "Spindle"),
        LT_TEXT("Engine", "Its springs (SPINDLE.json), instead of the chuck in the set-up."));
}

DeflectionOutcome answerDeflection(const project::PanelState& state, StudyKind kind, Stores& stores,
                                   task::Sources& sources, const Progress& progress)
{
    DeflectionOutcome outcome;
    outcome.question = fromValues<DeflectionQuestion>(state.parameters);
    StudyParameters asked = outcome.question.study;
    asked.correction = kind == StudyKind::Correction;
    try {
        const auto job = std::make_shared<const TurningJob>(
            jobOf(state, stores, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")), sources, outcome));
        outcome.job = job;
        outcome.study = std::make_shared<const TurningStudy>(
            studyTurning(*job, asked, detailsOf(outcome.question), progress.part(0.3, 0.98)));
        if (kind == StudyKind::Prediction && outcome.study->stock)
            outcome.drawn = stock::DrawnPath(job->path.moves, job->setup.z_zero_mm, job->program.blocks.size(),
                                             progress.part(0.98, 1));
    } catch (Error& error) {
        throw error.with("path", task::nameOf(state.inputs.at(gcode::programRole)));
    }
    Understanding of_program;
    of_program.add(outcome.job->path.understanding, task::nameOf(state.inputs.at(gcode::programRole)));
    outcome.record(state, sources, outcome.study->notes, of_program);
    set(outcome.asked.parameters, gcode::draftsKey, *find(toValues(outcome.question), gcode::draftsKey));
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const DeflectionOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.verdict = outcome->study->verdict;
    const std::shared_ptr<const TurningStudy> study = outcome->study;
    all.json = [study] { return toJson(*study); };
    all.answer = [study](const Language& language) {
        return study->corrected ? correctionAnswer(*study, language) : answer(*study, language);
    };
    all.summary = [study](const Language& language) { return studySummary(*study, language); };
    all.report = [outcome](const Language& language) {
        TurningStudy whole = *outcome->study;
        whole.notes = outcome->notes;
        return studyReport(whole, language);
    };
    all.writers[errorsExport] = [study](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, report::toCsv(errorPlot(study->prediction)));
    };
    all.writers[setupExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, setupText(setupBeside(*outcome, path)));
    };
    if (!study->corrected) return settled(deflectionTask(), std::move(all), outcome->understanding);
    all.writers[compensateExport] = [study](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, study->corrected->text);
    };
    all.products = [outcome](const Language& language) { return std::vector{correctedProduct(outcome, language)}; };
    all.writers[correctionExport] = [study](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, report::toCsv(correctionPlot(study->corrected->compensation)));
    };
    return settled(deflectionTask(), std::move(all), outcome->understanding);
}

const task::Task& deflectionTask()
{
    static const task::Task task = [] {
        const Text table = LT_TEXT("Engine", "Table (*.csv)");
        task::Task made;
        made.key = "deflection";
        made.title = LT_TEXT("Engine", "Deflection");
        made.summary = "Predict how far slender work bends under the tool, and write the program that allows for it.";
        made.question = "deflection";
        made.products = {gcode::correctedItem};
        made.inputs = {gcode::programAsInput(), setupAsInput(true), stockAsInput(), spindleAsInput(),
                       gcode::toolTableAsInput()};
        task::askFor<DeflectionQuestion>(made);
        made.exports = {
            {compensateExport, "Write the corrected program as FILE.", LT_TEXT("Engine", "Corrected program…"),
             LT_TEXT("Engine", "NC program (*.nc *.ngc *.mpf *.tap)"), "nc", true},
            {correctionExport, "Write the correction along the work as FILE.csv.",
             LT_TEXT("Engine", "Correction along the work (CSV)…"), table, "csv", true},
            {errorsExport, "Write the error along the work as FILE.csv.",
             LT_TEXT("Engine", "Error along the work (CSV)…"), table, "csv"},
            {setupExport, "Write the set-up with its changes as FILE.json.",
             LT_TEXT("Engine", "Set-up as changed here (JSON)…"), LT_TEXT("Engine", "Set-up (*.json)"), "json"}};
        made.run = [](const project::PanelState& state, const task::Wanted& wanted, Stores& stores,
                      task::Sources& sources, const Progress& progress) {
            const bool corrects = wanted.has(compensateExport) || wanted.has(correctionExport);
            return outcomeOf(std::make_shared<const DeflectionOutcome>(answerDeflection(
                state, corrects ? StudyKind::Correction : StudyKind::Prediction, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::deflection
