// The views of a tap test: signals with the hits, spectrum of the force, magnitude, phase, coherence, table of the
// hits.
#pragma once

#include <QToolButton>
#include <QWidget>
#include <memory>

#include "engine/receptance/task/tap_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::tap_panel {

class TapViews : public QWidget {
    Q_OBJECT

public:
    explicit TapViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const receptance::TapOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* force() const { return force_; }
    plot::ChartView* magnitude() const { return magnitude_; }
    CopyTable* hits() const { return hits_; }
    void retranslate();

signals:
    void responseRequested();              ///< request to hand the response on
    void notWritten(const QString& path);  ///< the file could not be written

private:
    void show();

    std::shared_ptr<const receptance::TapOutcome> outcome_;
    QToolButton* use_;
    PrimaryViews* primaryViews_;
    plot::ChartView* force_;
    plot::ChartView* motion_;
    plot::ChartView* spectrum_;
    plot::ChartView* magnitude_;
    plot::ChartView* phase_;
    plot::ChartView* coherence_;
    CopyTable* hits_;
};

}  // namespace lathelier::tap_panel
