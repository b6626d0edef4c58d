#include "widgets/scene/scene_view.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "engine/core/parallel.h"
#include "widgets/plot/colour_legend.h"
#include "widgets/plot/plot_style.h"
#include "widgets/scene/scene_actor.h"
#include "widgets/scene/scene_bar.h"
#include "widgets/scene/scene_camera.h"
#include "widgets/scene/scene_overlay.h"

namespace lathelier {
namespace {

constexpr int restAfter_ms = 250;
constexpr double slowFrame_s = 0.050;
constexpr double quickFrame_s = 0.025;
constexpr std::size_t fewestMoving = 10000;
constexpr std::size_t mostMoving = 400000;

bool openGlIsThere()
{
    const QString platform = QGuiApplication::platformName();
    if (platform == "offscreen" || platform == "minimal") return false;
    QOpenGLContext context;
    return context.create();
}

struct Box {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
};

/// Extent of the visible objects in the coordinates of `frame`.
Box extent(const std::vector<SceneObject>& objects, const Eigen::Matrix3d& frame)
{
    Box box;
    for (const SceneObject& object : objects) {
        const auto& points = object.scan->points_mm;
        const Eigen::Isometry3d toFrame = Eigen::Isometry3d(frame.transpose()) * object.scene_T_scan;
        box = parallelReduce(
            points.size(), 65536, {}, box,
            [&](std::size_t begin, std::size_t end) {
                Box part;
                for (std::size_t i = begin; i < end; ++i) {
                    const Eigen::Vector3d p = toFrame * points[i];
                    part.low = part.low.cwiseMin(p);
                    part.high = part.high.cwiseMax(p);
                }
                return part;
            },
            [](const Box& a, const Box& b) {
                return Box{a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
            });
    }
    if (!(box.low.array() <= box.high.array()).all())
        return {Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1)};
    return box;
}

}  // namespace

struct SceneView::Parts {
    QVTKOpenGLNativeWidget* canvas = nullptr;  ///< null where nothing can be drawn
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkPlane> plane;
    vtkNew<vtkCallbackCommand> frameObserver;

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
    QElapsedTimer frameTime;
    bool moving = false;
    bool aimed = false;
    std::optional<QPoint> pressedAt;
    std::size_t budget = 80000;
    Speed speed;

