#include "widgets/surface/picture_view.h"

#include <QKeyEvent>
#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <cmath>

#include "widgets/core/language.h"
#include "widgets/plot/plot_style.h"
#include "widgets/surface/picture_painting.h"

namespace lathelier::surface_panel {
namespace {

constexpr double mostZoom = 40;     // widget pixels for one of the picture
constexpr double wheelStep = 1.25;  // for a notch
constexpr double panStep = 0.1;     // of the view, for an arrow key
constexpr double least_px = 8;      // of a region, a length or an arrow that is meant

}  // namespace

PictureView::PictureView(QWidget* parent) : PlotWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
}

void PictureView::setPicture(const QImage& image, double mm_per_px)
{
    const bool another = image.size() != image_.size();
    image_ = image;
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
    second_ = image;
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
    if (image_.isNull()) return 1;
    return std::min(width() / static_cast<double>(image_.width()), height() / static_cast<double>(image_.height()));
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
    middle_ = zoom_ == 0 ? QPointF(image_.width() / 2.0, image_.height() / 2.0)
                         : QPointF(std::clamp(middle.x(), 0.0, double(image_.width())),
                                   std::clamp(middle.y(), 0.0, double(image_.height())));
    update();
}

void PictureView::tellLinked()
{
    for (PictureView* other : linked_) {
        other->zoom_ = zoom_;
        other->middle_ = middle_;
        other->pointer_.reset();
        other->update();
    }
    emit viewMoved();
}

void PictureView::zoomAt(const QPointF& place, double factor)
{
    if (image_.isNull()) return;
    const QPointF held = pixelAt(place);
    const double next = std::min(zoom() * factor, mostZoom);
    showPart(next, held - (place - QPointF(width() / 2.0, height() / 2.0)) / next);
    tellLinked();
}

void PictureView::panBy(const QPointF& by)
{
    showPart(zoom(), middle_ - by / zoom());
    tellLinked();
}

void PictureView::resetView()
{
    showPart(0, {});
    tellLinked();
}

void PictureView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || image_.isNull()) return;
    pressed_ = event->localPos();
    pointer_ = event->localPos();
    if (tool_ != Tool::Length) return;
    if (chosen_.size() >= 2) chosen_.clear();
    chosen_.push_back(pixelAt(event->localPos()));
    pressed_.reset();
    update();
    if (chosen_.size() < 2) return;
    const QPointF way = chosen_[1] - chosen_[0];
    const double pixels = std::hypot(way.x(), way.y());
    if (pixels * zoom() < least_px)
        chosen_.pop_back();  // a click that trembled
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
            QRectF(pixelAt(from), pixelAt(to)).normalized().intersected(QRectF(QPointF(), QSizeF(image_.size())));
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
    update();
    QWidget::leaveEvent(event);
}

void PictureView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paint(painter, palette());
    if (!hasFocus() || isSmall()) return;
    painter.setPen(QPen(palette().highlight().color(), 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void PictureView::paint(QPainter& painter, const QPalette& palette) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette.color(QPalette::Window));
    if (image_.isNull()) return;
    paintPicture(painter);
    const QRectF whole(placeOf({0, 0}), placeOf(QPointF(image_.width(), image_.height())));
    painter.save();
    painter.setClipRect(whole.intersected(QRectF(rect())));
    paintOverlays(painter, palette);
    paintTools(painter, palette);
    painter.restore();
    if (isSmall()) return;
    paintRulers(painter, palette);
    paintScaleBar(painter, palette);
    paintWords(painter, palette);
}

