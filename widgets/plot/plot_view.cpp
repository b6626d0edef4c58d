#include <algorithm>
#include <cmath>
#include <tuple>

#include "widgets/plot/plot_view_content.h"

namespace lathelier {
namespace {

QVector<double> toQt(const std::vector<double>& values)
{
    return {values.begin(), values.end()};
}

QColor faint(QColor colour, int alpha)
{
    colour.setAlpha(alpha);
    return colour;
}

/// Index of the sample nearest to x; x rises.
std::size_t nearest(const std::vector<double>& x, double place)
{
    const auto after = std::lower_bound(x.begin(), x.end(), place);
    if (after == x.begin()) return 0;
    if (after == x.end()) return x.size() - 1;
    const auto index = static_cast<std::size_t>(after - x.begin());
    return place - x[index - 1] < x[index] - place ? index - 1 : index;
}

/// The bar under this x; none between bars that are drawn apart, or beyond the last.
std::optional<std::size_t> barAt(const PlotCurve& curve, double x)
{
    if (curve.style != PlotCurve::Style::Bars || curve.x.empty()) return std::nullopt;
    const std::size_t i = nearest(curve.x, x);
    const double width = curve.x.size() > 1 ? curve.x[1] - curve.x[0] : 1;
    return std::abs(curve.x[i] - x) <= width / 2 ? std::optional(i) : std::nullopt;
}

}  // namespace

PlotView::PlotView(QWidget* parent) : PlotCanvas(parent), content_(std::make_unique<Content>())
{
    content_->marker = new QCPItemStraightLine(&plot());
    content_->marker->setLayer("overlay");
    content_->marker->setVisible(false);
    content_->marker->setSelectable(false);
    connect(&plot(), &QCustomPlot::afterLayout, this, &PlotView::placeLimits);
    refresh(false);
}

PlotView::~PlotView() = default;

const PlotData& PlotView::data() const
{
    return content_->data;
}
std::optional<double> PlotView::marker() const
{
    return content_->markedX;
}
QString PlotView::csv() const
{
    return toCsv(content_->data);
}

void PlotView::setData(PlotData data)
{
    const bool same = data.title == content_->data.title && !content_->data.curves.empty();
    content_->data = std::move(data);
    if (content_->dragged && static_cast<std::size_t>(*content_->dragged) >= content_->data.limits.size())
        content_->dragged.reset();
    build();
    setTitles(content_->data.title, content_->data.remark, content_->data.x.label(), content_->data.y.label());
    refresh(same);
}

void PlotView::build()
{
    Content& c = *content_;
    plot().clearPlottables();
    for (const Content::Line& limit : c.limits) {
        plot().removeItem(limit.line);
        plot().removeItem(limit.label);
    }
    for (QCPItemRect* region : c.regions) plot().removeItem(region);
    for (QCPItemText* label : c.regionLabels) plot().removeItem(label);
    c.drawn.clear();
    c.lowEdges.clear();
    c.limits.clear();
    c.regions.clear();
    c.regionLabels.clear();

    bool named = false;
    for (const PlotCurve& curve : c.data.curves) {
        QCPGraph* low = nullptr;
        if (curve.style == PlotCurve::Style::Bars) {
            auto* bars = new QCPBars(plot().xAxis, plot().yAxis);
            bars->setData(toQt(curve.x), toQt(curve.y), true);
            bars->setWidth(curve.x.size() > 1 ? curve.x[1] - curve.x[0] : 1);
            c.drawn.push_back(bars);
        } else {
            if (curve.style == PlotCurve::Style::Band) {
                low = plot().addGraph();
                low->setData(toQt(curve.x), toQt(curve.yLow), true);
                low->removeFromLegend();
            }
            QCPGraph* graph = plot().addGraph();
            graph->setData(toQt(curve.x), toQt(curve.y), true);
            graph->setAdaptiveSampling(true);
            if (low) graph->setChannelFillGraph(low);
            c.drawn.push_back(graph);
        }
        c.lowEdges.push_back(low);
        c.drawn.back()->setName(curve.name);
        if (curve.name.isEmpty()) c.drawn.back()->removeFromLegend();
        named = named || !curve.name.isEmpty();
    }
    showLegend(named);
    for (std::size_t i = 0; i < c.data.limits.size(); ++i) {
        c.limits.push_back({new QCPItemStraightLine(&plot()), new QCPItemText(&plot())});
        c.limits.back().line->setSelectable(false);
        c.limits.back().label->setSelectable(false);
    }
    for (const PlotRegion& region : c.data.regions) {
        auto* rect = new QCPItemRect(&plot());
        rect->setLayer("background");
        rect->setSelectable(false);
        rect->topLeft->setTypeY(QCPItemPosition::ptAxisRectRatio);
        rect->bottomRight->setTypeY(QCPItemPosition::ptAxisRectRatio);
        rect->topLeft->setCoords(region.from, 0);
        rect->bottomRight->setCoords(region.to, 1);
        auto* label = new QCPItemText(&plot());
        label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        label->position->setCoords((region.from + region.to) / 2, 0.98);
        label->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
        label->setText(region.label);
        label->setSelectable(false);
        c.regions.push_back(rect);
        c.regionLabels.push_back(label);
    }
    placeLimits();
}

void PlotView::applyStyle()
{
    Content& c = *content_;
    const double width = style().lineWidth;
    for (std::size_t i = 0; i < c.drawn.size(); ++i) {
        const PlotCurve& curve = c.data.curves[i];
        const QColor colour = curve.colour.value_or(style().colour({}, i));
        QCPAbstractPlottable* drawn = c.drawn[i];
        switch (curve.style) {
            case PlotCurve::Style::Line: drawn->setPen(QPen(colour, width)); break;
            case PlotCurve::Style::Dashed: drawn->setPen(QPen(colour, width, Qt::DashLine)); break;
            case PlotCurve::Style::Bars:
                drawn->setPen(QPen(colour, 0));
                drawn->setBrush(faint(colour, 150));
                break;
            case PlotCurve::Style::Band:
                drawn->setPen(Qt::NoPen);
                c.lowEdges[i]->setPen(Qt::NoPen);
                drawn->setBrush(faint(colour, 90));
                break;
            case PlotCurve::Style::Points: {
                auto* graph = static_cast<QCPGraph*>(drawn);
                graph->setLineStyle(QCPGraph::lsNone);
                graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 2.5 * width));
                drawn->setPen(QPen(colour, width));
                break;
            }
        }
    }
    for (const auto& [line, label] : c.limits) {
        line->setPen(QPen(style().limit, width, Qt::DashLine));
        label->setColor(style().limit);
        label->setFont(font());
        label->setBrush(faint(style().background, 200));
    }
    for (std::size_t i = 0; i < c.regions.size(); ++i) {
        c.regions[i]->setPen(Qt::NoPen);
        c.regions[i]->setBrush(faint(c.data.regions[i].colour.value_or(style().text), 30));
        c.regionLabels[i]->setFont(font());
        c.regionLabels[i]->setColor(style().text);
    }
    c.marker->setPen(QPen(style().marker, width * 1.2));
}

