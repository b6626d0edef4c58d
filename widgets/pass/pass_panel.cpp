#include "widgets/pass/pass_panel.h"

#include <algorithm>
#include <cmath>

#include "widgets/chatter_common/understood_models.h"
#include "widgets/core/session.h"
#include "widgets/pass/pass_views.h"

namespace lathelier::pass_panel {
namespace {

using stability::LobesOutcome;

const std::vector<std::string> roles{stability::shaftRole, stability::spindleRole};

/// A screen shows no more speeds, and a pass has many stations.
const Values begins_with{{"speed_rpm", std::vector<Interval>{{1000, 6000}}}, {"points", std::int64_t{800}}};

/// What a pass cannot be without.
const std::vector<std::string> needed{"pass_z_mm", stability::passDepthKey, "cutting_coefficient_N_mm2"};

LobesOutcome overPass(const project::PanelState& state, Stores& stores, task::Sources& sources,
                      const Progress& progress)
{
    return stability::answerLobes(filledWith(state, begins_with), stores, sources, progress);
}

std::vector<InputRole> passRoles()
{
    std::vector<InputRole> all = rolesOf(stability::lobesTask(), roles);
    for (InputRole& role : all) role.required = true;
    return all;
}

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(
        stability::lobesTask(), roles,
        {"pass_z_mm", stability::passDepthKey, "cutting_coefficient_N_mm2", "speed_rpm", stability::operatingSpeedKey},
        true, LT_TEXT("Engine", "Drop a shaft and a spindle here, then state the pass, its depth and the coefficient."),
        {stability::modeKey, stability::operatingDepthKey, "respond_z_mm", "excite_z_mm", "rule", "range_hz", "use",
         "uncertainty_frequency_percent", "uncertainty_damping_percent", "uncertainty_compliance_percent",
         "uncertainty_coefficient_percent"});
    inputs.roles = passRoles();
    for (const auto& [key, value] : begins_with) set(inputs.defaults, key, value);
    return inputs;
}

std::vector<Text> missingOfPass(const project::PanelState& state)
{
    std::vector<Text> labels = missingOf(passRoles())(state);
    for (const std::string& key : needed) {
        const Value* const value = find(state.parameters, key);
        const auto* const intervals = value ? std::get_if<std::vector<Interval>>(value) : nullptr;
        if (value && !std::holds_alternative<std::monostate>(*value) && !(intervals && intervals->empty())) continue;
        for (const FieldInfo& info : stability::lobesTask().fields)
            if (info.key == key) labels.push_back(info.label);
    }
    return labels;
}

}  // namespace

PanelFacts passPanelFacts()
{
    PanelFacts facts = factsOf(stability::lobesTask(), "pass", "pass", roles, {}, begins_with);
    facts.title = LT_TEXT("Engine", "Pass");
    facts.roles = passRoles();
    facts.missing = missingOfPass;
    facts.has_work = {};
    facts.answer = answeredBy(overPass);
    facts.make = [](Session& session) -> PanelBase* { return new PassPanel(session); };
    return facts;
}

PassPanel::PassPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, passPanelFacts(), panelInputs(), parent), views_(new PassViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &PassViews::pointMoved, this, &PassPanel::movePoint);
    connect(views_, &PassViews::notWritten, this, &PassPanel::reportWriteFailure);
}

void PassPanel::movePoint(double speed_rpm, double depth_mm, bool dropped)
{
    constexpr double least = 1e-3;  // least depth of cut and rounding step, mm
    editState(
        tr("Move the operating point"),
        [&](project::PanelState& state) {
            lathelier::set(state.parameters, stability::operatingSpeedKey, std::round(speed_rpm));
            lathelier::set(state.parameters, stability::passDepthKey,
                           std::max(least, std::round(depth_mm / least) * least));
        },
        QString("pass/point/%1").arg(gesture_));
    gesture_ += dropped;
}

QString PassPanel::understood(const InputRole&, const project::Source& source) const
{
    return chatter_common::understoodModel(source, session().stores());
}

void PassPanel::showResult(const std::shared_ptr<const LobesOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void PassPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::pass_panel
