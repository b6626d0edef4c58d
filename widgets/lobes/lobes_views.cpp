#include "widgets/lobes/lobes_views.h"

#include <QVBoxLayout>

#include "engine/receptance/frf_plots.h"
#include "engine/stability/stability_report.h"
#include "widgets/core/language.h"

namespace lathelier::lobes_panel {

LobesViews::LobesViews(QWidget* parent)
    : QWidget(parent),
      heroes_(new HeroViews),
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
    heroes_->add("lobes", lobes_);
    heroes_->add("parts", parts_);
    heroes_->add("magnitude", magnitude_);
    heroes_->add("chatter", chatter_);
    heroes_->add("candidates", candidates_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(heroes_, 1);
    connect(lobes_, &plot::ChartView::handleMoved, this,
            [this](const QString& key, double speed_rpm, double depth, bool dropped) {
                if (key == stability::operatingPointKey) emit operatingPointMoved(speed_rpm, depth, dropped);
            });
    connect(candidates_, &QTableWidget::cellDoubleClicked, this, [this](int row, int) {
        if (!picture_ || !picture_->speed) return;
        const auto& list = picture_->speed->candidates;
        if (row >= 0 && static_cast<std::size_t>(row) < list.size())
            emit speedWanted(list[static_cast<std::size_t>(row)].speed_rpm);
    });
    for (plot::ChartView* chart : {lobes_, chatter_, parts_, magnitude_})
        connect(chart, &plot::PlotWidget::notWritten, this, &LobesViews::notWritten);
    retranslate();
}

void LobesViews::setPicture(const std::shared_ptr<const LobesPicture>& picture)
{
    picture_ = picture;
    heroes_->setAvailable("candidates", picture->speed.has_value());
    show();
}

void LobesViews::show()
{
    if (!picture_) return;
    const stability::LobeResult& result = *picture_->lobes;
    report::Plot lobes =
        lobesPlot(result, picture_->speed ? &*picture_->speed : nullptr, picture_->point, screenLanguage());
    report::Plot frequencies = chatterFrequencyPlot(result);
    if (picture_->marks) {
        drawMarks(lobes, *picture_->marks, screenLanguage());
        drawMarksFrequency(frequencies, *picture_->marks, screenLanguage());
    }
    lobes_->setData(std::move(lobes));
    chatter_->setData(std::move(frequencies));
    parts_->setData(receptance::realImaginaryPlot(*picture_->frf, result.frequency_of_minimum_hz, screenLanguage()));
    magnitude_->setData(receptance::magnitudePlot(*picture_->frf));
    if (picture_->speed) candidates_->setTable(stability::candidatesTable(*picture_->speed));
}

void LobesViews::retranslate()
{
    heroes_->setTitle("lobes", tr("Lobes"));
    heroes_->setTitle("parts", tr("Real and imaginary"));
    heroes_->setTitle("magnitude", tr("Magnitude"));
    heroes_->setTitle("chatter", tr("Chatter frequency"));
    heroes_->setTitle("candidates", tr("Stable speeds"));
    candidates_->setAccessibleName(tr("Stable speeds"));
    candidates_->setToolTip(tr("Double click: work at this speed"));
    show();
}

}  // namespace lathelier::lobes_panel
