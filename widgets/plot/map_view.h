// A colour map of a gridded value, with axes, colour scale, crosshair and picking.
#pragma once

#include "widgets/plot/plot_canvas.h"

namespace lathelier::plot {

struct ScaleCounts;

class MapView : public PlotCanvas {
    Q_OBJECT

public:
    explicit MapView(QWidget* parent = nullptr);
    ~MapView() override;

    /// The colour scale is set separately, so that it follows the user immediately.
    void setData(report::ColourMap data);
    const report::ColourMap& data() const;

    /// Recolours immediately.
    void setColours(const report::DeviationColours& colours);
    void setCounts(ScaleCounts counts);  ///< histogram beside the scale

    /// Marks one place, set here or by a linked view.
    void setMarker(std::optional<QPointF> place);
    std::optional<QPointF> marker() const;

    /// The colour drawn at a place; invalid where there are no data.
    QColor colourAt(double x, double y) const;

    QString csv() const override;

signals:
    void limitEdited(double upper, double lower);  ///< request for another scale; see LimitEdit::edited()

protected:
    void applyStyle() override;
    PointerTag::Words tagAt(const QPointF& pointer, double x, double y) const override;
    QString readoutAt(double x, double y) const override;
    void fitRanges() override;
    int besideAxes() const override;
    void sizeChosen() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Content;
    void recolour();
    void placeEdit();

    std::unique_ptr<Content> content_;
};

}  // namespace lathelier::plot