    Eigen::Matrix3d frame() const { return levelFrame(axis ? axis->direction : Eigen::Vector3d::UnitX()); }
    double aspect() const
    {
        return canvas ? static_cast<double>(std::max(1, canvas->width())) / std::max(1, canvas->height()) : 1;
    }
    SceneCamera camera() const;
    void aim(const SceneCamera& camera);
};

SceneCamera SceneView::Parts::camera() const
{
    vtkCamera* eye = renderer->GetActiveCamera();
    const Eigen::Vector3d place = Eigen::Vector3d(eye->GetPosition()) + origin;
    const Eigen::Vector3d target = Eigen::Vector3d(eye->GetFocalPoint()) + origin;
    SceneCamera camera;
    Eigen::Matrix3d rows;
    rows.row(2) = (place - target).normalized();
    rows.row(0) = Eigen::Vector3d(eye->GetViewUp()).cross(rows.row(2).transpose()).normalized();
    rows.row(1) = rows.row(2).cross(rows.row(0));
    camera.view_T_scene.linear() = rows;
    camera.view_T_scene.translation() = -(rows * place);
    camera.distance_mm = (place - target).norm();
    camera.parallel = eye->GetParallelProjection() != 0;
    camera.halfHeight_mm =
        camera.parallel ? eye->GetParallelScale() : camera.distance_mm * std::tan(eye->GetViewAngle() * M_PI / 360);
    camera.aspect = aspect();
    return camera;
}

void SceneView::Parts::aim(const SceneCamera& camera)
{
    vtkCamera* eye = renderer->GetActiveCamera();
    const Eigen::Isometry3d scene_T_view = camera.view_T_scene.inverse();
    const Eigen::Vector3d place = scene_T_view.translation() - origin;
    const Eigen::Vector3d target = scene_T_view * Eigen::Vector3d(0, 0, -camera.distance_mm) - origin;
    const Eigen::Vector3d up = scene_T_view.linear().col(1);
    eye->SetPosition(place.data());
    eye->SetFocalPoint(target.data());
    eye->SetViewUp(up.data());
    eye->SetParallelProjection(camera.parallel);
    eye->SetParallelScale(camera.halfHeight_mm);
    eye->SetViewAngle(2 * std::atan(camera.halfHeight_mm / camera.distance_mm) * 180 / M_PI);
}

void SceneView::prepareApplication()
{
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    format.setSamples(0);  // software rendering pays for every sample
    QSurfaceFormat::setDefaultFormat(format);
}

SceneView::SceneView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>())
{
    Parts& p = *parts_;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    if (!openGlIsThere()) {
        auto* words =
            new QLabel(tr("The 3-D view needs OpenGL, which is not available here.\nAll other views work."), this);
        words->setAlignment(Qt::AlignCenter);
        words->setWordWrap(true);
        layout->addWidget(words, 1);
        return;
    }
    p.bar = new SceneBar(this);
    p.canvas = new QVTKOpenGLNativeWidget(this);
    layout->addWidget(p.bar);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    layout->addLayout(row, 1);
    row->addWidget(p.canvas, 1);
    p.window->SetMultiSamples(0);
    p.canvas->setRenderWindow(p.window.Get());
    p.window->AddRenderer(p.renderer);
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    p.window->GetInteractor()->SetInteractorStyle(style);
    p.canvas->installEventFilter(this);
    p.canvas->setFocusPolicy(Qt::StrongFocus);
    p.canvas->setAccessibleName(tr("3-D view"));
    setFocusProxy(p.canvas);

    p.legend = new ColourLegend(this);
    p.legend->setAutoFillBackground(true);
    row->addWidget(p.legend);
    p.ruler = new SceneRuler(p.canvas);
    p.label = new SceneLabel(p.canvas);
    p.cross = new SceneLabel(p.canvas);
    p.cross->setAutoFillBackground(false);
    p.cross->setFrameShape(QFrame::NoFrame);
    p.cross->setText(QStringLiteral("⊕"));
    p.legend->hide();
    connect(p.legend, &ColourLegend::limitEdited, this, &SceneView::limitEdited);
    connect(p.bar, &SceneBar::viewpointWanted, this, &SceneView::setViewpoint);
    connect(p.bar, &SceneBar::parallelWanted, this, &SceneView::setParallel);
    connect(p.bar, &SceneBar::sectionWanted, this, [this](int sceneAxis, double share) {
        if (sceneAxis < 0)
            clearSection();
        else
            setSection(sceneAxis, share);
    });
    p.rest.setSingleShot(true);
    p.rest.setInterval(restAfter_ms);
    connect(&p.rest, &QTimer::timeout, this, &SceneView::endMoving);

    p.frameObserver->SetClientData(this);
    p.frameObserver->SetCallback([](vtkObject*, unsigned long event, void* self, void*) {
        auto* view = static_cast<SceneView*>(self);
        if (event == vtkCommand::StartEvent)
            view->parts_->frameTime.start();
        else
            view->frameDone();
    });
    p.renderer->AddObserver(vtkCommand::StartEvent, p.frameObserver);
    p.renderer->AddObserver(vtkCommand::EndEvent, p.frameObserver);
    applyStyle(false);
}

SceneView::~SceneView()
{
    parts_->renderer->RemoveObserver(parts_->frameObserver);
    if (parts_->canvas) parts_->canvas->removeEventFilter(this);
    parts_->actors.clear();
}

bool SceneView::canDraw() const
{
    return parts_->canvas != nullptr;
}
const std::vector<SceneObject>& SceneView::objects() const
{
    return parts_->objects;
}
bool SceneView::isParallel() const
{
    return parts_->renderer->GetActiveCamera()->GetParallelProjection() != 0;
}
std::optional<Eigen::Vector3d> SceneView::marker() const
{
    return parts_->marked;
}
SceneView::Speed SceneView::speed() const
{
    return parts_->speed;
}

