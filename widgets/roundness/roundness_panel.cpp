#include "widgets/roundness/roundness_panel.h"

#include "engine/form/roundness/roundness_dfq.h"
#include "engine/form/roundness/roundness_report.h"
#include "engine/form/roundness/superimpose_report.h"
#include "engine/io/file.h"
#include "widgets/core/language.h"
#include "widgets/roundness/roundness_charts.h"
#include "widgets/roundness/roundness_views.h"
#include "widgets/trajectory_common/spindle_inputs.h"

namespace lathelier::roundness_panel {
namespace {

PanelInputs panelInputs()
{
    return trajectory_common::spindleInputs(
        {&trajectory_common::recordRole(), &trajectory_common::profileRole(), &trajectory_common::traceRole()},
        {"circle", "cutoff_upr", "tolerance_um", "workpiece_diameter_mm"},
        {"band_upr", "exclude_deg", "outliers", "decision", "probe_uncertainty_um"},
        LT_TEXT("Engine", "Drop a measured profile or a probe record here."));
}

report::Document reportOf(const trajectory_common::SpindleOutcome& outcome, const Language& language)
{
    report::Document document = form::roundnessReport({*outcome.roundness()}, outcome.inputs, language);
    trajectory_common::addSectionSentence(outcome, document);
    if (outcome.superimposed) document.sections.push_back(superimposeSection(*outcome.superimposed));
    document.synthetic = document.synthetic || outcome.synthetic;
    document.results = {trajectory_common::roundnessJson(outcome)};
    return document;
}

}  // namespace

PanelFacts roundnessPanelFacts()
{
    PanelFacts facts = trajectory_common::spindleFacts("roundness", LT_TEXT("Engine", "Roundness"), "roundness",
                                                       trajectory_common::SpindleStudyKind::Roundness);
    facts.make = [](Session& session) -> PanelBase* { return new RoundnessPanel(session); };
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        return reportOf(
            trajectory_common::outcomeOrThrow(state, trajectory_common::SpindleStudyKind::Roundness, stores, progress),
            language);
    };
    return facts;
}

RoundnessPanel::RoundnessPanel(Session& owner, QWidget* parent)
    : trajectory_common::SpindlePanel(owner, roundnessPanelFacts(), panelInputs(),
                                      trajectory_common::SpindleStudyKind::Roundness, parent),
      views_(new RoundnessViews(markedAngle()))
{
    setViews(views_, views_->primaryViews());
    connect(views_, &RoundnessViews::sectionRequested, this, &RoundnessPanel::chooseSection);
    connect(views_, &RoundnessViews::notWritten, this, &RoundnessPanel::reportWriteFailure);
}

void RoundnessPanel::showResult(const std::shared_ptr<const trajectory_common::SpindleOutcome>& outcome)
{
    views_->setOutcome(outcome, isSectionChosen());
}

void RoundnessPanel::showPlace(const report::Place& place)
{
    if (place.upr) views_->markHarmonic(place.upr);
}

report::Answer RoundnessPanel::answer(const trajectory_common::SpindleOutcome& outcome) const
{
    report::Answer answer = form::answer(*outcome.roundness(), screenLanguage());
    if (const trajectory::TrajectorySection* section = outcome.profile ? nullptr : outcome.chosenSection()) {
        answer.used = outcome.trajectory->used;
        answer.subject = tr("section %1 of %2")
                             .arg(section->section)
                             .arg(outcome.trajectory->sections.size())
                             .replace(' ', QChar::Nbsp)  // no break within the term
                             .toStdString();
    }
    return answer;
}

report::Document RoundnessPanel::document(const trajectory_common::SpindleOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> RoundnessPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {
        {tr("Profile and circles as drawn (CSV)…"), tr("Table (*.csv)"), "csv",
         [outcome](const QString& path) {
             io::writeFile(path.toStdString(), plot::toCsv(outcome->polar->plot).toStdString());
         }},
        {tr("For statistical process control (Q-DAS)…"), tr("Q-DAS (*.dfq)"), "dfq", [outcome](const QString& path) {
             io::writeDfq(path.toStdString(), form::qdasFile({*outcome->roundness()}));
         }}};
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
