// The views of a cylindricity, linked: part, unrolled surface, local radius, axis, numbers. A place picked in one is
// marked in all.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <memory>
#include <optional>

#include "engine/core/skin.h"
#include "engine/form/task/cylindricity_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::cylindricity_panel {

class CylindricityViews : public QWidget {
    Q_OBJECT

public:
    explicit CylindricityViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const form::CylindricityOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }

    /// The camera, saved with the project.
    Values view() const;
    void restoreView(const Values& kept);

    /// Marks the place at this z and angle of the cylinder in all views.
    void markPlace(double z_mm, double angle_deg);
    std::optional<QPointF> place() const { return place_; }  ///< z in mm and angle in degrees

    void retranslate();

signals:
    void sectionRequested(double z_mm);    ///< request for the roundness of the marked section
    void notWritten(const QString& path);  ///< the file could not be written

private:
    void showPart();
    void showMagnification();
    void showCharts();
    void showPlace();
    void recolour(double upper_um, double lower_um);

    std::shared_ptr<const form::CylindricityOutcome> outcome_;
    std::optional<QPointF> place_;
    Skin skin_;          ///< of the surface, in the frame of its axis
    double factor_ = 1;  ///< magnification of its error in the scene
    QLabel* remark_;
    QToolButton* section_;
    QLabel* synthetic_;
    scene::SceneView* scene_;
    plot::MapView* map_;
    plot::ChartView* radius_;
    plot::ChartView* axis_;
    CopyTable* numbers_;
    PrimaryViews* primaryViews_;
};

}  // namespace lathelier::cylindricity_panel
