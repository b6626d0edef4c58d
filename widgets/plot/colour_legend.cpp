#include "widgets/plot/colour_legend.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "widgets/core/icons.h"
#include "widgets/core/language.h"
#include "widgets/plot/plot_style.h"

namespace lathelier::plot {
namespace {

struct Tick {
    double value;
    bool tolerance;
};

/// Round shares of the limit and the tolerance; numbers closer than `apart` (in the unit of the value) to the tolerance
/// are omitted.
std::vector<Tick> ticksOf(const report::DeviationColours& colours, double apart)
{
    std::vector<Tick> ticks;
    for (const std::optional<double>& line : {colours.tolerance, colours.marked})
        for (const double sign : {-1.0, 1.0})
            if (line && *line > 0 && *line < colours.endOf(sign)) ticks.push_back({sign * *line, true});
    for (const double share : {-1.0, 1.0, 0.0, -0.5, 0.5}) {
        const double value = share * colours.endOf(share);
        bool free = true;
        for (const Tick& tick : ticks) free = free && std::abs(tick.value - value) > apart;
        if (free) ticks.push_back({value, false});
    }
    return ticks;
}

/// `limit` and the tick in the engine's unit, the number in the display unit.
QString signedNumber(const Tick& tick, double limit, Text unit, const QLocale& locale)
{
    // A tolerance is shown with the digits it was given with.
    const double value = tick.value * screenFactor(unit);
    const double least_digit = std::floor(std::log10(limit * screenFactor(unit)) + 1e-9);
    const int digits = static_cast<int>(std::clamp(2 - least_digit, 0.0, 7.0)) + 2 * tick.tolerance;
    QString text = locale.toString(std::abs(value), 'f', digits);
    // No trailing zeros: 0.100 reads as 0.1.
    if (digits > 0) {
        while (text.endsWith(locale.zeroDigit())) text.chop(1);
        if (text.endsWith(locale.decimalPoint())) text.chop(1);
    }
    if (value > 0) return "+" + text;
    return value < 0 ? QChar(0x2212) + text : text;
}

double countsWidth(const ScaleCounts& counts, double line)
{
    return counts.counts.empty() ? 0 : 2.2 * line;
}

/// Bars that grow from the scale to the left, the highest as wide as `room`.
void paintCounts(QPainter& painter, const QRectF& room, const Legend& legend, const QColor& text)
{
    const auto& [edges, counts] = legend.counts;
    if (counts.empty() || edges.size() != counts.size() + 1) return;
    const double most = *std::max_element(counts.begin(), counts.end());
    if (!(most > 0)) return;
    const double least = legend.colours.least(), range = legend.colours.limit - least;
    QColor fill = text;
    fill.setAlphaF(0.45);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double from = std::max(edges[i], least), to = std::min(edges[i + 1], legend.colours.limit);
        if (!(to > from)) continue;
        const double width = counts[i] / most * (room.width() - 3);
        painter.fillRect(QRectF(room.right() - 1 - width, room.bottom() - (to - least) / range * room.height(), width,
                                (to - from) / range * room.height()),
                         fill);
    }
}

}  // namespace

ScaleCounts countsOf(const std::vector<float>& values, const report::DeviationColours& colours)
{
    constexpr int bins = 48;
    const double least = colours.least(), range = colours.limit - least;
    ScaleCounts result;
    for (int i = 0; i <= bins; ++i) result.edges.push_back(least + range * i / bins);
    result.counts.assign(bins, 0);
    for (const float value : values) {
        const double place = (static_cast<double>(value) - least) / range * bins;
        if (place >= 0 && place < bins) ++result.counts[static_cast<std::size_t>(place)];
    }
    return result;
}

