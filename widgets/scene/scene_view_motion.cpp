// Interaction of a SceneView: mouse and keys, decimation, frame times, picking.
#include <vtkCamera.h>

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <cmath>

#include "widgets/scene/scene_parts.h"

namespace lathelier::scene {
namespace {

constexpr double turnOverHeight_deg = 200;  // a drag over the height of the picture turns the part round to its back
constexpr double zoomOverHeight = 3;        // … or makes it e³ times larger
constexpr double zoomOverNotch = 1.15;
constexpr int clickReach_px = 3;
constexpr double farReach_px = 24;
constexpr double reach_px = 6;                // how far from the pointer a point of a cloud may lie
constexpr std::size_t mostHovered = 3000000;  // larger clouds are not searched while hovering, for responsiveness
constexpr double slowFrame_s = 0.050;
constexpr double quickFrame_s = 0.025;
constexpr double slowestFrame_s = 0.066;  // 15 frames in a second
constexpr std::size_t fewestMoving = 10000;
constexpr std::size_t mostMoving = 400000;

}  // namespace

void SceneView::startMoving()
{
    Parts& p = *parts_;
    p.rest.stop();
    if (p.moving) return;
    p.moving = true;
    shareDetail();
    for (const auto& actor : p.actors)
        if (actor) actor->setMoving(true);
}

void SceneView::endMoving()
{
    Parts& p = *parts_;
    if (!p.moving) return;
    p.moving = false;
    shareDetail();
    for (const auto& actor : p.actors)
        if (actor) actor->setMoving(false);
    render();
}

void SceneView::turn(double right_deg, double up_deg)
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    startMoving();
    p.standing.reset();
    vtkCamera* eye = p.canvas->renderer().GetActiveCamera();
    eye->Azimuth(-right_deg);
    eye->Elevation(-up_deg);
    eye->OrthogonalizeViewUp();
    render();
    p.rest.start();
}

void SceneView::zoom(double factor)
{
    Parts& p = *parts_;
    startMoving();
    p.standing.reset();
    vtkCamera* eye = p.canvas->renderer().GetActiveCamera();
    if (isParallel())
        eye->SetParallelScale(eye->GetParallelScale() / factor);
    else
        eye->Dolly(factor);
    render();
    p.rest.start();
}

void SceneView::drag(const QPoint& to, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys)
{
    Parts& p = *parts_;
    const QPointF way = QPointF(to - p.moved_to) / std::max(1, p.canvas->height());
    p.moved_to = to;
    startMoving();
    if (buttons & Qt::RightButton) return zoom(std::exp(-zoomOverHeight * way.y()));
    if (!(buttons & Qt::MiddleButton) && !(keys & Qt::ShiftModifier))
        return turn(turnOverHeight_deg * way.x(), -turnOverHeight_deg * way.y());
    p.standing.reset();
    SceneCamera camera = p.camera();
    const Eigen::Vector3d shift(2 * camera.half_height_mm * way.x(), -2 * camera.half_height_mm * way.y(), 0);
    camera.view_T_scene.pretranslate(shift);
    p.aim(camera);
    render();
    p.rest.start();
}

void SceneView::frameDone(double taken_s)
{
    Parts& p = *parts_;
    (p.moving ? p.speed.moving_s : p.speed.resting_s) = taken_s;
    if (p.moving && (taken_s > slowFrame_s || taken_s < quickFrame_s)) {
        p.budget =
            std::clamp(static_cast<std::size_t>(static_cast<double>(p.budget) * (taken_s > slowFrame_s ? 0.7 : 1.3)),
                       fewestMoving, mostMoving);
        shareBudget();
    }
    if (p.moving && taken_s > slowestFrame_s && p.budget == fewestMoving)
        p.coarse = true;
    else if (p.moving && taken_s < slowFrame_s / 4)  // full resolution would still be fast enough
        p.coarse = false;
    shareDetail();
    placeOverlays();
}

void SceneView::shareDetail()
{
    Parts& p = *parts_;
    // The finer pixels of a dense screen are for the picture at rest.
    p.canvas->setDetail(p.moving ? (p.coarse ? 0.5 : 1) / p.canvas->devicePixelRatioF() : 1);
}

void SceneView::shareBudget()
{
    Parts& p = *parts_;
    std::size_t clouds = 0;
    for (const auto& actor : p.actors) clouds += actor && actor->isThinned();
    p.speed.moving_points = 0;
    for (const auto& actor : p.actors) {
        if (!actor) continue;
        const std::size_t share = p.budget / std::max<std::size_t>(1, clouds);
        actor->setBudget(share);
        if (actor->isThinned()) p.speed.moving_points += std::min(share, actor->thinnedCount());
    }
}

