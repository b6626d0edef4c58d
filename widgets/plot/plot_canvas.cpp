#include "widgets/plot/plot_canvas.h"

#include <QVBoxLayout>
#include <algorithm>

#include "engine/report/ticks.h"
#include "widgets/core/language.h"
#include "widgets/plot/plot_parts.h"

namespace lathelier::plot {
namespace {

constexpr int lowestWithLegend = 10;  // height in text lines below which a legend of one row is omitted

/// Ticker with the ticks and labels of the report.
class ChartTicker : public QCPAxisTicker {
public:
    ChartTicker(report::Axis::Scale scale, double factor) : scale_(scale), factor_(factor) {}

    void generate(const QCPRange& range, const QLocale& locale, QChar, int, QVector<double>& ticks,
                  QVector<double>* subTicks, QVector<QString>* labels) override
    {
        // Steps of 1, 2, 5 give up to 2.5 times fewer ticks than requested: the request is scaled accordingly.
        const report::Ticks found =
            report::axisTicks(scale_, {range.lower, range.upper}, tickCount() + (tickCount() + 1) / 2, factor_);
        ticks = {found.values.begin(), found.values.end()};
        if (subTicks) *subTicks = {found.minor.begin(), found.minor.end()};
        if (!labels) return;
        Language numbers;
        numbers.number = [&](double value) { return locale.toString(value, 'g', 6).toStdString(); };
        numbers.fixed = [&](double value, int decimals) { return locale.toString(value, 'f', decimals).toStdString(); };
        labels->clear();
        for (const double value : found.values)
            *labels << QString::fromStdString(report::tickLabel(value, found, numbers));
    }

private:
    report::Axis::Scale scale_;
    double factor_;  ///< tick label = value × factor
};

}  // namespace

PlotCanvas::PlotCanvas(QWidget* parent)
    : PlotWidget(parent),
      plot_(new QCustomPlot(this)),
      tag_(new PointerTag(this)),
      style_(palette(), font()),
      parts_(std::make_unique<Parts>())
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot_);
    setFocusPolicy(Qt::StrongFocus);
    plot_->setFocusProxy(this);
    plot_->setMouseTracking(true);
    plot_->setMinimumSize(40, 30);  // QCustomPlot cannot paint on an empty area
    plot_->installEventFilter(this);
    plot_->setPlottingHint(QCP::phFastPolylines);
    plot_->setNoAntialiasingOnDrag(true);
    plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);

    QCPLayoutGrid* grid = plot_->plotLayout();
    grid->setRowSpacing(0);
    grid->insertRow(0);
    grid->addElement(0, 0, parts_->title = new TextLine(plot_));
    parts_->readout = new TextLine(plot_);
    parts_->readout->setLayer("overlay");
    parts_->readout->coverTitle(parts_->title);
    plot_->axisRect()->insetLayout()->take(plot_->legend);
    plot_->axisRect()->setupFullAxesBox();
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
    plot_->legend->setBorderPen(Qt::NoPen);
    plot_->legend->setIconTextPadding(4);
    plot_->legend->setColumnSpacing(6);
    plot_->legend->setMargins(QMargins(6, 0, 6, 2));
    plot_->legend->setVisible(false);

    for (QCPItemStraightLine** line : {&parts_->vertical, &parts_->horizontal}) {
        *line = new QCPItemStraightLine(plot_);
        (*line)->setLayer("overlay");
        (*line)->setVisible(false);
        (*line)->setSelectable(false);
    }
    parts_->stretch = new QCPItemRect(plot_);
    parts_->stretch->setLayer("overlay");
    parts_->stretch->setVisible(false);
    parts_->stretch->setSelectable(false);
    setAxes({}, {});
    connect(plot_, &QCustomPlot::mousePress, this, &PlotCanvas::mousePressed);
    connect(plot_, &QCustomPlot::mouseMove, this, &PlotCanvas::mouseMoved);
    connect(plot_, &QCustomPlot::mouseRelease, this, &PlotCanvas::mouseReleased);
    connect(plot_, &QCustomPlot::mouseWheel, this, &PlotCanvas::mouseWheel);
    connect(plot_, &QCustomPlot::mouseDoubleClick, this, &PlotCanvas::mouseDoubleClicked);
}

