#include "widgets/speed/speed_panel.h"

#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle_item.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/shaft/shaft_item.h"
#include "engine/stability/stability_report.h"
#include "widgets/chatter_common/model_inputs.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/speed/speed_views.h"

namespace lathelier::speed_panel {
namespace {

PanelInputs panelInputs()
{
    PanelInputs inputs;
    inputs.roles = {
        chatter_common::inputRole(spindleRole, LT_TEXT("Engine", "Spindle"),
                                  LT_TEXT("Engine", "That holds the bar: SPINDLE.json."), receptance::spindleFiles(),
                                  receptance::spindleItem),
        chatter_common::inputRole(
            shaftRole, LT_TEXT("Engine", "Shaft"),
            LT_TEXT("Engine", "In place of a plain bar of diameter D and overhang L: SHAFT.json or a stock file."),
            io::shaftFiles(), shaftItem)};
    inputs.roles.back().required = false;
    inputs.fields = infos<SpeedQuestion>();
    inputs.defaults = toValues(SpeedQuestion{});
    inputs.invitation =
        LT_TEXT("Engine", "Drop the file of a spindle here, then type diameter, overhang and cutting speed.");
    return inputs;
}

}  // namespace

PanelFacts speedPanelFacts()
{
    PanelFacts facts;
    facts.id = "speed";
    facts.title = LT_TEXT("Engine", "Speed");
    facts.icon = "speed";
    facts.workspaces = {workspaceOf("chatter")};
    facts.kinds = {&receptance::spindleFiles(), &io::shaftFiles()};
    facts.roles = panelInputs().roles;
    facts.make = [](Session& session) -> PanelBase* { return new SpeedPanel(session); };
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        const SpeedOutcome outcome = speedOutcome(state, stores, progress);
        if (outcome.problem) throw Error(*outcome.problem);
        return reportOf(outcome, language);
    };
    return facts;
}

SpeedPanel::SpeedPanel(Session& owner, QWidget* parent)
    : Panel(owner, speedPanelFacts(), panelInputs(), parent), views_(new SpeedViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &SpeedViews::valueEntered, this, [this](const QString& key, double value) { take(key, value); });
    connect(views_, &SpeedViews::valueCleared, this, [this](const QString& key) { take(key, {}); });
    connect(views_, &SpeedViews::notWritten, this, &SpeedPanel::reportWriteFailure);
}

void SpeedPanel::take(const QString& key, const Value& value)
{
    editState(tr("Type a value"),
              [&](project::PanelState& state) { lathelier::set(state.parameters, key.toStdString(), value); });
}

SpeedPanel::Compute SpeedPanel::compute(const project::PanelState& state) const
{
    fromValues<SpeedQuestion>(state.parameters);  // validates ranges before the computation
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return speedOutcome(state, *stores, progress);
    };
}

void SpeedPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    chatter_common::assignModels(state, files);
}

QString SpeedPanel::understood(const InputRole& role, const project::Source& source) const
{
    return chatter_common::understoodModel(role.role, source, session().stores());
}

void SpeedPanel::showResult(const std::shared_ptr<const SpeedOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer SpeedPanel::answer(const SpeedOutcome& outcome) const
{
    report::Answer answer = stability::answer(*outcome.speed, screenLanguage());
    answer.used = outcome.used;
    return answer;
}

report::Document SpeedPanel::document(const SpeedOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

void SpeedPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::speed_panel
