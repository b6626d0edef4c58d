#include "widgets/program/program_picture.h"

#include <nlohmann/json.hpp>

#include "engine/deflection/turning_study.h"
#include "engine/report/result_json.h"
#include "widgets/chatter_common/taken_input.h"
#include "widgets/deflection_common/turning_files.h"

namespace lathelier::program_panel {
namespace {

using namespace deflection_common;

/// Stock and tool as far as they are known.
std::optional<stock::CheckedStock> takeStock(const project::PanelState& state, Stores& stores, const Progress& progress,
                                             const TakenProgram& taken, ProgramPicture& picture)
{
    std::optional<Shaft> shaft;
    if (state.inputs.count(setupRole) > 0) {
        const auto setup = takeFile<SetupStore>(state, setupRole, stores, progress, picture);
        shaft = setup->file.stock;
        picture.parameters =
            deflection::stockParameters(changed(setup->file.setup, picture.question.changes, picture.notes));
    }
    if (auto stated = chatter_common::takeShaft(state, stores, progress))
        shaft = chatter_common::noted(picture, *std::move(stated));
    if (!shaft && taken.item && taken.item->stock) {  // the bar that it was planned for
        shaft = taken.item->stock;
        if (!picture.question.changes.z_zero_mm) picture.parameters.z_zero_mm = taken.item->z_zero_mm;
    }
    if (!shaft) return std::nullopt;
    return stock::CheckedStock{*std::move(shaft), picture.parameters};
}

}  // namespace

ProgramPicture programPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    ProgramPicture picture;
    picture.question = fromValues<DeflectionQuestion>(state.parameters);
    TakenProgram taken;
    std::string text = takeProgram(state, stores, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")), picture, taken);
    picture.file = taken.name;
    picture.item = state.inputs.at(programRole).item;
    picture.sha256 = taken.input.sha256;
    picture.file_text = toUtf8(taken.text);
    picture.text = picture.isDraft() ? picture.question.drafts.front().text : picture.file_text;
    const std::optional<stock::CheckedStock> stock = takeStock(state, stores, progress.part(0.1, 0.2), taken, picture);
    try {
        picture.check = std::make_shared<stock::ProgramCheck>(
            stock::checkProgram(std::move(text), picture.question.reading, stock, progress.part(0.2, 1)));
    } catch (Error& error) {
        throw error.with("path", programName(state));
    }
    picture.notes.insert(picture.notes.end(), picture.check->notes.begin(), picture.check->notes.end());
    return picture;
}

report::Document reportOf(const ProgramPicture& picture, const Language& language)
{
    report::Document document = stock::programReport(*picture.check, picture.notes, language);
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    document.results = {report::toText(report::wholeResult("program", picture.inputs, toValues(picture.question),
                                                           stock::toJson(*picture.check), picture.notes))};
    return document;
}

}  // namespace lathelier::program_panel
