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

report::Document reportOf(const trajectory_common::SpindlePicture& picture, const Language& language,
                          std::vector<report::Picture> pictures)
{
    report::Document document = trajectoryReport(*picture.trajectory, picture.inputs, language);
    if (!pictures.empty() && !document.sections.empty())
        for (report::Picture& shown : pictures) document.sections.front().blocks.push_back(std::move(shown));
    document.synthetic = document.synthetic || picture.synthetic;
    document.results = {trajectory_common::trajectoryJson(picture)};
    return document;
}

}  // namespace

PanelFacts longitudinalPanelFacts()
{
    PanelFacts facts = trajectory_common::spindleFacts("longitudinal", LT_TEXT("Engine", "Longitudinal"),
                                                       "longitudinal", trajectory_common::SpindleWant::Longitudinal);
    facts.make = [](Session& session) -> PanelBase* { return new LongitudinalPanel(session); };
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        return reportOf(
            trajectory_common::answeredPicture(state, trajectory_common::SpindleWant::Longitudinal, stores, progress),
            language, {});
    };
    return facts;
}

LongitudinalPanel::LongitudinalPanel(Session& owner, QWidget* parent)
    : trajectory_common::SpindlePanel(owner, longitudinalPanelFacts(), panelInputs(),
                                      trajectory_common::SpindleWant::Longitudinal, parent),
      views_(new LongitudinalViews(markedAngle()))
{
    setViews(views_, views_->heroes());
    connect(views_, &LongitudinalViews::sectionWanted, this, &LongitudinalPanel::chooseSection);
    connect(views_, &LongitudinalViews::notWritten, this, &LongitudinalPanel::sayNotWritten);
}

void LongitudinalPanel::showResult(const std::shared_ptr<const trajectory_common::SpindlePicture>& picture)
{
    views_->setPicture(picture, isSectionChosen());
}

report::Answer LongitudinalPanel::answer(const trajectory_common::SpindlePicture& picture) const
{
    return trajectory::answer(*picture.trajectory, screenLanguage());
}

report::Document LongitudinalPanel::document(const trajectory_common::SpindlePicture& picture) const
{
    return reportOf(picture, screenLanguage(), views_->pictures());
}

std::vector<PanelExport> LongitudinalPanel::exports() const
{
    const auto picture = result();
    if (!picture) return {};
    return {
        {tr("Table of all sections (CSV)…"), tr("Table (*.csv)"), "csv",
         [picture](const QString& path) { writeSectionTable(path.toStdString(), *picture->trajectory); }},
        {tr("For statistical process control (Q-DAS)…"), tr("Q-DAS (*.dfq)"), "dfq", [picture](const QString& path) {
             std::vector<form::RoundnessResult> results;
             for (const trajectory::TrajectorySection& section : picture->trajectory->sections)
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
