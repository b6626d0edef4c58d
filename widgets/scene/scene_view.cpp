#include "widgets/scene/scene_view.h"

#include <QVariant>

#include <vtkCamera.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/core/panel/view_frame.h"
#include "widgets/scene/scene_parts.h"

namespace lathelier::scene {
namespace {

constexpr int restAfter_ms = 250;
constexpr int pointingAfter_ms = 60;
constexpr double sameExtent = 0.1;  // of the diagonal

/// Of about the same size at the same place: the view point stays, as for the next part and for one that is cut.
bool isAbout(const SceneBox& a, const SceneBox& b)
{
    const double apart_mm = std::max((a.low - b.low).norm(), (a.high - b.high).norm());
    return apart_mm < sameExtent * std::min((a.high - a.low).norm(), (b.high - b.low).norm());
}

}  // namespace

SceneView::SceneView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>())
{
    Parts& p = *parts_;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    if (!SceneCanvas::canDraw()) {
        auto* words =
            new QLabel(tr("The 3-D view needs OpenGL, which is not available here.\nAll other views work."), this);
        words->setAlignment(Qt::AlignCenter);
        words->setWordWrap(true);
        layout->addWidget(words, 1);
        return;
    }
    p.bar = new SceneBar(this);
    setProperty(ViewFrame::smallView, false);
    p.bar->setProperty(ViewFrame::onlyLarge, true);  // hidden in a small view
    p.canvas = new SceneCanvas(this);
    layout->addWidget(p.bar);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    layout->addLayout(row, 1);
    row->addWidget(p.canvas, 1);
    p.canvas->installEventFilter(this);
    p.canvas->setFocusPolicy(Qt::StrongFocus);
    p.canvas->setAccessibleName(tr("3-D view"));
    setFocusProxy(p.canvas);

    p.legend = new plot::ColourLegend(this);
    p.legend->setAutoFillBackground(true);
    row->addWidget(p.legend);
    p.flags = new SceneFlags(p.canvas);
    p.ruler = new SceneRuler(p.canvas);
    p.label = new SceneLabel(p.canvas);
    p.cross = new SceneLabel(p.canvas);
    p.cross->setAutoFillBackground(false);
    p.cross->setFrameShape(QFrame::NoFrame);
    p.cross->setText(QStringLiteral("⊕"));
    p.legend->hide();
    connect(p.legend, &plot::ColourLegend::limitEdited, this, &SceneView::limitEdited);
    connect(p.bar, &SceneBar::viewpointRequested, this, &SceneView::setViewpoint);
    connect(p.bar, &SceneBar::parallelRequested, this, &SceneView::setParallel);
    connect(p.bar, &SceneBar::sectionRequested, this, [this](int sceneAxis, double share) {
        if (sceneAxis < 0)
            clearSection();
        else
            setSection(sceneAxis, share);
    });
    p.tag = new plot::PointerTag(p.canvas);
    p.canvas->setMouseTracking(true);
    p.pointing.setSingleShot(true);
    p.pointing.setInterval(pointingAfter_ms);
    connect(&p.pointing, &QTimer::timeout, this, [this] { hover(parts_->pointed_at); });
    p.rest.setSingleShot(true);
    p.rest.setInterval(restAfter_ms);
    connect(&p.rest, &QTimer::timeout, this, [this] {
        if (parts_->dragging)
            parts_->rest.start();  // restarted: the pointer rests during a drag
        else
            endMoving();
    });

    connect(p.canvas, &SceneCanvas::drawn, this, &SceneView::frameDone);
    applyStyle(false);
}

SceneView::~SceneView()
{
    if (!canDraw()) return;
    parts_->canvas->removeEventFilter(this);
    parts_->canvas->makeCurrent();
    parts_->actors.clear();
    parts_->outline.reset();
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
    return canDraw() && parts_->canvas->renderer().GetActiveCamera()->GetParallelProjection() != 0;
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
    const bool other = p.objects.empty() || objects.empty() || p.objects.front().scan != objects.front().scan;
    p.objects = std::move(objects);
    if (!canDraw()) return;
    p.canvas->makeCurrent();
    const SceneBox box = other ? extent(p.objects, Eigen::Matrix3d::Identity()) : p.box;
    if (other && !isAbout(box, p.box)) {
        p.actors.clear();
        p.box = box;
        p.origin = (box.low + box.high) / 2;
        Eigen::Index along = 0;
        (box.high - box.low).maxCoeff(&along);
        p.longest = Eigen::Vector3d::Unit(along);
        p.aimed = false;
    }
    std::vector<std::unique_ptr<SceneActor>> kept = std::move(p.actors);
    p.actors.clear();
    for (const SceneObject& object : p.objects) {
        std::unique_ptr<SceneActor> actor;
        if (!object.visible) {
            p.actors.push_back(nullptr);  // uploaded when it is drawn
            continue;
        }
        for (auto& old : kept)
            if (old && old->sameGeometry(object)) {
                actor = std::move(old);
                break;
            }
        if (!actor) actor = std::make_unique<SceneActor>(&p.canvas->renderer(), object, p.origin, p.axis);
        actor->setMoving(p.moving);
        p.actors.push_back(std::move(actor));
    }
    kept.clear();
    for (std::size_t i = 0; i < p.actors.size(); ++i)
        if (p.actors[i]) p.actors[i]->update(p.objects[i], p.colours, p.axis);
    showAround();
    shareBudget();
    applySection();
    if (!p.aimed && !p.kept) return setViewpoint(SceneViewpoint::Oblique);
    if (!p.aimed) {
        p.aim(*p.kept);
        p.aimed = true;
        p.kept.reset();
    }
    render();
}

