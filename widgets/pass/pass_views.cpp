#include "widgets/pass/pass_views.h"

#include <QVBoxLayout>

#include "engine/stability/stability_plots.h"
#include "widgets/core/language.h"

namespace lathelier::pass_panel {

PassViews::PassViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      limit_(new plot::ChartView),
      map_(new plot::MapView),
      stations_(new CopyTable)
{
    limit_->setObjectName("passLimit");
    map_->setObjectName("passMap");
    stations_->setObjectName("passStations");
    primaryViews_->add("limit", limit_);
    primaryViews_->add("map", map_);
    primaryViews_->add("stations", stations_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    connect(limit_, &plot::ChartView::handleMoved, this,
            [this](const QString& key, double speed_rpm, double depth_mm, bool dropped) {
                if (key == stability::operatingPointKey) emit pointMoved(speed_rpm, depth_mm, dropped);
            });
    connect(map_, &plot::MapView::limitEdited, this, [this](double upper_mm, double) {
        limit_mm_ = upper_mm;
        show();
    });
    connect(limit_, &plot::PlotWidget::notWritten, this, &PassViews::notWritten);
    connect(map_, &plot::PlotWidget::notWritten, this, &PassViews::notWritten);
    retranslate();
}

void PassViews::setOutcome(const std::shared_ptr<const stability::LobesOutcome>& outcome)
{
    outcome_ = outcome;
    show();
}

void PassViews::show()
{
    if (!outcome_) return;
    limit_->setData(passPlot(*outcome_->pass, outcome_->safe));
    report::ColourMap map = passMap(*outcome_->pass);
    const double limit = map.limit;
    map_->setData(std::move(map));
    map_->setColours(report::DeviationColours{limit_mm_.value_or(limit)});
    stations_->setTable(stationsTable(*outcome_->pass));
}

void PassViews::retranslate()
{
    primaryViews_->setTitle("limit", tr("Least limit"));
    primaryViews_->setTitle("map", tr("Along the pass"));
    primaryViews_->setTitle("stations", tr("Stations"));
    stations_->setAccessibleName(tr("Stations"));
    show();
}

}  // namespace lathelier::pass_panel
