#include "widgets/deflection/deflection_panel.h"

#include "widgets/deflection/deflection_views.h"

namespace lathelier::deflection_panel {
namespace {

using deflection::DeflectionOutcome;

const std::vector<std::string> roles{gcode::programRole, deflection::setupRole, deflection::stockRole,
                                     deflection::spindleRole};

/// What the window shows beside the prediction; the command line computes it where it is asked.
const Values begins_with{{"band", true}, {"sensitivities", true}, {"feed", true}, {"map", true}};

DeflectionOutcome predict(const project::PanelState& state, Stores& stores, task::Sources& sources,
                          const Progress& progress)
{
    return deflection::answerDeflection(state, deflection::StudyKind::Prediction, stores, sources, progress);
}

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(
        deflection::deflectionTask(), roles,
        {"tolerance_um", "changed_tailstock_N_mm", "changed_chuck_N_mm", "changed_chuck_N_mm_rad",
         "changed_forces_percent", "changed_insert", "changed_machine", "changed_material", "measured",
         "cutting_speed_m_min", "band", "sensitivities", "feed", "map"},
        true,
        LT_TEXT("Engine", "Drop an NC program and a set-up (SETUP.json) here: the error along the work follows."));
    foldAllBut(inputs, {"tolerance_um", "changed_machine", "changed_material", "changed_insert",
                        "changed_tailstock_N_mm", "cutting_speed_m_min"});
    for (const auto& [key, value] : begins_with) set(inputs.defaults, key, value);
    return inputs;
}

}  // namespace

PanelFacts deflectionPanelFacts()
{
    PanelFacts facts = deflection_common::turningFacts(
        factsOf(deflection::deflectionTask(), "deflection", "deflection", roles, {}, begins_with));
    facts.answer = answeredBy(predict);
    facts.make = [](Session& session) -> PanelBase* { return new DeflectionPanel(session); };
    return facts;
}

DeflectionPanel::DeflectionPanel(Session& owner, QWidget* parent)
    : TurningPanel(owner, deflectionPanelFacts(), panelInputs(), parent), views_(new DeflectionViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &DeflectionViews::notWritten, this, &DeflectionPanel::reportWriteFailure);
}

void DeflectionPanel::showResult(const std::shared_ptr<const DeflectionOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void DeflectionPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::deflection_panel
