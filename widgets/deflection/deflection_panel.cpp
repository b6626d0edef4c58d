#include "widgets/deflection/deflection_panel.h"

#include "engine/deflection/deflection_plots.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/file.h"
#include "engine/report/chart_csv.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/deflection/deflection_views.h"
#include "widgets/deflection_common/deflection_inputs.h"

namespace lathelier::deflection_panel {
namespace {

using deflection_common::DeflectionQuestion;
using deflection_common::StudyKind;

PanelInputs panelInputs()
{
    return deflection_common::deflectionInputs(
        {"tolerance_um", "changed_tailstock_N_mm", "changed_chuck_N_mm", "changed_chuck_N_mm_rad",
         "changed_forces_percent", "changed_insert", "changed_machine", "changed_material", "measured",
         "cutting_speed_m_min", "band", "sensitivities", "feed", "map"},
        LT_TEXT("Engine", "Drop an NC program and a set-up (SETUP.json) here: the error along the work follows."));
}

}  // namespace

PanelFacts deflectionPanelFacts()
{
    PanelFacts facts = deflection_common::deflectionFacts("deflection", LT_TEXT("Engine", "Deflection"), "deflection",
                                                          StudyKind::Prediction);
    facts.make = [](Session& session) -> PanelBase* { return new DeflectionPanel(session); };
    return facts;
}

DeflectionPanel::DeflectionPanel(Session& owner, QWidget* parent)
    : TurningPanel(owner, deflectionPanelFacts(), panelInputs(), StudyKind::Prediction, parent),
      views_(new DeflectionViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &DeflectionViews::notWritten, this, &DeflectionPanel::reportWriteFailure);
}

void DeflectionPanel::showResult(const std::shared_ptr<const deflection_common::DeflectionOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer DeflectionPanel::answer(const deflection_common::DeflectionOutcome& outcome) const
{
    return deflection::answer(*outcome.study, screenLanguage());
}

std::vector<PanelExport> DeflectionPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {{tr("Error along the work (CSV)…"), tr("Table (*.csv)"), "csv",
             [outcome](const QString& path) {
                 io::writeFile(path.toStdString(), report::toCsv(deflection::errorPlot(outcome->study->prediction)));
             }},
            {tr("Set-up as changed here (JSON)…"), tr("Set-up (*.json)"), "json", [outcome](const QString& path) {
                 io::writeFile(path.toStdString(), deflection::setupText(outcome->job->setup));
             }}};
}

void DeflectionPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::deflection_panel
