// The views of a cylindricity, linked: part, unrolled surface, local radius, axis, numbers. A place picked in one is
// marked in all.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <memory>
#include <optional>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/cylindricity/cylindricity_picture.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::cylindricity_panel {

class CylindricityViews : public QWidget {
    Q_OBJECT

public:
    explicit CylindricityViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const CylindricityPicture>& picture);
    HeroViews* heroes() const { return heroes_; }

    /// The camera, to be kept with the project.
    Values view() const;
    void restoreView(const Values& kept);

    /// Marks the place at this z and angle of the cylinder in all views.
    void markPlace(double z_mm, double angle_deg);
    std::optional<QPointF> place() const { return place_; }  ///< z in mm and angle in degrees

    void retranslate();

signals:
    void sectionWanted(double z_mm);       ///< the user wants the roundness of the marked section
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    void showPart();
    void showCharts();
    void showPlace();
    void recolour(double upper_um, double lower_um);

    std::shared_ptr<const CylindricityPicture> picture_;
    std::optional<QPointF> place_;
    QLabel* remark_;
    QToolButton* section_;
    QLabel* synthetic_;
    scene::SceneView* scene_;
    plot::MapView* map_;
    plot::ChartView* radius_;
    plot::ChartView* axis_;
    CopyTable* numbers_;
    HeroViews* heroes_;
};

}  // namespace lathelier::cylindricity_panel
