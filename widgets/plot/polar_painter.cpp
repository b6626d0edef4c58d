#include "widgets/plot/polar_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/core/language.h"

namespace lathelier {

/// The words of this plot.
struct PolarWords {
    Q_DECLARE_TR_FUNCTIONS(lathelier::PolarWords)
};

struct PolarPainter::LegendLine {
    QString text;
    QColor colour;
    enum class Kind { Line, Thin, Dashed, Outer, Inner } kind = Kind::Line;
};

namespace {

QString words(const Caption& caption)
{
    return QString::fromStdString(captionText(caption, screenLanguage()));
}

QString signedDivision(double value_um, const QLocale& locale)
{
    if (value_um == 0) return QStringLiteral("0");
    QString text = locale.toString(std::abs(value_um), 'g', 6);
    return (value_um > 0 ? QStringLiteral("+") : QStringLiteral("−")) + text;
}

}  // namespace

double sharePerUm(const PolarPicture& picture, double magnification)
{
    const double base_mm = picture.plot.base_radius_mm > 0 ? picture.plot.base_radius_mm : 1;
    return magnification / (base_mm * 1000);
}

PolarPainter::PolarPainter(const PolarPicture& picture, double magnification, const QRectF& room, const QFont& font,
                           const PlotStyle& style, const QLocale& locale)
    : picture_(picture),
      magnification_(magnification),
      font_(font),
      style_(style),
      locale_(locale),
      layout_(layOut(room)),
      scale_(sharePerUm(picture, magnification), picture, layout_.disc.center(), layout_.disc.width() / 2),
      division_um_(division_um(scale_, 1.25 * QFontMetricsF(font).height()))
{
}

std::vector<PolarPainter::LegendLine> PolarPainter::legendLines() const
{
    std::vector<LegendLine> lines;
    const auto known = [&](const QString& text) {
        return std::any_of(lines.begin(), lines.end(), [&](const LegendLine& line) { return line.text == text; });
    };
    std::size_t position = 0;
    for (const PolarPlot::Trace& trace : picture_.plot.traces) {
        const QString name = words(trace.name);
        if (!name.isEmpty() && !known(name))
            lines.push_back(
                {name, colourOf(trace.colour, position), trace.thin ? LegendLine::Kind::Thin : LegendLine::Kind::Line});
        ++position;
    }
    for (const PolarPlot::ReferenceLine& circle : picture_.plot.circles) {
        const QString name = words(circle.name);
        if (!name.isEmpty())
            lines.push_back({name, colourOf(circle.colour, position),
                             circle.dashed ? LegendLine::Kind::Dashed : LegendLine::Kind::Line});
        ++position;
    }
    const auto contacts = [&](bool outer) {
        return std::any_of(picture_.plot.contacts.begin(), picture_.plot.contacts.end(),
                           [&](const PolarPlot::Mark& mark) { return mark.outer == outer; });
    };
    if (contacts(true)) lines.push_back({PolarWords::tr("outer contact"), style_.text, LegendLine::Kind::Outer});
    if (contacts(false)) lines.push_back({PolarWords::tr("inner contact"), style_.text, LegendLine::Kind::Inner});
    return lines;
}

QColor PolarPainter::colourOf(int wanted, std::size_t position) const
{
    return style_.curve(wanted >= 0 ? wanted : static_cast<int>(position));
}

PolarPainter::Layout PolarPainter::layOut(const QRectF& room) const
{
    const QFontMetricsF metrics(font_);
    const double line = metrics.height();
    Layout layout;
    layout.title = QRectF(room.left() + 6, room.top(), room.width() - 12, line + 4);
    QRectF rest = room.adjusted(4, line + 6, -4, -4);
    const std::vector<LegendLine> lines = legendLines();
    if (!lines.empty()) {
        double widest = 0;
        for (const LegendLine& entry : lines) widest = std::max(widest, metrics.horizontalAdvance(entry.text));
        widest += 2.6 * line;
        const int columns = std::max(1, static_cast<int>(rest.width() / widest));
        const double rows = std::ceil(static_cast<double>(lines.size()) / columns);
        const double below = rows * line * 1.15 + 4;
        // Where the disc becomes larger: with the legend beside it, or below.
        layout.beside = std::min(rest.width() - widest, rest.height()) > std::min(rest.width(), rest.height() - below);
        if (layout.beside) {
            const double side = std::min(rest.width() - widest, rest.height());
            const double spare = std::max(0.0, rest.width() - widest - side) / 2;
            layout.legend = QRectF(rest.left() + spare + side, rest.top(), widest, rest.height());
            rest = QRectF(rest.left() + spare, rest.top(), side, rest.height());
        } else {
            layout.legend = QRectF(rest.left(), rest.bottom() - below, rest.width(), below);
            rest.setBottom(layout.legend.top());
        }
    }
    const double degrees = metrics.horizontalAdvance("180°") + line * 0.5;
    const double side = std::max(20.0, std::min(rest.width(), rest.height()) - 2 * degrees);
    layout.disc = QRectF(rest.center().x() - side / 2, rest.center().y() - side / 2, side, side);
    return layout;
}

QString PolarPainter::remark() const
{
    const QString division = PolarWords::tr("%1 µm/div").arg(locale_.toString(division_um_, 'g', 6));
    if (picture_.plot.base_radius_mm <= 0) return division;
    return PolarWords::tr("deviation × %1 · %2").arg(locale_.toString(magnification_, 'f', 0), division);
}

void PolarPainter::paint(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font_);
    paintTitle(painter);
    paintGrid(painter);
    painter.save();
    QPainterPath disc;
    disc.addEllipse(layout_.disc);
    painter.setClipPath(disc);
    paintLines(painter, true);
    paintCircles(painter);
    paintLines(painter, false);
    paintContacts(painter);
    painter.restore();
    paintScale(painter);
    paintLegend(painter);
}

