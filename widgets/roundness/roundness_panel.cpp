#include "widgets/roundness/roundness_panel.h"

#include "engine/io/file.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/roundness/roundness_views.h"

namespace lathelier::roundness_panel {
namespace {

const std::vector<std::string> roles{trajectory::recordRole, trajectory::profileRole, trajectory::traceRole};

/// The panel judges one profile.
std::vector<InputRole> roundnessRoles()
{
    std::vector<InputRole> all = rolesOf(trajectory::roundnessTask(), roles);
    all[0].hint = LT_TEXT("Engine", "One record of all sections, or one for each: CSV or L-Graph");
    all[1].hint = LT_TEXT("Engine", "x and y, or angle and radius, of one section; goes before the record");
    all[1].several = false;
    return all;
}

PanelInputs panelInputs()
{
    return trajectory_common::spindleInputs(trajectory::roundnessTask(), roundnessRoles(),
                                            {"circle", "cutoff_upr", "tolerance_um", "workpiece_diameter_mm"},
                                            {"band_upr", "exclude_deg", "outliers", "decision", "probe_uncertainty_um"},
                                            LT_TEXT("Engine", "Drop a measured profile or a probe record here."));
}

}  // namespace

PanelFacts roundnessPanelFacts()
{
    PanelFacts facts =
        trajectory_common::spindleFacts(factsOf(trajectory::roundnessTask(), "roundness", "roundness", roles, {}));
    facts.roles = roundnessRoles();
    facts.answer = answeredBy(showRoundness);
    facts.make = [](Session& session) -> PanelBase* { return new RoundnessPanel(session); };
    return facts;
}

RoundnessPanel::RoundnessPanel(Session& owner, QWidget* parent)
    : SpindlePanel(owner, roundnessPanelFacts(), panelInputs(), parent), views_(new RoundnessViews(markedAngle()))
{
    setViews(views_, views_->primaryViews());
    connect(views_, &RoundnessViews::sectionRequested, this, &RoundnessPanel::chooseSection);
    connect(views_, &RoundnessViews::notWritten, this, &RoundnessPanel::reportWriteFailure);
}

void RoundnessPanel::showResult(const std::shared_ptr<const RoundnessShown>& outcome)
{
    views_->setOutcome(outcome, isSectionChosen());
}

void RoundnessPanel::showPlace(const report::Place& place)
{
    if (place.upr) views_->markHarmonic(place.upr);
}

report::Answer RoundnessPanel::answer(const RoundnessShown& outcome) const
{
    report::Answer answer = SpindlePanel::answer(outcome);
    if (const trajectory::TrajectorySection* const section = outcome.chosenSection())
        answer.subject = tr("section %1 of %2")
                             .arg(section->section)
                             .arg(outcome.trajectory->sections.size())
                             .replace(' ', QChar::Nbsp)  // no break within the term
                             .toStdString();
    return answer;
}

std::vector<PanelExport> RoundnessPanel::exports() const
{
    std::vector<PanelExport> all = SpindlePanel::exports();
    if (const auto outcome = result())
        all.insert(all.begin(), {tr("Profile and circles as drawn (CSV)…"), tr("Table (*.csv)"), "csv",
                                 [outcome](const QString& path) {
                                     io::writeFile(path.toStdString(), plot::toCsv(outcome->polar->plot).toStdString());
                                 }});
    return all;
}

Values RoundnessPanel::view() const
{
    return views_->view();
}

void RoundnessPanel::restoreView(const Values& kept)
{
    views_->restoreView(kept);
}

void RoundnessPanel::retranslate()
{
    views_->retranslate();
    if (hasResult()) recompute();  // the polar plots contain texts; results are cached
}

}  // namespace lathelier::roundness_panel
