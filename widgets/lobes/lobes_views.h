// The views of the lobes: the chart with the operating point to drag, the frequency response, the candidates.
#pragma once

#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/lobes/lobes_picture.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::lobes_panel {

class LobesViews : public QWidget {
    Q_OBJECT

public:
    explicit LobesViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const LobesPicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    plot::ChartView* chart() const { return lobes_; }
    void retranslate();

signals:
    void operatingPointMoved(double speed_rpm, double depth, bool dropped);
    void speedWanted(double speed_rpm);    ///< a candidate was chosen
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    void show();

    std::shared_ptr<const LobesPicture> picture_;
    HeroViews* heroes_;
    plot::ChartView* lobes_;
    plot::ChartView* chatter_;
    plot::ChartView* parts_;
    plot::ChartView* magnitude_;
    CopyTable* candidates_;
};

}  // namespace lathelier::lobes_panel
