#include "widgets/correction/correction_panel.h"

#include <filesystem>

#include "engine/cam/check/correction_file.h"
#include "engine/core/item_numbers.h"
#include "widgets/core/session.h"
#include "widgets/correction/correction_views.h"

namespace lathelier::correction_panel {
namespace {

using deflection::DeflectionOutcome;
using deflection::DeflectionQuestion;

const std::vector<std::string> roles{gcode::programRole, deflection::setupRole, deflection::stockRole,
                                     deflection::spindleRole};

/// Prediction and correction alone: what the panel Deflection shows beside the prediction is left out.
DeflectionOutcome correct(const project::PanelState& state, Stores& stores, task::Sources& sources,
                          const Progress& progress)
{
    project::PanelState asked = state;
    for (const char* key : {"sensitivities", "feed", "map"}) lathelier::set(asked.parameters, key, false);
    lathelier::set(asked.parameters, "band", true);  // the uncertainty of the answer
    return deflection::answerDeflection(asked, deflection::StudyKind::Correction, stores, sources, progress);
}

PanelInputs panelInputs()
{
    return inputsOf(
        deflection::deflectionTask(), roles,
        {"corrected_runs", "residual_tolerance_um", "largest_correction_um", deflection::keptLinesKey}, true,
        LT_TEXT("Engine", "Drop an NC program and a set-up (SETUP.json) here: the corrected program follows."));
}

}  // namespace

PanelFacts correctionPanelFacts()
{
    PanelFacts facts = deflection_common::turningFacts(
        factsOf(deflection::deflectionTask(), "correction", "correction", roles, {{deflection::compensateExport}},
                {{"band", true}, {"sensitivities", false}, {"feed", false}, {"map", false}}));
    facts.title = LT_TEXT("Engine", "Correction");
    facts.answer = answeredBy(correct);
    facts.make = [](Session& session) -> PanelBase* { return new CorrectionPanel(session); };
    return facts;
}

CorrectionPanel::CorrectionPanel(Session& owner, QWidget* parent)
    : TurningPanel(owner, correctionPanelFacts(), panelInputs(), parent), views_(new CorrectionViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &CorrectionViews::taken, this, &CorrectionPanel::take);
    connect(views_, &CorrectionViews::checkRequested, this, [this] { offer(gcode::correctedItem); });
    connect(views_, &CorrectionViews::notWritten, this, &CorrectionPanel::reportWriteFailure);
}

void CorrectionPanel::showResult(const std::shared_ptr<const DeflectionOutcome>& outcome)
{
    views_->setOutcome(outcome);
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
                  lathelier::set(state.parameters, deflection::keptLinesKey, Value(kept));
              });
}

void CorrectionPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::correction_panel
