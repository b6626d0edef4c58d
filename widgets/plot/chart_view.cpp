#include "widgets/plot/chart_view.h"

#include <algorithm>
#include <cmath>

#include "engine/report/chart_csv.h"
#include "widgets/core/language.h"
#include "widgets/plot/chart_parts.h"
#include "widgets/plot/grid_picture.h"

namespace lathelier::plot {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

QVector<double> toVector(const std::vector<double>& values)
{
    return {values.begin(), values.end()};
}

QColor faint(QColor colour, int alpha)
{
    colour.setAlpha(alpha);
    return colour;
}

/// Index of the sample nearest to x, for ascending x.
std::size_t nearest(const std::vector<double>& x, double place)
{
    const auto after = std::lower_bound(x.begin(), x.end(), place);
    if (after == x.begin()) return 0;
    if (after == x.end()) return x.size() - 1;
    const auto index = static_cast<std::size_t>(after - x.begin());
    return place - x[index - 1] < x[index] - place ? index - 1 : index;
}

bool isRead(const report::Curve& curve)
{
    return curve.has_readout && !curve.thin;
}

/// A line with non-monotone x, such as an outline: a QCPGraph would sort it or omit parts.
bool isPath(const report::Curve& curve)
{
    if (!curve.along.empty()) return true;
    if (curve.style != report::Curve::Style::Line && curve.style != report::Curve::Style::Dashed) return false;
    double last = -infinity;
    for (const double x : curve.x) {
        if (x < last) return true;
        if (!std::isnan(x)) last = x;
    }
    return false;
}

std::size_t samplesOf(const report::Curve& curve)
{
    return std::min(curve.x.size(), curve.y.size());
}

/// A number in the unit of its axis, with the digits resolved by the axis.
QString onAxis(const QCPAxis& axis, double value, Text unit, const QLocale& locale)
{
    const bool logarithmic = axis.scaleType() == QCPAxis::stLogarithmic;
    return logarithmic ? locale.toString(value * screenFactor(unit), 'g', 4)
                       : readable(value * screenFactor(unit), axis.range().size() * screenFactor(unit), locale);
}

QString withUnit(const QString& number, Text unit)
{
    return unit.empty() ? number : number + ' ' + screenUnit(unit);
}

}  // namespace

ChartView::ChartView(QWidget* parent) : PlotCanvas(parent), content_(std::make_unique<Content>())
{
    content_->lines = new ChartLines(&plot(), content_->data, style());
    connect(&plot(), &QCustomPlot::afterLayout, this, &ChartView::keepScalesEqual);
    for (QCPAxis* axis : {plot().xAxis, plot().yAxis})
        connect(axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this] { emit rangeChanged(); });
    refresh(false);
}

ChartView::~ChartView() = default;

const report::Plot& ChartView::data() const
{
    return content_->data;
}
std::optional<double> ChartView::marker() const
{
    return content_->marked;
}
QString ChartView::csv() const
{
    return QString::fromStdString(toCsv(content_->data, screenLanguage()));
}

void ChartView::setData(report::Plot data)
{
    Content& c = *content_;
    const bool same = data.title == c.data.title && !c.data.curves.empty();
    std::optional<report::Handle> chosen;
    if (c.lines->chosen) chosen = c.data.handles[*c.lines->chosen];
    c.data = std::move(data);
    c.lines->chosen.reset();
    for (std::size_t i = 0; chosen && i < c.data.handles.size(); ++i) {
        if (c.data.handles[i].key != chosen->key) continue;
        c.lines->chosen = i;
        if (c.holds) report::moveHandle(c.data.handles[i], chosen->x, chosen->y);
    }
    if (!c.lines->chosen) c.holds = c.has_moved = false;
    build();
    setAxes(c.data.x, c.data.y);
    setTitles(chartText(c.data.title), chartText(c.data.remark), chartText(c.data.x), chartText(c.data.y));
    setMarker(c.marked);
    refresh(same);
}

