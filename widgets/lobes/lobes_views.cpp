#include "widgets/lobes/lobes_views.h"

#include <QVBoxLayout>

#include "engine/receptance/frf_plots.h"
#include "engine/stability/stability_report.h"
#include "widgets/core/language.h"

namespace lathelier::lobes_panel {

LobesViews::LobesViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      lobes_(new plot::ChartView),
      chatter_(new plot::ChartView),
      parts_(new plot::ChartView),
      magnitude_(new plot::ChartView),
      candidates_(new CopyTable)
{
    lobes_->setObjectName("lobes");
    chatter_->setObjectName("chatterFrequency");
    parts_->setObjectName("realImaginary");
    magnitude_->setObjectName("magnitude");
    candidates_->setObjectName("candidates");
    primaryViews_->add("lobes", lobes_);
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
    for (plot::ChartView* chart : {lobes_, chatter_, parts_, magnitude_})
        connect(chart, &plot::PlotWidget::notWritten, this, &LobesViews::notWritten);
    retranslate();
}

void LobesViews::setOutcome(const std::shared_ptr<const stability::LobesOutcome>& outcome)
{
    outcome_ = outcome;
    primaryViews_->setAvailable("candidates", !outcome->safe.peaks.empty());
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
}

void LobesViews::retranslate()
{
    primaryViews_->setTitle("lobes", tr("Lobes"));
    primaryViews_->setTitle("parts", tr("Real and imaginary"));
    primaryViews_->setTitle("magnitude", tr("Magnitude"));
    primaryViews_->setTitle("chatter", tr("Chatter frequency"));
    primaryViews_->setTitle("candidates", tr("Stable speeds"));
    candidates_->setAccessibleName(tr("Stable speeds"));
    candidates_->setToolTip(tr("Double click: work at this speed"));
    show();
}

}  // namespace lathelier::lobes_panel
