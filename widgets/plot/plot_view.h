// An XY plot: curves, bars, bands, limits, shaded regions; 1e6 points draw smoothly.
#pragma once

#include "widgets/plot/plot_canvas.h"

namespace lathelier {

class PlotView : public PlotCanvas {
    Q_OBJECT

public:
    explicit PlotView(QWidget* parent = nullptr);
    ~PlotView() override;

    /// Shows `data`; the user's zoom stays when the title is the same as before.
    void setData(PlotData data);
    const PlotData& data() const;

    /// Moves the limits alone, without touching the curves.
    void setLimitValues(const std::vector<double>& values);

    /// Marks one x, picked here or in a linked view.
    void setMarker(std::optional<double> x);
    std::optional<double> marker() const;

    QString csv() const override;

signals:
    void limitMoved(int index, double value);    ///< while a movable limit is dragged
    void limitDropped(int index, double value);  ///< when it is let go

protected:
    void applyStyle() override;
    QString readoutAt(double x, double y) const override;
    void fitRanges() override;
    bool beginDrag(const QPointF& place) override;
    void continueDrag(double x, double y) override;
    void endDrag() override;
    bool isHandle(const QPointF& place, Qt::CursorShape& shape) const override;

private:
    struct Content;
    void build();
    void placeLimits();
    std::optional<int> limitAt(const QPointF& place) const;

    std::unique_ptr<Content> content_;
};

}  // namespace lathelier
