#include "engine/chain/of_project/settled_chain.h"

#include <filesystem>

#include "engine/deflection/deflection_task.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/spindle/spindle_input.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/shaft/shaft_item.h"
#include "engine/task/edited_segments.h"

namespace lathelier::chain {
namespace {

namespace fs = std::filesystem;

/// The set-up of the panel with its stock named absolutely; that of an item as it was made for the chain.
deflection::TurningSetup statedSetup(const AskedChain& asked, Stores& stores, const Progress& progress)
{
    const project::Source& source = asked.deflection->inputs.at(deflection::setupRole);
    if (!source.item.empty()) {
        for (const MadeInput& made : asked.made)
            if (Notes noted; made.path == asked.question.setup) return deflection::readSetup(made.text, noted);
        task::throwItemNotThere(source.item, deflection::setupItem);
    }
    const auto loaded = stores.of<task::CacheOf<deflection::SetupInput>>()->load(source, progress);
    deflection::TurningSetup stated = loaded->file.setup;
    if (!stated.stock.empty())
        stated.stock = fs::absolute(fs::path(source.path).parent_path() / stated.stock).lexically_normal().string();
    return stated;
}

/// Set-up as changed in the panel; empty: as it is given.
std::string changedSetup(const AskedChain& asked, Stores& stores, const Progress& progress)
{
    const project::PanelState& state = *asked.deflection;
    const deflection::TurningSetup stated = statedSetup(asked, stores, progress);
    deflection::TurningSetup setup = stated;
    task::Sources unused;
    if (const auto spindle =
            task::take<receptance::SpindleInput>(state, deflection::spindleRole, stores, progress, unused))
        if (const receptance::SpindleSprings* const springs = spindle->springs()) {
            setup.chuck.radial_N_mm = springs->radial_N_mm;
            setup.chuck.tilt_N_mm_rad = springs->tilt_N_mm_rad;
        }
    const auto question = fromValues<deflection::DeflectionQuestion>(state.parameters);
    Notes setupNotes;  // notes of the panel's changes
    const std::string text = deflection::setupText(changed(std::move(setup), question.changes, setupNotes));
    return text == deflection::setupText(stated) ? std::string() : text;
}

void giveMade(AskedChain& asked, std::string& path, const char* name, std::string text)
{
    asked.made.push_back(madeInput(asked.question.out, name, std::move(text)));
    path = asked.made.back().path;
}

/// What the turning program takes from earlier questions and the chain would not find by itself.
void takeFromPart(AskedChain& asked, const walk::Walk& walk, const Progress& progress)
{
    constexpr const char *drawingPlace = "drawing", *programPlace = "turning", *spindlePlace = "spindle";
    if (!walk.place(drawingPlace) || !walk.place(programPlace)) return;
    const Value* const table = find(walk.promised(drawingPlace).parameters, task::segmentsKey);
    const auto* const rows = table ? std::get_if<Rows>(table) : nullptr;
    const bool is_edited = asked.question.drawing.empty() && rows && !rows->rows.empty();
    const std::map<std::string, project::Item>& items = walk.promised(programPlace).items;
    const auto machine = items.find(machineRole);
    const bool is_measured =
        asked.question.machine.empty() && machine != items.end() && machine->second.origin.panel == spindlePlace;
    if (!is_edited && !is_measured) return;
    try {
        Notes reported_there;
        const project::PanelState state = walk.complete(programPlace, reported_there, progress);
        const auto shaft = state.items.find(drawingRole), spindle = state.items.find(machineRole);
        if (is_edited && shaft != state.items.end())
            if (const auto drawn = shaftOf(shaft->second.values))
                giveMade(asked, asked.question.drawing, "drawing", io::shaftText(*drawn));
        if (is_measured && spindle != state.items.end())
            if (const auto found = receptance::spindleOf(spindle->second.values))
                giveMade(asked, asked.question.machine, "spindle", receptance::spindleText(*found));
    } catch (const Error&) {  // reported by the panel and the step
    }
}

}  // namespace

AskedChain settled(AskedChain asked, const walk::Walk& walk, Stores& stores, const Progress& progress)
{
    takeFromPart(asked, walk, progress);
    if (!asked.deflection || asked.deflection->inputs.count(deflection::setupRole) == 0) return asked;
    try {
        if (std::string text = changedSetup(asked, stores, progress); !text.empty())
            giveMade(asked, asked.question.setup, "setup", std::move(text));
    } catch (const Error&) {  // reported by the panel and the step
    }
    return asked;
}

}  // namespace lathelier::chain
