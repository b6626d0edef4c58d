// The views of lobes over a pass: the least limit with draggable speed and depth, the depth of cut beyond the limit
// over speed and place, the stations.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "engine/stability/task/lobes_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"

namespace lathelier::pass_panel {

class PassViews : public QWidget {
    Q_OBJECT

public:
    explicit PassViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const stability::LobesOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* limit() const { return limit_; }
    plot::MapView* map() const { return map_; }
    void retranslate();

signals:
    void pointMoved(double speed_rpm, double depth_mm, bool dropped);
    void notWritten(const QString& path);  ///< the file could not be written

private:
    void show();

    std::shared_ptr<const stability::LobesOutcome> outcome_;
    std::optional<double> limit_mm_;  ///< limit of the map's colour scale set by the user
    PrimaryViews* primaryViews_;
    plot::ChartView* limit_;
    plot::MapView* map_;
    CopyTable* stations_;
};

}  // namespace lathelier::pass_panel
