// Charts placed one below the other with a common x axis.
#include "widgets/plot/chart_parts.h"

namespace lathelier::plot {

void ChartView::followX(ChartView* leader)
{
    content_->leader = leader;
    QCPMarginGroup* margins = leader->plot().axisRect()->marginGroup(QCP::msLeft);
    if (!margins) margins = new QCPMarginGroup(&leader->plot());
    for (ChartView* chart : {leader, this})
        chart->plot().axisRect()->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    connect(leader, &ChartView::rangeChanged, this, [this] {
        const QRectF shown = content_->leader->visibleRange();
        takeX(shown.left(), shown.right());
    });
    connect(this, &ChartView::rangeChanged, leader, [this] {
        if (content_->sharing) return;
        const QRectF shown = visibleRange();
        content_->leader->showX(shown.left(), shown.right());
    });
}

/// Propagates the range of the leader.
void ChartView::takeX(double lower, double upper)
{
    if (plot().xAxis->range() == QCPRange(lower, upper)) return;
    content_->sharing = true;
    plot().xAxis->setRange(lower, upper);
    content_->sharing = false;
    redraw();
}

/// Propagates the range of a zoomed or panned follower; equal scales are preserved.
void ChartView::showX(double lower, double upper)
{
    QCPAxis* const x = plot().xAxis;
    if (x->range() == QCPRange(lower, upper)) return;
    const double factor = (upper - lower) / x->range().size();
    chooseView();
    x->setRange(lower, upper);
    if (content_->data.equal_scales) plot().yAxis->scaleRange(factor);
    redraw();
}

void ChartView::resetView()
{
    if (content_->leader) content_->leader->resetView();
    PlotCanvas::resetView();
}

}  // namespace lathelier::plot
