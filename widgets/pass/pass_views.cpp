#include "widgets/pass/pass_views.h"

#include <QVBoxLayout>

#include "engine/stability/stability_plots.h"
#include "widgets/core/language.h"

namespace lathelier::pass_panel {

PassViews::PassViews(QWidget* parent)
    : QWidget(parent),
      heroes_(new HeroViews),
      limit_(new plot::ChartView),
      map_(new plot::MapView),
      stations_(new CopyTable)
{
    limit_->setObjectName("passLimit");
    map_->setObjectName("passMap");
    stations_->setObjectName("passStations");
    heroes_->add("limit", limit_);
    heroes_->add("map", map_);
    heroes_->add("stations", stations_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(heroes_, 1);
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

void PassViews::setPicture(const std::shared_ptr<const PassPicture>& picture)
{
    picture_ = picture;
    show();
}

void PassViews::show()
{
    if (!picture_) return;
    limit_->setData(passPlot(*picture_->pass, picture_->speed_rpm));
    report::ColourMap map = passMap(*picture_->pass);
    const double limit = map.limit;
    map_->setData(std::move(map));
    map_->setColours(report::DeviationColours{limit_mm_.value_or(limit)});
    stations_->setTable(stationsTable(*picture_->pass));
}

void PassViews::retranslate()
{
    heroes_->setTitle("limit", tr("Least limit"));
    heroes_->setTitle("map", tr("Along the pass"));
    heroes_->setTitle("stations", tr("Stations"));
    stations_->setAccessibleName(tr("Stations"));
    show();
}

}  // namespace lathelier::pass_panel
