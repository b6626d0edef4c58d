// A colour map as a part of a chart. Included by .cpp files of this folder only, because it shows QCustomPlot.
#pragma once

#include <qcustomplot.h>

#include "engine/report/chart.h"

namespace lathelier::plot {

/// An image over a rectangle of plot coordinates, without interpolation between cells.
class GridPicture : public QCPAbstractPlottable {
public:
    GridPicture(QCPAxis* x, QCPAxis* y) : QCPAbstractPlottable(x, y) { removeFromLegend(); }

    /// NaN is transparent; without a map nothing is drawn.
    void set(const report::ColourMap& map, const report::DeviationColours& colours);
    void setOpacity(double opacity) { opacity_ = opacity; }

    double selectTest(const QPointF&, bool, QVariant*) const override { return -1; }
    QCPRange getKeyRange(bool& found, QCP::SignDomain) const override
    {
        found = !image_.isNull();
        return {place_.left(), place_.right()};
    }
    QCPRange getValueRange(bool& found, QCP::SignDomain, const QCPRange&) const override
    {
        found = !image_.isNull();
        return {place_.top(), place_.bottom()};
    }

protected:
    void draw(QCPPainter* painter) override;
    void drawLegendIcon(QCPPainter*, const QRectF&) const override {}

private:
    QImage image_;
    QRectF place_;
    double opacity_ = 1;
};

}  // namespace lathelier::plot
