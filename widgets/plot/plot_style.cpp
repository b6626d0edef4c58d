#include "widgets/plot/plot_style.h"

#include <QFontMetricsF>
#include <cmath>

#include "widgets/core/language.h"

namespace lathelier::plot {
namespace {

QColor mix(const QColor& a, const QColor& b, double share)
{
    const auto part = [&](int x, int y) { return static_cast<int>(std::lround(x + share * (y - x))); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

}  // namespace

PlotStyle::PlotStyle(const QPalette& palette, const QFont& font)
    : background(palette.color(QPalette::Base)), text(palette.color(QPalette::Text)), grid(mix(background, text, 0.15))
{
    limit = colour(report::ColourRole::Limit);
    marker = colour(report::ColourRole::Mark);
    line_width = std::max(1.4, QFontMetricsF(font).height() / 10);
}

QColor PlotStyle::colour(const report::ChartColour& meaning, std::size_t position) const
{
    return toQt(report::colourOf(meaning, position, dark() ? report::Ground::Dark : report::Ground::Light));
}

QColor toQt(const report::Rgb& colour)
{
    return {colour.red, colour.green, colour.blue};
}

QString chartText(const report::Caption& caption)
{
    return QString::fromStdString(report::captionText(caption, screenLanguage()));
}

QString chartText(const report::Axis& axis)
{
    return QString::fromStdString(report::axisLabel(axis, screenLanguage()));
}

QString shortAxisTitle(const report::Axis& axis)
{
    return chartText(axis.title).section(',', 0, 0);
}

QPalette paperPalette()
{
    QPalette palette(Qt::black, QColor(240, 240, 240), QColor(250, 250, 250), QColor(120, 120, 120),
                     QColor(200, 200, 200), Qt::black, Qt::white, Qt::white, Qt::white);
    return palette;
}

QString readable(double value, double span, Text unit, const QLocale& locale)
{
    QString number = readable(value * screenFactor(unit), span * screenFactor(unit), locale);
    if (unit.empty()) return number;
    const QString unitText = screenUnit(unit);
    return unitText == QStringLiteral("°") ? number + unitText : number + ' ' + unitText;
}

QString readable(double value, double span, const QLocale& locale)
{
    if (!std::isfinite(value)) return QStringLiteral("–");
    const double step = std::abs(span) > 0 ? std::abs(span) / 1000 : 1e-3;
    const int digits = static_cast<int>(std::clamp(std::ceil(-std::log10(step)), 0.0, 9.0));
    QString text = locale.toString(value, 'f', digits);
    if (text.startsWith('-')) text[0] = QChar(0x2212);
    return text;
}

}  // namespace lathelier::plot