void paintColourLegend(QPainter& painter, const QRectF& room, const Legend& legend, const QFont& font,
                       const QColor& text, const QLocale& locale)
{
    const report::DeviationColours& colours = legend.colours;
    const QFontMetricsF metrics(font);
    const double line = metrics.height();
    painter.save();
    painter.setFont(font);
    painter.setPen(text);
    painter.drawText(QRectF(room.left(), room.top(), room.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     legend.title);
    const double aside = countsWidth(legend.counts, line);
    const QRectF bar(room.left() + aside, room.top() + 1.7 * line, 1.1 * line, room.height() - 2.4 * line);
    if (bar.height() < 2 * line) return painter.restore();

    const double limit = std::max(colours.limit, -colours.least());
    const double least = colours.least(), range = colours.limit - least;
    const auto height = [&](double value) { return bar.bottom() - (value - least) / range * bar.height(); };
    const int rows = std::max(1, static_cast<int>(bar.height()));
    for (int row = 0; row < rows; ++row) {
        const report::Rgb c = colours(colours.limit - range * (row + 0.5) / rows);
        painter.fillRect(
            QRectF(bar.left(), bar.top() + row * bar.height() / rows, bar.width(), bar.height() / rows + 0.6),
            QColor(c.red, c.green, c.blue));
    }
    paintCounts(painter, QRectF(bar.left() - aside, bar.top(), aside, bar.height()), legend, text);
    painter.setPen(QPen(text, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
    for (const Tick& tick : ticksOf(colours, 1.1 * range * line / bar.height())) {
        const double y = height(tick.value);
        painter.setPen(QPen(text, tick.tolerance ? 2 : 1));
        painter.drawLine(QPointF(tick.tolerance ? bar.left() : bar.right(), y), QPointF(bar.right() + 0.3 * line, y));
        QFont face = font;
        face.setBold(tick.tolerance);
        painter.setFont(face);
        painter.drawText(QRectF(bar.right() + 0.45 * line, y - line / 2, room.right() - bar.right(), line),
                         Qt::AlignLeft | Qt::AlignVCenter, signedNumber(tick, limit, legend.unit, locale));
    }
    painter.restore();
}

int colourLegendWidth(const Legend& legend, const QFont& font, const QLocale& locale)
{
    const report::DeviationColours& colours = legend.colours;
    QFont bold = font;
    bold.setBold(true);
    const QFontMetricsF metrics(bold);
    double widest = 0;
    for (const Tick& tick : ticksOf(colours, 0))
        widest = std::max(widest, metrics.horizontalAdvance(signedNumber(
                                      tick, std::max(colours.limit, -colours.least()), legend.unit, locale)));
    const double line = QFontMetricsF(font).height();
    return static_cast<int>(std::ceil(std::max(countsWidth(legend.counts, line) + 1.8 * line + widest,
                                               QFontMetricsF(font).horizontalAdvance(legend.title) + 2)));
}

LimitEdit::LimitEdit(QWidget* parent)
    : QWidget(parent), upper_(new QDoubleSpinBox(this)), lower_(new QDoubleSpinBox(this)), apart_(new QAction(this))
{
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(upper_, 0, 0);
    layout->addWidget(lower_, 1, 0);
    for (QDoubleSpinBox* box : {upper_, lower_}) {
        box->setDecimals(4);
        box->setRange(0.0001, 1000);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        box->setKeyboardTracking(false);
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { announce(); });
    }
    lower_->setPrefix(QString(QChar(0x2212)) + ' ');
    upper_->setObjectName("scaleUpper");
    lower_->setObjectName("scaleLower");
    apart_->setObjectName("scaleApart");
    apart_->setIcon(icon("sides"));
    apart_->setCheckable(true);
    upper_->findChild<QLineEdit*>()->addAction(apart_, QLineEdit::TrailingPosition);
    connect(apart_, &QAction::toggled, this, [this] {
        lower_->setValue(upper_->value());
        showSides();
        announce();
    });
    setFocusProxy(upper_);
    showSides();
}

void LimitEdit::showSides()
{
    const bool apart = apart_->isChecked();
    upper_->setPrefix(apart ? QStringLiteral("+ ") : QStringLiteral("± "));
    const QString unit = screenUnit(unit_);
    upper_->setToolTip(apart ? tr("Upper end of the colour scale in %1").arg(unit)
                             : tr("The colour scale runs from minus to plus this many %1.").arg(unit));
    upper_->setAccessibleName(tr("Limit of the colour scale in %1").arg(unit));
    lower_->setToolTip(tr("How far below 0 the colour scale goes, in %1").arg(unit));
    lower_->setAccessibleName(lower_->toolTip());
    apart_->setText(tr("Each side of the scale by itself"));
    lower_->setVisible(apart);
    adjustSize();
}

void LimitEdit::announce()
{
    const double factor = screenFactor(unit_);
    emit edited(upper_->value() / factor, apart_->isChecked() ? lower_->value() / factor : 0);
}

void LimitEdit::setUnit(Text unit)
{
    unit_ = unit;
    {
        const QSignalBlocker quiet[]{QSignalBlocker(upper_), QSignalBlocker(lower_)};
        const double factor = screenFactor(unit_);
        for (QDoubleSpinBox* box : {upper_, lower_}) box->setRange(factor < 1 ? 1e-5 : 1e-4, factor > 1 ? 1e5 : 1e3);
    }
    setColours(shown_);
}

void LimitEdit::setColours(const report::DeviationColours& colours)
{
    const QSignalBlocker quiet[]{QSignalBlocker(upper_), QSignalBlocker(lower_), QSignalBlocker(apart_)};
    shown_ = colours;
    const auto show = [factor = screenFactor(unit_)](QDoubleSpinBox* box, double limit) {
        const double shown = limit * factor;
        box->setDecimals(shown < 0.01 ? 5 : shown < 0.1 ? 4 : 3);
        box->setValue(shown);
    };
    apart_->setChecked(colours.lower.has_value());
    show(upper_, colours.limit);
    show(lower_, -colours.least());
    showSides();
}

ColourLegend::ColourLegend(QWidget* parent) : QWidget(parent), edit_(new LimitEdit(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addStretch(1);
    layout->addWidget(edit_);
    connect(edit_, &LimitEdit::edited, this, &ColourLegend::limitEdited);
}

void ColourLegend::setAxis(const report::Axis& axis)
{
    legend_.title = chartText(axis);
    legend_.unit = axis.unit;
    edit_->setUnit(axis.unit);
    updateGeometry();
    update();
}

void ColourLegend::setColours(const report::DeviationColours& colours)
{
    legend_.colours = colours;
    edit_->setColours(colours);
    updateGeometry();
    update();
}

void ColourLegend::setCounts(ScaleCounts counts)
{
    legend_.counts = std::move(counts);
    updateGeometry();
    update();
}

QSize ColourLegend::sizeHint() const
{
    const int wide = colourLegendWidth(legend_, font(), locale());
    return {std::max(wide + 8, edit_->sizeHint().width()), 14 * fontMetrics().height() + edit_->sizeHint().height()};
}

void ColourLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintColourLegend(painter, QRectF(rect()).adjusted(4, 2, 0, -edit_->height() - 2), legend_, font(),
                      palette().color(QPalette::WindowText), locale());
}

}  // namespace lathelier::plot
