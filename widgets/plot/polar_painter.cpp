#include "widgets/plot/polar_painter.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/core/language.h"

namespace lathelier::plot {

namespace {

// In lines of type.
constexpr double lowestWithReadout = 13;
constexpr double lowestWithTitle = 9;
constexpr double smallestWithDegrees = 5;
constexpr double smallestWithAllDegrees = 9;
constexpr double leastShareOfDisc = 0.72;
constexpr double smallestWithNames = 16;
constexpr double ringOpacity = 0.16;

QString signedDivision(double value, const QLocale& locale)
{
    if (value == 0) return QStringLiteral("0");
    QString text = locale.toString(std::abs(value), 'g', 6);
    return (value > 0 ? QStringLiteral("+") : QStringLiteral("−")) + text;
}

}  // namespace

double sharePerUm(const PolarPicture& picture, double magnification)
{
    const double base_mm = picture.plot.base_radius_mm > 0 ? picture.plot.base_radius_mm : 1;
    return magnification / (base_mm * 1000);
}

PolarPainter::PolarPainter(const PolarPicture& picture, double magnification, const QRectF& room, const QFont& font,
                           const PlotStyle& style, const QLocale& locale, std::string asked)
    : picture_(picture),
      magnification_(magnification),
      font_(font),
      style_(style),
      locale_(locale),
      asked_(std::move(asked)),
      layout_(layOut(room)),
      scale_(sharePerUm(picture, magnification), picture, layout_.disc.center(), layout_.disc.width() / 2),
      division_um_(division_um(scale_, 1.25 * QFontMetricsF(font).height(), screenFactor(micrometre)))
{
}

PolarPainter::Layout PolarPainter::layOut(const QRectF& room) const
{
    const QFontMetricsF metrics(font_);
    const double line = metrics.height();
    Layout layout;
    layout.title = QRectF(room.left() + 6, room.top(), room.width() - 12, line + 4);
    if (room.height() < lowestWithTitle * line) layout.title.setHeight(0);
    QRectF rest = room.adjusted(4, layout.title.height() + 2, -4, -4);
    if (rest.height() > lowestWithReadout * line) {
        layout.readout = layout.title.translated(0, line + 2);
        rest.setTop(layout.readout.bottom());
    }
    QSizeF margins(metrics.horizontalAdvance("180°") + 0.5 * line, 1.45 * line);
    const auto bare = [&] {
        return std::min(rest.width() - 2 * margins.width(), rest.height() - 2 * margins.height());
    };
    if (bare() < smallestWithDegrees * line) {
        layout.degrees = 0;
        margins = {2, 2};
    } else if (bare() < smallestWithAllDegrees * line) {
        layout.degrees = 90;
    }
    // The legend is shortened, then omitted, before it takes a large share of the disc.
    Split best;
    for (const bool shortNames : {false, true}) {
        best = split(rest, margins, shortNames);
        if (best.disc_px >= leastShareOfDisc * bare()) break;
    }
    if (best.disc_px < leastShareOfDisc * bare()) best = {bare(), rest, {}, {}};
    const double side = std::max(20.0, best.disc_px);
    layout.disc = QRectF(best.disc.center().x() - side / 2, best.disc.center().y() - side / 2, side, side);
    layout.legend = std::move(best.legend);
    layout.legend_at = best.legend_at;
    return layout;
}

QString PolarPainter::remark() const
{
    QString division =
        PolarWords::tr("%1 %2/div")
            .arg(locale_.toString(division_um_ * screenFactor(micrometre), 'g', 6), screenUnit(micrometre));
    if (picture_.plot.base_radius_mm <= 0) return division;
    return PolarWords::tr("deviation × %1 · %2").arg(locale_.toString(magnification_, 'f', 0), division);
}

void PolarPainter::paint(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font_);
    paintTitle(painter);
    paintGrid(painter);
    paintScale(painter);
    painter.save();
    QPainterPath disc;
    disc.addEllipse(layout_.disc);
    painter.setClipPath(disc);
    paintRings(painter);
    paintLines(painter, true);
    paintCircles(painter);
    paintLines(painter, false);
    paintContacts(painter);
    painter.restore();
    paintContactNames(painter);
    paintLegend(painter);
}