void PolarPainter::paintTitle(QPainter& painter) const
{
    QFont bold = font_;
    bold.setBold(true);
    const QFontMetricsF boldMetrics(bold), metrics(font_);
    const QString aside = remark();
    // The magnification is part of what the plot says: the title gives way to it.
    const double asideWidth = metrics.horizontalAdvance(aside) + metrics.height();
    const QString title = boldMetrics.elidedText(words(picture_.plot.title), Qt::ElideRight,
                                                 std::max(0.0, layout_.title.width() - asideWidth));
    painter.setPen(style_.text);
    painter.setFont(bold);
    painter.drawText(layout_.title, Qt::AlignLeft | Qt::AlignVCenter, title);
    painter.setFont(font_);
    const double gap = title.isEmpty() ? 0 : boldMetrics.horizontalAdvance(title) + metrics.height();
    painter.drawText(layout_.title.adjusted(gap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, aside);
}

void PolarPainter::paintReadout(QPainter& painter, const QString& text) const
{
    painter.fillRect(layout_.title, style_.background);
    painter.setFont(font_);
    painter.setPen(style_.text);
    painter.drawText(layout_.title, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(font_).elidedText(text, Qt::ElideRight, layout_.title.width()));
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
        painter.setPen(style_.text);
        // Clear of the disc by half a line in every direction, also where the label lies beside it.
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

/// The numbers of the rings, along one spoke between two of degrees.
void PolarPainter::paintScale(QPainter& painter) const
{
    const QFontMetricsF metrics(font_);
    const double step = scale_.pixelsPerUm() * division_um_;
    const int every = std::max(1, static_cast<int>(std::ceil(1.6 * metrics.height() / step)));
    const int inward = static_cast<int>((scale_.base_px() - 2 * metrics.height()) / step);
    const int outward = static_cast<int>((scale_.room_px() - scale_.base_px()) / step);
    for (int ring = -inward; ring <= outward; ++ring) {
        if (ring % every != 0) continue;
        const double value_um = ring * division_um_;
        if (scale_.base_px() + ring * step > scale_.room_px() - 0.6 * metrics.height()) break;
        const QString label = ring == 0 ? QStringLiteral("0 µm") : signedDivision(value_um, locale_);
        QRectF plate(0, 0, metrics.horizontalAdvance(label) + 6, metrics.height());
        plate.moveCenter(scale_.at(75, value_um));
        QColor ground = style_.background;
        ground.setAlphaF(0.75);
        painter.fillRect(plate, ground);
        painter.setPen(style_.text);
        painter.drawText(plate, Qt::AlignCenter, label);
    }
}

void PolarPainter::paintLines(QPainter& painter, bool thin) const
{
    painter.setBrush(Qt::NoBrush);
    for (std::size_t t = 0; t < picture_.lines.size(); ++t) {
        const PolarPlot::Trace& trace = picture_.plot.traces[t];
        if (trace.thin != thin) continue;
        QColor colour = colourOf(trace.colour, t);
        if (thin) colour.setAlphaF(0.35);
        painter.setPen(QPen(colour, thin ? 1.0 : 1.2 * style_.lineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
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
    for (const PolarPlot::ReferenceLine& circle : picture_.plot.circles) {
        painter.setPen(
            QPen(colourOf(circle.colour, position++), style_.lineWidth, circle.dashed ? Qt::DashLine : Qt::SolidLine));
        QPolygonF points;
        for (int i = 0; i <= 720; ++i) {
            const double deviation_um = deviationAt(circle, picture_.plot.base_radius_mm, i / 2.0);
            if (std::isfinite(deviation_um)) points << scale_.at(i / 2.0, deviation_um);
        }
        painter.drawPolyline(points);
    }
}

void PolarPainter::paintMark(QPainter& painter, const QPointF& place, bool outer, const QColor& colour) const
{
    const double size = 3.2 * style_.lineWidth;
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
    for (const PolarPlot::Mark& mark : picture_.plot.contacts)
        paintMark(painter, scale_.at(mark.angle_deg, mark.deviation_um), mark.outer, style_.text);
}

void PolarPainter::paintLegend(QPainter& painter) const
{
    const std::vector<LegendLine> lines = legendLines();
    if (lines.empty()) return;
    const QFontMetricsF metrics(font_);
    const double line = metrics.height();
    double widest = 0;
    for (const LegendLine& entry : lines) widest = std::max(widest, metrics.horizontalAdvance(entry.text));
    widest += 2.6 * line;
    const int columns = layout_.beside ? 1 : std::max(1, static_cast<int>(layout_.legend.width() / widest));
    const double step = layout_.beside ? 1.35 * line : 1.15 * line;
    const double used = std::min<double>(columns, static_cast<double>(lines.size())) * widest;
    const double left =
        layout_.beside ? layout_.legend.left() : layout_.legend.left() + (layout_.legend.width() - used) / 2;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto column = static_cast<double>(static_cast<int>(i) % columns);
        const auto row = static_cast<double>(static_cast<int>(i) / columns);
        const QRectF place(left + column * widest, layout_.legend.top() + row * step, widest, line);
        const QPointF middle(place.left() + line, place.center().y());
        const LegendLine& entry = lines[i];
        using Kind = LegendLine::Kind;
        if (entry.kind == Kind::Outer || entry.kind == Kind::Inner) {
            paintMark(painter, middle, entry.kind == Kind::Outer, entry.colour);
        } else {
            painter.setPen(QPen(entry.colour, entry.kind == Kind::Thin ? 1 : 1.2 * style_.lineWidth,
                                entry.kind == Kind::Dashed ? Qt::DashLine : Qt::SolidLine));
            painter.drawLine(middle - QPointF(0.8 * line, 0), middle + QPointF(0.8 * line, 0));
        }
        painter.setPen(style_.text);
        painter.drawText(place.adjusted(2.2 * line, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, entry.text);
    }
}

void PolarPainter::paintAngle(QPainter& painter, double angle_deg, const QColor& colour, bool strong) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF centre = scale_.centre();
    const QPointF end = centre + (scale_.at(angle_deg, 0) - centre) * (scale_.room_px() / scale_.base_px());
    painter.setPen(QPen(colour, strong ? style_.lineWidth : 1, strong ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(centre, end);
    for (std::size_t t = 0; t < picture_.plot.traces.size(); ++t) {
        const PolarPlot::Trace& trace = picture_.plot.traces[t];
        if (trace.thin) continue;
        const auto nearest = nearestSample(trace, angle_deg);
        if (!nearest) continue;
        painter.setPen(QPen(style_.background, 1.5));
        painter.setBrush(colour);
        const double size = 3 * style_.lineWidth;
        painter.drawEllipse(scale_.at(trace.angle_deg[*nearest], trace.deviation_um[*nearest]), size, size);
        painter.setBrush(Qt::NoBrush);
        return;
    }
}

}  // namespace lathelier