void PlotView::fitRanges()
{
    if (content_->dragged) return;  // the ground must not move under the pointer
    const double infinity = std::numeric_limits<double>::infinity();
    double xLow = infinity, xHigh = -infinity, yLow = infinity, yHigh = -infinity;
    const auto widen = [](double& low, double& high, double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    };
    for (const PlotCurve& curve : content_->data.curves) {
        const double half =
            curve.style == PlotCurve::Style::Bars && curve.x.size() > 1 ? (curve.x[1] - curve.x[0]) / 2 : 0;
        if (!curve.x.empty()) {
            widen(xLow, xHigh, curve.x.front() - half);
            widen(xLow, xHigh, curve.x.back() + half);
        }
        for (const double y : curve.y) widen(yLow, yHigh, y);
        for (const double y : curve.yLow) widen(yLow, yHigh, y);
    }
    bool upright = false;
    for (const PlotLimit& limit : content_->data.limits) {
        if (limit.orientation == Qt::Horizontal)
            widen(yLow, yHigh, limit.value);
        else
            widen(xLow, xHigh, limit.value);
        upright = upright || limit.orientation == Qt::Vertical;
    }
    if (!(xLow <= xHigh)) xLow = 0, xHigh = 1;
    if (!(yLow <= yHigh)) yLow = 0, yHigh = 1;
    if (content_->data.xRange) std::tie(xLow, xHigh) = *content_->data.xRange;
    if (content_->data.yRange) std::tie(yLow, yHigh) = *content_->data.yRange;
    if (content_->data.yFromZero) yLow = 0;
    const double xMargin = xHigh > xLow ? 0.02 * (xHigh - xLow) : 0.5;
    const double yMargin = yHigh > yLow ? 0.06 * (yHigh - yLow) : 0.5;
    plot().xAxis->setRange(xLow - xMargin, xHigh + xMargin);
    // Upright limits carry their names at the top: leave room above the curves.
    plot().yAxis->setRange(content_->data.yFromZero ? 0 : yLow - yMargin, yHigh + (upright ? 3 : 1) * yMargin);
}