void PolarPainter::paintTitle(QPainter& painter) const
{
    if (layout_.title.isEmpty()) return;
    QFont bold = font_;
    bold.setBold(true);
    const QFontMetricsF boldMetrics(bold), metrics(font_);
    const QString aside = remark();
    // The magnification is essential: the title is elided in favour of it.
    const double asideWidth = metrics.horizontalAdvance(aside) + metrics.height();
    const QString title = boldMetrics.elidedText(chartText(picture_.plot.title), Qt::ElideRight,
                                                 std::max(0.0, layout_.title.width() - asideWidth));
    painter.setPen(style_.text);
    painter.setFont(bold);
    painter.drawText(layout_.title, Qt::AlignLeft | Qt::AlignVCenter, title);
    painter.setFont(font_);
    if (layout_.readout.isEmpty()) {  // the readout is at the left
        painter.drawText(layout_.title, Qt::AlignRight | Qt::AlignVCenter, aside);
        return;
    }
    const double gap = title.isEmpty() ? 0 : boldMetrics.horizontalAdvance(title) + metrics.height();
    painter.drawText(layout_.title.adjusted(gap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, aside);
}

void PolarPainter::paintReadout(QPainter& painter, const QString& text) const
{
    const QFontMetricsF metrics(font_);
    QRectF place = layout_.readout;
    if (place.isEmpty()) {
        place = layout_.title.adjusted(0, 0, -metrics.horizontalAdvance(remark()) - metrics.height() / 2, 0);
        painter.fillRect(place, style_.background);
    }
    painter.setFont(font_);
    painter.setPen(style_.text);
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(text, Qt::ElideRight, place.width()));
}

void PolarPainter::paintGrid(QPainter& painter) const
{
    const QPointF centre = scale_.centre();
    const double room = scale_.room_px();
    const double line = QFontMetricsF(font_).height();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(style_.grid, 1));
    const double step = scale_.pixelsPerUm() * division_um_;
    for (double radius = scale_.base_px() + step; radius < room; radius += step)
        painter.drawEllipse(centre, radius, radius);
    for (double radius = scale_.base_px() - step; radius > 1.5 * line; radius -= step)
        painter.drawEllipse(centre, radius, radius);
    for (int angle = 0; angle < 360; angle += 30) {
        const QPointF end = centre + (scale_.at(angle, 0) - centre) * (room / scale_.base_px());
        painter.setPen(QPen(style_.grid, 1));
        painter.drawLine(centre + (end - centre) * 0.05, end);
        if (layout_.degrees == 0 || angle % layout_.degrees != 0) continue;
        painter.setPen(style_.text);
        // Keeps a distance of half a line from the disc in every direction.
        const QString label = QStringLiteral("%1°").arg(angle);
        const QPointF outward = (end - centre) / room;
        const double half = QFontMetricsF(font_).horizontalAdvance(label) / 2;
        const QPointF place = end + QPointF(outward.x() * (half + 0.4 * line), outward.y() * 0.9 * line);
        painter.drawText(QRectF(place.x() - 3 * line, place.y() - line, 6 * line, 2 * line), Qt::AlignCenter, label);
    }
    painter.setPen(QPen(style_.text, 1, Qt::DotLine));
    painter.drawEllipse(centre, scale_.base_px(), scale_.base_px());
    painter.setPen(QPen(style_.text, 1));
    painter.drawEllipse(layout_.disc);
    painter.drawLine(centre - QPointF(line / 3, 0), centre + QPointF(line / 3, 0));
    painter.drawLine(centre - QPointF(0, line / 3), centre + QPointF(0, line / 3));
}

std::vector<report::PolarPlace> PolarPainter::drawnPlaces() const
{
    std::vector<report::PolarPlace> places;
    const auto add = [&](double angle_deg, double deviation_um) {
        if (!std::isfinite(angle_deg) || !std::isfinite(deviation_um)) return;
        const QPointF arm = scale_.at(angle_deg, deviation_um) - scale_.centre();
        places.push_back({arm.x(), -arm.y()});
    };
    for (const PolarLine& line : picture_.lines)
        for (std::size_t i = 0; i < line.angle_deg.size(); ++i) add(line.angle_deg[i], line.deviation_um[i]);
    for (const report::PolarPlot::ReferenceLine& circle : picture_.plot.circles)
        for (int angle = 0; angle < 360 && isDrawn(circle); ++angle)
            add(angle, deviationAt(circle, picture_.plot.base_radius_mm, angle));
    for (const report::PolarPlot::Mark& mark : picture_.plot.contacts) add(mark.angle_deg, mark.deviation_um);
    return places;
}

