// A Plot of the engine on the screen: the same titles, colours, ranges and ticks as in the report, with pointer
// readout, zoom and pan, a marked place, and draggable handles. Handles 1e6 points interactively.
#pragma once

#include <QPolygonF>
#include <vector>

#include "engine/report/chart.h"
#include "widgets/plot/plot_canvas.h"

namespace lathelier::plot {

/// Highlight set by a linked view: a section of a path, the outline of a tool. In data coordinates.
struct PointedOut {
    std::vector<QPolygonF> lines;   ///< thick lines
    std::vector<QPolygonF> shapes;  ///< shaded polygons
    std::optional<QPointF> place;   ///< dot
};

class ChartView : public PlotCanvas {
    Q_OBJECT

public:
    explicit ChartView(QWidget* parent = nullptr);
    ~ChartView() override;

    /// Shows `data`; the user's zoom stays when the title is the same as before, a dragged handle stays at the pointer.
    void setData(report::Plot data);
    const report::Plot& data() const;

    /// Moves a handle alone, without touching the curves; inside its ranges. Unknown keys are ignored.
    void setHandle(const QString& key, double x, double y);

    /// Light about the handle of a point until it is moved by hand: it is what a reader is asked to use.
    void setGlow(bool glows);
    bool glows() const;

    /// Marks one x, or one place along the paths of the chart; set here or by a linked view.
    void setMarker(std::optional<double> place);
    std::optional<double> marker() const;

    /// Drawn above the curves without redrawing them.
    void pointOut(PointedOut what);
    const PointedOut& pointedOut() const;

    /// This chart shares the x axis of `leader` above it: equal margins and range under zoom and pan. `leader` must
    /// outlive this chart.
    void followX(ChartView* leader);

    QString csv() const override;
    void resetView() override;

signals:
    void rangeChanged();  ///< the visible range has changed

    /// A handle is dragged, or moved by the arrow keys after Tab or a click has chosen it; `dropped` at the end of the
    /// drag.
    void handleMoved(const QString& key, double x, double y, bool dropped);

protected:
    void applyStyle() override;
    PointerTag::Words tagAt(const QPointF& pointer, double x, double y) const override;
    QString readoutAt(double x, double y) const override;
    void fitRanges() override;
    bool beginDrag(const QPointF& place) override;
    void continueDrag(double x, double y) override;
    void endDrag() override;
    bool isHandle(const QPointF& place, Qt::CursorShape& shape) const override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    struct Content;
    void build();
    void keepScalesEqual();
    void takeX(double lower, double upper);
    void showX(double lower, double upper);
    QString pathReadout(double x, double y) const;
    std::optional<std::size_t> handleAt(const QPointF& place) const;
    void choose(std::optional<std::size_t> handle);
    void moveChosen(double x, double y);
    void drop();

    std::unique_ptr<Content> content_;
};

}  // namespace lathelier::plot
