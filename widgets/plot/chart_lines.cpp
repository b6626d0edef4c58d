// Regions, limits, marks and handles of a ChartView.
#include <algorithm>
#include <cmath>

#include "widgets/plot/chart_parts.h"

namespace lathelier::plot {
namespace {

constexpr double farAway = 1e5;  ///< px: beyond every screen, within the range of the painter

}  // namespace

void RegionFill::draw(QCPPainter* painter)
{
    const QRectF edge = keyAxis()->axisRect()->rect();
    const auto place = [](double value, double pixel, double low, double high) {
        return std::isinf(value) ? (value < 0 ? low : high) : std::clamp(pixel, -farAway, farAway);
    };
    QPolygonF polygon;
    for (std::size_t i = 0; i < std::min(region_.x.size(), region_.y.size()); ++i) {
        const double x = region_.x[i], y = region_.y[i];
        if (std::isnan(x) || std::isnan(y)) continue;
        polygon << QPointF(place(x, keyAxis()->coordToPixel(x), edge.left(), edge.right() + 1),
                           place(y, valueAxis()->coordToPixel(y), edge.bottom() + 1, edge.top()));
    }
    painter->setPen(Qt::NoPen);
    painter->setBrush(mBrush);
    painter->drawPolygon(polygon);
    if (!hatch_.isValid()) return;
    painter->setPen(QPen(hatch_, 1.5));
    painter->setBrush(QBrush(hatch_, Qt::BDiagPattern));
    painter->drawPolygon(polygon);
}

void ChartLines::draw(QCPPainter* painter)
{
    names_.clear();
    drawPointedOut(*painter);
    const QPen dashed(style_.limit, style_.line_width, Qt::DashLine);
    for (const report::Limit& limit : chart_.limits)
        drawLine(*painter, limit.direction == report::Limit::Direction::Vertical, limit.place, limit.name, dashed);
    const double size = 0.6 * reach();
    for (const report::Mark& mark : chart_.marks) {
        const QPointF place = pixel(mark.x, mark.y);
        painter->setPen(QPen(style_.background, 1));
        painter->setBrush(style_.marker);
        painter->drawEllipse(place, size, size);
        drawName(*painter, place + QPointF(size, -size), mark.name);
    }
    for (std::size_t i = 0; i < chart_.handles.size(); ++i) drawHandle(*painter, chart_.handles[i], chosen == i);
    if (marked_x) drawLine(*painter, true, *marked_x, {}, QPen(style_.marker, 1.2 * style_.line_width));
    painter->setPen(QPen(style_.background, 1));
    painter->setBrush(style_.marker);
    for (const QPointF& place : marked_places)
        painter->drawEllipse(pixel(place.x(), place.y()), 3 * style_.line_width, 3 * style_.line_width);
}

void ChartLines::drawPointedOut(QCPPainter& painter)
{
    const auto onScreen = [this](const QPolygonF& corners) {
        QPolygonF places;
        for (const QPointF& corner : corners) {
            const QPointF at = pixel(corner.x(), corner.y());
            places << QPointF(std::clamp(at.x(), -farAway, farAway), std::clamp(at.y(), -farAway, farAway));
        }
        return places;
    };
    QColor ground = style_.limit;
    ground.setAlpha(70);
    painter.setPen(QPen(style_.limit, style_.line_width));
    painter.setBrush(ground);
    for (const QPolygonF& shape : pointed_out.shapes) painter.drawPolygon(onScreen(shape));
    painter.setPen(QPen(style_.marker, 2.5 * style_.line_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    for (const QPolygonF& line : pointed_out.lines) painter.drawPolyline(onScreen(line));
    if (!pointed_out.place) return;
    painter.setPen(QPen(style_.background, 1));
    painter.setBrush(style_.marker);
    painter.drawEllipse(pixel(pointed_out.place->x(), pointed_out.place->y()), 3 * style_.line_width,
                        3 * style_.line_width);
}

void ChartLines::drawLine(QCPPainter& painter, bool upright, double place, const report::Caption& name, const QPen& pen)
{
    const QRectF room = clipRect();
    const QPointF at = pixel(place, place);
    if (upright ? at.x() < room.left() || at.x() > room.right() : at.y() < room.top() || at.y() > room.bottom()) return;
    painter.setPen(pen);
    if (upright) {
        painter.drawLine(QPointF(at.x(), room.top()), QPointF(at.x(), room.bottom()));
        drawName(painter, QPointF(at.x(), room.top() + QFontMetricsF(font).height()), name);
    } else {
        painter.drawLine(QPointF(room.left(), at.y()), QPointF(room.right(), at.y()));
        const double width = QFontMetricsF(font).horizontalAdvance(chartText(name)) + 12;
        drawName(painter, QPointF(room.right() - width, at.y() - 1), name);
    }
}

/// Above and beside `place`; a label that would be clipped at the right edge is placed to the left, one that would
/// overlap another below it.
void ChartLines::drawName(QCPPainter& painter, const QPointF& place, const report::Caption& name)
{
    const QString text = chartText(name);
    if (text.isEmpty()) return;
    const QFontMetricsF metrics(font);
    const double width = metrics.horizontalAdvance(text) + 10;
    const bool cut = place.x() + width > clipRect().right();
    const bool high = place.y() - metrics.height() < clipRect().top();  // then placed below
    QRectF room(cut ? place.x() - width : place.x(), high ? place.y() + 2 : place.y() - metrics.height(), width,
                metrics.height());
    constexpr int mostRows = 6;
    const auto covers = [&](const QRectF& other) { return other.intersects(room); };
    for (int row = 0; row < mostRows && std::any_of(names_.begin(), names_.end(), covers); ++row)
        room.translate(0, metrics.height());
    names_.push_back(room);
    QColor ground = style_.background;
    ground.setAlpha(200);
    painter.fillRect(room.adjusted(1, 0, -1, 0), ground);
    painter.setFont(font);
    painter.setPen(style_.limit);
    painter.drawText(room, Qt::AlignCenter, text);
}

void ChartLines::drawHandle(QCPPainter& painter, const report::Handle& handle, bool isChosen)
{
    const double width = (isChosen ? 2 : 1) * style_.line_width;
    if (handle.kind != report::Handle::Kind::Point) {
        const bool upright = handle.kind == report::Handle::Kind::Vertical;
        return drawLine(painter, upright, upright ? handle.x : handle.y, handle.name,
                        QPen(style_.limit, width, Qt::DashLine));
    }
    const QPointF place = pixel(handle.x, handle.y);
    if (glows) {
        constexpr double glowReach = 4;  // of the handle's
        QRadialGradient light(place, glowReach * reach());
        QColor inner = style_.limit, outer = style_.limit;
        inner.setAlpha(150);
        outer.setAlpha(0);
        light.setColorAt(0, inner);
        light.setColorAt(1, outer);
        painter.setPen(Qt::NoPen);
        painter.setBrush(light);
        painter.drawEllipse(place, glowReach * reach(), glowReach * reach());
    }
    QColor ground = style_.background;
    ground.setAlpha(150);
    painter.setPen(QPen(style_.limit, 1.3 * width));
    painter.setBrush(ground);
    painter.drawEllipse(place, reach(), reach());
    painter.setPen(Qt::NoPen);
    painter.setBrush(style_.limit);
    painter.drawEllipse(place, style_.line_width, style_.line_width);
    drawName(painter, place + QPointF(reach(), -reach()), handle.name);
}

}  // namespace lathelier::plot