void SceneView::setObjects(std::vector<SceneObject> objects)
{
    Parts& p = *parts_;
    const bool fresh = p.objects.empty() || objects.empty() || p.objects.front().scan != objects.front().scan;
    p.objects = std::move(objects);
    if (!canDraw()) return;
    if (fresh) {
        p.actors.clear();
        const Box box = extent(p.objects, Eigen::Matrix3d::Identity());
        p.origin = (box.low + box.high) / 2;
        p.aimed = false;
    }
    std::vector<std::unique_ptr<SceneActor>> kept = std::move(p.actors);
    p.actors.clear();
    for (const SceneObject& object : p.objects) {
        std::unique_ptr<SceneActor> actor;
        for (auto& old : kept)
            if (old && old->sameGeometry(object)) {
                actor = std::move(old);
                break;
            }
        if (!actor) actor = std::make_unique<SceneActor>(p.renderer, object, p.origin, p.axis);
        actor->setMoving(p.moving);
        p.actors.push_back(std::move(actor));
    }
    kept.clear();
    bool valued = false;
    for (std::size_t i = 0; i < p.actors.size(); ++i) {
        p.actors[i]->update(p.objects[i], p.colours, p.axis);
        valued = valued || (p.objects[i].visible && p.objects[i].values);
    }
    p.legend->setVisible(valued);
    shareBudget();
    applySection();
    if (!p.aimed)
        setViewpoint(SceneViewpoint::Oblique);
    else
        render();
}

void SceneView::setLongAxis(const std::optional<SceneAxis>& axis)
{
    const bool news = axis.has_value() != parts_->axis.has_value() ||
                      (axis && (axis->direction - parts_->axis->direction).norm() > 1e-2);
    parts_->axis = axis;
    if (news) parts_->aimed = false;
}

void SceneView::setColours(const DeviationColours& colours)
{
    Parts& p = *parts_;
    if (p.colours == colours && canDraw()) return p.legend->setColours(colours);
    p.colours = colours;
    if (!canDraw()) return;
    p.legend->setColours(colours);
    for (std::size_t i = 0; i < p.actors.size(); ++i)
        if (p.objects[i].values) p.actors[i]->update(p.objects[i], colours, p.axis);
    // The answer at once with the thinned set, the full one when nothing more comes.
    startMoving();
    p.rest.start();
    render();
}

void SceneView::setScaleTitle(const QString& title)
{
    if (canDraw()) parts_->legend->setTitle(title);
}

void SceneView::setViewpoint(SceneViewpoint viewpoint)
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    std::vector<SceneObject> shown;
    for (const SceneObject& object : p.objects)
        if (object.visible) shown.push_back(object);
    const Box box = extent(shown, p.frame());
    p.aim(cameraFor(viewpoint, p.frame(), box.low, box.high, p.aspect(), isParallel()));
    p.aimed = !p.objects.empty();
    render();
}

void SceneView::setParallel(bool parallel)
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    SceneCamera camera = p.camera();
    camera.parallel = parallel;
    p.aim(camera);
    render();
}

void SceneView::setSection(int sceneAxis, double share)
{
    Parts& p = *parts_;
    const Box box = extent(p.objects, Eigen::Matrix3d::Identity());
    p.section = SceneSection{Eigen::Vector3d::Unit(sceneAxis),
                             box.low[sceneAxis] + share * (box.high[sceneAxis] - box.low[sceneAxis])};
    applySection();
    startMoving();
    p.rest.start();
    render();
}

void SceneView::clearSection()
{
    parts_->section.reset();
    applySection();
    render();
}

void SceneView::applySection()
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    if (p.section) {
        const Eigen::Vector3d place = p.section->normal * p.section->offset_mm - p.origin;
        p.plane->SetNormal(p.section->normal.data());
        p.plane->SetOrigin(place.data());
    }
    for (const auto& actor : p.actors) actor->setSection(p.section ? p.plane.Get() : nullptr);
}

void SceneView::setMarker(const std::optional<Eigen::Vector3d>& place_mm, const QString& label)
{
    Parts& p = *parts_;
    p.marked = place_mm;
    if (!canDraw()) return;
    p.label->setText(label);
    p.label->setVisible(place_mm && !label.isEmpty());
    layOver();
}

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

