#include "widgets/longitudinal/longitudinal_panel.h"

#include "engine/form/roundness/roundness_dfq.h"
#include "engine/trajectory/section_file.h"
#include "engine/trajectory/trajectory_report.h"
#include "widgets/core/language.h"
#include "widgets/longitudinal/longitudinal_views.h"
#include "widgets/trajectory_common/spindle_inputs.h"

namespace lathelier::longitudinal_panel {
namespace {

PanelInputs panelInputs()
{
    return trajectory_common::spindleInputs(
        {&trajectory_common::recordRole()}, {"circle", "cutoff_upr", "tolerance_um", "workpiece_diameter_mm", "z_mm"},
        {"decision", "feed_mm_rev", "sections", "rotation"},
        LT_TEXT("Engine", "Drop the record of a whole workpiece here, or one record for each section."));
}

report::Document reportOf(const trajectory_common::SpindleOutcome& outcome, const Language& language,
                          std::vector<report::Picture> pictures)
{
    report::Document document = trajectoryReport(*outcome.trajectory, outcome.inputs, language);
    if (!pictures.empty() && !document.sections.empty())
        for (report::Picture& shown : pictures) document.sections.front().blocks.push_back(std::move(shown));
    document.synthetic = document.synthetic || outcome.synthetic;
    document.results = {trajectory_common::trajectoryJson(outcome)};
    return document;
}

}  // namespace

PanelFacts longitudinalPanelFacts()
{
    PanelFacts facts =
        trajectory_common::spindleFacts("longitudinal", LT_TEXT("Engine", "Longitudinal"), "longitudinal",
                                        trajectory_common::SpindleStudyKind::Longitudinal);
    facts.make = [](Session& session) -> PanelBase* { return new LongitudinalPanel(session); };
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        return reportOf(trajectory_common::outcomeOrThrow(state, trajectory_common::SpindleStudyKind::Longitudinal,
                                                          stores, progress),
                        language, {});
    };
    return facts;
}

LongitudinalPanel::LongitudinalPanel(Session& owner, QWidget* parent)
    : trajectory_common::SpindlePanel(owner, longitudinalPanelFacts(), panelInputs(),
                                      trajectory_common::SpindleStudyKind::Longitudinal, parent),
      views_(new LongitudinalViews(markedAngle()))
{
    setViews(views_, views_->primaryViews());
    connect(views_, &LongitudinalViews::sectionRequested, this, &LongitudinalPanel::chooseSection);
    connect(views_, &LongitudinalViews::notWritten, this, &LongitudinalPanel::reportWriteFailure);
}

void LongitudinalPanel::showResult(const std::shared_ptr<const trajectory_common::SpindleOutcome>& outcome)
{
    views_->setOutcome(outcome, isSectionChosen());
}

report::Answer LongitudinalPanel::answer(const trajectory_common::SpindleOutcome& outcome) const
{
    return trajectory::answer(*outcome.trajectory, screenLanguage());
}

report::Document LongitudinalPanel::document(const trajectory_common::SpindleOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage(), views_->pictures());
}

std::vector<PanelExport> LongitudinalPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {
        {tr("Table of all sections (CSV)…"), tr("Table (*.csv)"), "csv",
         [outcome](const QString& path) { writeSectionTable(path.toStdString(), *outcome->trajectory); }},
        {tr("For statistical process control (Q-DAS)…"), tr("Q-DAS (*.dfq)"), "dfq", [outcome](const QString& path) {
             std::vector<form::RoundnessResult> results;
             for (const trajectory::TrajectorySection& section : outcome->trajectory->sections)
                 results.push_back(section.roundness);
             io::writeDfq(path.toStdString(), qdasFile(results));
         }}};
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
