#include "widgets/frf/frf_panel.h"

#include "engine/core/frf_item.h"
#include "engine/receptance/task/shaft_task.h"
#include "widgets/chatter_common/understood_models.h"
#include "widgets/frf/frf_views.h"

namespace lathelier::frf_panel {
namespace {

using receptance::ModesOutcome;
using receptance::modesTask;
using receptance::responseRole;

const std::vector<std::string> roles{responseRole, receptance::shaftRole, receptance::spindleRole};

PanelInputs panelInputs()
{
    PanelInputs inputs =
        inputsOf(modesTask(), roles, {}, false,
                 LT_TEXT("Engine", "Drop a measured frequency response here, or a shaft and its spindle."));
    inputs.roles.front().takes_next = true;
    inputs.fields = modesTask().fields;
    return inputs;
}

}  // namespace

PanelFacts frfPanelFacts()
{
    PanelFacts facts = factsOf(modesTask(), "frf", "frf", roles, {});
    facts.answer = answeredBy(receptance::answerModes);
    facts.make = [](Session& session) -> PanelBase* { return new FrfPanel(session); };
    return facts;
}

FrfPanel::FrfPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, frfPanelFacts(), panelInputs(), parent), views_(new FrfViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &FrfViews::modeDragged, this, &FrfPanel::dragMode);
    connect(views_, &FrfViews::fitRequested, this, &FrfPanel::goBackToTheFit);
    connect(views_, &FrfViews::responseRequested, this, [this] { offer(frfItem); });
    connect(views_, &FrfViews::notWritten, this, &FrfPanel::reportWriteFailure);
}

/// The dragged peak changes the mode of the model, not the fit.
void FrfPanel::dragMode(int index, double frequency_hz, double magnitude_mm_N, bool dropped)
{
    const auto outcome = result();
    const auto at = static_cast<std::size_t>(index);
    if (!outcome || at >= outcome->study.model.modes.size()) return;
    receptance::ModesQuestion question;
    question.modes = outcome->study.model.modes;
    question.modes[at] = receptance::draggedMode(outcome->study.model, at, frequency_hz, magnitude_mm_N);
    const Value dragged = *lathelier::find(toValues(question), receptance::changedModesKey);
    editState(
        tr("Drag a peak"),
        [&](project::PanelState& state) { lathelier::set(state.parameters, receptance::changedModesKey, dragged); },
        QString("frf/modes/%1").arg(gesture_));
    gesture_ += dropped;
}

void FrfPanel::goBackToTheFit()
{
    editState(tr("Back to the fit"), [](project::PanelState& state) {
        lathelier::set(state.parameters, receptance::changedModesKey, Rows{});
    });
}

QString FrfPanel::understood(const InputRole&, const project::Source& source) const
{
    return chatter_common::understoodModel(source, session().stores());
}

void FrfPanel::showResult(const std::shared_ptr<const ModesOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void FrfPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::frf_panel
