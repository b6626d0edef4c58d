// Views of one cut: lobes over the growth map with a draggable operating point, waveform, waves, surface, response,
// spectrum, spindle, both relations, the reasons, and the cut of an exercise.
#pragma once

#include <QTextBrowser>
#include <QWidget>
#include <memory>

#include "engine/training/exercise.h"
#include "engine/training/task/training_task.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/training/raster_filler.h"
#include "widgets/training/spindle_view.h"

namespace lathelier::training_panel {

class TrainingViews : public QWidget {
    Q_OBJECT

public:
    explicit TrainingViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const training::TrainingOutcome>& outcome);
    void setTime(double time_s);  ///< in the cut: marks it in the waveform, shows its revolution

    /// A cut or a blow of an exercise, on a machine that is hidden; null: none is shown.
    void setListened(std::shared_ptr<const stability::SimulationResult> cut);
    void setBlow(const training::Decay& blow);
    void clearExercise();

    /// The views of a step: what it speaks of large, the lobe chart always beside it. Empty: as the user arranges them.
    void showStep(const QStringList& keys);
    static QString alwaysShown();  ///< key of the lobe chart

    /// While an exercise runs what would give its answer away is hidden.
    void setExercising(bool exercising);
    bool isExercising() const { return isExercising_; }

    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* lobes() const { return lobes_; }
    plot::ChartView* waves() const { return waves_; }
    const RasterFiller& filler() const { return filler_; }
    /// Every plot with its key, for pictures of all of them.
    std::vector<std::pair<QString, plot::PlotWidget*>> plots() const;
    void retranslate();

signals:
    void pointMoved(double speed_rpm, double depth_mm, bool dropped);
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    bool isOpen() const;  ///< the charts that say where it chatters are shown
    void showCharts();
    void showLobes();
    void showCut();
    void showRevolution();
    void showListened();
    void showWhy();

    std::shared_ptr<const training::TrainingOutcome> outcome_;
    std::shared_ptr<const stability::SimulationResult> listened_;
    std::optional<training::Decay> blow_;
    double time_s_ = 0;
    int revolution_ = -1;
    bool isExercising_ = false;
    PrimaryViews* primaryViews_;
    plot::ChartView* lobes_;
    plot::ChartView* growth_;
    plot::ChartView* waveform_;
    plot::ChartView* waves_;
    plot::MapView* surface_;
    plot::ChartView* frf_;
    SpindleView* spindle_;
    plot::ChartView* spectrum_;
    plot::ChartView* comparison_;
    QTextBrowser* why_;
    QWidget* exercise_;
    plot::ChartView* heardWave_;
    plot::ChartView* heardTurn_;
    RasterFiller filler_;
};

}  // namespace lathelier::training_panel
