#include "widgets/trajectory/trajectory_panel.h"

#include <array>
#include <cmath>

#include "engine/form/verify/form_verification.h"
#include "engine/io/io_codes.h"
#include "engine/report/quantity_table.h"
#include "engine/trajectory/section_file.h"
#include "engine/trajectory/trajectory_plots.h"
#include "engine/trajectory/trajectory_quantities.h"
#include "engine/trajectory/trajectory_report.h"
#include "widgets/core/language.h"
#include "widgets/trajectory/trajectory_charts.h"
#include "widgets/trajectory/trajectory_views.h"
#include "widgets/trajectory_common/spindle_inputs.h"

namespace lathelier::trajectory_panel {
namespace {

constexpr std::array<const char*, 4> probeNames{"X3", "Y3", "Xp", "Yp"};

PanelInputs panelInputs()
{
    return trajectory_common::spindleInputs(
        {&trajectory_common::recordRole()}, {"workpiece_diameter_mm", "z_mm", "feed_mm_rev"},
        {"channels", "sensitivity_um_per_V", "marker_threshold_V", "channel_skew_s", "rotation", "points",
         "revolutions", "sections", "drift", "outlier_sigmas"},
        LT_TEXT("Engine", "Drop a probe record here: a table, or a pair .dat and .par of L-Graph."));
}

report::QuantityTable motionTable(const trajectory::TrajectorySection& section, std::size_t probe)
{
    return report::quantityTable(std::string(probeNames[probe]), section.error_motion[probe],
                                 {"synchronous_um", "asynchronous_um", "total_um"});
}

/// The motion in the chosen section. The workpiece's form is the report of the other panels.
report::Document reportOf(const trajectory_common::SpindleOutcome& outcome, const Language& language)
{
    const trajectory::TrajectoryResult& result = *outcome.trajectory;
    const trajectory::TrajectorySection& section = *outcome.chosenSection();
    report::Document document;
    document.title = LT_TEXT("Engine", "Motion of spindle and tool");
    document.verification = {&form::formVerification()};
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic || contains(result.notes, notes::syntheticData);
    report::Section motion{LT_TEXT("Engine", "Error motion (ISO 230-7)"), {trajectory::motionAnswer(result, section)}};
    for (std::size_t probe = 0; probe < probeNames.size(); ++probe)
        motion.blocks.push_back(motionTable(section, probe));
    motion.blocks.push_back(errorMotionPlot(section, result.workpiece_diameter_mm, trajectory::Probe::X3, language));
    motion.blocks.push_back(outcome.notes);
    document.sections.push_back(std::move(motion));
    document.sections.push_back(
        {LT_TEXT("Engine", "Trajectories"), {trajectoryPlot(section, language), envelopePlot(section)}});
    document.sections.push_back(trajectoryMethod(result, language));
    trajectory_common::addSectionSentence(outcome, document);
    document.results = {trajectory_common::trajectoryJson(outcome)};
    return document;
}

}  // namespace

PanelFacts trajectoryPanelFacts()
{
    PanelFacts facts = trajectory_common::spindleFacts("trajectory", LT_TEXT("Engine", "Trajectory"), "trajectory",
                                                       trajectory_common::SpindleStudyKind::Trajectory);
    facts.make = [](Session& session) -> PanelBase* { return new TrajectoryPanel(session); };
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        const trajectory_common::SpindleOutcome outcome = trajectory_common::outcomeOrThrow(
            state, trajectory_common::SpindleStudyKind::Longitudinal, stores, progress);
        return reportOf(outcome, language);
    };
    return facts;
}

TrajectoryPanel::TrajectoryPanel(Session& owner, QWidget* parent)
    : trajectory_common::SpindlePanel(owner, trajectoryPanelFacts(), panelInputs(),
                                      trajectory_common::SpindleStudyKind::Trajectory, parent),
      views_(new TrajectoryViews(markedAngle()))
{
    setViews(views_, views_->primaryViews());
    connect(views_, &TrajectoryViews::sectionRequested, this, &TrajectoryPanel::chooseSection);
    connect(views_, &TrajectoryViews::notWritten, this, &TrajectoryPanel::reportWriteFailure);
    connect(views_, &TrajectoryViews::mapEdited, this,
            [this](const std::string& map) { setParameter("channels", map, tr("Change the channels")); });
    connect(views_, &TrajectoryViews::calibrationsEdited, this,
            [this](const std::vector<trajectory::ProbeCalibration>& probes) {
                trajectory::TrajectoryParameters parameters;
                parameters.probes = probes;
                setParameter("probes", *lathelier::find(toValues(parameters), "probes"), tr("Change a calibration"));
            });
}

void TrajectoryPanel::showResult(const std::shared_ptr<const trajectory_common::SpindleOutcome>& outcome)
{
    views_->setOutcome(outcome, isSectionChosen(), fromValues<trajectory::TrajectoryParameters>(state().parameters));
}

report::Answer TrajectoryPanel::answer(const trajectory_common::SpindleOutcome& outcome) const
{
    const trajectory::TrajectorySection* chosen = outcome.chosenSection();
    return chosen ? trajectory::motionAnswer(*outcome.trajectory, *chosen) : report::Answer();
}

report::Document TrajectoryPanel::document(const trajectory_common::SpindleOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> TrajectoryPanel::exports() const
{
    const auto outcome = result();
    if (!outcome || !outcome->trajectory) return {};
    return {{tr("Trajectories and images of all sections (CSV)…"), tr("Table (*.csv)"), "csv",
             [outcome](const QString& path) { writeImages(path.toStdString(), *outcome->trajectory); }}};
}

Values TrajectoryPanel::view() const
{
    return views_->view();
}

void TrajectoryPanel::restoreView(const Values& kept)
{
    views_->restoreView(kept);
}

void TrajectoryPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::trajectory_panel
