#include "widgets/shaft/shaft_outcome.h"

#include <limits>

#include "engine/io/frf/frf_lines.h"
#include "engine/receptance/receptance_codes.h"
#include "widgets/chatter_common/shaft_files.h"
#include "widgets/part_common/shaft_table.h"

namespace lathelier::shaft_panel {
namespace {

void chooseShaft(ShaftOutcome& outcome, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const ShaftQuestion& question = outcome.question;
    outcome.table_rules = part_common::chooseSegments(
        question.segments, question.segments_of, state, outcome.shaft, outcome.notes, [&](const project::Source&) {
            outcome.shaft = chatter_common::recordInput(outcome, *chatter_common::takeShaft(state, stores, progress));
        });
}

/// The material by precedence: user, library, file. None: steel is assumed.
ValueOrigin chooseMaterial(ShaftOutcome& outcome)
{
    if (outcome.question.own_material) {
        outcome.shaft.material = outcome.question.own_material;
        return ValueOrigin::Given;
    }
    const bool chosen = part_common::chooseMaterial(outcome.question.material, outcome.shaft, outcome.notes);
    return !chosen && outcome.shaft.material ? ValueOrigin::File : ValueOrigin::Assumed;
}

void chooseHolding(ShaftOutcome& outcome, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const ShaftQuestion& question = outcome.question;
    receptance::ShaftHolding& holding = outcome.holding;
    for (const Rest& rest : question.rests)
        holding.supports.push_back({rest.z_mm, rest.radial_N_mm, 0, rest.loss_factor});
    constexpr double rigid = std::numeric_limits<double>::infinity();
    switch (question.hold) {
        case Hold::Free: return;
        case Hold::Clamped: holding.supports.push_back({outcome.shaft.length_mm(), rigid, rigid, 0}); return;
        case Hold::Springs: holding.spindle = receptance::SpindleReceptance{question.springs}; return;
        case Hold::Given: break;
    }
    if (auto spindle = chatter_common::takeSpindle(state, stores, progress))
        holding.spindle = chatter_common::recordInput(outcome, *std::move(spindle));
}

}  // namespace

ShaftOutcome shaftOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    ShaftOutcome outcome;
    outcome.question = fromValues<ShaftQuestion>(state.parameters);
    chooseShaft(outcome, state, stores, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")));
    const ValueOrigin origin = chooseMaterial(outcome);
    chooseHolding(outcome, state, stores, progress.part(0.1, 0.2));
    outcome.study = studyShaft(outcome.shaft, outcome.question.response, outcome.holding,
                               progress.part(0.2, 1, LT_TEXT("Engine", "Computing")));
    for (UsedValue& used : outcome.study.response.used) used.origin = origin;
    const Notes& found = outcome.study.response.notes;
    outcome.notes.insert(outcome.notes.end(), found.begin(), found.end());
    return outcome;
}

Frf usableResponse(const ShaftOutcome& outcome)
{
    Frf frf = outcome.study.response.frf;
    io::dropUnusableLines(frf);
    return frf;
}

}  // namespace lathelier::shaft_panel
