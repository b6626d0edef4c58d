// Elements drawn by ChartView on QCustomPlot. Included by its .cpp files only, because it shows QCustomPlot.
#pragma once

#include <qcustomplot.h>

#include <optional>
#include <vector>

#include "widgets/plot/chart_view.h"

namespace lathelier::plot {

/// A shaded polygon; vertices at infinity are moved to the edge of the axes.
class RegionFill : public QCPAbstractPlottable {
public:
    RegionFill(QCPAxis* x, QCPAxis* y, const report::Region& region) : QCPAbstractPlottable(x, y), region_(region)
    {
        setLayer("background");
    }
    /// Hatching in this colour, and along the edge so that small areas are visible.
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
    QColor hatch_;  ///< hatching colour; invalid: none
};

/// Layer above the curves: limits, marks, handles and the marked place, with labels.
class ChartLines : public QCPLayerable {
public:
    ChartLines(QCustomPlot* plot, const report::Plot& chart, const PlotStyle& style)
        : QCPLayerable(plot, "overlay"), chart_(chart), style_(style)
    {
    }
    QFont font;
    std::optional<double> marked_x;      ///< marked x: vertical line
    std::vector<QPointF> marked_places;  ///< marked places on paths
    std::optional<std::size_t> chosen;   ///< handle moved by keys
    bool glows = false;                  ///< handles of points are surrounded by light
    PointedOut pointed_out;              ///< highlighted by a linked view

    double reach() const { return 0.4 * QFontMetricsF(font).height(); }  ///< picking radius of a point's handle

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
    std::vector<QRectF> names_;  ///< rectangles of the labels drawn so far
};

struct ChartView::Content {
    report::Plot data;                         ///< shown plot
    std::vector<std::vector<double>> places;   ///< x of the samples by curve
    std::vector<QCPAbstractPlottable*> drawn;  ///< graph by curve; Band: the upper edge
    std::vector<QCPGraph*> low_edges;          ///< lower edge by curve; null except for bands
    std::vector<RegionFill*> regions;          ///< one for each region of `data`
    ChartLines* lines = nullptr;               ///< limits, marks and handles
    std::optional<double> marked;              ///< the marked place; none: no mark
    bool holds = false;                        ///< the chosen handle is being dragged
    bool has_moved = false;                    ///< the chosen handle has moved in this drag
    ChartView* leader = nullptr;               ///< whose x axis this chart shares; null: it has its own
    bool sharing = false;                      ///< guards against recursion between leader and follower
    bool levelling = false;                    ///< guards against recursion while scales are equalised

    bool hasPaths() const { return !data.curves.empty() && !data.curves.back().along.empty(); }
};

}  // namespace lathelier::plot
