// Parts of a SceneView. Included by the .cpp files of SceneView only, because it shows VTK.
#pragma once

#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <QTimer>
#include <algorithm>

#include "widgets/plot/colour_legend.h"
#include "widgets/plot/pointer_tag.h"
#include "widgets/scene/scene_actor.h"
#include "widgets/scene/scene_bar.h"
#include "widgets/scene/scene_camera.h"
#include "widgets/scene/scene_canvas.h"
#include "widgets/scene/scene_flags.h"
#include "widgets/scene/scene_outline.h"
#include "widgets/scene/scene_overlay.h"
#include "widgets/scene/scene_pick.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::scene {

/// A box, in the coordinates of some frame.
struct SceneBox {
    Eigen::Vector3d low;   ///< smallest coordinates
    Eigen::Vector3d high;  ///< largest coordinates
};

/// Extent of the objects in the coordinates of `frame`.
SceneBox extent(const std::vector<SceneObject>& objects, const Eigen::Matrix3d& frame);

struct SceneView::Parts {
    SceneCanvas* canvas = nullptr;  ///< null without OpenGL
    vtkNew<vtkPlane> plane;         ///< of the section, relative to `origin`

    SceneBar* bar = nullptr;               ///< viewpoints, projection and section
    plot::ColourLegend* legend = nullptr;  ///< colour scale beside the picture
    SceneRuler* ruler = nullptr;           ///< directions of x, y, z and a bar of a round length
    SceneLabel* label = nullptr;           ///< text beside the marked place
    SceneFlags* flags = nullptr;           ///< values at places
    SceneLabel* cross = nullptr;           ///< sign at the marked place

    std::unique_ptr<SceneOutline> outline;            ///< thin lines; null: none
    std::vector<SceneObject> objects;                 ///< as given to setObjects()
    std::vector<std::unique_ptr<SceneActor>> actors;  ///< one for each object, in their order; null: not drawn
    /// Extent of the objects when the view point was chosen; at first that of nothing.
    SceneBox box{Eigen::Vector3d::Constant(HUGE_VAL), Eigen::Vector3d::Constant(HUGE_VAL)};
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< middle of the objects: geometry is uploaded relative to it
    std::optional<SceneAxis> axis;                     ///< long axis of the part; none: `longest`
    report::DeviationColours colours;                  ///< from deviation to colour
    std::optional<SceneSection> section;               ///< drawn section; none: all
    std::optional<Eigen::Vector3d> marked;             ///< place of the marker in the scene; none: no marker

    plot::PointerTag* tag = nullptr;  ///< tag of the object under the resting pointer
    QTimer pointing;                  ///< expires when the pointer rests
    QPoint pointed_at;                ///< resting position of the pointer

    QTimer rest;                             ///< expires some time after the last motion: all points are drawn again
    bool moving = false;                     ///< decimated sets are drawn
    bool aimed = false;                      ///< the camera is set for the present objects
    std::optional<SceneViewpoint> standing;  ///< standard viewpoint that nobody has left: fitted anew at each size
    std::optional<SceneCamera> kept;         ///< camera for the next objects; none: a standard viewpoint
    std::optional<QPoint> pressed_at;        ///< place of the pointer when a button went down; none: no button is down
    QPoint moved_to;                         ///< last place of the pointer with a button down
    bool dragging = false;                   ///< the pointer has moved further than in a click
    std::size_t budget = 80000;  ///< points drawn while moving, by all clouds together; follows the frame times
    bool coarse = false;         ///< too slow even with the fewest points: half the resolution while moving
    Speed speed;                 ///< times of the last frames

    Eigen::Vector3d longest = Eigen::Vector3d::UnitX();  ///< scene axis of the largest extent

    Eigen::Matrix3d frame() const { return levelFrame(axis ? axis->direction : longest); }
    double aspect() const
    {
        return canvas ? static_cast<double>(std::max(1, canvas->width())) / std::max(1, canvas->height()) : 1;
    }
    SceneCamera camera() const;
    void aim(const SceneCamera& camera);
};

}  // namespace lathelier::scene
