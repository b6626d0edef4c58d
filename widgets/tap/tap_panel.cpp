#include "widgets/tap/tap_panel.h"

#include "engine/core/frf_item.h"
#include "engine/io/time_record/time_record_input.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/session.h"
#include "widgets/tap/tap_views.h"

namespace lathelier::tap_panel {
namespace {

using receptance::tapTask;

const std::vector<std::string> roles{receptance::tapRecordRole};

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(
        tapTask(), roles,
        {"hammer", "hammer_sensitivity", "response", "response_sensitivity", "estimator", "window", "block_s"}, true,
        LT_TEXT("Engine", "Drop the record of a tap test here, hammer and sensor over time, or one for each hit."));
    inputs.roles.front().takes_next = true;
    return inputs;
}

}  // namespace

PanelFacts tapPanelFacts()
{
    PanelFacts facts = factsOf(tapTask(), "tap", "tap", roles, {});
    facts.answer = answeredBy(receptance::answerTap);
    facts.make = [](Session& session) -> PanelBase* { return new TapPanel(session); };
    return facts;
}

TapPanel::TapPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, tapPanelFacts(), panelInputs(), parent), views_(new TapViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &TapViews::responseRequested, this, [this] { offer(frfItem); });
    connect(views_, &TapViews::notWritten, this, &TapPanel::reportWriteFailure);
}

QString TapPanel::understood(const InputRole&, const project::Source& source) const
{
    const auto loaded = session().stores().of<task::CacheOf<io::TimeRecordInput>>()->known(source);
    if (!loaded) return {};
    const std::vector<io::TimeChannel>& channels = loaded->file.record.channels;
    return understoodText(loaded->file.facts,
                          tr("%L1 channels · %L2 samples").arg(channels.size()).arg(channels.front().values.size()));
}

void TapPanel::showResult(const std::shared_ptr<const receptance::TapOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void TapPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::tap_panel
