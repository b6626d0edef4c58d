// The views along the workpiece, linked: all sections as a surface in 3-D, the profile along z, the table of sections.
#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>

#include "engine/report/document.h"
#include "engine/trajectory/stacked_sections.h"
#include "engine/trajectory/task/trajectory_task.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/trajectory_common/section_bar.h"

namespace lathelier::scene {
class SceneView;
}

namespace lathelier::longitudinal_panel {

class SectionTable;

class LongitudinalViews : public QWidget {
    Q_OBJECT

public:
    explicit LongitudinalViews(trajectory_common::MarkedAngle& angle, QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const trajectory::TrajectoryOutcome>& outcome, bool sectionChosen);
    const trajectory::StackedSections& stack() const { return stack_; }

    /// The 3-D view for the report; empty without OpenGL.
    std::vector<report::Picture> pictures();

    PrimaryViews* primaryViews() const { return primaryViews_; }

    /// Magnification, removed components and camera, saved with the project.
    Values view() const;
    void restoreView(const Values& kept);

    void retranslate();

signals:
    void sectionRequested(std::optional<int> section);
    void notWritten(const QString& path);

private:
    void buildBar();
    void showStack();
    void markPlace();
    void choose(std::size_t vertex);

    trajectory_common::MarkedAngle& angle_;
    std::shared_ptr<const trajectory::TrajectoryOutcome> outcome_;
    trajectory::StackedSections stack_;
    std::shared_ptr<const trajectory::TrajectoryResult> stacked_;
    std::optional<double> limit_um_;
    trajectory_common::SectionBar* section_;
    trajectory_common::AngleBar* angleBar_;
    QCheckBox* formOnly_;
    QLabel* magnificationLabel_;
    QDoubleSpinBox* magnification_;
    std::optional<double> chosenMagnification_;  ///< magnification chosen by the user; none: automatic
    QLabel* synthetic_;
    scene::SceneView* scene_;
    plot::ChartView* profile_;
    SectionTable* table_;
    PrimaryViews* primaryViews_;
};

}  // namespace lathelier::longitudinal_panel
