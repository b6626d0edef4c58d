#include "widgets/series/series_views.h"

#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/series/series_report.h"
#include "widgets/core/language.h"

namespace lathelier::series_panel {

SeriesViews::SeriesViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      chart_(new plot::ChartView),
      pictures_(new PicturesView),
      values_(new CopyTable),
      characteristics_(new CopyTable),
      facts_(new CopyTable),
      numbers_(new CopyTable),
      open_(new QPushButton)
{
    chart_->setObjectName("seriesChart");
    pictures_->setObjectName("seriesPictures");
    values_->setObjectName("seriesValues");
    characteristics_->setObjectName("seriesCharacteristics");
    open_->setObjectName("openEvaluation");
    primaryViews_->add("chart", chart_);
    primaryViews_->add("pictures", pictures_);
    primaryViews_->add("part", makeDetail());
    primaryViews_->add("values", values_);
    primaryViews_->add("characteristics", characteristics_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    connectViews();
    retranslate();
}

QWidget* SeriesViews::makeDetail()
{
    auto* detail = new QWidget;
    auto* tables = new QSplitter(Qt::Horizontal);
    tables->addWidget(numbers_);
    tables->addWidget(facts_);
    auto* layout = new QVBoxLayout(detail);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(tables, 1);
    layout->addWidget(open_, 0, Qt::AlignLeft);
    return detail;
}

void SeriesViews::connectViews()
{
    connect(chart_, &plot::ChartView::clicked, this, [this](double x, double) {
        if (outcome_ && x >= 0.5) choosePoint(static_cast<std::size_t>(std::lround(x)));
    });
    connect(pictures_, &PicturesView::partChosen, this, &SeriesViews::partChosen);
    connect(pictures_, &PicturesView::partOpened, this, &SeriesViews::partOpened);
    connect(values_, &CopyTable::itemSelectionChanged, this, [this] {
        if (!filling_ && values_->currentRow() >= 0) choosePoint(static_cast<std::size_t>(values_->currentRow()) + 1);
    });
    connect(values_, &CopyTable::cellDoubleClicked, this, [this](int row, int) {
        if (outcome_ && row < static_cast<int>(outcome_->points.size()))
            emit partOpened(outcome_->points[static_cast<std::size_t>(row)].uuid);
    });
    connect(characteristics_, &CopyTable::itemSelectionChanged, this, [this] {
        const int row = characteristics_->currentRow();
        if (filling_ || !outcome_ || row < 0 || row >= static_cast<int>(outcome_->characteristics.size())) return;
        const auto& chosen = outcome_->characteristics[static_cast<std::size_t>(row)];
        emit characteristicChosen(chosen.task, chosen.key);
    });
    connect(open_, &QPushButton::clicked, this, [this] {
        if (outcome_) emit partOpened(outcome_->part.entry.uuid);
    });
    connect(chart_, &plot::PlotWidget::notWritten, this, &SeriesViews::notWritten);
}

void SeriesViews::choosePoint(std::size_t number)
{
    if (!outcome_ || number < 1 || number > outcome_->points.size()) return;
    emit partChosen(outcome_->points[number - 1].uuid);
}

void SeriesViews::setOutcome(const std::shared_ptr<const series::SeriesOutcome>& outcome)
{
    outcome_ = outcome;
    show();
}

void SeriesViews::show()
{
    if (!outcome_) return;
    filling_ = true;
    const Language language = screenLanguage();
    chart_->setData(seriesPlot(*outcome_, language));
    chart_->setMarker(outcome_->shown ? std::optional(static_cast<double>(*outcome_->shown + 1)) : std::nullopt);
    primaryViews_->setAvailable("pictures", !outcome_->pictures.empty());
    pictures_->setPictures(outcome_->pictures, outcome_->part.entry.uuid);
    values_->setTable(valuesTable(*outcome_, language));
    if (outcome_->shown) values_->selectRow(static_cast<int>(*outcome_->shown));
    characteristics_->setTable(characteristicsTable(*outcome_, language));
    for (std::size_t i = 0; i < outcome_->characteristics.size(); ++i)
        if (outcome_->characteristics[i].key == outcome_->chosen.key) characteristics_->selectRow(static_cast<int>(i));
    report::Document detail;
    detail.sections = {{{}, {partTable(*outcome_)}}};
    facts_->setQuantities(detail);
    numbers_->setTable(partCharacteristics(*outcome_, language));
    const bool is_whole = outcome_->as_asked.isWhole();
    open_->setEnabled(is_whole);
    open_->setToolTip(
        is_whole ? QString() : tr("Its files are not there any more, or were changed; the numbers are those of then."));
    filling_ = false;
}

void SeriesViews::retranslate()
{
    primaryViews_->setTitle("chart", tr("Over time"));
    primaryViews_->setTitle("pictures", tr("Deviations"));
    primaryViews_->setTitle("part", tr("Part in detail"));
    primaryViews_->setTitle("values", tr("Values"));
    primaryViews_->setTitle("characteristics", tr("Characteristics"));
    pictures_->setAccessibleName(tr("Deviation pictures of the latest parts"));
    values_->setAccessibleName(tr("Values"));
    characteristics_->setAccessibleName(tr("Characteristics"));
    facts_->setAccessibleName(tr("Part in detail"));
    numbers_->setAccessibleName(tr("Characteristics of the part"));
    open_->setText(tr("Open this evaluation"));
    show();
}

}  // namespace lathelier::series_panel
