// The views of the lobes: the chart with a draggable operating point, the work as it swings, the frequency response,
// the candidates.
#pragma once

#include <QLabel>
#include <QWidget>
#include <memory>

#include "engine/stability/task/lobes_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/panel/swing_button.h"
#include "widgets/plot/chart_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::lobes_panel {

class LobesViews : public QWidget {
    Q_OBJECT

public:
    explicit LobesViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const stability::LobesOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* chart() const { return lobes_; }
    void retranslate();

signals:
    void operatingPointMoved(double speed_rpm, double depth, bool dropped);
    void speedRequested(double speed_rpm);  ///< request to use the speed of a candidate
    void notWritten(const QString& path);   ///< the file could not be written

private:
    void show();
    void showSwing();

    std::shared_ptr<const stability::LobesOutcome> outcome_;
    PrimaryViews* primaryViews_;
    plot::ChartView* lobes_;
    plot::ChartView* chatter_;
    plot::ChartView* parts_;
    plot::ChartView* magnitude_;
    CopyTable* candidates_;
    QWidget* swinging_;  ///< the work, with its remark and button
    scene::SceneView* work_;
    QLabel* remark_;
    SwingButton* play_;
};

}  // namespace lathelier::lobes_panel
