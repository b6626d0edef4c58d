#include "widgets/surface/picture_painting.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/surface/surface_pictures.h"
#include "widgets/core/language.h"
#include "widgets/plot/plot_style.h"
#include "widgets/surface/picture_view.h"

namespace lathelier::surface_panel {
namespace {

constexpr double paperOpacity = 0.85;  // behind words over a picture

QColor paper(const QPalette& palette)
{
    QColor colour = palette.color(QPalette::Base);
    colour.setAlphaF(paperOpacity);
    return colour;
}

}  // namespace

void drawStripes(QPainter& painter, const Overlay& overlay, const plot::PlotStyle& style, double zoom,
                 const PictureView& view)
{
    if (overlay.spacing_px * zoom < closestStripes) return;
    QColor colour = style.colour(overlay.colour);
    colour.setAlphaF(overlay.width > 1 ? 0.9 : 0.65);
    painter.setPen(QPen(colour, overlay.width * style.line_width));
    for (const auto& [a, b] : overlay.stripes) painter.drawLine(view.placeOf({a.x, a.y}), view.placeOf({b.x, b.y}));
}

void drawRulers(QPainter& painter, const std::vector<Ruler>& rulers, double direction_deg, double zoom,
                const QRect& room, const QPalette& palette, const QFont& font)
{
    const QFontMetricsF metrics(font);
    const plot::PlotStyle style(palette, font);
    const double angle = qDegreesToRadians(direction_deg);
    const bool upright = std::abs(std::cos(angle)) >= std::abs(std::sin(angle));
    const double share = upright ? std::abs(std::cos(angle)) : std::abs(std::sin(angle));
    const double band = metrics.height() + 14;
    const double whole = band * static_cast<double>(rulers.size());
    painter.save();
    if (upright) {
        painter.translate(room.left(), room.bottom() - whole + 1);
    } else {  // reads upward along the left edge
        painter.translate(room.left(), room.bottom() + 1);
        painter.rotate(-90);
    }
    const double length = 0.6 * (upright ? room.width() : room.height());
    painter.fillRect(QRectF(0, 0, length, whole), paper(palette));
    double top = 0;
    for (const Ruler& ruler : rulers) {
        const double step = ruler.pitch_px * zoom / share;
        painter.setPen(QPen(style.colour(ruler.colour), style.line_width * 1.4));
        if (step >= closestStripes)
            for (double x = step; x < length; x += step) painter.drawLine(QPointF(x, top + 2), QPointF(x, top + 11));
        painter.setPen(palette.color(QPalette::Text));
        painter.setFont(font);
        painter.drawText(QRectF(6, top + 11, length - 6, metrics.height() + 2), Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(ruler.name, Qt::ElideRight, length - 12));
        top += band;
    }
    painter.restore();
}

void drawRegion(QPainter& painter, const QRectF& region, const QRect& room, const QPen& pen)
{
    const QRegion outside = QRegion(room).subtracted(QRegion(region.toRect()));
    for (const QRect& part : outside) painter.fillRect(part, QColor(0, 0, 0, 110));
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(region);
}

void drawArrow(QPainter& painter, const QPointF& from, const QPointF& to, const QPen& pen)
{
    constexpr double head = 14;
    const double angle = std::atan2(to.y() - from.y(), to.x() - from.x());
    painter.setPen(QPen(pen.color(), pen.widthF() + 1));
    painter.drawLine(from, to);
    for (const double side : {2.6, -2.6})
        painter.drawLine(to, to + head * QPointF(std::cos(angle + side), std::sin(angle + side)));
}

void drawLength(QPainter& painter, const std::vector<QPointF>& ends, const QPen& pen)
{
    constexpr double arm = 7;
    painter.setPen(pen);
    for (const QPointF& end : ends) {
        painter.drawLine(end - QPointF(arm, 0), end + QPointF(arm, 0));
        painter.drawLine(end - QPointF(0, arm), end + QPointF(0, arm));
    }
    if (ends.size() > 1) painter.drawLine(ends[0], ends[1]);
}

void drawScaleBar(QPainter& painter, double mm_per_pixel, const QRect& room, const QPalette& palette, const QFont& font)
{
    const QFontMetricsF metrics(font);
    const Text unit = unit::mm;
    const double factor = screenFactor(unit);  // round in the unit that is shown
    const double mm = surface::roundBelow(0.25 * room.width() * mm_per_pixel * factor) / factor,
                 length = mm / mm_per_pixel;
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(mm) + 1e-9)));
    const QString words = screenQuantity(mm, unit, decimals);
    const double width = std::max(length, metrics.horizontalAdvance(words)) + 16, height = metrics.height() + 14;
    const QRectF frame(room.right() - width - 4, room.bottom() - height - 4, width, height);
    painter.fillRect(frame, paper(palette));
    painter.setPen(palette.color(QPalette::Text));
    painter.setFont(font);
    painter.drawText(frame.adjusted(0, 0, 0, -10), Qt::AlignCenter, words);
    painter.fillRect(QRectF(frame.center().x() - length / 2, frame.bottom() - 9, length, 4),
                     palette.color(QPalette::Text));
}

void drawLegend(QPainter& painter, const QStringList& lines, const std::vector<QColor>& colours,
                const QPalette& palette, const QFont& font)
{
    if (lines.isEmpty()) return;
    const QFontMetricsF metrics(font);
    const double sample = 1.6 * metrics.height();
    double widest = 0;
    for (const QString& line : lines) widest = std::max(widest, metrics.horizontalAdvance(line));
    const double row = metrics.height() + 2;
    painter.fillRect(QRectF(4, 4, widest + sample + 18, row * lines.size() + 6), paper(palette));
    painter.setFont(font);
    double top = 7;
    for (int i = 0; i < lines.size(); ++i) {
        const QColor& colour = colours[static_cast<std::size_t>(i)];
        double left = 10;
        if (colour.isValid()) {
            painter.setPen(QPen(colour, 3));
            painter.drawLine(QPointF(left, top + row / 2), QPointF(left + sample - 6, top + row / 2));
            left += sample;
        }
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QRectF(left, top, widest + 6, row), Qt::AlignLeft | Qt::AlignVCenter, lines[i]);
        top += row;
    }
}

}  // namespace lathelier::surface_panel
