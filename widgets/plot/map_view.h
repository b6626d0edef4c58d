// The unrolled map: a value on a grid as a colour picture, with axes, colour scale, crosshair and picking.
#pragma once

#include "widgets/plot/plot_canvas.h"

namespace lathelier::plot {

struct ScaleCounts;

class MapView : public PlotCanvas {
    Q_OBJECT

public:
    explicit MapView(QWidget* parent = nullptr);
    ~MapView() override;

    /// The colours of the scale are set apart: they follow the user at once.
    void setData(report::ColourMap data);
    const report::ColourMap& data() const;

    /// Recolours at once.
    void setColours(const report::DeviationColours& colours);
    void setCounts(ScaleCounts counts);  ///< beside the scale

    /// Marks one place, picked here or in a linked view.
    void setMarker(std::optional<QPointF> place);
    std::optional<QPointF> marker() const;

    /// The colour drawn at a place; invalid where there are no data.
    QColor colourAt(double x, double y) const;

    QString csv() const override;

signals:
    void limitEdited(double upper, double lower);  ///< the user wants another scale; as LimitEdit::edited()

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
