// The views along the workpiece, linked: all sections as a surface in 3-D, the profile along z, the table of sections.
#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>

#include "engine/report/document.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/longitudinal/longitudinal_charts.h"
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

    void setPicture(const std::shared_ptr<const trajectory_common::SpindlePicture>& picture, bool sectionChosen);
    const StackedSections& stack() const { return stack_; }

    /// The 3-D view for the report; empty without OpenGL.
    std::vector<report::Picture> pictures();

    HeroViews* heroes() const { return heroes_; }

    /// Magnification, what is taken out, and camera, to be kept with the project.
    Values view() const;
    void restoreView(const Values& kept);

    void retranslate();

signals:
    void sectionWanted(std::optional<int> section);
    void notWritten(const QString& path);

private:
    void buildBar();
    void showStack();
    void markPlace();
    void choose(std::size_t vertex);

    trajectory_common::MarkedAngle& angle_;
    std::shared_ptr<const trajectory_common::SpindlePicture> picture_;
    StackedSections stack_;
    std::shared_ptr<const trajectory::TrajectoryResult> stacked_;
    std::optional<double> limit_um_;
    trajectory_common::SectionBar* section_;
    trajectory_common::AngleBar* angleBar_;
    QCheckBox* formOnly_;
    QLabel* magnificationLabel_;
    QDoubleSpinBox* magnification_;
    std::optional<double> chosenMagnification_;  ///< by the user; none: what fits
    QLabel* synthetic_;
    scene::SceneView* scene_;
    plot::ChartView* profile_;
    SectionTable* table_;
    HeroViews* heroes_;
};

}  // namespace lathelier::longitudinal_panel
