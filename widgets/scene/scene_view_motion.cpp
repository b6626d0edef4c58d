// SceneView while it is moved: mouse and keys, thinning, frame times, picking.
#include <vtkCamera.h>

#include <QMouseEvent>
#include <cmath>

#include "widgets/scene/scene_parts.h"

namespace lathelier {
namespace {

constexpr double slowFrame_s = 0.050;
constexpr double quickFrame_s = 0.025;
constexpr std::size_t fewestMoving = 10000;
constexpr std::size_t mostMoving = 400000;

}  // namespace

void SceneView::startMoving()
{
    Parts& p = *parts_;
    p.rest.stop();
    if (p.moving) return;
    p.moving = true;
    for (const auto& actor : p.actors) actor->setMoving(true);
}

void SceneView::endMoving()
{
    Parts& p = *parts_;
    if (!p.moving) return;
    p.moving = false;
    for (const auto& actor : p.actors) actor->setMoving(false);
    render();
}

void SceneView::turn(double right_deg, double up_deg)
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    startMoving();
    vtkCamera* eye = p.renderer->GetActiveCamera();
    eye->Azimuth(-right_deg);
    eye->Elevation(-up_deg);
    eye->OrthogonalizeViewUp();
    render();
    p.rest.start();
}

void SceneView::frameDone()
{
    Parts& p = *parts_;
    p.window->WaitForCompletion();  // the time counts until the last pixel is there
    const double taken_s = static_cast<double>(p.frameTime.nsecsElapsed()) * 1e-9;
    (p.moving ? p.speed.moving_s : p.speed.resting_s) = taken_s;
    if (p.moving && (taken_s > slowFrame_s || taken_s < quickFrame_s)) {
        p.budget =
            std::clamp(static_cast<std::size_t>(static_cast<double>(p.budget) * (taken_s > slowFrame_s ? 0.7 : 1.3)),
                       fewestMoving, mostMoving);
        shareBudget();
    }
    layOver();
}

void SceneView::shareBudget()
{
    Parts& p = *parts_;
    std::size_t clouds = 0;
    for (const auto& actor : p.actors) clouds += actor->object().visible && actor->isThinned();
    p.speed.movingPoints = 0;
    for (const auto& actor : p.actors) {
        const std::size_t share = p.budget / std::max<std::size_t>(1, clouds);
        actor->setBudget(share);
        if (actor->object().visible && actor->isThinned())
            p.speed.movingPoints += std::min(share, actor->thinnedCount());
    }
}

void SceneView::pick(const QPoint& place)
{
    Parts& p = *parts_;
    const QSize room = p.canvas->size();
    const Eigen::Vector2d pointer(2.0 * (place.x() + 0.5) / room.width() - 1,
                                  1 - 2.0 * (place.y() + 0.5) / room.height());
    const SceneCamera camera = p.camera();
    for (const double radius_px : {6.0, 24.0}) {  // the wide one for meshes with few corners
        std::optional<ScenePick> best;
        int object = -1;
        for (std::size_t i = 0; i < p.objects.size(); ++i) {
            if (!p.objects[i].visible) continue;
            const auto found = nearestVisible(p.objects[i].scan->points_mm, p.objects[i].scene_T_scan, camera,
                                              p.section, pointer, radius_px, room.height());
            if (!found || (best && found->depth_mm >= best->depth_mm)) continue;
            best = found;
            object = static_cast<int>(i);
        }
        if (best) return emit pointPicked(object, static_cast<qint64>(best->index));
    }
}

bool SceneView::eventFilter(QObject* watched, QEvent* event)
{
    Parts& p = *parts_;
    switch (event->type()) {
        case QEvent::MouseButtonPress: p.pressedAt = static_cast<QMouseEvent*>(event)->pos(); break;
        case QEvent::MouseMove: {
            auto* mouse = static_cast<QMouseEvent*>(event);
            if (!p.pressedAt || !mouse->buttons()) return true;  // VTK has no use for hovering
            if ((mouse->pos() - *p.pressedAt).manhattanLength() > 3) startMoving();
            break;
        }
        case QEvent::MouseButtonRelease: {
            auto* mouse = static_cast<QMouseEvent*>(event);
            const bool still = p.pressedAt && (mouse->pos() - *p.pressedAt).manhattanLength() <= 3;
            p.pressedAt.reset();
            p.rest.start();
            if (still && mouse->button() == Qt::LeftButton) pick(mouse->pos());
            break;
        }
        case QEvent::MouseButtonDblClick: setViewpoint(SceneViewpoint::Oblique); return true;
        case QEvent::Wheel:
            startMoving();
            p.rest.start();
            break;
        case QEvent::Resize: layOver(); break;
        case QEvent::KeyPress: {
            switch (static_cast<QKeyEvent*>(event)->key()) {
                case Qt::Key_Left: turn(-5, 0); return true;
                case Qt::Key_Right: turn(5, 0); return true;
                case Qt::Key_Up: turn(0, 5); return true;
                case Qt::Key_Down: turn(0, -5); return true;
                case Qt::Key_Home: setViewpoint(SceneViewpoint::Oblique); return true;
                default: break;
            }
            event->ignore();  // VTK's own keys (quit, wireframe…) stay off; shortcuts go on to the window
            return true;
        }
        default: break;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace lathelier
