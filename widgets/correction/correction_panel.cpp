#include "widgets/correction/correction_panel.h"

#include "engine/deflection/deflection_plots.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/file.h"
#include "engine/report/chart_csv.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/correction/correction_views.h"
#include "widgets/deflection_common/deflection_inputs.h"

namespace lathelier::correction_panel {
namespace {

using deflection_common::DeflectionQuestion;
using deflection_common::Wanted;

PanelInputs panelInputs()
{
    return deflection_common::deflectionInputs(
        {"corrected_runs", "residual_tolerance_um", "largest_correction_um", deflection_common::keptLinesKey},
        LT_TEXT("Engine", "Drop an NC program and a set-up (SETUP.json) here: the corrected program follows."));
}

}  // namespace

PanelFacts correctionPanelFacts()
{
    PanelFacts facts = deflection_common::deflectionFacts("correction", LT_TEXT("Engine", "Correction"), "correction",
                                                          Wanted::Correction);
    facts.make = [](Session& session) -> PanelBase* { return new CorrectionPanel(session); };
    return facts;
}

CorrectionPanel::CorrectionPanel(Session& owner, QWidget* parent)
    : TurningPanel(owner, correctionPanelFacts(), panelInputs(), Wanted::Correction, parent),
      views_(new CorrectionViews)
{
    setViews(views_, views_->heroes());
    connect(views_, &CorrectionViews::taken, this, &CorrectionPanel::take);
    connect(views_, &CorrectionViews::notWritten, this, &CorrectionPanel::sayNotWritten);
}

void CorrectionPanel::showResult(const std::shared_ptr<const deflection_common::DeflectionPicture>& picture)
{
    views_->setPicture(picture);
}

report::Answer CorrectionPanel::answer(const deflection_common::DeflectionPicture& picture) const
{
    return deflection::answer(picture.study->corrected->compensation, screenLanguage());
}

std::vector<PanelExport> CorrectionPanel::exports() const
{
    const auto picture = result();
    if (!picture) return {};
    return {{tr("Corrected program…"), tr("NC program (*.nc *.ngc *.mpf *.tap)"), "nc",
             [picture](const QString& path) { io::writeFile(path.toStdString(), picture->study->corrected->text); }},
            {tr("Correction along the work (CSV)…"), tr("Table (*.csv)"), "csv", [picture](const QString& path) {
                 io::writeFile(path.toStdString(),
                               report::toCsv(deflection::correctionPlot(picture->study->corrected->compensation)));
             }}};
}

/// Intervals of single lines; what the user typed is kept.
void CorrectionPanel::take(qlonglong line, bool wanted)
{
    editState(wanted ? tr("Correct line %1").arg(line) : tr("Keep line %1").arg(line), [&](project::PanelState& state) {
        auto question = fromValues<DeflectionQuestion>(state.parameters);
        std::vector<Interval> kept;
        const auto number = static_cast<double>(line);
        for (const Interval& lines : question.compensation.kept_lines) {
            if (number < lines.from || number > lines.to) {
                kept.push_back(lines);
                continue;
            }
            if (lines.from < number) kept.push_back({lines.from, number - 1});
            if (number < lines.to) kept.push_back({number + 1, lines.to});
        }
        if (!wanted) kept.push_back({number, number});
        lathelier::set(state.parameters, deflection_common::keptLinesKey, Value(kept));
    });
}

void CorrectionPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::correction_panel
