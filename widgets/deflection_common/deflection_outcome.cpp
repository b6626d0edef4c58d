#include "widgets/deflection_common/deflection_outcome.h"

#include <nlohmann/json.hpp>

#include "engine/deflection/deflection_codes.h"
#include "engine/gcode/program_item_codes.h"
#include "engine/io/file.h"
#include "engine/report/result_json.h"
#include "widgets/chatter_common/input_value.h"

namespace lathelier::deflection_common {
namespace {

deflection::TurningJob jobOf(const project::PanelState& state, Stores& stores, const Progress& progress,
                             DeflectionOutcome& outcome)
{
    ProgramInput taken;
    std::string program = takeProgram(state, stores, progress.part(0, 0.3), outcome, taken);
    outcome.program = taken.item;
    outcome.program_sha256 = io::sha256(program);
    const auto machine = takeFile<SetupStore>(state, setupRole, stores, progress.part(0.3, 0.4), outcome);
    deflection::TurningSetup setup = machine->file.setup;
    std::optional<Shaft> stock = machine->file.stock;
    if (auto stated = chatter_common::takeShaft(state, stores, progress)) {
        stock = chatter_common::recordInput(outcome, *std::move(stated));
        // A shaft item provides geometry and material for all panels, a shaft file only geometry. A material selected
        // from the library has precedence.
        const bool is_stated = outcome.question.changes.material == chatter_common::MaterialChoice::Stated;
        if (!state.inputs.at(chatter_common::shaftRole).item.empty() && stock->material && is_stated) {
            setup.material.elastic = *stock->material;
            outcome.notes.push_back(
                {notes::materialOfShaft, {{"modulus_MPa", setup.material.elastic.elastic_modulus_MPa}}});
        }
    }
    if (auto spindle = chatter_common::takeSpindle(state, stores, progress)) {
        const receptance::SpindleReceptance chuck = chatter_common::recordInput(outcome, *std::move(spindle));
        if (const receptance::SpindleSprings* springs = chuck.springs()) {
            setup.chuck.radial_N_mm = springs->radial_N_mm;
            setup.chuck.tilt_N_mm_rad = springs->tilt_N_mm_rad;
        } else {
            outcome.notes.push_back({notes::spindleHasNoSprings, {}});
        }
    }
    // A planned program contains its bar.
    if (!stock && taken.item && taken.item->stock) {
        stock = taken.item->stock;
        if (!outcome.question.changes.z_zero_mm) setup.z_zero_mm = taken.item->z_zero_mm;
        outcome.notes.push_back({notes::barOfProgram, {{"length_mm", stock->length_mm()}}});
    }
    const std::string path = programName(state);
    if (!stock) throw Error(errors::stockMissing, {{"path", state.inputs.at(setupRole).path}});
    try {
        gcode::Program read =
            gcode::readProgram(std::move(program), controlOf(outcome.question.reading), progress.part(0.4, 0.6));
        gcode::Toolpath moves = findToolpath(read, outcome.question.reading, {}, progress.part(0.6, 1));
        for (const gcode::Diagnostic& diagnostic : moves.diagnostics)
            if (diagnostic.error) throw Error(*diagnostic.error);
        return deflection::turningJob(std::move(read), std::move(moves), *std::move(stock),
                                      changed(std::move(setup), outcome.question.changes, outcome.notes));
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace

DeflectionOutcome deflectionOutcome(const project::PanelState& state, StudyKind studyKind, Stores& stores,
                                    const Progress& progress)
{
    DeflectionOutcome outcome;
    outcome.question = fromValues<DeflectionQuestion>(state.parameters);
    auto job = std::make_shared<deflection::TurningJob>(
        jobOf(state, stores, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")), outcome));
    deflection::StudyParameters asked = outcome.question.study;
    asked.correction = studyKind == StudyKind::Correction;
    if (asked.correction) asked.band = asked.sensitivities = asked.map = asked.feed = false;
    const DeflectionQuestion& q = outcome.question;
    try {
        outcome.study = std::make_shared<deflection::TurningStudy>(deflection::studyTurning(
            *job, asked,
            {q.band, q.map, {0, q.map.least_feed_mm_rev, q.map.largest_feed_mm_rev}, q.identification, q.compensation},
            progress.part(0.3, 0.98)));
        if (studyKind == StudyKind::Prediction && outcome.study->stock)
            outcome.drawn = stock::DrawnPath(job->path.moves, job->setup.z_zero_mm, job->program.blocks.size(),
                                             progress.part(0.98, 1));
    } catch (Error& error) {
        throw error.with("path", programName(state));
    }
    outcome.notes.insert(outcome.notes.end(), outcome.study->notes.begin(), outcome.study->notes.end());
    outcome.job = std::move(job);
    return outcome;
}

report::Document reportOf(const DeflectionOutcome& outcome, const Language& language)
{
    deflection::TurningStudy study = *outcome.study;
    study.notes = outcome.notes;  // including those of the files
    report::Document document = deflection::studyReport(study, language);
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    document.results = {report::toText(report::wholeResult("deflection", outcome.inputs, toValues(outcome.question),
                                                           deflection::toJson(study), outcome.notes))};
    return document;
}

}  // namespace lathelier::deflection_common
