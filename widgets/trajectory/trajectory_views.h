// The views of a record: trajectories of axis and tool, error motion, coordinates, signals, all sections in 3-D, and
// what was understood of the record. One angle is marked in all of them.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "engine/trajectory/task/trajectory_task.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/polar_view.h"
#include "widgets/trajectory_common/section_bar.h"

namespace lathelier::scene {
class SceneView;
}

namespace lathelier::trajectory_panel {

class ChannelTable;

class TrajectoryViews : public QWidget {
    Q_OBJECT

public:
    explicit TrajectoryViews(trajectory_common::MarkedAngle& angle, QWidget* parent = nullptr);

    /// `parameters`: those in force.
    void setOutcome(const std::shared_ptr<const trajectory::MotionOutcome>& outcome, bool sectionChosen,
                    const trajectory::TrajectoryParameters& parameters);
    Values view() const;                   ///< section mode, probe, camera: to be kept with the project
    void restoreView(const Values& kept);  ///< as view() gave it; what is missing goes back to its default
    PrimaryViews* primaryViews() const { return primaryViews_; }
    void retranslate();

signals:
    void sectionRequested(std::optional<int> section);
    void mapEdited(const std::string& map);
    void calibrationsEdited(const std::vector<trajectory::ProbeCalibration>& probes);
    void notWritten(const QString& path);

private:
    QWidget* makeMotion();
    QWidget* makeRecord();
    void buildBar();
    void showSection();
    void showMotion();
    void showRecord();
    void showSpace();
    void markAngle();
    void markNear(double x_um, double y_um);
    void markInSpace();

    trajectory_common::MarkedAngle& angle_;
    std::shared_ptr<const trajectory::MotionOutcome> outcome_;
    trajectory::TrajectoryParameters parameters_;
    trajectory_common::SectionBar* section_;
    trajectory_common::AngleBar* angleBar_;
    QCheckBox* all_;
    QLabel* synthetic_;
    PrimaryViews* primaryViews_;
    plot::ChartView* axes_;
    QComboBox* probe_;
    QLabel* motionText_;
    plot::PolarView* motion_;
    plot::ChartView* coordinates_;
    plot::ChartView* signals_;
    scene::SceneView* scene_;
    QLabel* spaceText_;
    ChannelTable* channelTable_;
    QLabel* recordText_;
    std::shared_ptr<const trajectory::TrajectoryResult> inScene_;
};

}  // namespace lathelier::trajectory_panel
