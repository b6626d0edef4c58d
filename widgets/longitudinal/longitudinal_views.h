// The views along the workpiece, linked: all sections as a surface in 3-D, the profile along z, the table of sections.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QWidget>

#include "engine/report/document.h"
#include "widgets/longitudinal/longitudinal_charts.h"
#include "widgets/plot/chart_view.h"
#include "widgets/trajectory_common/section_bar.h"

namespace lathelier {

class SceneView;
class SectionTable;

class LongitudinalViews : public QWidget {
    Q_OBJECT

public:
    explicit LongitudinalViews(MarkedAngle& angle, QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const SpindlePicture>& picture, bool sectionChosen);
    const StackedSections& stack() const { return stack_; }

    /// The 3-D view for the report; empty without OpenGL.
    std::vector<Picture> pictures();

    void retranslate();

signals:
    void sectionWanted(std::optional<int> section);
    void notWritten(const QString& path);

private:
    void buildBar();
    void showStack();
    void markPlace();

    MarkedAngle& angle_;
    std::shared_ptr<const SpindlePicture> picture_;
    StackedSections stack_;
    std::shared_ptr<const trajectory::TrajectoryResult> stacked_;
    std::optional<double> limit_um_;
    SectionBar* section_;
    AngleBar* angleBar_;
    QCheckBox* formOnly_;
    QLabel* magnification_;
    QLabel* synthetic_;
    SceneView* scene_;
    ChartView* profile_;
    SectionTable* table_;
};

}  // namespace lathelier
