// Legend of a polar plot: full names, or short ones if the disc needs the space.
#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "widgets/plot/polar_painter.h"

namespace lathelier::plot {

namespace {

// In lines of type.
constexpr double sampleWidth = 2.2, shortSample = 1.5;
constexpr double legendGap = 0.6;
constexpr double rowStep = 1.15;
constexpr double columnStep = 1.35;

}  // namespace

std::vector<PolarPainter::LegendLine> PolarPainter::legendLines(bool shortNames) const
{
    using Kind = LegendLine::Kind;
    std::vector<LegendLine> lines;
    const auto add = [&](QString text, const QColor& colour, Kind kind) {
        if (shortNames) text = text.section("  ", 0, 0);  // a value follows the name
        const bool known =
            std::any_of(lines.begin(), lines.end(), [&](const LegendLine& line) { return line.text == text; });
        if (!text.isEmpty() && !known) lines.push_back({text, colour, kind});
    };
    std::size_t position = 0;
    for (const report::PolarPlot::Trace& trace : picture_.plot.traces)
        add(chartText(trace.name), style_.colour(trace.colour, position++), trace.thin ? Kind::Thin : Kind::Line);
    for (const report::PolarPlot::ReferenceLine& circle : picture_.plot.circles) {
        const QColor colour = style_.colour(circle.colour, position++);
        if (isDrawn(circle)) add(chartText(circle.name), colour, circle.dashed ? Kind::Dashed : Kind::Line);
    }
    for (std::size_t i = 0; i < picture_.plot.rings.size(); ++i)
        add(chartText(picture_.plot.rings[i].name), style_.colour(picture_.plot.rings[i].colour, i), Kind::Ring);
    for (const bool outer : {true, false})
        if (std::any_of(picture_.plot.contacts.begin(), picture_.plot.contacts.end(),
                        [&](const report::PolarPlot::Mark& mark) { return mark.outer == outer; }))
            add(outer ? PolarWords::tr("outer contact") : PolarWords::tr("inner contact"), style_.text,
                outer ? Kind::Outer : Kind::Inner);
    return lines;
}

PolarPainter::Legend PolarPainter::column(Legend legend) const
{
    const QFontMetricsF metrics(font_);
    const double line = metrics.height();
    for (LegendLine& entry : legend.lines) {
        entry.place = {0, legend.size.height()};
        legend.size = {
            std::max(legend.size.width(), legend.sample_px + legendGap * line + metrics.horizontalAdvance(entry.text)),
            legend.size.height() + columnStep * line};
    }
    return legend;
}

/// Columns of equal width; if only one fits, entries are set consecutively.
PolarPainter::Legend PolarPainter::rows(Legend legend, double width_px) const
{
    const QFontMetricsF metrics(font_);
    const double line = metrics.height();
    const auto widthOf = [&](const LegendLine& entry) {
        return legend.sample_px + legendGap * line + metrics.horizontalAdvance(entry.text);
    };
    if (legend.lines.empty()) return legend;
    double widest = 0;
    for (const LegendLine& entry : legend.lines) widest = std::max(widest, widthOf(entry));
    const auto columns = static_cast<int>(width_px / widest);
    QPointF next(0, 0);
    double used = 0;
    for (LegendLine& entry : legend.lines) {
        const double width = columns > 2 ? widest : widthOf(entry);
        if (next.x() > 0 && next.x() + width > width_px) next = {0, next.y() + rowStep * line};
        entry.place = next;
        next.rx() += width;
        used = std::max(used, next.x());
    }
    legend.size = {used, next.y() + rowStep * line + 4};
    return legend;
}

PolarPainter::Split PolarPainter::split(const QRectF& room, const QSizeF& margins, bool shortNames) const
{
    const auto disc = [&](const QRectF& rest) {
        return std::min(rest.width() - 2 * margins.width(), rest.height() - 2 * margins.height());
    };
    Legend legend;
    legend.lines = legendLines(shortNames);
    legend.sample_px = (shortNames ? shortSample : sampleWidth) * QFontMetricsF(font_).height();
    if (legend.lines.empty()) return {disc(room), room, {}, {}};
    Split below, beside;
    below.legend = rows(legend, room.width());
    below.disc = room.adjusted(0, 0, 0, -below.legend.size.height());
    below.disc_px = disc(below.disc);
    below.legend_at = {room.center().x() - below.legend.size.width() / 2, below.disc.bottom()};
    beside.legend = column(std::move(legend));
    if (beside.legend.size.height() > room.height()) return below;
    const double width = std::min(room.width() - beside.legend.size.width(), room.height() + 2 * margins.width());
    const double spare = std::max(0.0, room.width() - beside.legend.size.width() - width) / 2;
    beside.disc = QRectF(room.left() + spare, room.top(), width, room.height());
    beside.disc_px = disc(beside.disc);
    beside.legend_at = beside.disc.topRight();
    return beside.disc_px > below.disc_px ? beside : below;
}

void PolarPainter::paintLegend(QPainter& painter) const
{
    const double line = QFontMetricsF(font_).height();
    for (const LegendLine& entry : layout_.legend.lines) {
        const QRectF place(layout_.legend_at + entry.place, QSizeF(layout_.legend.size.width(), line));
        const double half = layout_.legend.sample_px / 2 - 0.2 * line;
        const QPointF middle(place.left() + half, place.center().y());
        using Kind = LegendLine::Kind;
        if (entry.kind == Kind::Outer || entry.kind == Kind::Inner) {
            paintMark(painter, middle, entry.kind == Kind::Outer, entry.colour);
        } else if (entry.kind == Kind::Ring) {
            QColor fill = entry.colour;
            fill.setAlphaF(0.3);
            painter.fillRect(QRectF(middle.x() - 0.9 * half, middle.y() - 0.3 * line, 1.8 * half, 0.6 * line), fill);
        } else {
            painter.setPen(QPen(entry.colour, entry.kind == Kind::Thin ? 1 : 1.2 * style_.line_width,
                                entry.kind == Kind::Dashed ? Qt::DashLine : Qt::SolidLine));
            painter.drawLine(middle - QPointF(0.9 * half, 0), middle + QPointF(0.9 * half, 0));
        }
        painter.setPen(style_.text);
        painter.drawText(place.adjusted(layout_.legend.sample_px, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         entry.text);
    }
}

}  // namespace lathelier::plot
