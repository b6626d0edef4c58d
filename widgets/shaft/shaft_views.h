// The views of a shaft: its drawing with draggable ends, animated mode shapes, response and frequencies.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <memory>

#include "engine/receptance/task/shaft_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/panel/swing_button.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::shaft_panel {

class ShaftViews : public QWidget {
    Q_OBJECT

public:
    explicit ShaftViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const receptance::ShaftOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* drawing() const { return drawing_; }
    plot::ChartView* shapes() const { return shapes_; }
    void setPresenting(bool presenting);  ///< hides the buttons
    void retranslate();

signals:
    void endMoved(std::size_t segment, double z_mm, double radius_mm, bool dropped);
    void shaftRequested();                 ///< request to store the shaft in the project
    void responseRequested();              ///< request to hand the response to another panel
    void notWritten(const QString& path);  ///< the file could not be written

private:
    void show();
    void swing();

    std::shared_ptr<const receptance::ShaftOutcome> outcome_;
    PrimaryViews* primaryViews_;
    plot::ChartView* drawing_;
    plot::ChartView* shapes_;
    plot::ChartView* magnitude_;
    plot::ChartView* parts_;
    CopyTable* frequencies_;
    QWidget* buttons_;
    SwingButton* play_;
    QPushButton* shaft_;
    QPushButton* response_;
};

}  // namespace lathelier::shaft_panel
