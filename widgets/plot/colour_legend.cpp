#include "widgets/plot/colour_legend.h"

#include <QDoubleSpinBox>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>
#include <vector>

namespace lathelier::plot {
namespace {

struct Tick {
    double value;
    bool tolerance;
};

/// Round shares of the limit and the tolerance; numbers nearer than `apart` (in units of the value) give way to it.
std::vector<Tick> ticksOf(const report::DeviationColours& colours, double apart)
{
    std::vector<Tick> ticks;
    for (const std::optional<double>& line : {colours.tolerance, colours.marked})
        if (line && *line > 0 && *line < colours.limit)
            for (const double sign : {-1.0, 1.0}) ticks.push_back({sign * *line, true});
    for (const double share : {-1.0, 1.0, 0.0, -0.5, 0.5}) {
        const double value = share * colours.limit;
        bool free = true;
        for (const Tick& tick : ticks) free = free && std::abs(tick.value - value) > apart;
        if (free) ticks.push_back({value, false});
    }
    return ticks;
}

QString signedNumber(const Tick& tick, double limit, const QLocale& locale)
{
    // A tolerance was given: it is shown as it was.
    const double value = tick.value;
    const int digits =
        static_cast<int>(std::clamp(2 - std::floor(std::log10(limit) + 1e-9), 0.0, 6.0)) + 2 * tick.tolerance;
    QString text = locale.toString(std::abs(value), 'f', digits);
    // No trailing zeros: 0.100 reads as 0.1.
    if (digits > 0) {
        while (text.endsWith(locale.zeroDigit())) text.chop(1);
        if (text.endsWith(locale.decimalPoint())) text.chop(1);
    }
    if (value > 0) return "+" + text;
    return value < 0 ? QChar(0x2212) + text : text;
}

}  // namespace

void paintColourLegend(QPainter& painter, const QRectF& room, const report::DeviationColours& colours,
                       const QString& title, const QFont& font, const QColor& text, const QLocale& locale)
{
    const QFontMetricsF metrics(font);
    const double line = metrics.height();
    painter.save();
    painter.setFont(font);
    painter.setPen(text);
    painter.drawText(QRectF(room.left(), room.top(), room.width(), line), Qt::AlignLeft | Qt::AlignVCenter, title);
    const QRectF bar(room.left(), room.top() + 1.7 * line, 1.1 * line, room.height() - 2.4 * line);
    if (bar.height() < 2 * line) return painter.restore();

    const double limit = colours.limit;
    const auto height = [&](double value) { return bar.center().y() - value / limit * bar.height() / 2; };
    const int rows = std::max(1, static_cast<int>(bar.height()));
    for (int row = 0; row < rows; ++row) {
        const report::Rgb c = colours(limit * (1 - 2 * (row + 0.5) / rows));
        painter.fillRect(
            QRectF(bar.left(), bar.top() + row * bar.height() / rows, bar.width(), bar.height() / rows + 0.6),
            QColor(c.red, c.green, c.blue));
    }
    painter.setPen(QPen(text, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
    for (const Tick& tick : ticksOf(colours, 2.2 * limit * line / bar.height())) {
        const double y = height(tick.value);
        painter.setPen(QPen(text, tick.tolerance ? 2 : 1));
        painter.drawLine(QPointF(tick.tolerance ? bar.left() : bar.right(), y), QPointF(bar.right() + 0.3 * line, y));
        QFont face = font;
        face.setBold(tick.tolerance);
        painter.setFont(face);
        painter.drawText(QRectF(bar.right() + 0.45 * line, y - line / 2, room.right() - bar.right(), line),
                         Qt::AlignLeft | Qt::AlignVCenter, signedNumber(tick, limit, locale));
    }
    painter.restore();
}

int colourLegendWidth(const report::DeviationColours& colours, const QString& title, const QFont& font,
                      const QLocale& locale)
{
    QFont bold = font;
    bold.setBold(true);
    const QFontMetricsF metrics(bold);
    double widest = 0;
    for (const Tick& tick : ticksOf(colours, 0))
        widest = std::max(widest, metrics.horizontalAdvance(signedNumber(tick, colours.limit, locale)));
    return static_cast<int>(std::ceil(
        std::max(1.8 * QFontMetricsF(font).height() + widest, QFontMetricsF(font).horizontalAdvance(title) + 2)));
}

LimitEdit::LimitEdit(QWidget* parent) : QWidget(parent), box_(new QDoubleSpinBox(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(box_);
    box_->setDecimals(4);
    box_->setRange(0.0001, 1000);
    box_->setPrefix(QStringLiteral("± "));
    box_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box_->setKeyboardTracking(false);
    box_->setToolTip(tr("The colour scale runs from minus to plus this many mm."));
    box_->setAccessibleName(tr("Limit of the colour scale in mm"));
    setFocusProxy(box_);
    connect(box_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &LimitEdit::edited);
}

void LimitEdit::setLimit(double limit)
{
    const QSignalBlocker quiet(box_);
    box_->setDecimals(limit < 0.01 ? 5 : limit < 0.1 ? 4 : 3);
    box_->setValue(limit);
}

double LimitEdit::limit() const
{
    return box_->value();
}

ColourLegend::ColourLegend(QWidget* parent) : QWidget(parent), edit_(new LimitEdit(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addStretch(1);
    layout->addWidget(edit_);
    connect(edit_, &LimitEdit::edited, this, &ColourLegend::limitEdited);
}

void ColourLegend::setTitle(const QString& title)
{
    title_ = title;
    updateGeometry();
    update();
}

void ColourLegend::setColours(const report::DeviationColours& colours)
{
    colours_ = colours;
    edit_->setLimit(colours.limit);
    updateGeometry();
    update();
}

QSize ColourLegend::sizeHint() const
{
    const int wide = colourLegendWidth(colours_, title_, font(), locale());
    return {std::max(wide + 8, edit_->sizeHint().width()), 14 * fontMetrics().height() + edit_->sizeHint().height()};
}

void ColourLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintColourLegend(painter, QRectF(rect()).adjusted(4, 2, 0, -edit_->height() - 2), colours_, title_, font(),
                      palette().color(QPalette::WindowText), locale());
}

}  // namespace lathelier::plot
