#include "widgets/plot/plot_style.h"

#include <QFontMetricsF>
#include <cmath>

#include "engine/report/polar_svg.h"

namespace lathelier {
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
    limit = dark() ? QColor(255, 176, 64) : QColor(176, 88, 0);
    marker = dark() ? QColor(255, 105, 180) : QColor(170, 0, 110);
    lineWidth = std::max(1.4, QFontMetricsF(font).height() / 10);
}

QColor PlotStyle::curve(int index) const
{
    const std::string_view name = polarColour(static_cast<std::size_t>(index));  // as in the report
    const QColor colour(QString::fromLatin1(name.data(), static_cast<int>(name.size())));
    return dark() ? mix(colour, Qt::white, 0.3) : colour;
}

QPalette paperPalette()
{
    QPalette palette(Qt::black, QColor(240, 240, 240), QColor(250, 250, 250), QColor(120, 120, 120),
                     QColor(200, 200, 200), Qt::black, Qt::white, Qt::white, Qt::white);
    return palette;
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

}  // namespace lathelier
