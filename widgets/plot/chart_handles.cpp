// Mouse and keyboard interaction of the handles of a ChartView.
#include <algorithm>
#include <cmath>

#include "widgets/plot/chart_parts.h"

namespace lathelier::plot {
namespace {

constexpr double nearEnough = 6;  ///< picking distance of a line in px
constexpr double keyStep = 0.01;  ///< step of an arrow key relative to the visible range
constexpr double fineKeyStep = 0.001;

/// Moves by a share of the visible range; by a factor on a logarithmic axis.
double stepped(const QCPAxis& axis, double value, double share)
{
    const QCPRange range = axis.range();
    return axis.scaleType() == QCPAxis::stLogarithmic ? value * std::pow(range.upper / range.lower, share)
                                                      : value + share * range.size();
}

}  // namespace

std::optional<std::size_t> ChartView::handleAt(const QPointF& place) const
{
    const Content& c = *content_;
    std::optional<std::size_t> nearest;
    double least = nearEnough;
    for (std::size_t i = 0; i < c.data.handles.size(); ++i) {
        const report::Handle& handle = c.data.handles[i];
        const QPointF away = place - pixelAt(handle.x, handle.y);
        double distance = std::abs(handle.kind == report::Handle::Kind::Vertical ? away.x() : away.y());
        // Points have precedence over lines.
        if (handle.kind == report::Handle::Kind::Point) distance = std::hypot(away.x(), away.y()) - c.lines->reach();
        if (distance > least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

bool ChartView::isHandle(const QPointF& place, Qt::CursorShape& shape) const
{
    const auto index = handleAt(place);
    if (!index) return false;
    switch (content_->data.handles[*index].kind) {
        case report::Handle::Kind::Point: shape = Qt::SizeAllCursor; break;
        case report::Handle::Kind::Vertical: shape = Qt::SplitHCursor; break;
        case report::Handle::Kind::Horizontal: shape = Qt::SplitVCursor; break;
    }
    return true;
}

void ChartView::choose(std::optional<std::size_t> handle)
{
    content_->lines->chosen = handle;
    if (!handle) setReadout({});
    drawOverlay();
}

void ChartView::setHandle(const QString& key, double x, double y)
{
    for (report::Handle& handle : content_->data.handles)
        if (handle.key == key.toStdString()) report::moveHandle(handle, x, y);
    drawOverlay();
}

void ChartView::setGlow(bool glows)
{
    content_->lines->glows = glows;
    drawOverlay();
}

bool ChartView::glows() const
{
    return content_->lines->glows;
}

void ChartView::moveChosen(double x, double y)
{
    Content& c = *content_;
    report::Handle& handle = c.data.handles[*c.lines->chosen];
    const QPointF before(handle.x, handle.y);
    report::moveHandle(handle, x, y);
    if (before.x() == handle.x && before.y() == handle.y) return;
    c.has_moved = true;
    c.lines->glows = false;
    setReadout(chartText(handle.name) + (report::captionText(handle.name).empty() ? "" : "  ·  ") +
               readoutAt(handle.x, handle.y));
    drawOverlay();
    emit handleMoved(QString::fromStdString(handle.key), handle.x, handle.y, false);
}

void ChartView::drop()
{
    Content& c = *content_;
    const bool moved = c.has_moved;
    c.holds = c.has_moved = false;
    if (!moved || !c.lines->chosen) return;
    refresh(true);
    const report::Handle handle = c.data.handles[*c.lines->chosen];  // copied, since a slot may set new data
    emit handleMoved(QString::fromStdString(handle.key), handle.x, handle.y, true);
}

bool ChartView::beginDrag(const QPointF& place)
{
    choose(handleAt(place));
    content_->holds = content_->lines->chosen.has_value();
    return content_->holds;
}

void ChartView::continueDrag(double x, double y)
{
    if (content_->holds) moveChosen(x, y);  // otherwise new data no longer contain it
}

void ChartView::endDrag()
{
    drop();
}

void ChartView::keyPressEvent(QKeyEvent* event)
{
    const auto chosen = content_->lines->chosen;
    if (!chosen) return PlotCanvas::keyPressEvent(event);
    if (event->key() == Qt::Key_Escape) return choose({});
    const double step = event->modifiers() & Qt::ShiftModifier ? fineKeyStep : keyStep;
    const report::Handle& handle = content_->data.handles[*chosen];
    const auto along = [&](double share) { moveChosen(stepped(*plot().xAxis, handle.x, share), handle.y); };
    const auto up = [&](double share) { moveChosen(handle.x, stepped(*plot().yAxis, handle.y, share)); };
    switch (event->key()) {
        case Qt::Key_Left: along(-step); break;
        case Qt::Key_Right: along(step); break;
        case Qt::Key_Up: up(step); break;
        case Qt::Key_Down: up(-step); break;
        default: PlotCanvas::keyPressEvent(event);
    }
}

void ChartView::keyReleaseEvent(QKeyEvent* event)
{
    if (!event->isAutoRepeat() && !content_->holds) drop();
    PlotCanvas::keyReleaseEvent(event);
}

void ChartView::focusOutEvent(QFocusEvent* event)
{
    if (!content_->holds) drop();
    PlotCanvas::focusOutEvent(event);
}

/// Tab cycles through the handles before it leaves the chart.
bool ChartView::focusNextPrevChild(bool next)
{
    const int count = static_cast<int>(content_->data.handles.size());
    const int at = content_->lines->chosen ? static_cast<int>(*content_->lines->chosen) : -1;
    const int to = at + (next ? 1 : -1);
    if (to < -1 || to >= count) {
        choose({});
        return PlotCanvas::focusNextPrevChild(next);
    }
    choose(to < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(to)));
    return true;
}

}  // namespace lathelier::plot
