#include "widgets/deflection_common/deflection_picture.h"

#include <nlohmann/json.hpp>

#include "engine/deflection/deflection_codes.h"
#include "engine/gcode/program_item_codes.h"
#include "engine/io/file.h"
#include "engine/report/result_json.h"
#include "widgets/chatter_common/taken_input.h"

namespace lathelier::deflection_common {
namespace {

deflection::TurningJob jobOf(const project::PanelState& state, Stores& stores, const Progress& progress,
                             DeflectionPicture& picture)
{
    TakenProgram taken;
    std::string program = takeProgram(state, stores, progress.part(0, 0.3), picture, taken);
    picture.program = taken.item;
    picture.program_sha256 = io::sha256(program);
    const auto machine = takeFile<SetupStore>(state, setupRole, stores, progress.part(0.3, 0.4), picture);
    deflection::TurningSetup setup = machine->file.setup;
    std::optional<Shaft> stock = machine->file.stock;
    if (auto stated = chatter_common::takeShaft(state, stores, progress)) {
        stock = chatter_common::noted(picture, *std::move(stated));
        // A shaft of the project is one definition for all panels, and its material with it. A file gives geometry.
        // A material of the library rules over it.
        const bool is_stated = picture.question.changes.material == chatter_common::MaterialChoice::Stated;
        if (!state.inputs.at(chatter_common::shaftRole).item.empty() && stock->material && is_stated) {
            setup.material.elastic = *stock->material;
            picture.notes.push_back(
                {notes::materialOfShaft, {{"modulus_MPa", setup.material.elastic.elastic_modulus_MPa}}});
        }
    }
    if (auto spindle = chatter_common::takeSpindle(state, stores, progress)) {
        const receptance::SpindleReceptance chuck = chatter_common::noted(picture, *std::move(spindle));
        if (const receptance::SpindleSprings* springs = chuck.springs()) {
            setup.chuck.radial_N_mm = springs->radial_N_mm;
            setup.chuck.tilt_N_mm_rad = springs->tilt_N_mm_rad;
        } else {
            picture.notes.push_back({notes::spindleHasNoSprings, {}});
        }
    }
    // A program that was planned knows the bar that it was planned for.
    if (!stock && taken.item && taken.item->stock) {
        stock = taken.item->stock;
        if (!picture.question.changes.z_zero_mm) setup.z_zero_mm = taken.item->z_zero_mm;
        picture.notes.push_back({notes::barOfProgram, {{"length_mm", stock->length_mm()}}});
    }
    const std::string path = programName(state);
    if (!stock) throw Error(errors::stockMissing, {{"path", state.inputs.at(setupRole).path}});
    try {
        gcode::Program read =
            gcode::readProgram(std::move(program), picture.question.reading.dialect, progress.part(0.4, 0.6));
        gcode::Toolpath moves = findToolpath(read, picture.question.reading, {}, progress.part(0.6, 1));
        for (const gcode::Diagnostic& diagnostic : moves.diagnostics)
            if (diagnostic.error) throw Error(*diagnostic.error);
        return deflection::turningJob(std::move(read), std::move(moves), *std::move(stock),
                                      changed(std::move(setup), picture.question.changes, picture.notes));
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace

DeflectionPicture deflectionPicture(const project::PanelState& state, Wanted wanted, Stores& stores,
                                    const Progress& progress)
{
    DeflectionPicture picture;
    picture.question = fromValues<DeflectionQuestion>(state.parameters);
    auto job = std::make_shared<deflection::TurningJob>(
        jobOf(state, stores, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")), picture));
    deflection::StudyParameters asked = picture.question.study;
    asked.correction = wanted == Wanted::Correction;
    if (asked.correction) asked.band = asked.sensitivities = asked.map = asked.feed = false;
    const DeflectionQuestion& q = picture.question;
    try {
        picture.study = std::make_shared<deflection::TurningStudy>(deflection::studyTurning(
            *job, asked,
            {q.band, q.map, {0, q.map.least_feed_mm_rev, q.map.largest_feed_mm_rev}, q.identification, q.compensation},
            progress.part(0.3, 0.98)));
        if (wanted == Wanted::Prediction && picture.study->stock)
            picture.drawn = stock::DrawnPath(job->path.moves, job->setup.z_zero_mm, job->program.blocks.size(),
                                             progress.part(0.98, 1));
    } catch (Error& error) {
        throw error.with("path", programName(state));
    }
    picture.notes.insert(picture.notes.end(), picture.study->notes.begin(), picture.study->notes.end());
    picture.job = std::move(job);
    return picture;
}

report::Document reportOf(const DeflectionPicture& picture, const Language& language)
{
    deflection::TurningStudy study = *picture.study;
    study.notes = picture.notes;  // those of the files as well
    report::Document document = deflection::studyReport(study, language);
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    document.results = {report::toText(report::wholeResult("deflection", picture.inputs, toValues(picture.question),
                                                           deflection::toJson(study), picture.notes))};
    return document;
}

}  // namespace lathelier::deflection_common
