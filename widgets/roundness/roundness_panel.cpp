#include "widgets/roundness/roundness_panel.h"

#include "engine/form/roundness_dfq.h"
#include "engine/form/roundness_report.h"
#include "engine/io/file.h"
#include "widgets/core/language.h"
#include "widgets/roundness/roundness_charts.h"
#include "widgets/roundness/roundness_views.h"
#include "widgets/trajectory_common/spindle_inputs.h"

namespace lathelier {
namespace {

PanelInputs panelInputs()
{
    return spindleInputs({&recordRole(), &profileRole(), &traceRole()},
                         {"circle", "cutoff_upr", "tolerance_um", "workpiece_diameter_mm"},
                         {"band_upr", "exclude_deg", "outliers", "decision", "probe_uncertainty_um"},
                         LT_TEXT("Engine", "Drop a measured profile or a probe record here."));
}

Document reportOf(const SpindlePicture& picture, const Language& language)
{
    Document document = form::roundnessReport({*picture.roundness()}, picture.inputs, language);
    saySection(picture, document);
    if (picture.superimposed) document.sections.push_back(superimposeSection(*picture.superimposed, language));
    document.synthetic = document.synthetic || picture.synthetic;
    document.results = {roundnessJson(picture)};
    return document;
}

}  // namespace

PanelFacts roundnessPanelFacts()
{
    PanelFacts facts = spindleFacts("roundness", LT_TEXT("Engine", "Roundness"), "roundness", SpindleWant::Roundness);
    facts.make = [](Session& session) -> PanelBase* { return new RoundnessPanel(session); };
    facts.report = [](const PanelState& state, Stores& stores, const Language& language, const Progress& progress) {
        return reportOf(answeredPicture(state, SpindleWant::Roundness, stores, progress), language);
    };
    return facts;
}

RoundnessPanel::RoundnessPanel(Session& owner, QWidget* parent)
    : SpindlePanel(owner, roundnessPanelFacts(), panelInputs(), SpindleWant::Roundness, parent),
      views_(new RoundnessViews(markedAngle()))
{
    setViews(views_);
    connect(views_, &RoundnessViews::sectionWanted, this, &RoundnessPanel::chooseSection);
    connect(views_, &RoundnessViews::notWritten, this, &RoundnessPanel::sayNotWritten);
}

void RoundnessPanel::showResult(const std::shared_ptr<const SpindlePicture>& picture)
{
    views_->setPicture(picture, isSectionChosen());
}

Headline RoundnessPanel::headline(const SpindlePicture& picture) const
{
    Headline headline = form::headline(*picture.roundness(), screenLanguage());
    if (const trajectory::TrajectorySection* section = picture.profile ? nullptr : picture.chosenSection())
        headline.text += " · " + tr("section %1 of %2")
                                     .arg(section->section)
                                     .arg(picture.trajectory->sections.size())
                                     .replace(' ', QChar::Nbsp)  // one thing, on one line
                                     .toStdString();
    return headline;
}

Document RoundnessPanel::document(const SpindlePicture& picture) const
{
    return reportOf(picture, screenLanguage());
}

std::vector<PanelExport> RoundnessPanel::exports() const
{
    const auto picture = result();
    if (!picture) return {};
    return {
        {tr("Profile and circles as drawn (CSV)…"), tr("Table (*.csv)"), "csv",
         [picture](const QString& path) { writeFile(path.toStdString(), toCsv(picture->polar->plot).toStdString()); }},
        {tr("For statistical process control (Q-DAS)…"), tr("Q-DAS (*.dfq)"), "dfq",
         [picture](const QString& path) { writeDfq(path.toStdString(), form::qdasFile({*picture->roundness()})); }}};
}

void RoundnessPanel::retranslate()
{
    views_->retranslate();
    if (hasResult()) recompute();  // the polar plots carry words; the answers are there
}

}  // namespace lathelier
