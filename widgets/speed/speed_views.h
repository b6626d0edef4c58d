// The views of the recommended speed: the operator's screen, the lobes about it, the candidates, the response.
#pragma once

#include <QWidget>
#include <memory>

#include "engine/stability/task/speed_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/speed/link_bar.h"
#include "widgets/speed/operator_keys.h"

namespace lathelier::speed_panel {

class SpeedViews : public QWidget {
    Q_OBJECT

public:
    explicit SpeedViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const stability::SpeedOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    OperatorKeys* keys() const { return keys_; }
    LinkBar* linkBar() const { return linkBar_; }
    void retranslate();

signals:
    void valueEntered(const QString& key, double value);
    void valueCleared(const QString& key);
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    void show();

    std::shared_ptr<const stability::SpeedOutcome> outcome_;
    PrimaryViews* primaryViews_;
    OperatorKeys* keys_;
    LinkBar* linkBar_;
    plot::ChartView* lobes_;
    plot::ChartView* parts_;
    CopyTable* candidates_;
};

}  // namespace lathelier::speed_panel