void SceneView::render()
{
    Parts& p = *parts_;
    if (!canDraw() || !p.canvas->isVisible()) return;
    p.renderer->ResetCameraClippingRange();
    p.window->Render();
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

void SceneView::layOver()
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    const QSize room = p.canvas->size();
    p.ruler->resize(p.ruler->sizeHint());
    p.ruler->move(6, room.height() - p.ruler->height() - 4);
    p.ruler->setCamera(p.camera(), room.height());
    if (p.marked && !p.label->text().isEmpty()) {
        p.label->adjustSize();
        p.label->move(room.width() - p.label->width() - 8, 8);  // the standard oblique view leaves this corner free
    }
    const auto place = p.marked ? pixelAt(*p.marked) : std::nullopt;
    p.cross->setVisible(place.has_value());
    if (place) {
        p.cross->adjustSize();
        const QPoint centre = p.canvas->mapFrom(this, place->toPoint());
        p.cross->move(centre - p.cross->rect().center());
    }
}

std::optional<QPointF> SceneView::pixelAt(const Eigen::Vector3d& place_mm) const
{
    if (!canDraw()) return std::nullopt;
    const auto place = parts_->camera().project(place_mm);
    if (!place) return std::nullopt;
    const QSize room = parts_->canvas->size();
    const QPointF inside((place->x() + 1) / 2 * room.width(), (1 - place->y()) / 2 * room.height());
    return parts_->canvas->mapTo(const_cast<SceneView*>(this), QPoint(0, 0)) + inside;
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

void SceneView::applyStyle(bool paper)
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    const QColor back = paper ? QColor(Qt::white) : QWidget::palette().color(QPalette::Base);
    p.renderer->SetBackground(back.redF(), back.greenF(), back.blueF());
    const QPalette inks = paper ? paperPalette() : QWidget::palette();
    const PlotStyle style(inks, font());
    QFont large = font();
    large.setPointSizeF(1.6 * large.pointSizeF());
    p.cross->setFont(large);
    for (QWidget* part : {static_cast<QWidget*>(p.ruler), static_cast<QWidget*>(p.legend)}) {
        QPalette palette = inks;
        palette.setColor(QPalette::WindowText, style.text);
        palette.setColor(QPalette::Window, style.background);
        part->setPalette(palette);
    }
    QPalette mark = inks;
    mark.setColor(QPalette::WindowText, style.marker);
    p.cross->setPalette(mark);
}

void SceneView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange) return;
    applyStyle(false);
    render();
}

void SceneView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layOver();
}

QImage SceneView::picture(std::optional<SceneViewpoint> viewpoint, bool legend)
{
    Parts& p = *parts_;
    if (!canDraw() || !p.canvas->isVisible() || p.canvas->size().isEmpty()) return {};
    const SceneCamera before = p.camera();
    const bool legendShown = p.legend->isVisible();
    endMoving();
    applyStyle(true);
    if (!legend) p.legend->hide();
    if (viewpoint)
        setViewpoint(*viewpoint);
    else
        render();
    const QImage drawn = p.canvas->grabFramebuffer();
    const double scale = static_cast<double>(drawn.width()) / p.canvas->width();
    const int beside = p.legend->isVisible() ? p.legend->width() : 0;
    QImage image(static_cast<int>((p.canvas->width() + beside) * scale), drawn.height(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.drawImage(0, 0, drawn);
    painter.scale(scale, scale);
    for (QWidget* over :
         {static_cast<QWidget*>(p.ruler), static_cast<QWidget*>(p.label), static_cast<QWidget*>(p.cross)})
        if (over->isVisible()) over->render(&painter, over->pos(), {}, QWidget::DrawChildren);
    if (beside) p.legend->render(&painter, QPoint(p.canvas->width(), 0), {}, {});
    painter.end();
    p.legend->setVisible(legendShown);
    applyStyle(false);
    p.aim(before);
    render();
    return image;
}

}  // namespace lathelier