QString PlotView::readoutAt(double x, double y) const
{
    const PlotData& data = content_->data;
    const QRectF range = visibleRange();
    bool counts = false;  // an x that only takes whole numbers is spoken as one
    for (const PlotCurve& curve : data.curves)
        if (const auto bar = barAt(curve, x)) {
            x = curve.x[*bar];
            counts = std::all_of(curve.x.begin(), curve.x.end(), [](double v) { return v == std::round(v); });
            break;
        }
    const auto withUnit = [](const QString& number, const QString& unit) {
        return unit.isEmpty() ? number : number + ' ' + unit;
    };
    QStringList parts;
    if (counts && !data.x.unit.isEmpty())
        parts << withUnit(readable(x, 1000, locale()), data.x.unit);  // "5 UPR" says it all
    else
        parts << data.x.title + ' ' + withUnit(readable(x, counts ? 1000 : range.width(), locale()), data.x.unit);
    bool any = false;
    for (const PlotCurve& curve : data.curves) {
        if (!curve.spoken || curve.x.empty() || x < curve.x.front() || x > curve.x.back()) continue;
        const std::size_t i = nearest(curve.x, x);
        if (std::isnan(curve.y[i])) continue;
        const QString name = curve.name.isEmpty() ? data.y.title : curve.name;
        any = true;
        if (!curve.readout.empty())
            parts << name + ' ' + withUnit(readable(curve.readout[i], 0.1, locale()), curve.readoutUnit);
        else if (curve.style == PlotCurve::Style::Band)
            parts << name + ' ' + readable(curve.yLow[i], range.height(), locale()) + "…" +
                         withUnit(readable(curve.y[i], range.height(), locale()), data.y.unit);
        else
            parts << name + ' ' + withUnit(readable(curve.y[i], range.height(), locale()), data.y.unit);
        if (static_cast<int>(i) < curve.words.size() && !curve.words[static_cast<int>(i)].isEmpty())
            parts << curve.words[static_cast<int>(i)];
    }
    if (!any) parts << data.y.title + ' ' + withUnit(readable(y, range.height(), locale()), data.y.unit);
    return parts.join("  ·  ");
}

void PlotView::setMarker(std::optional<double> x)
{
    content_->markedX = x;
    content_->marker->setVisible(x.has_value());
    if (x) {
        content_->marker->point1->setCoords(*x, 0);
        content_->marker->point2->setCoords(*x, 1);
    }
    drawOverlay();
}

}  // namespace lathelier
