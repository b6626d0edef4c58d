// The views of the deflection of the work: the work as it bends over the error along z, its axis with a draggable tool,
// forces, depth, power, the map over depth and feed, sensitivities, measured diameters.
#pragma once

#include <QLabel>
#include <QWidget>
#include <memory>

#include "engine/deflection/deflection_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::deflection_panel {

using deflection::DeflectionOutcome;

class DeflectionViews : public QWidget {
    Q_OBJECT

public:
    explicit DeflectionViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const DeflectionOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* error() const { return error_; }
    plot::ChartView* shape() const { return shape_; }
    plot::ChartView* forces() const { return forces_; }
    plot::ChartView* stock() const { return stock_; }
    CopyTable* findings() const { return findings_; }
    plot::ChartView* map() const { return map_; }
    CopyTable* sensitivities() const { return sensitivities_; }

    /// Tool position: deflected shape, forces and mark follow. At overlapping passes the last one is used.
    void setTool(double z_mm);
    double toolPlace_mm() const { return toolZ_mm_; }

    void retranslate();

signals:
    void notWritten(const QString& path);  ///< the file could not be written

private:
    void show();
    void showTool();
    void showBent(const deflection::DeflectedShape& shape);

    std::shared_ptr<const DeflectionOutcome> outcome_;
    double toolZ_mm_ = 0;
    bool isToolPlaced_ = false;  ///< the tool was placed by the user
    PrimaryViews* primaryViews_;
    scene::SceneView* bent_;
    std::optional<report::DeviationColours> chosenColours_;  ///< scale chosen by the user; none: from the data
    QLabel* remark_;                                         ///< magnification of the bend
    plot::ChartView* error_;
    plot::ChartView* shape_;
    plot::ChartView* forces_;
    plot::ChartView* depth_;
    plot::ChartView* power_;
    plot::ChartView* feed_;
    plot::ChartView* map_;
    plot::ChartView* compliance_;
    plot::ChartView* stock_;
    CopyTable* sensitivities_;
    CopyTable* diameters_;
    CopyTable* findings_;
};

}  // namespace lathelier::deflection_panel
