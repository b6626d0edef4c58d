#include "widgets/longitudinal/longitudinal_panel.h"

#include "widgets/core/session.h"
#include "widgets/longitudinal/longitudinal_views.h"

namespace lathelier::longitudinal_panel {
namespace {

using trajectory::TrajectoryOutcome;

const std::vector<std::string> roles{trajectory::recordRole};

PanelInputs panelInputs()
{
    return trajectory_common::spindleInputs(
        trajectory::trajectoryTask(), rolesOf(trajectory::trajectoryTask(), roles),
        {"circle", "cutoff_upr", "tolerance_um", "workpiece_diameter_mm", "z_mm"},
        {"decision", "feed_mm_rev", "sections", "rotation"},
        LT_TEXT("Engine", "Drop the record of a whole workpiece here, or one record for each section."));
}

}  // namespace

PanelFacts longitudinalPanelFacts()
{
    PanelFacts facts = trajectory_common::spindleFacts(
        factsOf(trajectory::trajectoryTask(), "longitudinal", "longitudinal", roles, {}));
    facts.answer = answeredBy(trajectory::answerTrajectory);
    facts.make = [](Session& session) -> PanelBase* { return new LongitudinalPanel(session); };
    return facts;
}

LongitudinalPanel::LongitudinalPanel(Session& owner, QWidget* parent)
    : SpindlePanel(owner, longitudinalPanelFacts(), panelInputs(), parent), views_(new LongitudinalViews(markedAngle()))
{
    setViews(views_, views_->primaryViews());
    connect(views_, &LongitudinalViews::sectionRequested, this, &LongitudinalPanel::chooseSection);
    connect(views_, &LongitudinalViews::notWritten, this, &LongitudinalPanel::reportWriteFailure);
}

void LongitudinalPanel::showResult(const std::shared_ptr<const TrajectoryOutcome>& outcome)
{
    views_->setOutcome(outcome, isSectionChosen());
}

report::Document LongitudinalPanel::document(const TrajectoryOutcome& outcome) const
{
    report::Document document = SpindlePanel::document(outcome);
    if (document.sections.empty()) return document;
    for (report::Picture& shown : views_->pictures()) document.sections.front().blocks.push_back(std::move(shown));
    return document;
}

Values LongitudinalPanel::view() const
{
    return views_->view();
}

void LongitudinalPanel::restoreView(const Values& kept)
{
    views_->restoreView(kept);
}

void LongitudinalPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::longitudinal_panel
