#include "widgets/program/program_outcome.h"

#include <nlohmann/json.hpp>

#include "engine/deflection/turning_study.h"
#include "engine/report/result_json.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/deflection_common/turning_files.h"

namespace lathelier::program_panel {
namespace {

using namespace deflection_common;

/// Stock and tools if known.
std::optional<stock::CheckedStock> takeStock(const project::PanelState& state, Stores& stores, const Progress& progress,
                                             const ProgramInput& taken, ProgramOutcome& outcome)
{
    std::optional<Shaft> shaft;
    if (state.inputs.count(setupRole) > 0) {
        const auto setup = takeFile<SetupStore>(state, setupRole, stores, progress, outcome);
        shaft = setup->file.stock;
        outcome.parameters =
            deflection::stockParameters(changed(setup->file.setup, outcome.question.changes, outcome.notes));
    }
    if (auto stated = chatter_common::takeShaft(state, stores, progress))
        shaft = chatter_common::recordInput(outcome, *std::move(stated));
    if (!shaft && taken.item && taken.item->stock) {  // the bar of a planned program
        shaft = taken.item->stock;
        if (!outcome.question.changes.z_zero_mm) outcome.parameters.z_zero_mm = taken.item->z_zero_mm;
    }
    if (!shaft) return std::nullopt;
    return stock::CheckedStock{*std::move(shaft), outcome.parameters};
}

}  // namespace

ProgramOutcome programOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    ProgramOutcome outcome;
    outcome.question = fromValues<DeflectionQuestion>(state.parameters);
    ProgramInput taken;
    std::string text = takeProgram(state, stores, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")), outcome, taken);
    outcome.file = taken.name;
    outcome.item = state.inputs.at(programRole).item;
    outcome.sha256 = taken.input.sha256;
    outcome.file_text = toUtf8(taken.text);
    outcome.text = outcome.isDraft() ? outcome.question.drafts.front().text : outcome.file_text;
    const std::optional<stock::CheckedStock> stock = takeStock(state, stores, progress.part(0.1, 0.2), taken, outcome);
    try {
        outcome.check = std::make_shared<stock::ProgramCheck>(
            stock::checkProgram(std::move(text), outcome.question.reading, stock, progress.part(0.2, 1)));
    } catch (Error& error) {
        throw error.with("path", programName(state));
    }
    outcome.notes.insert(outcome.notes.end(), outcome.check->notes.begin(), outcome.check->notes.end());
    return outcome;
}

report::Document reportOf(const ProgramOutcome& outcome, const Language& language)
{
    report::Document document = stock::programReport(*outcome.check, outcome.notes, language);
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    document.results = {report::toText(report::wholeResult("program", outcome.inputs, toValues(outcome.question),
                                                           stock::toJson(*outcome.check), outcome.notes))};
    return document;
}

}  // namespace lathelier::program_panel
