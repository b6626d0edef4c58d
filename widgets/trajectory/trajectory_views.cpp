#include "widgets/trajectory/trajectory_views.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/trajectory/trajectory_plots.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"
#include "widgets/core/panel/view_frame.h"
#include "widgets/scene/scene_view.h"
#include "widgets/trajectory/channel_table.h"
#include "widgets/trajectory/trajectory_charts.h"

namespace lathelier::trajectory_panel {

TrajectoryViews::TrajectoryViews(trajectory_common::MarkedAngle& angle, QWidget* parent)
    : QWidget(parent),
      angle_(angle),
      section_(new trajectory_common::SectionBar),
      angleBar_(new trajectory_common::AngleBar(angle)),
      all_(new QCheckBox),
      synthetic_(new QLabel),
      primaryViews_(new PrimaryViews),
      axes_(new plot::ChartView),
      probe_(new QComboBox),
      motionText_(new QLabel),
      motion_(new plot::PolarView),
      coordinates_(new plot::ChartView),
      signals_(new plot::ChartView),
      scene_(new scene::SceneView),
      spaceText_(new QLabel),
      channelTable_(new ChannelTable),
      recordText_(new QLabel)
{
    axes_->setObjectName("axes");
    motion_->setObjectName("motion");
    coordinates_->setObjectName("coordinates");
    signals_->setObjectName("signals");
    scene_->setObjectName("scene");
    probe_->setObjectName("probe");
    all_->setObjectName("allSections");
    all_->setChecked(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    buildBar();

    auto* space = new QWidget;
    auto* spaceLayout = new QVBoxLayout(space);
    spaceLayout->setContentsMargins(0, 4, 0, 0);
    spaceLayout->addWidget(spaceText_);
    for (QWidget* words : {static_cast<QWidget*>(spaceText_), static_cast<QWidget*>(recordText_),
                           static_cast<QWidget*>(probe_), static_cast<QWidget*>(motionText_)})
        words->setProperty(ViewFrame::onlyLarge, true);
    spaceLayout->addWidget(scene_, 1);
    primaryViews_->add("motion", makeMotion());
    primaryViews_->add("axes", axes_);
    primaryViews_->add("coordinates", coordinates_);
    primaryViews_->add("space", space);
    primaryViews_->add("signals", signals_);
    primaryViews_->add("record", makeRecord());
    layout->addWidget(primaryViews_, 1);

    connect(section_, &trajectory_common::SectionBar::sectionRequested, this, &TrajectoryViews::sectionRequested);
    connect(all_, &QCheckBox::toggled, this, [this] { showSection(); });
    connect(probe_, qOverload<int>(&QComboBox::activated), this, [this] { showMotion(); });
    connect(motion_, &plot::PolarView::clicked, this, [this](double deg) { angle_.set(deg); });
    connect(coordinates_, &plot::PlotCanvas::clicked, this, [this](double deg, double) {
        if (!outcome_ || !outcome_->chosenSection()) return;
        const trajectory::TrajectorySection& chosen = *outcome_->chosenSection();
        const std::vector<double> angles = partAngles_deg(chosen);
        for (std::size_t i = 0; i < chosen.angle_deg.size(); ++i)
            if (chosen.angle_deg[i] >= deg) return angle_.set(angles[i]);
    });
    connect(axes_, &plot::PlotCanvas::clicked, this, &TrajectoryViews::markNear);
    connect(motion_, &plot::PolarView::unmarked, this, [this] { angle_.set({}); });
    for (plot::PlotCanvas* plot : {static_cast<plot::PlotCanvas*>(axes_), static_cast<plot::PlotCanvas*>(coordinates_)})
        connect(plot, &plot::PlotCanvas::clickTakenBack, &angle_, &trajectory_common::MarkedAngle::takeBack);
    connect(scene_, &scene::SceneView::pointPicked, this, [this](int path, qint64 dot) {
        const StackedPlace place = stackedPlace(*inScene_, static_cast<std::size_t>(path), dot);
        angle_.set(place.angle_deg);
        if (place.section != outcome_->section) emit sectionRequested(inScene_->sections[place.section].section);
    });
    connect(channelTable_, &ChannelTable::mapEdited, this, &TrajectoryViews::mapEdited);
    connect(channelTable_, &ChannelTable::calibrationsEdited, this, &TrajectoryViews::calibrationsEdited,
            Qt::QueuedConnection);  // the answer fills the table anew, which must not happen within an edit
    connect(&angle_, &trajectory_common::MarkedAngle::changed, this, &TrajectoryViews::markAngle);
    for (plot::PlotWidget* plot :
         {static_cast<plot::PlotWidget*>(axes_), static_cast<plot::PlotWidget*>(motion_),
          static_cast<plot::PlotWidget*>(coordinates_), static_cast<plot::PlotWidget*>(signals_)})
        connect(plot, &plot::PlotWidget::notWritten, this, &TrajectoryViews::notWritten);
    retranslate();
}

void TrajectoryViews::buildBar()
{
    auto* row = new FlowRow;
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    row->addWidget(section_);
    row->addWidget(all_);
    row->addWidget(angleBar_);
    synthetic_->setFrameShape(QFrame::Box);
    synthetic_->setMargin(2);
    synthetic_->hide();
    row->setTrailing(synthetic_);
}

QWidget* TrajectoryViews::makeMotion()
{
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* row = new QHBoxLayout;
    for (const char* name : {"X3", "Y3", "Xp", "Yp"}) probe_->addItem(name);
    motionText_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(probe_);
    row->addWidget(motionText_, 1);
    layout->addLayout(row);
    layout->addWidget(motion_, 1);
    return page;
}

QWidget* TrajectoryViews::makeRecord()
{
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    recordText_->setWordWrap(true);
    recordText_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(recordText_);
    layout->addWidget(channelTable_, 1);
    return page;
}

void TrajectoryViews::setOutcome(const std::shared_ptr<const trajectory::MotionOutcome>& outcome, bool sectionChosen,
                                 const trajectory::TrajectoryParameters& parameters)
{
    const bool problem = outcome->problem.has_value();
    const bool news = !outcome_ || outcome_->problem.has_value() != problem;
    outcome_ = outcome;
    parameters_ = parameters;
    section_->setSections(outcome->trajectory, outcome->section, sectionChosen);
    synthetic_->setVisible(outcome->sources.synthetic);
    all_->setVisible(outcome->trajectory && outcome->trajectory->sections.size() > 1);
    const QSignalBlocker quiet(primaryViews_);  // what nobody chose is not kept with the project
    const QString before = primaryViews_->primary();
    for (const char* key : {"motion", "axes", "coordinates", "space"}) primaryViews_->setAvailable(key, !problem);
    if (news)
        primaryViews_->setPrimary(problem              ? "record"
                                  : before == "record" ? "motion"
                                                       : before);  // where it can be mended
    showRecord();
    showSection();
    showSpace();
}

void TrajectoryViews::showSection()
{
    if (!outcome_ || !outcome_->chosenSection()) return;
    const trajectory::TrajectorySection& chosen = *outcome_->chosenSection();
    const auto& others = outcome_->trajectory->sections;
    axes_->setData(all_->isChecked() ? trajectoryPlot(chosen, screenLanguage(), others)
                                     : trajectoryPlot(chosen, screenLanguage()));
    coordinates_->setData(coordinatesPlot(chosen, screenLanguage()));
    showMotion();
}

void TrajectoryViews::showMotion()
{
    const trajectory::TrajectorySection* chosen = outcome_ ? outcome_->chosenSection() : nullptr;
    if (!chosen) return;
    const auto probe = static_cast<trajectory::Probe>(std::max(0, probe_->currentIndex()));
    const double diameter_mm = outcome_->trajectory->workpiece_diameter_mm;
    motion_->setPicture(plot::polarPicture(errorMotionPlot(*chosen, diameter_mm, probe, screenLanguage())));
    const QString text = motionText(chosen->error_motion[static_cast<std::size_t>(probe)]);
    motionText_->setText(text);
    motionText_->setToolTip(
        tr("ISO 230-7, fixed sensitive direction, %1 revolutions: %2").arg(chosen->revolutions_used).arg(text));
    markAngle();
}

void TrajectoryViews::showRecord()
{
    const auto& file = outcome_->records.front()->file;
    const auto* record = std::get_if<io::ProbeRecord>(&file.record);
    primaryViews_->setAvailable("signals", record != nullptr);
    channelTable_->setVisible(record != nullptr);
    channelTable_->setRecord(record, parameters_);
    if (outcome_->time_signals) signals_->setData(signalsPlot(*outcome_->time_signals, screenLanguage()));
    QStringList lines;
    if (outcome_->records.size() > 1) lines << tr("The first of %1 records:").arg(outcome_->records.size());
    if (record) {
        if (!record->device.empty()) lines << tr("Recorder: %1").arg(QString::fromStdString(record->device));
        if (!record->recorded.empty()) lines << tr("Recorded: %1").arg(QString::fromStdString(record->recorded));
        if (std::isfinite(record->rate_hz))
            lines << tr("%1 frames a second, %2 s, %3 channels")
                         .arg(screenNumber(record->rate_hz, 1),
                              screenNumber(static_cast<double>(record->frames()) / record->rate_hz, 2))
                         .arg(record->channels.size());
    } else {
        lines << tr("Averages over the revolutions: %1 sections")
                     .arg(std::get<io::AveragedRecord>(file.record).sections.size());
    }
    const Values& header = record ? record->header : std::get<io::AveragedRecord>(file.record).header;
    QStringList headerEntries;
    for (const auto& [name, value] : header) headerEntries << QString::fromStdString(name) + " = " + screenText(value);
    if (!headerEntries.isEmpty()) lines << tr("The file says: %1").arg(headerEntries.join(QStringLiteral(" · ")));
    recordText_->setText(lines.join('\n'));
}

void TrajectoryViews::showSpace()
{
    if (!outcome_ || !outcome_->trajectory) return;
    if (inScene_ == outcome_->trajectory) return;
    inScene_ = outcome_->trajectory;
    const double magnification = stackMagnification(*inScene_);
    spaceText_->setText(tr("Workpiece axis (blue) and tool (orange) of all sections along z; displacements × %1")
                            .arg(screenNumber(magnification, 0)));
    scene_->setLongAxis(scene::SceneAxis{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()});
    scene_->setObjects(stackedTrajectories(*inScene_, magnification));
    markInSpace();
}

/// The angle at which axis or tool of the chosen section comes nearest to a place in the plane.
void TrajectoryViews::markNear(double x_um, double y_um)
{
    const trajectory::TrajectorySection* chosen = outcome_ ? outcome_->chosenSection() : nullptr;
    if (!chosen) return;
    const std::vector<double> angles = partAngles_deg(*chosen);
    double least = HUGE_VAL;
    std::optional<double> nearest;
    for (const auto& [x, y] : {std::pair{trajectory::Probe::X3, trajectory::Probe::Y3},
                               std::pair{trajectory::Probe::Xp, trajectory::Probe::Yp}}) {
        const std::vector<double>& xs = chosen->probes[static_cast<std::size_t>(x)].mean_um;
        const std::vector<double>& ys = chosen->probes[static_cast<std::size_t>(y)].mean_um;
        for (std::size_t i = 0; i < std::min({xs.size(), ys.size(), angles.size()}); ++i) {
            const double distance = std::hypot(xs[i] - x_um, ys[i] - y_um);
            if (distance < least) {
                least = distance;
                nearest = angles[i];
            }
        }
    }
    if (nearest) angle_.set(nearest);
}

/// The marked angle of the chosen section, among all sections in space.
void TrajectoryViews::markInSpace()
{
    const auto angle = angle_.angle_deg();
    if (!inScene_ || inScene_ != outcome_->trajectory || !outcome_->section) return;
    if (!angle) return scene_->setMarker({});
    const auto section = *outcome_->section;
    scene_->setMarker(
        placeInStack(*inScene_, {section, *angle}, stackMagnification(*inScene_)),
        tr("section %1, angle %2°").arg(inScene_->sections[section].section).arg(screenNumber(*angle, 1)));
}

void TrajectoryViews::markAngle()
{
    markInSpace();
    const auto angle = angle_.angle_deg();
    motion_->setMarker(angle);
    axes_->setMarker(angle);
    const trajectory::TrajectorySection* chosen = outcome_ ? outcome_->chosenSection() : nullptr;
    if (!angle || !chosen) return coordinates_->setMarker({});
    const std::size_t nearest = sampleAt(*chosen, *angle);
    if (nearest < chosen->angle_deg.size()) coordinates_->setMarker(chosen->angle_deg[nearest]);
}

Values TrajectoryViews::view() const
{
    Values kept{{"all_sections", all_->isChecked()}, {"probe", std::int64_t{probe_->currentIndex()}}};
    if (std::vector<double> camera = scene_->view(); !camera.empty()) kept.emplace_back("camera", std::move(camera));
    return kept;
}

void TrajectoryViews::restoreView(const Values& kept)
{
    const QSignalBlocker quiet(all_);
    const Value* const all = lathelier::find(kept, "all_sections");
    all_->setChecked(!all || *all == Value(true));
    const Value* const probe = lathelier::find(kept, "probe");
    const auto* const index = probe ? std::get_if<std::int64_t>(probe) : nullptr;
    probe_->setCurrentIndex(index && *index >= 0 && *index < probe_->count() ? static_cast<int>(*index) : 0);
    if (const Value* camera = lathelier::find(kept, "camera"))
        if (const auto* numbers = std::get_if<std::vector<double>>(camera)) scene_->setView(*numbers);
    showSection();
}

void TrajectoryViews::retranslate()
{
    all_->setText(tr("all sections"));
    all_->setToolTip(tr("Draw the trajectories of all sections behind the chosen one"));
    synthetic_->setText(tr("Synthetic data"));
    probe_->setToolTip(tr("The probe whose error motion is shown"));
    probe_->setAccessibleName(probe_->toolTip());
    primaryViews_->setTitle("motion", tr("Error motion"));
    primaryViews_->setTitle("axes", tr("Trajectories"));
    primaryViews_->setTitle("coordinates", tr("Coordinates"));
    primaryViews_->setTitle("space", tr("All sections in 3-D"));
    primaryViews_->setTitle("signals", tr("Signals"));
    primaryViews_->setTitle("record", tr("Record and channels"));
    inScene_.reset();
    if (outcome_) setOutcome(outcome_, !section_->isWorst(), parameters_);
}

}  // namespace lathelier::trajectory_panel
