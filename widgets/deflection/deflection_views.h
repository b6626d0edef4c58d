// The views of the deflection of the work: the error along z over the bent work with a tool to drag, forces, depth,
// power, the map over depth and feed, sensitivities, measured diameters.
#pragma once

#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/deflection_common/deflection_picture.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::deflection_panel {

using deflection_common::DeflectionPicture;

class DeflectionViews : public QWidget {
    Q_OBJECT

public:
    explicit DeflectionViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const DeflectionPicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    plot::ChartView* error() const { return error_; }
    plot::ChartView* shape() const { return shape_; }
    plot::ChartView* forces() const { return forces_; }
    plot::ChartView* stock() const { return stock_; }
    CopyTable* findings() const { return findings_; }
    plot::ChartView* map() const { return map_; }
    CopyTable* sensitivities() const { return sensitivities_; }

    /// Where the tool stands: shape, forces and the mark follow. Between passes the last one counts.
    void setTool(double z_mm);
    double toolPlace_mm() const { return tool_z_mm_; }

    void retranslate();

signals:
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    void show();
    void showTool();

    std::shared_ptr<const DeflectionPicture> picture_;
    double tool_z_mm_ = 0;
    bool is_tool_placed_ = false;  ///< by the user
    HeroViews* heroes_;
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
