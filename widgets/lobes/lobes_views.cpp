#include "widgets/lobes/lobes_views.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "engine/core/units.h"
#include "engine/receptance/frf_plots.h"
#include "engine/stability/stability_report.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/view_frame.h"

namespace lathelier::lobes_panel {
namespace {

constexpr double shownShare = 1.0 / 3;  ///< of the largest radius: the drawn amplitude

}  // namespace

LobesViews::LobesViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      lobes_(new plot::ChartView),
      chatter_(new plot::ChartView),
      parts_(new plot::ChartView),
      magnitude_(new plot::ChartView),
      candidates_(new CopyTable),
      swinging_(new QWidget),
      work_(new scene::SceneView),
      remark_(new QLabel),
      play_(new SwingButton("playSwing"))
{
    lobes_->setObjectName("lobes");
    chatter_->setObjectName("chatterFrequency");
    parts_->setObjectName("realImaginary");
    magnitude_->setObjectName("magnitude");
    candidates_->setObjectName("candidates");
    work_->setObjectName("lobesSwing");
    auto* head = new QWidget;
    head->setProperty(ViewFrame::onlyLarge, true);
    auto* beside = new QHBoxLayout(head);
    beside->setContentsMargins(0, 0, 0, 0);
    beside->addWidget(remark_, 1);
    beside->addWidget(play_);
    auto* stacked = new QVBoxLayout(swinging_);
    stacked->setContentsMargins(0, 0, 0, 0);
    stacked->setSpacing(0);
    stacked->addWidget(head);
    stacked->addWidget(work_, 1);
    primaryViews_->add("lobes", lobes_);
    primaryViews_->add("swing", swinging_);
    primaryViews_->add("parts", parts_);
    primaryViews_->add("magnitude", magnitude_);
    primaryViews_->add("chatter", chatter_);
    primaryViews_->add("candidates", candidates_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    connect(lobes_, &plot::ChartView::handleMoved, this,
            [this](const QString& key, double speed_rpm, double depth, bool dropped) {
                if (key == stability::operatingPointKey) emit operatingPointMoved(speed_rpm, depth, dropped);
            });
    connect(candidates_, &QTableWidget::cellDoubleClicked, this, [this](int row, int) {
        if (!outcome_ || outcome_->pass) return;
        const std::vector<stability::DepthAtSpeed>& list = outcome_->safe.peaks;
        if (row >= 0 && static_cast<std::size_t>(row) < list.size())
            emit speedRequested(list[static_cast<std::size_t>(row)].speed_rpm);
    });
    connect(play_, &SwingButton::moved, this, [this] {
        if (work_->isVisible()) showSwing();
    });
    connect(work_, &scene::SceneView::notWritten, this, &LobesViews::notWritten);
    for (plot::ChartView* chart : {lobes_, chatter_, parts_, magnitude_})
        connect(chart, &plot::PlotWidget::notWritten, this, &LobesViews::notWritten);
    retranslate();
}

void LobesViews::setOutcome(const std::shared_ptr<const stability::LobesOutcome>& outcome)
{
    outcome_ = outcome;
    primaryViews_->setAvailable("candidates", !outcome->safe.peaks.empty());
    const bool swings = outcome->swing && work_->canDraw();
    primaryViews_->setAvailable("swing", swings);
    if (!swings) play_->setChecked(false);
    show();
}

void LobesViews::show()
{
    if (!outcome_) return;
    const stability::LobeResult& result = *outcome_->lobes;
    report::Plot lobes = lobesPlot(result, marksOf(*outcome_), screenLanguage());
    report::Plot frequencies = chatterFrequencyPlot(result);
    if (outcome_->marks) {
        drawMarks(lobes, *outcome_->marks, screenLanguage());
        drawMarksFrequency(frequencies, *outcome_->marks, screenLanguage());
    }
    lobes_->setData(std::move(lobes));
    chatter_->setData(std::move(frequencies));
    parts_->setData(
        receptance::realImaginaryPlot(*outcome_->response.frf, result.frequency_of_minimum_hz, screenLanguage()));
    magnitude_->setData(receptance::magnitudePlot(*outcome_->response.frf));
    candidates_->setTable(stability::pocketsTable(outcome_->safe, result.isRelative()));
    showSwing();
}

/// At rest the work stands at its largest.
void LobesViews::showSwing()
{
    if (!outcome_ || !outcome_->swing || !work_->canDraw()) return;
    const receptance::ForcedShape& shape = *outcome_->swing;
    const Skin skin = receptance::swingingSkin(*outcome_->response.shaft, shape, play_->phaseOfSwing());
    scene::SceneObject work;
    work.name = tr("Work");
    work.scan =
        std::make_shared<const Scan>(meshOf(skin, shownShare * skin.largestRadius(), Eigen::Isometry3d::Identity()));
    work.values = std::make_shared<const std::vector<float>>(skin.values);
    report::DeviationColours colours{report::niceLimit(um_per_mm * shape.largestDeflection())};
    colours.steps = report::contourSteps;
    work_->setScale({LT_TEXT("Engine", "Deflection per force"), LT_TEXT("Engine", "µm/N")});
    work_->setColours(colours);
    work_->setLongAxis(scene::SceneAxis{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()});
    work_->setObjects({work});
    remark_->setText(
        tr("Chatter at %1 under a force at z %2; the amplitude is drawn large")
            .arg(screenQuantity(shape.frequency_hz, unit::hz, 1), screenQuantity(shape.force_z_mm, unit::mm, 1)));
}

void LobesViews::retranslate()
{
    primaryViews_->setTitle("lobes", tr("Lobes"));
    primaryViews_->setTitle("swing", tr("How the work swings"));
    play_->setWords(tr("Swing"), tr("Let the work swing as it chatters"));
    primaryViews_->setTitle("parts", tr("Real and imaginary"));
    primaryViews_->setTitle("magnitude", tr("Magnitude"));
    primaryViews_->setTitle("chatter", tr("Chatter frequency"));
    primaryViews_->setTitle("candidates", tr("Stable speeds"));
    candidates_->setAccessibleName(tr("Stable speeds"));
    candidates_->setToolTip(tr("Double click: work at this speed"));
    show();
}

}  // namespace lathelier::lobes_panel