/// The numbers of the rings, along one ray where little is drawn. Painted below the data.
void PolarPainter::paintScale(QPainter& painter) const
{
    const QFontMetricsF metrics(font_);
    const double step = scale_.pixelsPerUm() * division_um_;
    const int every = std::max(1, static_cast<int>(std::ceil(1.6 * metrics.height() / step)));
    const int inward = static_cast<int>((scale_.base_px() - 2 * metrics.height()) / step);
    const int outward = static_cast<int>((scale_.room_px() - scale_.base_px()) / step);
    std::vector<report::RingLabel> labels;
    QStringList texts;
    const auto add = [&](int ring) {
        const double radius = scale_.base_px() + ring * step;
        if (radius > scale_.room_px() - 0.6 * metrics.height()) return;
        texts << (ring == 0 ? QStringLiteral("0 ") + screenUnit(micrometre)
                            : signedDivision(ring * division_um_ * screenFactor(micrometre), locale_));
        labels.push_back({radius, metrics.horizontalAdvance(texts.back()) + 6, metrics.height()});
    };
    add(0);  // placed first
    for (int ring = every; ring <= outward; ring += every) add(ring);
    for (int ring = -every; ring >= -inward; ring -= every) add(ring);
    report::placeRingLabels(labels, drawnPlaces(), scale_.room_px());
    QColor ground = style_.background;
    ground.setAlphaF(0.75);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!labels[i].place) continue;
        QRectF plate(0, 0, labels[i].width_px, labels[i].height_px);
        plate.moveCenter(scale_.centre() + QPointF(labels[i].place->x_px, -labels[i].place->y_px));
        painter.fillRect(plate, ground);
        painter.setPen(style_.text);
        painter.drawText(plate, Qt::AlignCenter, texts[static_cast<int>(i)]);
    }
}

