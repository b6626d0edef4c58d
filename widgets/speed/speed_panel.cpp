#include "widgets/speed/speed_panel.h"

#include "engine/stability/task/speed_entry.h"
#include "widgets/chatter_common/understood_models.h"
#include "widgets/core/session.h"
#include "widgets/speed/speed_views.h"

namespace lathelier::speed_panel {
namespace {

using stability::SpeedOutcome;

const std::vector<std::string> roles{stability::spindleRole, stability::shaftRole, stability::frfRole};

std::vector<InputRole> speedRoles()
{
    std::vector<InputRole> all = rolesOf(stability::speedTask(), roles);
    all.front().required = true;  // the operator's machine: a bar without it hangs free
    return all;
}

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(
        stability::speedTask(), roles,
        {"diameter_mm", stability::barLengthKey, "cutting_speed_m_min", "range_m_min", "depth_mm",
         "cutting_coefficient_N_mm2", "rule"},
        true, LT_TEXT("Engine", "Drop the file of a spindle here, then type diameter, overhang and cutting speed."),
        {stability::modeKey, "speed_rpm", "respond_z_mm", "excite_z_mm"});
    inputs.roles = speedRoles();
    return inputs;
}

}  // namespace

PanelFacts speedPanelFacts()
{
    PanelFacts facts = factsOf(stability::speedTask(), "speed", "speed", roles, {});
    facts.roles = speedRoles();
    // Values are asked for on the operator's screen.
    facts.missing = [](const project::PanelState& state) {
        const bool is_there =
            state.inputs.count(stability::frfRole) > 0 || state.inputs.count(stability::spindleRole) > 0;
        return is_there ? std::vector<Text>{} : std::vector<Text>{LT_TEXT("Engine", "Spindle")};
    };
    facts.has_work = {};
    facts.speaks_first = true;
    facts.answer = answeredBy(stability::answerSpeed);
    facts.make = [](Session& session) -> PanelBase* { return new SpeedPanel(session); };
    return facts;
}

SpeedPanel::SpeedPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, speedPanelFacts(), panelInputs(), parent), views_(new SpeedViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &SpeedViews::valueEntered, this, [this](const QString& key, double value) { take(key, value); });
    connect(views_, &SpeedViews::valueCleared, this, [this](const QString& key) { take(key, {}); });
    connect(views_->linkBar(), &LinkBar::asked, this, &SpeedPanel::takeRequest);
    connect(views_->linkBar(), &LinkBar::refused, this, [this](const Error& error) {
        emit messageRaised({error, facts().title});
    });
    connect(views_, &SpeedViews::notWritten, this, &SpeedPanel::reportWriteFailure);
}

void SpeedPanel::take(const QString& key, const Value& value)
{
    editState(tr("Type a value"),
              [&](project::PanelState& state) { stability::enterValue(state.parameters, key.toStdString(), value); });
}

/// What the control asked stands on the screen; requests that follow each other are one step to undo.
void SpeedPanel::takeRequest(const link::ControlValues& values)
{
    editState(
        tr("Request of the control"),
        [&](project::PanelState& state) {
            for (const FieldInfo& info : stability::screenFields()) {
                const auto found = values.find(info.key);
                if (found != values.end() && found->second != 0)
                    stability::enterValue(state.parameters, info.key, found->second);
            }
        },
        "request");
}

std::optional<Error> SpeedPanel::problem(const SpeedOutcome& outcome) const
{
    if (outcome.problem && !outcome.safe) return neededBy(stability::speedTask(), *outcome.problem);
    return std::nullopt;
}

QString SpeedPanel::understood(const InputRole&, const project::Source& source) const
{
    return chatter_common::understoodModel(source, session().stores());
}

void SpeedPanel::showResult(const std::shared_ptr<const SpeedOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void SpeedPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::speed_panel
