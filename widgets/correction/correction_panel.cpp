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
using deflection_common::Wanted;

PanelInputs panelInputs()
{
    return deflection_common::deflectionInputs(
        {"corrected_runs", "residual_tolerance_um", "largest_correction_um", deflection_common::keptLinesKey},
        LT_TEXT("Engine", "Drop an NC program and a set-up (SETUP.json) here: the corrected program follows."));
}

/// The text with what it stands off from the programmed contour; z from the free end of its clamping.
gcode::ProgramItem correctedProgram(const deflection_common::DeflectionPicture& picture)
{
    const deflection::CorrectedProgram& corrected = *picture.study->corrected;
    gcode::ProgramItem item;
    item.text = deflection_common::toUtf8(corrected.text);
    if (picture.program) item.clamping = picture.program->clamping;
    item.corrected_from = picture.program_sha256;
    item.z_zero_mm = picture.job->setup.z_zero_mm;
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
    connect(views_, &CorrectionViews::checkWanted, this, &CorrectionPanel::offerCorrected);
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

/// Under the name of the program that it was made of.
void CorrectionPanel::offerCorrected()
{
    const auto picture = result();
    if (!picture || !picture->study->corrected) return;
    const project::Source& source = state().inputs.at(deflection_common::programRole);
    const std::string of = source.item.empty() ? std::filesystem::path(source.path).stem().string() : source.item;
    try {
        offerItem(tr("%1, corrected").arg(QString::fromStdString(of)).toStdString(), gcode::correctedItem,
                  gcode::toValues(correctedProgram(*picture)), picture->synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void CorrectionPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::correction_panel
