#include "widgets/surface/picture_view.h"

#include <QKeyEvent>
#include <QtMath>
#include <algorithm>
#include <cmath>

namespace lathelier::surface_panel {
namespace {

constexpr double mostZoom = 40;     // widget pixels for one of the picture
constexpr double wheelStep = 1.25;  // for a notch
constexpr double panStep = 0.1;     // of the view, for an arrow key
constexpr double lensStep = 12;     // of the widget, for an arrow key
constexpr double least_px = 8;      // of a region, a length or an arrow that is meant

}  // namespace

PictureView::PictureView(QWidget* parent) : PlotWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
}

void PictureView::setPicture(const QImage& image, double mm_per_px)
{
    const bool another = image.size() != picture_.whole().size();
    if (image.cacheKey() != picture_.whole().cacheKey()) picture_ = PicturePyramid(image);
    mm_per_px_ = mm_per_px;
    if (another) {
        zoom_ = 0;
        middle_ = QPointF(image.width() / 2.0, image.height() / 2.0);
        chosen_.clear();
    }
    update();
}

void PictureView::setSecond(const QImage& image, double share)
{
    if (image.cacheKey() != second_.whole().cacheKey()) second_ = PicturePyramid(image);
    share_ = share;
    update();
}

void PictureView::setOverlays(std::vector<Overlay> overlays)
{
    overlays_ = std::move(overlays);
    update();
}

void PictureView::setRulers(std::vector<Ruler> rulers, double direction_deg)
{
    rulers_ = std::move(rulers);
    rulersDirection_deg_ = direction_deg;
    update();
}

void PictureView::setRegion(const std::optional<QRectF>& region)
{
    region_ = region;
    update();
}

void PictureView::setArrow(const std::optional<double>& direction_deg)
{
    arrow_deg_ = direction_deg;
    update();
}

void PictureView::setTool(Tool tool)
{
    tool_ = tool;
    chosen_.clear();
    pressed_.reset();
    setCursor(tool == Tool::None ? Qt::ArrowCursor : Qt::CrossCursor);
    update();
}

double PictureView::fitting() const
{
    if (image().isNull()) return 1;
    return std::min(width() / static_cast<double>(image().width()), height() / static_cast<double>(image().height()));
}

double PictureView::zoom() const
{
    return zoom_ > 0 ? zoom_ : fitting();
}

QPointF PictureView::placeOf(const QPointF& pixel) const
{
    return QPointF(width() / 2.0, height() / 2.0) + zoom() * (pixel - middle_);
}

QPointF PictureView::pixelAt(const QPointF& place) const
{
    return middle_ + (place - QPointF(width() / 2.0, height() / 2.0)) / zoom();
}

void PictureView::link(PictureView* other)
{
    linked_.push_back(other);
    other->linked_.push_back(this);
}

void PictureView::showPart(double zoom, const QPointF& middle)
{
    zoom_ = zoom <= fitting() ? 0 : std::min(zoom, mostZoom);
    middle_ = zoom_ == 0 ? QPointF(image().width() / 2.0, image().height() / 2.0)
                         : QPointF(std::clamp(middle.x(), 0.0, double(image().width())),
                                   std::clamp(middle.y(), 0.0, double(image().height())));
    update();
}

void PictureView::updateLinkedViews()
{
    for (PictureView* other : linked_) {
        other->zoom_ = zoom_;
        other->middle_ = middle_;
        other->pointer_.reset();
        other->update();
    }
    emit viewMoved();
}

void PictureView::setMagnifier(bool on)
{
    magnifier_ = on;
    showLens(on && !image().isNull() ? std::optional(middle_) : std::nullopt);
}

void PictureView::showLens(const std::optional<QPointF>& pixel)
{
    const bool inside = pixel && QRectF(image().rect()).contains(*pixel);
    lens_ = inside ? pixel : std::nullopt;
    update();
    for (PictureView* other : linked_) {
        other->lens_ = lens_;
        other->update();
    }
}

/// The arrow keys move the magnifier.
bool PictureView::moveLens(int key)
{
    if (!magnifier_ || !lens_) return false;
    const double step = lensStep / zoom();
    switch (key) {
        case Qt::Key_Left: showLens(*lens_ - QPointF(step, 0)); return true;
        case Qt::Key_Right: showLens(*lens_ + QPointF(step, 0)); return true;
        case Qt::Key_Up: showLens(*lens_ - QPointF(0, step)); return true;
        case Qt::Key_Down: showLens(*lens_ + QPointF(0, step)); return true;
        default: return false;
    }
}

