// What a PictureView shows: the picture, lines over it, tools, magnifier, words.
#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "widgets/core/language.h"
#include "widgets/plot/plot_style.h"
#include "widgets/surface/picture_painting.h"
#include "widgets/surface/picture_view.h"

namespace lathelier::surface_panel {
namespace {

constexpr double lensSide = 220, lensShare = 0.45;  // px; of the view at most
constexpr double lensTimes = 4, lensLeastZoom = 2;  // as large as the picture; px for one of the picture

/// A part of the picture, given in its pixels, where it belongs.
void drawPart(QPainter& painter, const PicturePyramid& picture, const QRectF& part, const QRectF& place)
{
    if (part.isEmpty()) return;
    const double ratio = painter.device()->devicePixelRatioF();
    const QImage& level = picture.forZoom(place.width() / part.width() * ratio);
    const double x = double(level.width()) / picture.whole().width();
    const double y = double(level.height()) / picture.whole().height();
    painter.drawImage(place, level, QRectF(part.x() * x, part.y() * y, part.width() * x, part.height() * y));
}

}  // namespace

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
    if (image().isNull()) return;
    paintPicture(painter);
    const QRectF whole(placeOf({0, 0}), placeOf(QPointF(image().width(), image().height())));
    painter.save();
    painter.setClipRect(whole.intersected(QRectF(rect())));
    paintOverlays(painter, palette);
    paintTools(painter, palette);
    painter.restore();
    if (isSmall()) return;
    paintRulers(painter, palette);
    paintScaleBar(painter, palette);
    paintLens(painter, palette);
    paintWords(painter, palette);
}

void PictureView::paintPicture(QPainter& painter) const
{
    painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom() < 4);
    const QRectF visible =
        QRectF(pixelAt({0, 0}), pixelAt({double(width()), double(height())})).intersected(QRectF(image().rect()));
    const double edge = second_.whole().isNull() ? image().width() : share_ * image().width();
    const auto draw = [&](const PicturePyramid& picture, double from, double to) {
        const QRectF part = visible.intersected(QRectF(from, 0, to - from, image().height()));
        drawPart(painter, picture, part, QRectF(placeOf(part.topLeft()), placeOf(part.bottomRight())));
    };
    draw(picture_, 0, edge);
    if (second_.whole().isNull()) return;
    draw(second_, edge, image().width());
    const double x = placeOf({edge, 0}).x();
    painter.setPen(QPen(palette().highlight().color(), 2));
    painter.drawLine(QPointF(x, placeOf({0, 0}).y()), QPointF(x, placeOf({0, double(image().height())}).y()));
}

void PictureView::paintOverlays(QPainter& painter, const QPalette& palette) const
{
    const plot::PlotStyle style(palette, font());
    for (const Overlay& overlay : overlays_) drawStripes(painter, overlay, style, zoom(), *this);
}

void PictureView::paintRulers(QPainter& painter, const QPalette& palette) const
{
    const bool visible = std::any_of(rulers_.begin(), rulers_.end(),
                                     [this](const Ruler& ruler) { return ruler.pitch_px * zoom() >= closestStripes; });
    if (!visible) return;  // the legend says so
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
        const QPointF middle(placeOf({image().width() / 2.0, image().height() / 2.0}));
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
        if (image().rect().contains(at.toPoint())) {
            lines << placeWords(at);
            colours.emplace_back();
        }
    }
    if (chosen_.size() == 2) {
        lines << lengthWords();
        colours.push_back(style.colour(report::ColourRole::Limit));
    }
    drawLegend(painter, lines, colours, palette, font());
}

QString PictureView::placeWords(const QPointF& at) const
{
    const Text unit = unit::mm;
    if (mm_per_px_ > 0)
        return QStringLiteral("x %1 · y %2")
            .arg(screenQuantity(at.x() * mm_per_px_, unit, 2), screenQuantity(at.y() * mm_per_px_, unit, 2));
    return QStringLiteral("x %1 px · y %2 px").arg(at.x(), 0, 'f', 0).arg(at.y(), 0, 'f', 0);
}

/// Of the length between two clicks.
QString PictureView::lengthWords() const
{
    const QPointF way = chosen_[1] - chosen_[0];
    const auto words = [&](double pixels) {
        return mm_per_px_ > 0 ? screenQuantity(pixels * mm_per_px_, unit::mm, 3)
                              : QStringLiteral("%1 px").arg(screenNumber(pixels, 1));
    };
    return QStringLiteral("%1 (↔ %2, ↕ %3)")
        .arg(words(std::hypot(way.x(), way.y())), words(std::abs(way.x())), words(std::abs(way.y())));
}

void PictureView::paintLens(QPainter& painter, const QPalette& palette) const
{
    if (!lens_) return;
    const double side = std::min(lensSide, lensShare * std::min(width(), height()));
    const double scale = std::max(lensTimes * zoom(), lensLeastZoom);
    const QPointF centre = placeOf(*lens_);
    const QRectF frame(centre - QPointF(side, side) / 2, QSizeF(side, side));
    const QRectF seen(*lens_ - QPointF(side, side) / (2 * scale), QSizeF(side, side) / scale);
    const double edge = second_.whole().isNull() ? image().width() : share_ * image().width();
    painter.save();
    painter.setClipRect(frame);
    painter.fillRect(frame, palette.color(QPalette::Window));
    const auto draw = [&](const PicturePyramid& picture, double from, double to) {
        const QRectF part = seen.intersected(QRectF(from, 0, to - from, image().height()));
        drawPart(painter, picture, part, QRectF(centre + scale * (part.topLeft() - *lens_), scale * part.size()));
    };
    draw(picture_, 0, edge);
    if (!second_.whole().isNull()) draw(second_, edge, image().width());
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette.color(QPalette::Highlight), 2));
    painter.drawRect(frame);
}

}  // namespace lathelier::surface_panel
