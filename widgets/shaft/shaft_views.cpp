#include "widgets/shaft/shaft_views.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

#include "engine/receptance/frf_plots.h"
#include "engine/receptance/shaft/shaft_plots.h"
#include "engine/receptance/shaft/shaft_report.h"
#include "widgets/core/language.h"

namespace lathelier::shaft_panel {

ShaftViews::ShaftViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      drawing_(new plot::ChartView),
      shapes_(new plot::ChartView),
      magnitude_(new plot::ChartView),
      parts_(new plot::ChartView),
      frequencies_(new CopyTable),
      buttons_(new QWidget),
      play_(new SwingButton("playShapes")),
      shaft_(new QPushButton),
      response_(new QPushButton)
{
    drawing_->setObjectName("drawing");
    shapes_->setObjectName("shapes");
    magnitude_->setObjectName("magnitude");
    parts_->setObjectName("realImaginary");
    frequencies_->setObjectName("frequencies");
    shaft_->setObjectName("useShaft");
    response_->setObjectName("useResponse");
    primaryViews_->add("drawing", drawing_);
    primaryViews_->add("shapes", shapes_);
    primaryViews_->add("magnitude", magnitude_);
    primaryViews_->add("parts", parts_);
    primaryViews_->add("frequencies", frequencies_);
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(play_);
    row->addStretch();
    row->addWidget(shaft_);
    row->addWidget(response_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    layout->addWidget(buttons_);
    connect(play_, &SwingButton::moved, this, &ShaftViews::swing);
    connect(shaft_, &QPushButton::clicked, this, &ShaftViews::shaftRequested);
    connect(response_, &QPushButton::clicked, this, &ShaftViews::responseRequested);
    connect(drawing_, &plot::ChartView::handleMoved, this,
            [this](const QString& key, double z_mm, double radius_mm, bool dropped) {
                if (const auto segment = receptance::segmentOfHandle(key.toStdString()))
                    emit endMoved(*segment, z_mm, radius_mm, dropped);
            });
    for (plot::ChartView* chart : {drawing_, shapes_, magnitude_, parts_})
        connect(chart, &plot::PlotWidget::notWritten, this, &ShaftViews::notWritten);
    retranslate();
}

void ShaftViews::setOutcome(const std::shared_ptr<const receptance::ShaftOutcome>& outcome)
{
    outcome_ = outcome;
    const bool has_modes = !outcome->study.modes.empty();
    primaryViews_->setAvailable("shapes", has_modes);
    primaryViews_->setAvailable("frequencies", has_modes);
    play_->setVisible(has_modes);
    if (!has_modes) play_->setChecked(false);
    show();
}

void ShaftViews::show()
{
    if (!outcome_) return;
    const receptance::ShaftStudy& study = outcome_->study;
    drawing_->setData(receptance::shaftDrawing(outcome_->shaft, outcome_->holding, true, screenLanguage()));
    magnitude_->setData(receptance::magnitudePlot(study.response.frf));
    parts_->setData(receptance::realImaginaryPlot(study.response.frf, {}, screenLanguage()));
    if (study.response.natural_frequencies_hz)
        frequencies_->setTable(receptance::frequenciesTable(*study.response.natural_frequencies_hz));
    swing();
}

/// At rest the shapes stand at their largest.
void ShaftViews::swing()
{
    if (!outcome_ || outcome_->study.modes.empty()) return;
    if (play_->isChecked() && !shapes_->isVisible()) return;
    shapes_->setData(receptance::modeShapesPlot(outcome_->study, std::cos(play_->phaseOfSwing()), screenLanguage()));
}

void ShaftViews::setPresenting(bool presenting)
{
    buttons_->setVisible(!presenting);
}

void ShaftViews::retranslate()
{
    primaryViews_->setTitle("drawing", tr("Shaft"));
    primaryViews_->setTitle("shapes", tr("Mode shapes"));
    primaryViews_->setTitle("magnitude", tr("Magnitude"));
    primaryViews_->setTitle("parts", tr("Real and imaginary"));
    primaryViews_->setTitle("frequencies", tr("Natural frequencies"));
    frequencies_->setAccessibleName(tr("Natural frequencies"));
    play_->setWords(tr("Swing"), tr("Let the mode shapes swing"));
    shaft_->setText(tr("Use this shaft"));
    shaft_->setToolTip(tr("Keep it in the project, where other panels take it as an input"));
    response_->setText(tr("Use this response"));
    response_->setToolTip(tr("Find the stability lobes of this receptance"));
    show();
}

}  // namespace lathelier::shaft_panel
