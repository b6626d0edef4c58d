#include "widgets/deflection_common/turning_panel.h"

#include <QCoreApplication>

#include "engine/deflection/setup_file.h"
#include "widgets/chatter_common/understood_models.h"
#include "widgets/core/form/input_box.h"

namespace lathelier::deflection_common {
namespace {

struct TurningFacts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::deflection_common::TurningFacts)
};

using FactsOfPrograms = task::CacheOf<gcode::ProgramFacts>;

}  // namespace

PanelFacts turningFacts(PanelFacts facts)
{
    facts.state = "deflection";
    facts.kinds = {&gcode::programFiles(), &deflection::setupFiles()};
    facts.item_inputs = {{gcode::programItem, gcode::programRole}};
    return facts;
}

void readProgramFacts(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const project::Source* const source = task::sourceOf(state, gcode::programRole);
    if (!source || !source->item.empty()) return;
    try {
        stores.of<FactsOfPrograms>()->load(*source, progress);
    } catch (const Error&) {  // reported by the answer
    }
}

QString understoodTurning(const std::string& role, const project::Source& source, Stores& stores)
{
    if (role == deflection::stockRole || role == deflection::spindleRole)
        return chatter_common::understoodModel(source, stores);
    if (role == deflection::setupRole) {
        const auto loaded = stores.of<task::CacheOf<deflection::SetupInput>>()->known(source);
        if (!loaded) return {};
        return understoodText(loaded->file.facts, loaded->file.setup.tailstock ? TurningFacts::tr("chuck and tailstock")
                                                                               : TurningFacts::tr("chuck"));
    }
    const auto loaded = stores.of<FactsOfPrograms>()->known(source);
    if (!loaded) return {};
    return understoodText(loaded->file.facts, TurningFacts::tr("%L1 blocks").arg(loaded->file.facts.rows));
}

}  // namespace lathelier::deflection_common