void ChartView::build()
{
    Content& c = *content_;
    plot().clearPlottables();
    c.drawn.clear();
    c.low_edges.clear();
    c.regions.clear();
    c.places.clear();
    bool named = false;
    const auto add = [&](QCPAbstractPlottable* drawn, const report::Caption& name) {
        drawn->setName(chartText(name));
        if (drawn->name().isEmpty())
            drawn->removeFromLegend();
        else
            named = true;
    };
    if (c.data.ground) {
        auto* ground = new GridPicture(plot().xAxis, plot().yAxis);
        ground->setLayer("background");
        ground->setOpacity(report::ColourMap::groundOpacity);
        ground->set(*c.data.ground, report::coloursOf(*c.data.ground));
    }
    for (const report::Region& region : c.data.regions) {
        c.regions.push_back(new RegionFill(plot().xAxis, plot().yAxis, region));
        add(c.regions.back(), region.name);
    }
    for (const report::Curve& curve : c.data.curves) {
        c.places.push_back(report::placesOf(curve));
        const std::vector<double>& places = c.places.back();
        QCPGraph* low = nullptr;
        if (curve.style == report::Curve::Style::Bars) {
            auto* bars = new QCPBars(plot().xAxis, plot().yAxis);
            bars->setData(toVector(places), toVector(curve.y), true);
            bars->setWidth(curve.x.size() > 1 ? curve.x[1] - curve.x[0] : 1);
            c.drawn.push_back(bars);
        } else if (isPath(curve)) {
            auto* path = new QCPCurve(plot().xAxis, plot().yAxis);
            path->setData(toVector(curve.x), toVector(curve.y));
            c.drawn.push_back(path);
        } else {
            if (curve.style == report::Curve::Style::Band) {
                low = plot().addGraph();
                low->setData(toVector(curve.x), toVector(curve.y_low), true);
                low->removeFromLegend();
            }
            QCPGraph* graph = plot().addGraph();
            graph->setData(toVector(curve.x), toVector(curve.y), true);
            graph->setAdaptiveSampling(true);
            if (low) graph->setChannelFillGraph(low);
            c.drawn.push_back(graph);
        }
        c.low_edges.push_back(low);
        add(c.drawn.back(), curve.name);
    }
    showLegend(named);
}

void ChartView::applyStyle()
{
    Content& c = *content_;
    c.lines->font = font();
    for (std::size_t i = 0; i < c.regions.size(); ++i) {
        const QColor colour = style().colour(c.data.regions[i].colour, i);
        c.regions[i]->setBrush(faint(colour, 45));
        if (c.data.regions[i].colour.role == report::ColourRole::Excess) c.regions[i]->setHatch(colour);
    }
    for (std::size_t i = 0; i < c.drawn.size(); ++i) {
        const report::Curve& curve = c.data.curves[i];
        const QColor colour = style().colour(curve.colour, i);
        const double width = curve.along.empty() ? style().line_width : 1.2 * style().line_width;
        QCPAbstractPlottable* drawn = c.drawn[i];
        switch (curve.style) {
            case report::Curve::Style::Line:
                drawn->setPen(curve.thin ? QPen(faint(colour, 110), 1) : QPen(colour, width));
                break;
            case report::Curve::Style::Dashed: drawn->setPen(QPen(colour, width, Qt::DashLine)); break;
            case report::Curve::Style::Bars:
                drawn->setPen(QPen(colour, 0));
                drawn->setBrush(faint(colour, 150));
                break;
            case report::Curve::Style::Band:
                drawn->setPen(Qt::NoPen);
                c.low_edges[i]->setPen(Qt::NoPen);
                drawn->setBrush(faint(colour, 90));
                break;
            case report::Curve::Style::Points:
                drawn->setPen(QPen(curve.thin ? faint(colour, 110) : colour, width));
                if (auto* graph = qobject_cast<QCPGraph*>(drawn)) {
                    graph->setLineStyle(QCPGraph::lsNone);
                    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, (curve.thin ? 1.4 : 2.5) * width));
                }
                break;
        }
    }
}

