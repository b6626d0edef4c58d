#include "widgets/tap/tap_views.h"

#include <QVBoxLayout>

#include "engine/receptance/frf_plots.h"
#include "engine/receptance/tap/tap_plots.h"
#include "engine/receptance/tap/tap_report.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"

namespace lathelier::tap_panel {

TapViews::TapViews(QWidget* parent)
    : QWidget(parent),
      use_(new QToolButton),
      primaryViews_(new PrimaryViews),
      force_(new plot::ChartView),
      motion_(new plot::ChartView),
      spectrum_(new plot::ChartView),
      magnitude_(new plot::ChartView),
      phase_(new plot::ChartView),
      coherence_(new plot::ChartView),
      hits_(new CopyTable)
{
    const std::pair<const char*, QWidget*> views[] = {{"magnitude", magnitude_}, {"force", force_}, {"motion", motion_},
                                                      {"spectrum", spectrum_},   {"phase", phase_}, {"hits", hits_},
                                                      {"coherence", coherence_}};
    for (const auto& [key, view] : views) {
        view->setObjectName(key);
        primaryViews_->add(key, view);
    }
    use_->setObjectName("useThisResponse");
    use_->setAutoRaise(true);
    use_->setEnabled(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* row = new FlowRow;
    row->addWidget(use_);
    layout->addLayout(row);
    layout->addWidget(primaryViews_, 1);
    connect(use_, &QToolButton::clicked, this, &TapViews::responseRequested);
    for (plot::ChartView* chart : {force_, motion_, spectrum_, magnitude_, phase_, coherence_})
        connect(chart, &plot::PlotWidget::notWritten, this, &TapViews::notWritten);
    retranslate();
}

void TapViews::setOutcome(const std::shared_ptr<const receptance::TapOutcome>& outcome)
{
    outcome_ = outcome;
    show();
}

void TapViews::show()
{
    if (!outcome_) return;
    const receptance::TapStudy& study = outcome_->study;
    const bool has_coherence = !study.result.coherence.empty();
    use_->setEnabled(!study.result.response.value.empty());
    primaryViews_->setAvailable("coherence", has_coherence);
    force_->setData(tapForcePlot(study, screenLanguage()));
    motion_->setData(tapMotionPlot(study, screenLanguage()));
    spectrum_->setData(tapSpectrumPlot(study.result, screenLanguage()));
    magnitude_->setData(receptance::magnitudePlot(study.result.response));
    phase_->setData(tapPhasePlot(study.result));
    if (has_coherence) coherence_->setData(tapCoherencePlot(study.result, screenLanguage()));
    hits_->setTable(hitsTable(study));
}

void TapViews::retranslate()
{
    primaryViews_->setTitle("magnitude", tr("Magnitude"));
    primaryViews_->setTitle("force", tr("Force"));
    primaryViews_->setTitle("motion", tr("Sensor"));
    primaryViews_->setTitle("spectrum", tr("Spectrum of the force"));
    primaryViews_->setTitle("phase", tr("Phase"));
    primaryViews_->setTitle("hits", tr("Hits"));
    primaryViews_->setTitle("coherence", tr("Coherence"));
    hits_->setAccessibleName(tr("Hits"));
    use_->setText(tr("Use this response"));
    use_->setToolTip(tr("Keeps the response in the project: for modes, lobes and speeds"));
    show();
}

}  // namespace lathelier::tap_panel
