#include "widgets/lobes/lobes_panel.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frf_item.h"
#include "widgets/chatter_common/understood_models.h"
#include "widgets/core/session.h"
#include "widgets/lobes/lobes_views.h"

namespace lathelier::lobes_panel {
namespace {

const std::vector<std::string> roles{stability::frfRole, stability::marksRole};

/// Of a shaft and of a pass: those have panels of their own.
std::vector<std::string> fieldsOfOthers()
{
    std::vector<std::string> keys;
    for (const FieldInfo& info : infos<stability::PassParameters>()) keys.push_back(info.key);
    for (const FieldInfo& info : infos<receptance::ReceptanceParameters>()) keys.push_back(info.key);
    for (const FieldInfo& info : infos<receptance::ShaftSupports>()) keys.push_back(info.key);
    return keys;
}

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(
        stability::lobesTask(), roles,
        {stability::modeKey, "cutting_coefficient_N_mm2", "speed_rpm", stability::operatingSpeedKey,
         stability::operatingDepthKey, "diameter_mm", "range_m_min"},
        true, LT_TEXT("Engine", "Drop a frequency response here, or state the modes of the point that is cut."),
        fieldsOfOthers());
    inputs.roles.front().takes_next = true;
    inputs.tables = {{stability::modeKey, stability::frfRole}};
    return inputs;
}

}  // namespace

PanelFacts lobesPanelFacts()
{
    PanelFacts facts = factsOf(stability::lobesTask(), "lobes", "chatter", roles, {});
    facts.answer = answeredBy(stability::answerLobes);
    facts.make = [](Session& session) -> PanelBase* { return new LobesPanel(session); };
    return facts;
}

LobesPanel::LobesPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, lobesPanelFacts(), panelInputs(), parent), views_(new LobesViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &LobesViews::operatingPointMoved, this, &LobesPanel::moveOperatingPoint);
    connect(views_, &LobesViews::speedRequested, this,
            [this](double speed_rpm) { moveOperatingPoint(speed_rpm, {}, true); });
    connect(views_, &LobesViews::notWritten, this, &LobesPanel::reportWriteFailure);
}

void LobesPanel::moveOperatingPoint(double speed_rpm, std::optional<double> depth, bool dropped)
{
    constexpr double least = 1e-4;  // least depth of cut and rounding step
    editState(
        tr("Move the operating point"),
        [&](project::PanelState& state) {
            lathelier::set(state.parameters, stability::operatingSpeedKey, std::round(speed_rpm));
            if (depth)
                lathelier::set(state.parameters, stability::operatingDepthKey,
                               std::max(least, std::round(*depth / least) * least));
        },
        QString("lobes/operating_point/%1").arg(gesture_));
    gesture_ += dropped;
}

QString LobesPanel::understood(const InputRole&, const project::Source& source) const
{
    return chatter_common::understoodModel(source, session().stores());
}

void LobesPanel::showResult(const std::shared_ptr<const stability::LobesOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void LobesPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::lobes_panel
