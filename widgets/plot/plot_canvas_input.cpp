// Mouse and keyboard interaction of a PlotCanvas.
#include <cmath>

#include "widgets/plot/plot_parts.h"

namespace lathelier::plot {

bool PlotCanvas::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != plot_) return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::Leave) hideCrosshair();
    // QCustomPlot does not propagate mouse events, including the context menu, to its parent.
    if (event->type() == QEvent::ContextMenu) {
        const auto* request = static_cast<QContextMenuEvent*>(event);
        QContextMenuEvent here(request->reason(), plot_->mapTo(this, request->pos()), request->globalPos(),
                               request->modifiers());
        contextMenuEvent(&here);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void PlotCanvas::hideCrosshair()
{
    parts_->vertical->setVisible(false);
    parts_->horizontal->setVisible(false);
    parts_->readout->set({});
    tag_->say({}, {});
    drawOverlay();
}

void PlotCanvas::mousePressed(QMouseEvent* event)
{
    setFocus(Qt::MouseFocusReason);
    if (event->button() != Qt::LeftButton) return;
    parts_->pressed = true;
    parts_->has_clicked = false;
    parts_->pressed_at = event->pos();
    if (parts_->draws_stretch && plot_->axisRect()->rect().contains(event->pos())) {
        parts_->drawn_from = plot_->xAxis->pixelToCoord(event->pos().x());
        return plot_->setInteraction(QCP::iRangeDrag, false);
    }
    parts_->drags_content = beginDrag(event->pos());
    plot_->setInteraction(QCP::iRangeDrag, !parts_->drags_content);
}

void PlotCanvas::mouseMoved(QMouseEvent* event)
{
    const double x = plot_->xAxis->pixelToCoord(event->pos().x());
    const double y = plot_->yAxis->pixelToCoord(event->pos().y());
    if (parts_->drawn_from) {
        parts_->stretch->topLeft->setCoords(*parts_->drawn_from, plot_->yAxis->range().upper);
        parts_->stretch->bottomRight->setCoords(x, plot_->yAxis->range().lower);
        parts_->stretch->setVisible(true);
        const auto number = [&](double v) {
            return readable(v * parts_->x_factor, visibleRange().width() * parts_->x_factor, locale());
        };
        tag_->say({number(std::min(*parts_->drawn_from, x)) + " … " + number(std::max(*parts_->drawn_from, x)), {}},
                  event->pos());
        return drawOverlay();
    }
    if (parts_->drags_content) return continueDrag(x, y);
    if (parts_->pressed && (event->pos() - parts_->pressed_at).manhattanLength() > 3) parts_->view_chosen = true;
    if (!plot_->axisRect()->rect().contains(event->pos())) return hideCrosshair();
    Qt::CursorShape shape = Qt::CrossCursor;
    if (parts_->draws_stretch)
        shape = Qt::SplitHCursor;
    else
        isHandle(event->pos(), shape);
    plot_->setCursor(shape);
    parts_->vertical->point1->setCoords(x, y);
    parts_->vertical->point2->setCoords(x, y + 1);
    parts_->horizontal->point1->setCoords(x, y);
    parts_->horizontal->point2->setCoords(x + 1, y);
    parts_->vertical->setVisible(true);
    parts_->horizontal->setVisible(true);
    parts_->readout->set(readoutAt(x, y));
    tag_->say(parts_->pressed ? PointerTag::Words() : tagAt(event->pos(), x, y), event->pos());
    drawOverlay();
}

void PlotCanvas::mouseReleased(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !parts_->pressed) return;
    parts_->pressed = false;
    plot_->setInteraction(QCP::iRangeDrag, true);
    if (parts_->drawn_from) {
        const double from = *parts_->drawn_from;
        const double to = plot_->xAxis->pixelToCoord(event->pos().x());
        parts_->drawn_from.reset();
        parts_->stretch->setVisible(false);
        hideCrosshair();
        if (std::abs(event->pos().x() - parts_->pressed_at.x()) > 3)
            emit stretchDrawn(std::min(from, to), std::max(from, to));
        return;
    }
    if (parts_->drags_content) {
        parts_->drags_content = false;
        return endDrag();
    }
    const bool still = (event->pos() - parts_->pressed_at).manhattanLength() <= 3;
    if (!still || !plot_->axisRect()->rect().contains(event->pos())) return;
    parts_->has_clicked = true;
    emit clicked(plot_->xAxis->pixelToCoord(event->pos().x()), plot_->yAxis->pixelToCoord(event->pos().y()));
}

void PlotCanvas::mouseDoubleClicked(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) return;
    if (parts_->has_clicked) emit clickTakenBack();
    parts_->has_clicked = false;
    resetView();
}

void PlotCanvas::mouseWheel(QWheelEvent* event)
{
    // Over the numbers of one axis the wheel zooms this axis alone.
    const QRect inner = plot_->axisRect()->rect();
    const QPointF place = event->position();
    Qt::Orientations zoom = Qt::Horizontal | Qt::Vertical;
    if (place.y() > inner.bottom())
        zoom = Qt::Horizontal;
    else if (place.x() < inner.left())
        zoom = Qt::Vertical;
    plot_->axisRect()->setRangeZoom(zoom);
    parts_->view_chosen = true;
}

void PlotCanvas::keyPressEvent(QKeyEvent* event)
{
    const auto pan = [&](QCPAxis* axis, double share) {
        const QCPRange range = axis->range();
        const bool byFactor = axis->scaleType() == QCPAxis::stLogarithmic;
        axis->moveRange(byFactor ? std::pow(range.upper / range.lower, share) : share * range.size());
    };
    const auto zoom = [&](double factor) {
        plot_->xAxis->scaleRange(factor);
        plot_->yAxis->scaleRange(factor);
    };
    switch (event->key()) {
        case Qt::Key_Left: pan(plot_->xAxis, -0.1); break;
        case Qt::Key_Right: pan(plot_->xAxis, 0.1); break;
        case Qt::Key_Up: pan(plot_->yAxis, 0.1); break;
        case Qt::Key_Down: pan(plot_->yAxis, -0.1); break;
        case Qt::Key_Plus: zoom(0.8); break;
        case Qt::Key_Minus: zoom(1.25); break;
        case Qt::Key_Home: return resetView();
        default: return QWidget::keyPressEvent(event);
    }
    parts_->view_chosen = true;
    plot_->replot();
}

}  // namespace lathelier::plot