void ChartView::fitRanges()
{
    if (content_->holds) return;  // keep the range during a drag
    const Interval x = report::shownX(content_->data), y = report::shownY(content_->data);
    if (const ChartView* leader = content_->leader)
        takeX(leader->visibleRange().left(), leader->visibleRange().right());
    else
        plot().xAxis->setRange(x.from, x.to);
    plot().yAxis->setRange(y.from, y.to);
}

/// Widens one axis range for equal scales.
void ChartView::keepScalesEqual()
{
    if (content_->levelling || !content_->data.equal_scales) return;
    content_->levelling = true;
    const QRectF before = visibleRange();
    if (!isViewChosen()) fitRanges();
    const double perX = plot().xAxis->range().size() / std::max(1, plot().axisRect()->width());
    const double perY = plot().yAxis->range().size() / std::max(1, plot().axisRect()->height());
    if (perX > 1.0001 * perY) plot().yAxis->setScaleRatio(plot().xAxis, 1);
    if (perY > 1.0001 * perX) plot().xAxis->setScaleRatio(plot().yAxis, 1);
    content_->levelling = false;
    // The ticks are those of the previous range; a change of margins alone is not redrawn.
    constexpr double seen = 0.02;
    const QRectF after = visibleRange();
    if (std::abs(after.width() - before.width()) > seen * before.width() ||
        std::abs(after.height() - before.height()) > seen * before.height())
        redraw();
}

QString ChartView::readoutAt(double x, double y) const
{
    const Content& c = *content_;
    const report::Plot& data = c.data;
    if (c.hasPaths()) return pathReadout(x, y);
    const auto onX = [&](double value) { return onAxis(*plot().xAxis, value, data.x.unit, locale()); };
    const auto onY = [&](double value) { return onAxis(*plot().yAxis, value, data.y.unit, locale()); };
    bool counts = false;  // integer x is shown without decimals
    for (std::size_t k = 0; k < data.curves.size() && !counts; ++k) {
        const std::vector<double>& places = c.places[k];
        if (data.curves[k].style != report::Curve::Style::Bars || places.empty()) continue;
        const std::size_t i = nearest(places, x);
        if (std::abs(places[i] - x) > (data.curves[k].x[1] - data.curves[k].x[0]) / 2) continue;
        x = places[i];
        counts = std::all_of(places.begin(), places.end(), [](double v) { return v == std::round(v); });
    }
    QStringList parts;
    const QString place = withUnit(counts ? readable(x, 1000, locale()) : onX(x), data.x.unit);
    // With a unit, such as "5 UPR", the axis title is omitted.
    parts << (counts && !data.x.unit.empty() ? place : shortAxisTitle(data.x) + ' ' + place);
    bool any = false;
    for (std::size_t k = 0; k < data.curves.size(); ++k) {
        const report::Curve& curve = data.curves[k];
        const std::vector<double>& places = c.places[k];
        if (!isRead(curve) || places.empty() || x < places.front() || x > places.back()) continue;
        const std::size_t i = nearest(places, x);
        if (i >= curve.y.size() || std::isnan(curve.y[i])) continue;
        const QString name = report::captionText(curve.name).empty() ? shortAxisTitle(data.y) : chartText(curve.name);
        any = true;
        if (i < curve.readout_y.size())
            parts << name + ' ' + readable(curve.readout_y[i], 0.1, curve.readout_unit, locale());
        else if (curve.style == report::Curve::Style::Band)
            parts << name + ' ' + onY(curve.y_low[i]) + "…" + withUnit(onY(curve.y[i]), data.y.unit);
        else
            parts << name + ' ' + withUnit(onY(curve.y[i]), data.y.unit);
        if (i < curve.words.size() && !curve.words[i].empty()) parts << screenText(curve.words[i]);
    }
    if (!any) parts << shortAxisTitle(data.y) + ' ' + withUnit(onY(y), data.y.unit);
    return parts.join("  ·  ");
}

