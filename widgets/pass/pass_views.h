// The views of lobes over a pass: the least limit with speed and depth to drag, the depth of cut beyond the limit over
// speed and place, the stations.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/pass/pass_picture.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"

namespace lathelier::pass_panel {

class PassViews : public QWidget {
    Q_OBJECT

public:
    explicit PassViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const PassPicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    plot::ChartView* limit() const { return limit_; }
    plot::MapView* map() const { return map_; }
    void retranslate();

signals:
    void pointMoved(double speed_rpm, double depth_mm, bool dropped);
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    void show();

    std::shared_ptr<const PassPicture> picture_;
    std::optional<double> limit_mm_;  ///< of the map's scale, as the user has set it
    HeroViews* heroes_;
    plot::ChartView* limit_;
    plot::MapView* map_;
    CopyTable* stations_;
};

}  // namespace lathelier::pass_panel
