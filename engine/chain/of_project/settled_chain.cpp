#include "engine/chain/of_project/settled_chain.h"

#include <filesystem>

#include "engine/deflection/deflection_task.h"
#include "engine/deflection/setup_file.h"
#include "engine/receptance/spindle/spindle_input.h"

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

}  // namespace

AskedChain settled(AskedChain asked, Stores& stores, const Progress& progress)
{
    if (!asked.deflection || asked.deflection->inputs.count(deflection::setupRole) == 0) return asked;
    try {
        if (std::string text = changedSetup(asked, stores, progress); !text.empty()) {
            asked.made.push_back(madeInput(asked.question.out, "setup", std::move(text)));
            asked.question.setup = asked.made.back().path;
        }
    } catch (const Error&) {  // reported by the panel and the step
    }
    return asked;
}

}  // namespace lathelier::chain
