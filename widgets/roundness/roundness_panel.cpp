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

report::Document reportOf(const trajectory_common::SpindlePicture& picture, const Language& language)
{
    report::Document document = form::roundnessReport({*picture.roundness()}, picture.inputs, language);
    trajectory_common::saySection(picture, document);
    if (picture.superimposed) document.sections.push_back(superimposeSection(*picture.superimposed));
    document.synthetic = document.synthetic || picture.synthetic;
    document.results = {trajectory_common::roundnessJson(picture)};
    return document;
}

}  // namespace

PanelFacts roundnessPanelFacts()
{
    PanelFacts facts = trajectory_common::spindleFacts("roundness", LT_TEXT("Engine", "Roundness"), "roundness",
                                                       trajectory_common::SpindleWant::Roundness);
    facts.make = [](Session& session) -> PanelBase* { return new RoundnessPanel(session); };
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        return reportOf(
            trajectory_common::answeredPicture(state, trajectory_common::SpindleWant::Roundness, stores, progress),
            language);
    };
    return facts;
}

RoundnessPanel::RoundnessPanel(Session& owner, QWidget* parent)
    : trajectory_common::SpindlePanel(owner, roundnessPanelFacts(), panelInputs(),
                                      trajectory_common::SpindleWant::Roundness, parent),
      views_(new RoundnessViews(markedAngle()))
{
    setViews(views_, views_->heroes());
    connect(views_, &RoundnessViews::sectionWanted, this, &RoundnessPanel::chooseSection);
    connect(views_, &RoundnessViews::notWritten, this, &RoundnessPanel::sayNotWritten);
}

void RoundnessPanel::showResult(const std::shared_ptr<const trajectory_common::SpindlePicture>& picture)
{
    views_->setPicture(picture, isSectionChosen());
}

void RoundnessPanel::showPlace(const report::Place& place)
{
    if (place.upr) views_->markHarmonic(place.upr);
}

report::Answer RoundnessPanel::answer(const trajectory_common::SpindlePicture& picture) const
{
    report::Answer answer = form::answer(*picture.roundness(), screenLanguage());
    if (const trajectory::TrajectorySection* section = picture.profile ? nullptr : picture.chosenSection()) {
        answer.used = picture.trajectory->used;
        answer.subject = tr("section %1 of %2")
                             .arg(section->section)
                             .arg(picture.trajectory->sections.size())
                             .replace(' ', QChar::Nbsp)  // one thing, on one line
                             .toStdString();
    }
    return answer;
}

report::Document RoundnessPanel::document(const trajectory_common::SpindlePicture& picture) const
{
    return reportOf(picture, screenLanguage());
}

std::vector<PanelExport> RoundnessPanel::exports() const
{
    const auto picture = result();
    if (!picture) return {};
    return {
        {tr("Profile and circles as drawn (CSV)…"), tr("Table (*.csv)"), "csv",
         [picture](const QString& path) {
             io::writeFile(path.toStdString(), plot::toCsv(picture->polar->plot).toStdString());
         }},
        {tr("For statistical process control (Q-DAS)…"), tr("Q-DAS (*.dfq)"), "dfq", [picture](const QString& path) {
             io::writeDfq(path.toStdString(), form::qdasFile({*picture->roundness()}));
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
    if (hasResult()) recompute();  // the polar plots carry words; the answers are there
}

}  // namespace lathelier::roundness_panel