PlotCanvas::~PlotCanvas() = default;

void PlotCanvas::setTitles(const QString& title, const QString& remark, const QString& x, const QString& y)
{
    parts_->title->set(title, remark);
    parts_->x_title = x;
    parts_->y_title = y;
    setAccessibleName(title);
}

void PlotCanvas::setAxes(const report::Axis& x, const report::Axis& y)
{
    const auto set = [](QCPAxis* axis, QCPAxis* opposite, const report::Axis& asked) {
        const auto ticker = QSharedPointer<ChartTicker>::create(asked.scale, screenFactor(asked.unit));
        const report::Axis::Scale scale = asked.scale;
        ticker->setTickCount(axis->ticker()->tickCount());
        for (QCPAxis* side : {axis, opposite}) {  // one ticker, so that both sides have the same ticks
            side->setScaleType(scale == report::Axis::Scale::Logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
            side->setTicker(ticker);
        }
    };
    parts_->x_factor = screenFactor(x.unit);
    set(plot_->xAxis, plot_->xAxis2, x);
    set(plot_->yAxis, plot_->yAxis2, y);
}

void PlotCanvas::setReadout(const QString& text)
{
    parts_->readout->set(text);
}

void PlotCanvas::showLegend(bool shown)
{
    parts_->legend_wanted = shown;
    placeLegend();
}

void PlotCanvas::placeLegend()
{
    // In a low plot the space is used for the curves.
    const int columns = std::max(1, plot_->legend->wrap());
    const int rows = (plot_->legend->itemCount() + columns - 1) / columns;
    const int lowest = (lowestWithLegend + 2 * std::max(0, rows - 1)) * fontMetrics().height();
    const bool shown = parts_->legend_wanted && !isSmall() && (height() == 0 || height() > lowest);
    // Below the axes, so that it covers no curve; removed from the layout when empty, since it would narrow the column.
    QCPLayoutGrid* grid = plot_->plotLayout();
    const bool there = grid->hasElement(2, 0);
    if (shown && !there) {
        grid->addElement(2, 0, plot_->legend);
        grid->setRowStretchFactor(2, 0.001);
    } else if (!shown && there) {
        grid->take(plot_->legend);
        grid->simplify();
    }
    plot_->legend->setVisible(shown);
}

void PlotCanvas::leaveRoomInTitle(int pixels)
{
    parts_->title->leaveRoom(pixels);
}

void PlotCanvas::refresh(bool keepView)
{
    if (!keepView || !parts_->view_chosen) {
        parts_->view_chosen = false;
        fitRanges();
    }
    restyle(palette());
    redraw();
}

void PlotCanvas::redraw()
{
    // A hidden plot is drawn when it is shown.
    if (isVisible()) plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::drawOverlay()
{
    if (isVisible() && !plot_->size().isEmpty()) plot_->layer("overlay")->replot();
}

void PlotCanvas::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    fitTexts();
    redraw();
}

void PlotCanvas::setDrawsStretch(bool on)
{
    parts_->draws_stretch = on;
    plot_->setCursor(on ? Qt::SplitHCursor : Qt::CrossCursor);
}

bool PlotCanvas::isViewChosen() const
{
    return parts_->view_chosen;
}

void PlotCanvas::chooseView()
{
    parts_->view_chosen = true;
}

void PlotCanvas::resetView()
{
    parts_->view_chosen = false;
    fitRanges();
    redraw();
}

QRectF PlotCanvas::visibleRange() const
{
    const QCPRange x = plot_->xAxis->range();
    const QCPRange y = plot_->yAxis->range();
    return {x.lower, y.lower, x.size(), y.size()};
}

QPointF PlotCanvas::pixelAt(double x, double y) const
{
    return {plot_->xAxis->coordToPixel(x), plot_->yAxis->coordToPixel(y)};
}

QString PlotCanvas::readout() const
{
    return parts_->readout->text();
}

void PlotCanvas::restyle(const QPalette& palette)
{
    style_ = PlotStyle(palette, font());
    QFont bold = font();
    bold.setBold(true);
    parts_->title->setLook(bold, style_.text, Qt::AlignLeft);
    parts_->readout->setLook(font(), style_.text, Qt::AlignLeft);
    parts_->readout->setBackground(style_.background);
    plot_->setBackground(style_.background);
    QLocale spoken = locale();
    spoken.setNumberOptions(QLocale::OmitGroupSeparator);
    plot_->setLocale(spoken);
    for (QCPAxisRect* rect : plot_->axisRects())
        for (QCPAxis* axis : rect->axes()) {
            axis->setLabelFont(font());
            axis->setTickLabelFont(font());
            axis->setLabelColor(style_.text);
            axis->setTickLabelColor(style_.text);
            for (auto set : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
                (axis->*set)(QPen(style_.text, 1));
            axis->grid()->setPen(QPen(style_.grid, 1));
            axis->grid()->setZeroLinePen(QPen(style_.text, 1));
        }
    for (QCPItemStraightLine* line : {parts_->vertical, parts_->horizontal})
        line->setPen(QPen(style_.text, 1, Qt::DotLine));
    QColor drawn = style_.limit;
    parts_->stretch->setPen(QPen(drawn, 1));
    drawn.setAlpha(60);
    parts_->stretch->setBrush(drawn);
    plot_->legend->setFont(font());
    const int line = QFontMetrics(font()).height();
    plot_->legend->setIconSize(3 * line / 2, 3 * line / 4);
    plot_->legend->setTextColor(style_.text);
    plot_->legend->setBrush(style_.background);
    fitTexts();
    applyStyle();
}

void PlotCanvas::fitTexts()
{
    const QFontMetrics metrics(font());
    const int height = metrics.height();
    const auto fit = [&](QCPAxis* axis, const QString& title, int length, int tickLength) {
        // Without space for the title its unit is shown.
        const qsizetype unit = title.lastIndexOf('(');
        const bool fits = metrics.horizontalAdvance(title) <= length;
        if (isSmall()) {
            axis->setLabel({});
            return axis->ticker()->setTickCount(std::clamp(length / std::max(tickLength, 1), 2, 5));
        }
        axis->setLabel(fits || unit < 0 ? metrics.elidedText(title, Qt::ElideRight, std::max(length, 2 * height))
                                        : title.mid(static_cast<int>(unit)));
        axis->ticker()->setTickCount(std::clamp(length / std::max(tickLength, 1), 2, 9));
    };
    fit(plot_->xAxis, parts_->x_title, width() - 6 * height - besideAxes(), 5 * height);
    fit(plot_->yAxis, parts_->y_title, this->height() - (isSmall() ? 2 : 6) * height, (isSmall() ? 4 : 3) * height / 2);
    int widest = 1;
    for (QCPLayoutElement* item : plot_->legend->elements(false))
        if (item) widest = std::max(widest, item->minimumOuterSizeHint().width() + plot_->legend->columnSpacing());
    plot_->legend->setWrap(std::max(1, (width() - 20) / widest));
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst, true);  // rearranges existing items into the new columns
}

void PlotCanvas::sizeChosen()
{
    parts_->title->setShown(!isSmall());
    fitTexts();
    placeLegend();
    redraw();
}

void PlotCanvas::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
        case QEvent::PaletteChange:
        case QEvent::FontChange:
        case QEvent::StyleChange:
        case QEvent::LocaleChange:
            restyle(palette());
            redraw();
            break;
        default: break;
    }
}

void PlotCanvas::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitTexts();
    placeLegend();
    redraw();  // the plot was resized before this event, with the old texts
}

}  // namespace lathelier::plot