/// Object at a position of the image: a point of a cloud, a place on a mesh, or nothing.
struct SceneView::Under {
    int object = -1;
    std::optional<ScenePick> point;
    std::optional<SceneHit> hit;
};

SceneView::Under SceneView::under(const QPoint& place) const
{
    const Parts& p = *parts_;
    const QSize room = p.canvas->size();
    const Eigen::Vector2d pointer(2.0 * (place.x() + 0.5) / room.width() - 1,
                                  1 - 2.0 * (place.y() + 0.5) / room.height());
    const SceneCamera camera = p.camera();
    Under found;
    double depth_mm = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < p.objects.size(); ++i) {
        const SceneObject& object = p.objects[i];
        if (!object.visible) continue;
        if (object.scan->isMesh()) {
            const auto hit = firstHit(*object.scan, object.scene_T_scan, camera, p.section, pointer);
            if (!hit || hit->depth_mm >= depth_mm) continue;
            depth_mm = hit->depth_mm;
            found = {static_cast<int>(i), {}, hit};
        } else {
            const auto& points = object.scan->points_mm;
            auto point =
                nearestVisible(points, object.scene_T_scan, camera, p.section, pointer, reach_px, room.height());
            if (!point)  // a cloud of few points
                point =
                    nearestVisible(points, object.scene_T_scan, camera, p.section, pointer, farReach_px, room.height());
            if (!point || point->depth_mm >= depth_mm) continue;
            depth_mm = point->depth_mm;
            found = {static_cast<int>(i), point, {}};
        }
    }
    return found;
}

void SceneView::pick(const QPoint& place)
{
    const Under found = under(place);
    if (found.hit)
        emit surfacePicked(found.object, found.hit->place);
    else if (found.point)
        emit pointPicked(found.object, static_cast<qint64>(found.point->index));
}

void SceneView::hover(const QPoint& place)
{
    Parts& p = *parts_;
    std::size_t points = 0;
    for (const SceneObject& object : p.objects) points += object.visible ? object.scan->points_mm.size() : 0;
    p.tag->say({}, {});
    if (p.moving || p.pressed_at || points > mostHovered) return;
    const Under found = under(place);
    if (found.hit)
        emit surfaceHovered(found.object, found.hit->place);
    else if (found.point)
        emit pointHovered(found.object, static_cast<qint64>(found.point->index));
}

bool SceneView::eventFilter(QObject* watched, QEvent* event)
{
    Parts& p = *parts_;
    switch (event->type()) {
        case QEvent::MouseButtonPress: {
            const QPoint place = static_cast<QMouseEvent*>(event)->pos();
            p.pressed_at = place;
            p.moved_to = place;
            p.dragging = false;
            return false;
        }
        case QEvent::MouseMove: {
            auto* mouse = static_cast<QMouseEvent*>(event);
            p.tag->say({}, {});
            if (!p.pressed_at || !mouse->buttons()) {
                p.pointed_at = mouse->pos();
                p.pointing.start();
                return true;
            }
            p.dragging = p.dragging || (mouse->pos() - *p.pressed_at).manhattanLength() > clickReach_px;
            if (p.dragging) drag(mouse->pos(), mouse->buttons(), mouse->modifiers());
            return true;
        }
        case QEvent::MouseButtonRelease: {
            auto* mouse = static_cast<QMouseEvent*>(event);
            const bool still = p.pressed_at && !p.dragging;
            p.pressed_at.reset();
            p.dragging = false;
            if (still && mouse->button() == Qt::LeftButton) pick(mouse->pos());
            if (still && mouse->button() == Qt::RightButton) showMenu(mouse->pos());  // moved: it has zoomed
            return true;
        }
        case QEvent::MouseButtonDblClick: setViewpoint(SceneViewpoint::Oblique); return true;
        case QEvent::Wheel:
            zoom(std::pow(zoomOverNotch, static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0));
            return true;
        case QEvent::ContextMenu: {
            auto* menu = static_cast<QContextMenuEvent*>(event);
            if (menu->reason() != QContextMenuEvent::Mouse) showMenu(menu->pos());
            return true;
        }
        case QEvent::Leave:
            p.pointing.stop();
            p.tag->say({}, {});
            break;
        case QEvent::Resize: placeOverlays(); break;
        case QEvent::KeyPress: {
            switch (static_cast<QKeyEvent*>(event)->key()) {
                case Qt::Key_Left: turn(-5, 0); return true;
                case Qt::Key_Right: turn(5, 0); return true;
                case Qt::Key_Up: turn(0, 5); return true;
                case Qt::Key_Down: turn(0, -5); return true;
                case Qt::Key_Home: setViewpoint(SceneViewpoint::Oblique); return true;
                default: break;
            }
            break;
        }
        default: break;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace lathelier::scene
