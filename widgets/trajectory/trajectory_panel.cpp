#include "widgets/trajectory/trajectory_panel.h"

#include "widgets/core/session.h"
#include "widgets/trajectory/trajectory_views.h"

namespace lathelier::trajectory_panel {
namespace {

using trajectory::MotionOutcome;

const std::vector<std::string> roles{trajectory::recordRole};

PanelInputs panelInputs()
{
    return trajectory_common::spindleInputs(
        trajectory::motionTask(), rolesOf(trajectory::motionTask(), roles),
        {"error_motion_limit_um", "workpiece_diameter_mm", "z_mm", "feed_mm_rev"},
        {"decision", "channels", "sensitivity_um_per_V", "marker_threshold_V", "channel_skew_s", "rotation", "points",
         "revolutions", "sections", "drift", "outlier_sigmas"},
        LT_TEXT("Engine", "Drop a probe record here: a table, or a pair .dat and .par of L-Graph."));
}

}  // namespace

PanelFacts trajectoryPanelFacts()
{
    PanelFacts facts =
        trajectory_common::spindleFacts(factsOf(trajectory::motionTask(), "trajectory", "trajectory", roles, {}));
    facts.answer = answeredBy(trajectory::answerMotion);
    facts.make = [](Session& session) -> PanelBase* { return new TrajectoryPanel(session); };
    return facts;
}

TrajectoryPanel::TrajectoryPanel(Session& owner, QWidget* parent)
    : SpindlePanel(owner, trajectoryPanelFacts(), panelInputs(), parent), views_(new TrajectoryViews(markedAngle()))
{
    setViews(views_, views_->primaryViews());
    connect(views_, &TrajectoryViews::sectionRequested, this, &TrajectoryPanel::chooseSection);
    connect(views_, &TrajectoryViews::notWritten, this, &TrajectoryPanel::reportWriteFailure);
    connect(views_, &TrajectoryViews::mapEdited, this,
            [this](const std::string& map) { setParameter("channels", map, tr("Change the channels")); });
    connect(views_, &TrajectoryViews::calibrationsEdited, this,
            [this](const std::vector<trajectory::ProbeCalibration>& probes) {
                trajectory::TrajectoryParameters parameters;
                parameters.probes = probes;
                setParameter("probes", *lathelier::find(toValues(parameters), "probes"), tr("Change a calibration"));
            });
}

void TrajectoryPanel::setParameter(const std::string& key, const Value& value, const QString& step)
{
    editState(step, [&](project::PanelState& state) { lathelier::set(state.parameters, key, value); });
}

void TrajectoryPanel::showResult(const std::shared_ptr<const MotionOutcome>& outcome)
{
    views_->setOutcome(outcome, isSectionChosen(), fromValues<trajectory::TrajectoryParameters>(state().parameters));
}

Values TrajectoryPanel::view() const
{
    return views_->view();
}

void TrajectoryPanel::restoreView(const Values& kept)
{
    views_->restoreView(kept);
}

void TrajectoryPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::trajectory_panel
