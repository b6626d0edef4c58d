// The views of a spindle: its receptance over frequency, and how well it was identified.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <memory>

#include "engine/receptance/task/spindle_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::machine_panel {

class MachineViews : public QWidget {
    Q_OBJECT

public:
    explicit MachineViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const receptance::SpindleOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* magnitude() const { return magnitude_; }
    plot::ChartView* heldOut() const { return heldOut_; }
    void setPresenting(bool presenting);  ///< without the button
    void retranslate();

signals:
    void spindleRequested();               ///< give it to another panel
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    void show();

    std::shared_ptr<const receptance::SpindleOutcome> outcome_;
    PrimaryViews* primaryViews_;
    plot::ChartView* magnitude_;
    plot::ChartView* phase_;
    plot::ChartView* heldOut_;
    plot::ChartView* residual_;
    plot::ChartView* condition_;
    CopyTable* responses_;
    QPushButton* use_;
};

}  // namespace lathelier::machine_panel
