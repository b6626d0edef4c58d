#include "widgets/plot/map_view.h"

#include <array>
#include <cmath>

#include "engine/report/chart_csv.h"
#include "widgets/core/language.h"
#include "widgets/plot/colour_legend.h"
#include "widgets/plot/grid_picture.h"

namespace lathelier::plot {

struct MapView::Content {
    /// The colour scale, drawn into the right margin of the axes.
    class LegendInMargin : public QCPLayerable {
    public:
        explicit LegendInMargin(QCustomPlot* plot) : QCPLayerable(plot, "axes") {}
        Legend shown;
        QFont font;
        QColor text;
        QLocale locale;
        int narrowest = 0;  ///< least width, required by the limit field above

        bool is_shown = true;

        int width() const { return !is_shown ? 0 : std::max(narrowest, colourLegendWidth(shown, font, locale) + gap); }

    protected:
        void applyDefaultAntialiasingHint(QCPPainter* painter) const override { painter->setAntialiasing(true); }
        void draw(QCPPainter* painter) override
        {
            if (!is_shown) return;
            const QRectF axes = parentPlot()->axisRect()->rect();
            paintColourLegend(*painter, QRectF(axes.right() + gap, axes.top() - 4, width() - gap, axes.height() + 8),
                              shown, font, text, locale);
        }

    private:
        static constexpr int gap = 12;
    };

    report::ColourMap data;
    report::DeviationColours colours;
    GridPicture* picture = nullptr;
    LegendInMargin* legend = nullptr;
    LimitEdit* edit = nullptr;
    QCPItemTracer* marker = nullptr;
    std::optional<QPointF> marked;
};

MapView::MapView(QWidget* parent) : PlotCanvas(parent), content_(std::make_unique<Content>())
{
    Content& c = *content_;
    c.picture = new GridPicture(plot().xAxis, plot().yAxis);
    c.legend = new Content::LegendInMargin(&plot());
    plot().axisRect()->setAutoMargins(QCP::msLeft | QCP::msTop | QCP::msBottom);
    plot().axisRect()->axis(QCPAxis::atBottom)->grid()->setVisible(false);
    plot().axisRect()->axis(QCPAxis::atLeft)->grid()->setVisible(false);
    c.marker = new QCPItemTracer(&plot());
    c.marker->setLayer("overlay");
    c.marker->setStyle(QCPItemTracer::tsCrosshair);
    c.marker->setVisible(false);
    c.marker->setSelectable(false);
    c.edit = new LimitEdit(this);
    connect(c.edit, &LimitEdit::edited, this, &MapView::limitEdited);
    refresh(false);
}

MapView::~MapView() = default;

const report::ColourMap& MapView::data() const
{
    return content_->data;
}
std::optional<QPointF> MapView::marker() const
{
    return content_->marked;
}
QString MapView::csv() const
{
    return QString::fromStdString(toCsv(content_->data, screenLanguage()));
}

void MapView::setData(report::ColourMap data)
{
    const auto extent = [](const report::ColourMap& d) { return std::array{d.x_from, d.x_to, d.y_from, d.y_to}; };
    const bool same = extent(data) == extent(content_->data) && !content_->data.empty();
    content_->data = std::move(data);
    const report::ColourMap& d = content_->data;
    setTitles(chartText(d.title), {}, chartText(d.x), chartText(d.y));
    setAxes(d.x, d.y);
    content_->legend->shown.title = chartText(d.value);
    content_->legend->shown.unit = d.value.unit;
    content_->edit->setUnit(d.value.unit);
    recolour();
    refresh(same);
    placeEdit();
}

void MapView::setColours(const report::DeviationColours& colours)
{
    content_->colours = colours;
    content_->legend->shown.colours = colours;
    content_->edit->setColours(colours);
    recolour();
    placeEdit();
    redraw();
}

void MapView::setCounts(ScaleCounts counts)
{
    content_->legend->shown.counts = std::move(counts);
    placeEdit();
    redraw();
}

void MapView::recolour()
{
    const report::ColourMap& d = content_->data;
    content_->picture->set(d, content_->colours);
}

QColor MapView::colourAt(double x, double y) const
{
    const double value = content_->data.at(x, y);
    if (std::isnan(value)) return {};
    return toQt(content_->colours(value));
}

void MapView::setMarker(std::optional<QPointF> place)
{
    content_->marked = place;
    content_->marker->setVisible(place.has_value());
    if (place) content_->marker->position->setCoords(*place);
    drawOverlay();
}

void MapView::applyStyle()
{
    Content::LegendInMargin& legend = *content_->legend;
    legend.font = font();
    legend.text = style().text;
    legend.locale = locale();
    content_->marker->setPen(QPen(style().marker, 1.2 * style().line_width));
    placeEdit();
}

QString MapView::readoutAt(double x, double y) const
{
    const report::ColourMap& d = content_->data;
    const auto axis = [&](const report::Axis& a, double value, double span) {
        return shortAxisTitle(a) + ' ' + readable(value, span, a.unit, locale());
    };
    const double value = d.at(x, y);
    return axis(d.x, x, visibleRange().width()) + "  ·  " + axis(d.y, y, visibleRange().height()) + "  ·  " +
           (std::isnan(value) ? tr("no data") : axis(d.value, value, 0.1));
}

PointerTag::Words MapView::tagAt(const QPointF&, double x, double y) const
{
    const report::ColourMap& d = content_->data;
    const double value = d.at(x, y);
    if (std::isnan(value)) return {};
    return {(value > 0 ? "+" : "") + readable(value, 0.1, d.value.unit, locale()),
            readable(x, visibleRange().width(), d.x.unit, locale()) + "  ·  " +
                readable(y, visibleRange().height(), d.y.unit, locale())};
}

void MapView::fitRanges()
{
    const report::ColourMap& d = content_->data;
    plot().xAxis->setRange(d.x_from, d.x_to);
    plot().yAxis->setRange(d.y_from, d.y_to);
}

int MapView::besideAxes() const
{
    return content_ ? content_->legend->width() : 0;
}

void MapView::placeEdit()
{
    // The field is above the scale, beside the title, where it covers nothing.
    LimitEdit* edit = content_->edit;
    content_->legend->is_shown = !isSmall();
    edit->setVisible(!content_->data.empty() && !isSmall());
    edit->adjustSize();
    content_->legend->narrowest = edit->width();
    edit->move(width() - edit->width(), 0);
    leaveRoomInTitle(edit->width());
    const int aside = isSmall() ? fontMetrics().height() : content_->legend->width();  // space for the label of the
                                                                                       // last tick
    plot().axisRect()->setMargins(QMargins(0, 0, aside, 0));
}

void MapView::sizeChosen()
{
    placeEdit();
    PlotCanvas::sizeChosen();
}

void MapView::resizeEvent(QResizeEvent* event)
{
    PlotCanvas::resizeEvent(event);
    placeEdit();
}

}  // namespace lathelier::plot