void PictureView::zoomAt(const QPointF& place, double factor)
{
    if (image().isNull()) return;
    const QPointF held = pixelAt(place);
    const double next = std::min(zoom() * factor, mostZoom);
    showPart(next, held - (place - QPointF(width() / 2.0, height() / 2.0)) / next);
    updateLinkedViews();
}

void PictureView::panBy(const QPointF& by)
{
    showPart(zoom(), middle_ - by / zoom());
    updateLinkedViews();
}

void PictureView::resetView()
{
    showPart(0, {});
    updateLinkedViews();
}

void PictureView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || image().isNull()) return;
    pressed_ = event->localPos();
    pointer_ = event->localPos();
    if (tool_ == Tool::Point) {
        chosen_ = {pixelAt(event->localPos())};
        pressed_.reset();
        update();
        emit pointChosen(chosen_.front());
    }
    if (tool_ != Tool::Length) return;
    if (chosen_.size() >= 2) chosen_.clear();
    chosen_.push_back(pixelAt(event->localPos()));
    pressed_.reset();
    update();
    if (chosen_.size() < 2) return;
    const QPointF way = chosen_[1] - chosen_[0];
    const double pixels = std::hypot(way.x(), way.y());
    if (pixels * zoom() < least_px)
        chosen_.pop_back();  // one click, with the pointer moved a little
    else
        emit lengthDrawn(pixels);
}

void PictureView::mouseMoveEvent(QMouseEvent* event)
{
    if (tool_ == Tool::None && pressed_ && (event->buttons() & Qt::LeftButton)) {
        panBy(event->localPos() - *pressed_);
        pressed_ = event->localPos();
    }
    pointer_ = event->localPos();
    if (magnifier_) showLens(pixelAt(*pointer_));
    update();
}

void PictureView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !pressed_) return;
    const QPointF from = *pressed_, to = event->localPos();
    pressed_.reset();
    update();
    if (tool_ == Tool::Region) {
        const QRectF drawn =
            QRectF(pixelAt(from), pixelAt(to)).normalized().intersected(QRectF(QPointF(), QSizeF(image().size())));
        if (drawn.width() * zoom() >= least_px && drawn.height() * zoom() >= least_px) emit regionDrawn(drawn);
    } else if (tool_ == Tool::Direction && std::hypot(to.x() - from.x(), to.y() - from.y()) >= least_px) {
        emit directionDrawn(qRadiansToDegrees(std::atan2(to.y() - from.y(), to.x() - from.x())));
    }
}

void PictureView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (tool_ == Tool::None) resetView();
    event->accept();
}

void PictureView::wheelEvent(QWheelEvent* event)
{
    const double notches = event->angleDelta().y() / 120.0;
    if (notches != 0) zoomAt(event->position(), std::pow(wheelStep, notches));
    event->accept();
}

void PictureView::keyPressEvent(QKeyEvent* event)
{
    const QPointF middle(width() / 2.0, height() / 2.0);
    switch (event->key()) {
        case Qt::Key_Plus: return zoomAt(middle, wheelStep);
        case Qt::Key_Minus: return zoomAt(middle, 1 / wheelStep);
        case Qt::Key_Home: return resetView();
        case Qt::Key_Escape:
            if (tool_ == Tool::None) break;
            return setTool(tool_);  // what was begun is dropped
        default: break;
    }
    if (moveLens(event->key())) return;
    if (zoom_ > 0) {
        const double x = panStep * width(), y = panStep * height();
        switch (event->key()) {
            case Qt::Key_Left: return panBy({x, 0});
            case Qt::Key_Right: return panBy({-x, 0});
            case Qt::Key_Up: return panBy({0, y});
            case Qt::Key_Down: return panBy({0, -y});
            default: break;
        }
    }
    QWidget::keyPressEvent(event);
}

void PictureView::leaveEvent(QEvent* event)
{
    pointer_.reset();
    if (magnifier_) showLens(std::nullopt);
    update();
    QWidget::leaveEvent(event);
}

}  // namespace lathelier::surface_panel
