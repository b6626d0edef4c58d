#include "widgets/correction/correction_panel.h"

#include <filesystem>

#include "engine/cam/check/correction_file.h"
#include "engine/core/item_numbers.h"
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
using deflection_common::StudyKind;

PanelInputs panelInputs()
{
    return deflection_common::deflectionInputs(
        {"corrected_runs", "residual_tolerance_um", "largest_correction_um", deflection_common::keptLinesKey},
        LT_TEXT("Engine", "Drop an NC program and a set-up (SETUP.json) here: the corrected program follows."));
}

/// The corrected text with its intended offset from the programmed contour; z from the free end of its clamping.
gcode::ProgramItem correctedProgram(const deflection_common::DeflectionOutcome& outcome)
{
    const deflection::CorrectedProgram& corrected = *outcome.study->corrected;
    gcode::ProgramItem item;
    item.text = deflection_common::toUtf8(corrected.text);
    if (outcome.program) item.clamping = outcome.program->clamping;
    item.corrected_from = outcome.program_sha256;
    item.z_zero_mm = outcome.job->setup.z_zero_mm;
    std::vector<cam::CorrectedCorner> corners;
    for (const deflection::CorrectedRun& run : corrected.compensation.runs)
        for (const deflection::CorrectedNode& node : run.nodes)
            corners.push_back({node.z_mm - item.z_zero_mm, node.x_mm - node.programmed_mm});
    const cam::StatedCorrection all = cam::correctionOf(corners);
    requireKeepable(all.z_mm.size());
    item.correction_z_mm = all.z_mm;
    item.correction_radius_mm = all.radius_mm;
    return item;
}

}  // namespace

PanelFacts correctionPanelFacts()
{
    PanelFacts facts = deflection_common::deflectionFacts("correction", LT_TEXT("Engine", "Correction"), "correction",
                                                          StudyKind::Correction);
    facts.make = [](Session& session) -> PanelBase* { return new CorrectionPanel(session); };
    return facts;
}

CorrectionPanel::CorrectionPanel(Session& owner, QWidget* parent)
    : TurningPanel(owner, correctionPanelFacts(), panelInputs(), StudyKind::Correction, parent),
      views_(new CorrectionViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &CorrectionViews::taken, this, &CorrectionPanel::take);
    connect(views_, &CorrectionViews::checkRequested, this, &CorrectionPanel::offerCorrected);
    connect(views_, &CorrectionViews::notWritten, this, &CorrectionPanel::reportWriteFailure);
}

void CorrectionPanel::showResult(const std::shared_ptr<const deflection_common::DeflectionOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer CorrectionPanel::answer(const deflection_common::DeflectionOutcome& outcome) const
{
    return deflection::answer(outcome.study->corrected->compensation, screenLanguage());
}

std::vector<PanelExport> CorrectionPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {{tr("Corrected program…"), tr("NC program (*.nc *.ngc *.mpf *.tap)"), "nc",
             [outcome](const QString& path) { io::writeFile(path.toStdString(), outcome->study->corrected->text); }},
            {tr("Correction along the work (CSV)…"), tr("Table (*.csv)"), "csv", [outcome](const QString& path) {
                 io::writeFile(path.toStdString(),
                               report::toCsv(deflection::correctionPlot(outcome->study->corrected->compensation)));
             }}};
}

/// Intervals of single lines, in addition to those typed by the user.
void CorrectionPanel::take(qlonglong line, bool isTaken)
{
    editState(isTaken ? tr("Correct line %1").arg(line) : tr("Keep line %1").arg(line),
              [&](project::PanelState& state) {
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
                  if (!isTaken) kept.push_back({number, number});
                  lathelier::set(state.parameters, deflection_common::keptLinesKey, Value(kept));
              });
}

/// Named after the original program.
void CorrectionPanel::offerCorrected()
{
    const auto outcome = result();
    if (!outcome || !outcome->study->corrected) return;
    const project::Source& source = state().inputs.at(deflection_common::programRole);
    const std::string of = source.item.empty() ? std::filesystem::path(source.path).stem().string() : source.item;
    try {
        offerItem(tr("%1, corrected").arg(QString::fromStdString(of)).toStdString(), gcode::correctedItem,
                  gcode::toValues(correctedProgram(*outcome)), outcome->synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void CorrectionPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::correction_panel
