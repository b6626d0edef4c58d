#include "widgets/plot/xy_view.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace lathelier {
namespace {

QColor faint(QColor colour, int alpha)
{
    colour.setAlpha(alpha);
    return colour;
}

std::size_t sizeOf(const XyCurve& curve)
{
    return std::min(curve.x.size(), curve.y.size());
}

}  // namespace

struct XyView::Content {
    XyData data;
    std::vector<QCPCurve*> drawn;
    QCPGraph* marks = nullptr;
    std::optional<double> marked;
    bool levelling = false;
};

XyView::XyView(QWidget* parent) : PlotCanvas(parent), content_(std::make_unique<Content>())
{
    connect(&plot(), &QCustomPlot::afterLayout, this, &XyView::keepScalesEqual);
    refresh(false);
}

XyView::~XyView() = default;

const XyData& XyView::data() const
{
    return content_->data;
}

QString XyView::csv() const
{
    return toCsv(content_->data);
}

void XyView::setData(XyData data)
{
    Content& c = *content_;
    const bool same = data.title == c.data.title && !c.data.curves.empty();
    c.data = std::move(data);
    plot().clearPlottables();
    c.drawn.clear();
    bool named = false;
    for (const XyCurve& curve : c.data.curves) {
        auto* path = new QCPCurve(plot().xAxis, plot().yAxis);
        const std::size_t count = sizeOf(curve);
        QVector<double> x(curve.x.begin(), curve.x.begin() + static_cast<std::ptrdiff_t>(count));
        QVector<double> y(curve.y.begin(), curve.y.begin() + static_cast<std::ptrdiff_t>(count));
        if (curve.closed && count > 0) {
            x << x.front();
            y << y.front();
        }
        path->setData(x, y);
        path->setName(curve.name);
        if (curve.name.isEmpty()) path->removeFromLegend();
        named = named || !curve.name.isEmpty();
        c.drawn.push_back(path);
    }
    c.marks = plot().addGraph();
    c.marks->setLineStyle(QCPGraph::lsNone);
    c.marks->removeFromLegend();
    c.marks->setLayer("overlay");
    showLegend(named);
    setTitles(c.data.title, c.data.remark, c.data.x.label(), c.data.y.label());
    setMarker(c.marked);
    refresh(same);
}

void XyView::setMarker(std::optional<double> along)
{
    Content& c = *content_;
    c.marked = along;
    if (!c.marks) return;
    QVector<double> x, y;
    for (const XyCurve& curve : c.data.curves) {
        if (!along || curve.thin || curve.along.empty()) continue;
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < std::min(sizeOf(curve), curve.along.size()); ++i) {
            const double away = std::abs(curve.along[i] - *along);
            if (away >= least) continue;
            least = away;
            best = i;
        }
        x << curve.x[best];
        y << curve.y[best];
    }
    c.marks->setData(x, y);
    drawOverlay();
}

void XyView::applyStyle()
{
    Content& c = *content_;
    const double width = style().lineWidth;
    for (std::size_t i = 0; i < c.drawn.size(); ++i) {
        const XyCurve& curve = c.data.curves[i];
        const QColor colour = curve.colour.value_or(style().colour({}, i));
        c.drawn[i]->setPen(curve.thin ? QPen(faint(colour, 110), 1) : QPen(colour, 1.2 * width));
    }
    if (!c.marks) return;
    c.marks->setPen(QPen(style().marker, width));
    c.marks->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(style().background, 1), QBrush(style().marker), 6 * width));
}

QString XyView::readoutAt(double x, double y) const
{
    const XyData& data = content_->data;
    const QRectF range = visibleRange();
    const XyCurve* nearest = nullptr;
    std::size_t sample = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const XyCurve& curve : data.curves)
        for (std::size_t i = 0; i < (curve.thin ? 0 : sizeOf(curve)); ++i) {
            const double away = std::hypot(curve.x[i] - x, curve.y[i] - y);
            if (away >= least) continue;
            least = away;
            nearest = &curve;
            sample = i;
        }
    if (!nearest) return {};
    const double px = nearest->x[sample], py = nearest->y[sample];
    const auto number = [&](double value) { return readable(value, range.width(), locale()); };
    QStringList parts;
    if (!nearest->name.isEmpty()) parts << nearest->name;
    if (sample < nearest->along.size()) parts << readable(nearest->along[sample], 100, locale()) + data.along.unit;
    parts << "X " + number(px) << "Y " + number(py);
    parts << tr("radius vector %1 %2").arg(number(std::hypot(px, py)), data.x.unit);
    return parts.join(" · ");
}

void XyView::fitRanges()
{
    double low[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    double high[2] = {-low[0], -low[1]};
    for (const XyCurve& curve : content_->data.curves)
        for (std::size_t i = 0; i < sizeOf(curve); ++i) {
            const double place[2] = {curve.x[i], curve.y[i]};
            for (int axis = 0; axis < 2; ++axis) {
                if (!std::isfinite(place[axis])) continue;
                low[axis] = std::min(low[axis], place[axis]);
                high[axis] = std::max(high[axis], place[axis]);
            }
        }
    for (int axis = 0; axis < 2; ++axis)
        if (!(low[axis] < high[axis])) low[axis] = -1, high[axis] = 1;
    const double margin = 0.05 * std::max(high[0] - low[0], high[1] - low[1]);
    plot().xAxis->setRange(low[0] - margin, high[0] + margin);
    plot().yAxis->setRange(low[1] - margin, high[1] + margin);
}

/// Widens the range of the axis that has more room, so that a circle looks like one.
void XyView::keepScalesEqual()
{
    if (content_->levelling) return;
    content_->levelling = true;
    if (!isViewChosen()) fitRanges();
    const double perX = plot().xAxis->range().size() / std::max(1, plot().axisRect()->width());
    const double perY = plot().yAxis->range().size() / std::max(1, plot().axisRect()->height());
    if (perX > 1.0001 * perY) plot().yAxis->setScaleRatio(plot().xAxis, 1);
    if (perY > 1.0001 * perX) plot().xAxis->setScaleRatio(plot().yAxis, 1);
    content_->levelling = false;
}

QString toCsv(const XyData& data)
{
    QString text = QString("curve,%1,x,y\n").arg(data.along.label());
    const auto number = [](double value) { return QString::number(value, 'g', 17); };
    int position = 0;
    for (const XyCurve& curve : data.curves) {
        ++position;
        QString name = curve.name.isEmpty() ? QString::number(position) : curve.name;
        name.replace('"', "\"\"");
        for (std::size_t i = 0; i < sizeOf(curve); ++i)
            text += '"' + name + "\"," + (i < curve.along.size() ? number(curve.along[i]) : QString()) + ',' +
                    number(curve.x[i]) + ',' + number(curve.y[i]) + '\n';
    }
    return text;
}

}  // namespace lathelier
