// The limits of a PlotView: lines across it, some of which can be dragged.
#include <algorithm>
#include <cmath>

#include "widgets/plot/plot_view_content.h"

namespace lathelier {

void PlotView::placeLimits()
{
    Content& c = *content_;
    for (std::size_t i = 0; i < c.limits.size(); ++i) {
        const PlotLimit& limit = c.data.limits[i];
        const auto [line, label] = c.limits[i];
        const bool level = limit.orientation == Qt::Horizontal;
        line->point1->setCoords(level ? 0 : limit.value, level ? limit.value : 0);
        line->point2->setCoords(level ? 1 : limit.value, level ? limit.value : 1);
        label->setText(limit.label);
        QCPItemPosition* place = label->position;
        place->setTypeX(level ? QCPItemPosition::ptAxisRectRatio : QCPItemPosition::ptPlotCoords);
        place->setTypeY(level ? QCPItemPosition::ptPlotCoords : QCPItemPosition::ptAxisRectRatio);
        place->setCoords(level ? 0.995 : limit.value, level ? limit.value : 0.01);
        // A name that would be cut off at the right edge stands at the left of its line.
        const double room = plot().axisRect()->right() - pixelAt(limit.value, 0).x();
        const bool cut = QFontMetricsF(font()).horizontalAdvance(limit.label) + 10 > room;
        label->setPositionAlignment(level ? Qt::AlignRight | Qt::AlignBottom
                                          : (cut ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop);
        label->setPadding(QMargins(5, 0, 5, 0));
    }
}

void PlotView::setLimitValues(const std::vector<double>& values)
{
    for (std::size_t i = 0; i < std::min(values.size(), content_->data.limits.size()); ++i)
        content_->data.limits[i].value = values[i];
    placeLimits();
    redraw();
}

std::optional<int> PlotView::limitAt(const QPointF& place) const
{
    for (std::size_t i = 0; i < content_->data.limits.size(); ++i) {
        const PlotLimit& limit = content_->data.limits[i];
        const QPointF there = pixelAt(limit.value, limit.value);
        const double away = limit.orientation == Qt::Vertical ? place.x() - there.x() : place.y() - there.y();
        if (limit.movable && std::abs(away) <= 6) return static_cast<int>(i);
    }
    return std::nullopt;
}

bool PlotView::isHandle(const QPointF& place, Qt::CursorShape& shape) const
{
    const auto index = limitAt(place);
    if (!index) return false;
    const bool upright = content_->data.limits[static_cast<std::size_t>(*index)].orientation == Qt::Vertical;
    shape = upright ? Qt::SplitHCursor : Qt::SplitVCursor;
    return true;
}

bool PlotView::beginDrag(const QPointF& place)
{
    content_->dragged = limitAt(place);
    return content_->dragged.has_value();
}

void PlotView::continueDrag(double x, double y)
{
    if (!content_->dragged) return;  // gone: new data came without it
    PlotLimit& limit = content_->data.limits[static_cast<std::size_t>(*content_->dragged)];
    limit.value = limit.orientation == Qt::Vertical ? x : y;
    placeLimits();
    redraw();
    emit limitMoved(*content_->dragged, limit.value);
}

void PlotView::endDrag()
{
    if (!content_->dragged) return;
    const int index = *content_->dragged;
    content_->dragged.reset();
    refresh(true);
    emit limitDropped(index, content_->data.limits[static_cast<std::size_t>(index)].value);
}

}  // namespace lathelier