/// The curve with readout nearest in y to the pointer.
PointerTag::Words ChartView::tagAt(const QPointF& pointer, double x, double) const
{
    const Content& c = *content_;
    const report::Plot& data = c.data;
    if (c.hasPaths()) return {};
    PointerTag::Words words;
    double least = infinity;
    for (std::size_t k = 0; k < data.curves.size(); ++k) {
        const report::Curve& curve = data.curves[k];
        const std::vector<double>& places = c.places[k];
        if (!isRead(curve) || curve.style == report::Curve::Style::Band || places.empty()) continue;
        const double reach = curve.style == report::Curve::Style::Bars && curve.x.size() > 1
                                 ? (curve.x[1] - curve.x[0]) / 2
                                 : std::abs(plot().xAxis->pixelToCoord(1) - plot().xAxis->pixelToCoord(0)) * 20;
        const std::size_t i = nearest(places, x);
        if (i >= curve.y.size() || std::isnan(curve.y[i]) || std::abs(places[i] - x) > reach) continue;
        const double away = std::abs(plot().yAxis->coordToPixel(curve.y[i]) - pointer.y());
        if (away >= least) continue;
        least = away;
        const bool has_readout_value = i < curve.readout_y.size();
        words.value = has_readout_value
                          ? readable(curve.readout_y[i], 0.1, curve.readout_unit, locale())
                          : withUnit(onAxis(*plot().yAxis, curve.y[i], data.y.unit, locale()), data.y.unit);
        words.place = withUnit(onAxis(*plot().xAxis, places[i], data.x.unit, locale()), data.x.unit);
        const QString name = chartText(curve.name);
        if (!name.isEmpty()) words.place += "  ·  " + name;
        if (i < curve.words.size() && !curve.words[i].empty()) words.place = screenText(curve.words[i]);
    }
    return words;
}

QString ChartView::pathReadout(double x, double y) const
{
    const report::Plot& data = content_->data;
    const report::Curve* nearest = nullptr;
    std::size_t sample = 0;
    double least = infinity;
    for (const report::Curve& curve : data.curves)
        for (std::size_t i = 0; i < (isRead(curve) ? samplesOf(curve) : 0); ++i) {
            const double away = std::hypot(curve.x[i] - x, curve.y[i] - y);
            if (away >= least) continue;
            least = away;
            nearest = &curve;
            sample = i;
        }
    if (!nearest) return {};
    const double px = nearest->x[sample], py = nearest->y[sample];
    const auto number = [&](double value) { return onAxis(*plot().xAxis, value, data.x.unit, locale()); };
    QStringList parts;
    if (!report::captionText(nearest->name).empty()) parts << chartText(nearest->name);
    if (sample < nearest->along.size())
        parts << readable(nearest->along[sample], 100, locale()) + screenText(data.along.unit);
    parts << "X " + number(px) << "Y " + number(py);
    parts << tr("radius vector %1 %2").arg(number(std::hypot(px, py)), screenUnit(data.x.unit));
    return parts.join(" · ");
}

void ChartView::pointOut(PointedOut what)
{
    content_->lines->pointed_out = std::move(what);
    drawOverlay();
}

const PointedOut& ChartView::pointedOut() const
{
    return content_->lines->pointed_out;
}

void ChartView::setMarker(std::optional<double> place)
{
    Content& c = *content_;
    c.marked = place;
    c.lines->marked_x = c.hasPaths() ? std::nullopt : place;
    c.lines->marked_places.clear();
    for (const report::Curve& curve : c.data.curves) {
        if (!place || !isRead(curve) || curve.along.empty()) continue;
        std::size_t best = 0;
        double least = infinity;
        for (std::size_t i = 0; i < std::min(samplesOf(curve), curve.along.size()); ++i) {
            const double away = std::abs(curve.along[i] - *place);
            if (away >= least) continue;
            least = away;
            best = i;
        }
        c.lines->marked_places.emplace_back(curve.x[best], curve.y[best]);
    }
    drawOverlay();
}

}  // namespace lathelier::plot