/// The scale stands beside a large picture while an object has values.
void SceneView::showAround()
{
    Parts& p = *parts_;
    const bool small = property(ViewFrame::smallView).toBool();
    const bool valued = std::any_of(p.objects.begin(), p.objects.end(),
                                    [](const SceneObject& object) { return object.visible && object.values; });
    p.legend->setVisible(valued && !small);
    p.ruler->setVisible(!small);
    p.flags->setVisible(!small);
    placeOverlays();
}

bool SceneView::event(QEvent* event)
{
    if (event->type() == QEvent::DynamicPropertyChange && canDraw() &&
        static_cast<QDynamicPropertyChangeEvent*>(event)->propertyName() == ViewFrame::smallView)
        showAround();
    return QWidget::event(event);
}

void SceneView::setOutline(const std::vector<std::vector<Eigen::Vector3d>>& lines_mm)
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    p.canvas->makeCurrent();
    p.outline.reset();
    if (!lines_mm.empty()) p.outline = std::make_unique<SceneOutline>(&p.canvas->renderer(), lines_mm, p.origin);
    applySection();
    render();
}

std::vector<double> SceneView::view() const
{
    if (!canDraw() || !parts_->aimed) return {};
    const SceneCamera camera = parts_->camera();
    std::vector<double> numbers;
    for (Eigen::Index row = 0; row < 3; ++row)
        for (Eigen::Index column = 0; column < 4; ++column) numbers.push_back(camera.view_T_scene(row, column));
    numbers.insert(numbers.end(), {camera.distance_mm, camera.half_height_mm, camera.parallel ? 1.0 : 0.0});
    return numbers;
}

void SceneView::setView(const std::vector<double>& view)
{
    constexpr std::size_t count = 15;
    SceneCamera camera;
    if (view.size() != count || !canDraw()) return;
    for (std::size_t i = 0; i < 12; ++i)
        camera.view_T_scene(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) = view[i];
    camera.distance_mm = view[12];
    camera.half_height_mm = view[13];
    camera.parallel = view[14] != 0;
    const bool turns = camera.view_T_scene.linear().isUnitary(1e-6) && camera.view_T_scene.matrix().allFinite();
    if (!turns || !(camera.distance_mm > 0) || !(camera.half_height_mm > 0)) return;
    Parts& p = *parts_;
    p.kept = camera;
    p.standing.reset();
    if (p.objects.empty()) return;
    p.aim(camera);
    p.aimed = true;
    p.kept.reset();
    render();
}

void SceneView::setLongAxis(const std::optional<SceneAxis>& axis)
{
    const bool news = axis.has_value() != parts_->axis.has_value() ||
                      (axis && (axis->direction - parts_->axis->direction).norm() > 1e-2);
    parts_->axis = axis;
    if (news) parts_->aimed = false;
}

void SceneView::setColours(const report::DeviationColours& colours)
{
    Parts& p = *parts_;
    if (p.colours == colours && canDraw()) return p.legend->setColours(colours);
    p.colours = colours;
    if (!canDraw()) return;
    p.legend->setColours(colours);
    for (std::size_t i = 0; i < p.actors.size(); ++i)
        if (p.actors[i] && p.objects[i].values) p.actors[i]->update(p.objects[i], colours, p.axis);
    // Immediate redraw with the decimated set, the full one after a pause.
    startMoving();
    p.rest.start();
    render();
}

void SceneView::setCounts(plot::ScaleCounts counts)
{
    if (canDraw()) parts_->legend->setCounts(std::move(counts));
}

void SceneView::setTag(const QString& value, const QString& place)
{
    if (canDraw()) parts_->tag->say({value, place}, parts_->pointed_at);
}

void SceneView::setScale(const report::Axis& axis)
{
    if (canDraw()) parts_->legend->setAxis(axis);
}

void SceneView::setViewpoint(SceneViewpoint viewpoint)
{
    Parts& p = *parts_;
    if (!canDraw()) return;
    std::vector<SceneObject> shown;
    for (const SceneObject& object : p.objects)
        if (object.visible) shown.push_back(object);
    const SceneBox box = extent(shown, p.frame());
    p.aim(cameraFor(viewpoint, p.frame(), box.low, box.high, p.aspect(), isParallel()));
    p.aimed = !p.objects.empty();
    p.standing = viewpoint;
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
    const SceneBox box = extent(p.objects, Eigen::Matrix3d::Identity());
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
    for (const auto& actor : p.actors)
        if (actor) actor->setSection(p.section ? p.plane.Get() : nullptr);
    if (p.outline) p.outline->setSection(p.section ? p.plane.Get() : nullptr);
}

void SceneView::setFlags(std::vector<SceneFlag> flags)
{
    if (canDraw()) parts_->flags->setFlags(std::move(flags));
}

void SceneView::setMarker(const std::optional<Eigen::Vector3d>& place_mm, const QString& label)
{
    Parts& p = *parts_;
    p.marked = place_mm;
    if (!canDraw()) return;
    p.label->setText(label);
    placeOverlays();
}

void SceneView::render()
{
    if (canDraw()) parts_->canvas->drawSoon();
}

}  // namespace lathelier::scene
