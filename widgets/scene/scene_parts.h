// What a SceneView is made of. Included by the .cpp files of SceneView only, because it shows VTK.
#pragma once

#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <QTimer>
#include <algorithm>

#include "widgets/plot/colour_legend.h"
#include "widgets/scene/scene_actor.h"
#include "widgets/scene/scene_bar.h"
#include "widgets/scene/scene_camera.h"
#include "widgets/scene/scene_canvas.h"
#include "widgets/scene/scene_overlay.h"
#include "widgets/scene/scene_pick.h"
#include "widgets/scene/scene_view.h"

namespace lathelier {

/// A box, in the coordinates of some frame.
struct SceneBox {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
};

/// Extent of the objects in the coordinates of `frame`.
SceneBox extent(const std::vector<SceneObject>& objects, const Eigen::Matrix3d& frame);

struct SceneView::Parts {
    SceneCanvas* canvas = nullptr;  ///< null where nothing can be drawn
    vtkNew<vtkPlane> plane;

    SceneBar* bar = nullptr;
    ColourLegend* legend = nullptr;
    SceneRuler* ruler = nullptr;
    SceneLabel* label = nullptr;
    SceneLabel* cross = nullptr;

    std::vector<SceneObject> objects;
    std::vector<std::unique_ptr<SceneActor>> actors;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::optional<SceneAxis> axis;
    DeviationColours colours;
    std::optional<SceneSection> section;
    std::optional<Eigen::Vector3d> marked;

    QTimer rest;
    bool moving = false;
    bool aimed = false;
    std::optional<QPoint> pressedAt;
    QPoint movedTo;
    bool dragging = false;
    std::size_t budget = 80000;
    bool coarse = false;  ///< too slow even with the fewest points: half the resolution while moving
    Speed speed;

    Eigen::Vector3d longest = Eigen::Vector3d::UnitX();  ///< scene axis along which there is most to see

    Eigen::Matrix3d frame() const { return levelFrame(axis ? axis->direction : longest); }
    double aspect() const
    {
        return canvas ? static_cast<double>(std::max(1, canvas->width())) / std::max(1, canvas->height()) : 1;
    }
    SceneCamera camera() const;
    void aim(const SceneCamera& camera);
};

}  // namespace lathelier