void PictureView::paintPicture(QPainter& painter) const
{
    painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom() < 4);
    const QRectF visible =
        QRectF(pixelAt({0, 0}), pixelAt({double(width()), double(height())})).intersected(QRectF(image_.rect()));
    const double edge = second_.isNull() ? image_.width() : share_ * image_.width();
    const auto draw = [&](const QImage& image, double from, double to) {
        const QRectF part = visible.intersected(QRectF(from, 0, to - from, image_.height()));
        if (!part.isEmpty())
            painter.drawImage(QRectF(placeOf(part.topLeft()), placeOf(part.bottomRight())), image, part);
    };
    draw(image_, 0, edge);
    if (second_.isNull()) return;
    draw(second_, edge, image_.width());
    const double x = placeOf({edge, 0}).x();
    painter.setPen(QPen(palette().highlight().color(), 2));
    painter.drawLine(QPointF(x, placeOf({0, 0}).y()), QPointF(x, placeOf({0, double(image_.height())}).y()));
}

void PictureView::paintOverlays(QPainter& painter, const QPalette& palette) const
{
    const plot::PlotStyle style(palette, font());
    for (const Overlay& overlay : overlays_) drawStripes(painter, overlay, style, zoom(), *this);
}

void PictureView::paintRulers(QPainter& painter, const QPalette& palette) const
{
    if (rulers_.empty()) return;
    drawRulers(painter, rulers_, rulersDirection_deg_, zoom(), rect(), palette, font());
}

void PictureView::paintTools(QPainter& painter, const QPalette& palette) const
{
    const QPen pen(plot::PlotStyle(palette, font()).colour(report::ColourRole::Limit), 2);
    const bool drags = pressed_ && pointer_;
    if (region_ && !(tool_ == Tool::Region && drags))
        drawRegion(painter, QRectF(placeOf(region_->topLeft()), placeOf(region_->bottomRight())), rect(), pen);
    if (tool_ == Tool::Region && drags) drawRegion(painter, QRectF(*pressed_, *pointer_).normalized(), rect(), pen);
    if (tool_ == Tool::Direction && drags) {
        drawArrow(painter, *pressed_, *pointer_, pen);
    } else if (arrow_deg_) {
        const double size = 0.12 * std::min(width(), height());
        const QPointF way(size * std::cos(qDegreesToRadians(*arrow_deg_)),
                          size * std::sin(qDegreesToRadians(*arrow_deg_)));
        const QPointF middle(placeOf({image_.width() / 2.0, image_.height() / 2.0}));
        drawArrow(painter, middle - way, middle + way, pen);
    }
    std::vector<QPointF> ends;
    ends.reserve(2);
    for (const QPointF& end : chosen_) ends.push_back(placeOf(end));
    if (tool_ == Tool::Length && ends.size() == 1 && pointer_) ends.push_back(*pointer_);
    if (!ends.empty()) drawLength(painter, ends, pen);
}

void PictureView::paintScaleBar(QPainter& painter, const QPalette& palette) const
{
    if (mm_per_px_ > 0) drawScaleBar(painter, mm_per_px_ / zoom(), rect(), palette, font());
}

void PictureView::paintWords(QPainter& painter, const QPalette& palette) const
{
    QStringList lines;
    std::vector<QColor> colours;
    const plot::PlotStyle style(palette, font());
    for (const Overlay& overlay : overlays_) {
        const bool drawn = overlay.spacing_px * zoom() >= closestStripes;
        lines << (drawn ? overlay.name : tr("%1: zoom in to see them").arg(overlay.name));
        colours.push_back(style.colour(overlay.colour));
    }
    if (pointer_ && !pressed_) {
        const QPointF at = pixelAt(*pointer_);
        if (image_.rect().contains(at.toPoint())) {
            const Text unit = LT_TEXT("Engine", "mm");
            lines << (mm_per_px_ > 0
                          ? QStringLiteral("x %1 · y %2")
                                .arg(screenQuantity(at.x() * mm_per_px_, unit, 2),
                                     screenQuantity(at.y() * mm_per_px_, unit, 2))
                          : QStringLiteral("x %1 px · y %2 px").arg(at.x(), 0, 'f', 0).arg(at.y(), 0, 'f', 0));
            colours.emplace_back();
        }
    }
    drawLegend(painter, lines, colours, palette, font());
}

}  // namespace lathelier::surface_panel
