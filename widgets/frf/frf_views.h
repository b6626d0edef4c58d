// The views of a response: magnitude with draggable peaks, phase, parts, Nyquist plot, coherence, error, modes.
#pragma once

#include <QToolButton>
#include <QWidget>
#include <memory>

#include "engine/receptance/task/modes_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::frf_panel {

class FrfViews : public QWidget {
    Q_OBJECT

public:
    explicit FrfViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const receptance::ModesOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* magnitude() const { return magnitude_; }
    plot::ChartView* nyquist() const { return nyquist_; }
    CopyTable* modes() const { return modes_; }
    void retranslate();

signals:
    void modeDragged(int index, double frequency_hz, double magnitude_mm_N, bool dropped);
    void fitRequested();                   ///< request to return to the fitted modes
    void responseRequested();              ///< request to hand the response on
    void notWritten(const QString& path);  ///< the file could not be written

private:
    void show();

    std::shared_ptr<const receptance::ModesOutcome> outcome_;
    QToolButton* use_;
    QToolButton* back_;
    PrimaryViews* primaryViews_;
    plot::ChartView* magnitude_;
    plot::ChartView* phase_;
    plot::ChartView* real_;
    plot::ChartView* imaginary_;
    plot::ChartView* nyquist_;
    plot::ChartView* coherence_;
    plot::ChartView* error_;
    plot::ChartView* stability_;
    CopyTable* shapes_;
    CopyTable* modes_;
};

}  // namespace lathelier::frf_panel
