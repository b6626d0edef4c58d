// What a ChartView draws by itself over QCustomPlot. Included by its .cpp files only, because it shows QCustomPlot.
#pragma once

#include <qcustomplot.h>

#include <optional>
#include <vector>

#include "widgets/plot/chart_view.h"

namespace lathelier::plot {

/// A shaded polygon; corners at infinity lie on the edge of the axes.
class RegionFill : public QCPAbstractPlottable {
public:
    RegionFill(QCPAxis* x, QCPAxis* y, const report::Region& region) : QCPAbstractPlottable(x, y), region_(region)
    {
        setLayer("background");
    }
    /// Lines in this colour over the ground, and along the edge so that a small area is seen.
    void setHatch(const QColor& colour) { hatch_ = colour; }
    double selectTest(const QPointF&, bool, QVariant*) const override { return -1; }
    QCPRange getKeyRange(bool& found, QCP::SignDomain) const override { return found = false, QCPRange(); }
    QCPRange getValueRange(bool& found, QCP::SignDomain, const QCPRange&) const override
    {
        return found = false, QCPRange();
    }

protected:
    void draw(QCPPainter* painter) override;
    void drawLegendIcon(QCPPainter* painter, const QRectF& rect) const override
    {
        painter->fillRect(rect, mBrush);
        if (hatch_.isValid()) painter->fillRect(rect, QBrush(hatch_, Qt::BDiagPattern));
    }

private:
    const report::Region region_;
    QColor hatch_;  ///< not valid: none
};

/// What lies over the curves: limits, marks, handles and the marked place, with their names.
class ChartLines : public QCPLayerable {
public:
    ChartLines(QCustomPlot* plot, const report::Plot& chart, const PlotStyle& style)
        : QCPLayerable(plot, "overlay"), chart_(chart), style_(style)
    {
    }
    QFont font;
    std::optional<double> markedX;      ///< an upright line
    std::vector<QPointF> markedPlaces;  ///< on paths
    std::optional<std::size_t> chosen;  ///< the handle that keys move
    PointedOut pointedOut;              ///< by a linked view

    double reach() const { return 0.4 * QFontMetricsF(font).height(); }  ///< radius of a point's handle

protected:
    void applyDefaultAntialiasingHint(QCPPainter* painter) const override { painter->setAntialiasing(true); }
    QRect clipRect() const override { return mParentPlot->axisRect()->rect(); }
    void draw(QCPPainter* painter) override;

private:
    QPointF pixel(double x, double y) const
    {
        return {mParentPlot->xAxis->coordToPixel(x), mParentPlot->yAxis->coordToPixel(y)};
    }
    void drawPointedOut(QCPPainter& painter);
    void drawLine(QCPPainter& painter, bool upright, double place, const report::Caption& name, const QPen& pen);
    void drawName(QCPPainter& painter, const QPointF& place, const report::Caption& name);
    void drawHandle(QCPPainter& painter, const report::Handle& handle, bool isChosen);

    const report::Plot& chart_;
    const PlotStyle& style_;
    std::vector<QRectF> names_;  ///< drawn so far
};

struct ChartView::Content {
    report::Plot data;                         ///< what is shown
    std::vector<std::vector<double>> places;   ///< where the samples of each curve stand
    std::vector<QCPAbstractPlottable*> drawn;  ///< one for each curve; Band: the upper edge
    std::vector<QCPGraph*> lowEdges;           ///< one for each curve, null but for bands
    std::vector<RegionFill*> regions;          ///< one for each region of `data`
    ChartLines* lines = nullptr;               ///< limits, marks and handles
    std::optional<double> marked;              ///< the marked place; none: no mark
    bool holds = false;                        ///< the pointer has the chosen handle
    bool hasMoved = false;                     ///< the chosen handle, since it was last let go
    ChartView* leader = nullptr;               ///< whose x axis this chart shares; null: it has its own
    bool sharing = false;                      ///< the range of x is being handed on between leader and follower
    bool levelling = false;  ///< scales are being made equal, so that the change of a range is not answered again

    bool hasPaths() const { return !data.curves.empty() && !data.curves.back().along.empty(); }
};

}  // namespace lathelier::plot