void PolarPainter::paintLines(QPainter& painter, bool thin) const
{
    painter.setBrush(Qt::NoBrush);
    for (std::size_t t = 0; t < picture_.lines.size(); ++t) {
        const report::PolarPlot::Trace& trace = picture_.plot.traces[t];
        if (trace.thin != thin) continue;
        QColor colour = style_.colour(trace.colour, t);
        if (thin) colour.setAlphaF(0.35);
        painter.setPen(QPen(colour, thin ? 1.0 : 1.2 * style_.line_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const PolarLine& line = picture_.lines[t];
        QPolygonF points;
        points.reserve(static_cast<int>(line.angle_deg.size()) + 1);
        const auto flush = [&] {
            if (points.size() > 1) painter.drawPolyline(points);
            points.clear();
        };
        for (std::size_t i = 0; i < line.angle_deg.size(); ++i) {
            if (std::isnan(line.angle_deg[i]))
                flush();
            else
                points << scale_.at(line.angle_deg[i], line.deviation_um[i]);
        }
        if (line.closed && !points.isEmpty()) points << scale_.at(line.angle_deg.front(), line.deviation_um.front());
        flush();
    }
}

void PolarPainter::paintCircles(QPainter& painter) const
{
    std::size_t position = picture_.plot.traces.size();
    for (const report::PolarPlot::ReferenceLine& line : picture_.plot.circles) {
        painter.setPen(QPen(style_.colour(line.colour, position++), style_.line_width,
                            line.dashed ? Qt::DashLine : Qt::SolidLine));
        if (isDrawn(line)) painter.drawPolyline(circle(line));
    }
}

QPolygonF PolarPainter::circle(const report::PolarPlot::ReferenceLine& line) const
{
    QPolygonF points;
    for (int i = 0; i <= 720; ++i) {
        const double deviation_um = deviationAt(line, picture_.plot.base_radius_mm, i / 2.0);
        if (std::isfinite(deviation_um)) points << scale_.at(i / 2.0, deviation_um);
    }
    return points;
}

void PolarPainter::paintRings(QPainter& painter) const
{
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < picture_.plot.rings.size(); ++i) {
        const report::PolarPlot::Ring& ring = picture_.plot.rings[i];
        QPainterPath between;
        between.addPolygon(circle({{}, ring.x_um, ring.y_um, ring.outer_um}));
        between.addPolygon(circle({{}, ring.x_um, ring.y_um, ring.inner_um}));
        QColor fill = style_.colour(ring.colour, i);
        fill.setAlphaF(ringOpacity);
        painter.setBrush(fill);
        painter.drawPath(between);  // odd-even: not within the inner circle
    }
    painter.setBrush(Qt::NoBrush);
}

/// Label of a contact, outside the profile at an outer one, else inside; none in a small plot.
void PolarPainter::paintContactNames(QPainter& painter) const
{
    const QFontMetricsF metrics(font_);
    if (layout_.disc.width() < smallestWithNames * metrics.height()) return;
    painter.setFont(font_);
    for (const report::PolarPlot::Mark& mark : picture_.plot.contacts) {
        const QString name = chartText(mark.name);
        if (name.isEmpty()) continue;
        const QPointF arm = scale_.at(mark.angle_deg, mark.deviation_um) - scale_.centre();
        const double length = std::hypot(arm.x(), arm.y());
        if (!(length > 0)) continue;
        const QPointF outward = arm / length;
        QRectF plate(0, 0, metrics.horizontalAdvance(name) + 6, metrics.height());
        const double away = 0.9 * metrics.height() + std::abs(outward.x()) * plate.width() / 2;
        // no overlap with the degree labels
        const bool has_room = length + away + metrics.height() / 2 < scale_.room_px();
        plate.moveCenter(scale_.centre() + outward * (length + (mark.outer && has_room ? away : -away)));
        QColor ground = style_.background;
        ground.setAlphaF(0.75);
        painter.fillRect(plate, ground);
        painter.setPen(style_.text);
        painter.drawText(plate, Qt::AlignCenter, name);
    }
}

void PolarPainter::paintMark(QPainter& painter, const QPointF& place, bool outer, const QColor& colour) const
{
    const double size = 3.2 * style_.line_width;
    painter.setPen(QPen(style_.background, 1.5));
    painter.setBrush(colour);
    if (outer)
        painter.drawPolygon(QPolygonF({place + QPointF(0, -1.2 * size), place + QPointF(1.1 * size, 0.8 * size),
                                       place + QPointF(-1.1 * size, 0.8 * size)}));
    else
        painter.drawRect(QRectF(place.x() - 0.85 * size, place.y() - 0.85 * size, 1.7 * size, 1.7 * size));
    painter.setBrush(Qt::NoBrush);
}

void PolarPainter::paintContacts(QPainter& painter) const
{
    for (const report::PolarPlot::Mark& mark : picture_.plot.contacts)
        paintMark(painter, scale_.at(mark.angle_deg, mark.deviation_um), mark.outer, style_.text);
}

void PolarPainter::paintAngle(QPainter& painter, double angle_deg, const QColor& colour, bool strong) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF centre = scale_.centre();
    const QPointF end = centre + (scale_.at(angle_deg, 0) - centre) * (scale_.room_px() / scale_.base_px());
    painter.setPen(QPen(colour, strong ? style_.line_width : 1, strong ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(centre, end);
    for (std::size_t t = 0; t < picture_.readoutTraces(); ++t) {
        const report::PolarPlot::Trace& trace = picture_.plot.traces[t];
        if (trace.thin) continue;
        const auto nearest = nearestSample(trace, angle_deg);
        if (!nearest) continue;
        painter.setPen(QPen(style_.background, 1.5));
        painter.setBrush(colour);
        const double size = 3 * style_.line_width;
        painter.drawEllipse(scale_.at(trace.angle_deg[*nearest], trace.deviation_um[*nearest]), size, size);
        painter.setBrush(Qt::NoBrush);
        return;
    }
}

}  // namespace lathelier::plot
