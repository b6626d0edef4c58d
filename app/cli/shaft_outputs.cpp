#include "app/cli/shaft_outputs.h"

#include <algorithm>

#include "engine/cad/cad_codes.h"
#include "engine/cad/cad_notes.h"
#include "engine/cad/task/part_files.h"
#include "engine/core/understanding.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/features/features_codes.h"
#include "engine/features/stock_part.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::cli {
namespace {

constexpr const char* shaftOption = "--shaft";

std::string optionOf(const task::Export& one)
{
    return "--" + one.option;
}

drawing::Drawing drawingOf(const ShaftToWrite& asked, const cad::CadQuestion& cad)
{
    drawing::DrawingOptions options;
    options.scan = asked.scan;
    options.measured = asked.measured;
    options.uncertainties = asked.uncertainties;
    options.bore_uncertainties = asked.bore_uncertainties;
    if (!cad.undated) options.date = cad::today();
    return drawing::drawShaft(asked.shaft, options);
}

/// What a part is made by: not written where something of it was not understood. Error not_modelled.
void requireUnderstoodFor(const Request& request, const Notes& notes)
{
    for (const task::Export& one : cad::partExports())
        if (one.is_cut_by && request.outputs.count(optionOf(one)) > 0) return requireUnderstood(understandingOf(notes));
}

}  // namespace

std::vector<OutputOption> shaftOutputs()
{
    std::vector<OutputOption> options;
    for (const task::Export& one : cad::partExports()) options.push_back({optionOf(one), one.help});
    return options;
}

std::vector<Option> cadOptions()
{
    return optionsOf<cad::CadQuestion>();
}

void writeShaftOutputs(const Request& request, const ShaftToWrite& asked, const Progress& progress, Answer& answer)
{
    requireUnderstoodFor(request, answer.notes);
    cad::PartToWrite part;
    part.shaft = asked.shaft;
    part.cad = fromValues<cad::CadQuestion>(request.parameters);
    part.drawing = [&](const Language&) { return drawingOf(asked, part.cad); };
    const auto writers = cad::partWriters(std::shared_ptr<const cad::PartToWrite>(std::shared_ptr<void>(), &part));
    const auto write = [&](const auto& output) { writers.at(output.first.substr(2))(output.second, {}, progress); };
    const auto shaft = request.outputs.find(shaftOption);
    if (shaft != request.outputs.end()) write(*shaft);
    const bool others = request.outputs.size() > (shaft != request.outputs.end() ? 1U : 0U);
    if (!others) return;
    if (!asked.complete) throw Error(errors::shaftIncomplete, {{"reason", asked.missing}});
    const Notes remarks = checkShaft(asked.shaft);
    answer.notes.insert(answer.notes.end(), remarks.begin(), remarks.end());
    part.stock = features::outOfChuck(asked.shaft, asked.chucked_mm);
    task::Wanted wanted;
    for (const auto& [option, path] : request.outputs) wanted.exports.push_back(option.substr(2));
    if (cad::isSolidWanted(wanted)) {
        const Notes left_out = cad::cadNotes(asked.shaft);
        if (contains(left_out, notes::marksLeftOut))  // implies the other note
            std::erase_if(answer.notes, [](const Note& note) { return note.code == notes::marksFound; });
        answer.notes.insert(answer.notes.end(), left_out.begin(), left_out.end());
    }
    for (const auto& output : request.outputs)
        if (output.first != shaftOption) write(output);
}

}  // namespace lathelier::cli
