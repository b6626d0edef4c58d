#include "app/gui/theme.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QMainWindow>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <optional>

namespace lathelier {
namespace {

QPalette lightPalette()
{
    QPalette palette(QColor("#eef1f4"));
    palette.setColor(QPalette::Window, "#f4f6f8");
    palette.setColor(QPalette::WindowText, "#1c2530");
    palette.setColor(QPalette::Base, "#ffffff");
    palette.setColor(QPalette::AlternateBase, "#fbf3e6");
    palette.setColor(QPalette::Text, "#1c2530");
    palette.setColor(QPalette::Button, "#e9edf1");
    palette.setColor(QPalette::ButtonText, "#1c2530");
    palette.setColor(QPalette::ToolTipBase, "#fffdf5");
    palette.setColor(QPalette::ToolTipText, "#1c2530");
    palette.setColor(QPalette::Highlight, "#2c6aa0");
    palette.setColor(QPalette::HighlightedText, "#ffffff");
    palette.setColor(QPalette::PlaceholderText, "#66717d");
    palette.setColor(QPalette::Link, "#1f5f99");
    return palette;
}

QPalette darkPalette()
{
    QPalette palette(QColor("#2a3038"));
    palette.setColor(QPalette::Window, "#20252c");
    palette.setColor(QPalette::WindowText, "#e6eaee");
    palette.setColor(QPalette::Base, "#191d23");
    palette.setColor(QPalette::AlternateBase, "#3a3223");
    palette.setColor(QPalette::Text, "#e6eaee");
    palette.setColor(QPalette::Button, "#2d343d");
    palette.setColor(QPalette::ButtonText, "#e6eaee");
    palette.setColor(QPalette::ToolTipBase, "#2d343d");
    palette.setColor(QPalette::ToolTipText, "#e6eaee");
    palette.setColor(QPalette::Highlight, "#4a8cc7");
    palette.setColor(QPalette::HighlightedText, "#ffffff");
    palette.setColor(QPalette::PlaceholderText, "#9aa5b1");
    palette.setColor(QPalette::Link, "#7fb4e0");
    return palette;
}

void withDisabled(QPalette& palette)
{
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor faint = palette.color(QPalette::Active, role);
        faint.setAlphaF(0.5);
        palette.setColor(QPalette::Disabled, role, faint);
    }
}

constexpr int dockTabSpace_px = 4;  // over and under the words

/// Fusion without the dots on what separates docks (they are found by the pointer), and with check boxes that are seen.
class CalmStyle : public QProxyStyle {
public:
    CalmStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override
    {
        // The tabs of the docks are low: they take height from every view.
        if (metric == PM_TabBarTabVSpace && widget && qobject_cast<const QMainWindow*>(widget->parentWidget()))
            return dockTabSpace_px;
        return QProxyStyle::pixelMetric(metric, option, widget);
    }

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override
    {
        if (element == PE_IndicatorDockWidgetResizeHandle) return;
        const auto* box = qstyleoption_cast<const QStyleOptionButton*>(option);
        if (element != PE_IndicatorCheckBox || !box)
            return QProxyStyle::drawPrimitive(element, option, painter, widget);
        // Fusion draws the frame darker than the window, which nobody sees on a dark one.
        QStyleOptionButton framed = *box;
        framed.palette.setColor(QPalette::Window, box->palette.color(QPalette::PlaceholderText));
        QProxyStyle::drawPrimitive(element, &framed, painter, widget);
    }
};

// The desktop's colour scheme: 0 no preference, 1 dark, 2 light (XDG desktop portal, org.freedesktop.appearance).
constexpr const char* portalService = "org.freedesktop.portal.Desktop";
constexpr const char* portalPath = "/org/freedesktop/portal/desktop";
constexpr const char* portalSettings = "org.freedesktop.portal.Settings";
constexpr const char* appearance = "org.freedesktop.appearance";
constexpr const char* colourScheme = "color-scheme";
constexpr int answerTime_ms = 300;

/// Nothing when there is no portal or the user has no preference.
std::optional<bool> isDark(QVariant value)
{
    while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
    const uint scheme = value.toUInt();
    if (scheme != 1 && scheme != 2) return std::nullopt;
    return scheme == 1;
}

std::optional<bool> desktopIsDark(QDBusConnection& bus)
{
    if (!bus.isConnected()) return std::nullopt;
    QDBusMessage question = QDBusMessage::createMethodCall(portalService, portalPath, portalSettings, "Read");
    question << appearance << colourScheme;
    const QDBusMessage answer = bus.call(question, QDBus::Block, answerTime_ms);
    if (answer.type() != QDBusMessage::ReplyMessage || answer.arguments().isEmpty()) return std::nullopt;
    return isDark(answer.arguments().constFirst());
}

}  // namespace

Theme::Theme(QApplication& application) : QObject(&application)
{
    QDBusConnection bus = QDBusConnection::sessionBus();
    const bool platformIsDark = QApplication::palette().color(QPalette::Window).lightness() < 128;
    QApplication::setStyle(new CalmStyle);
    desktopDark_ = desktopIsDark(bus).value_or(platformIsDark);
    apply();
    bus.connect(portalService, portalPath, portalSettings, "SettingChanged", this,
                SLOT(desktopChanged(QString, QString, QDBusVariant)));
}

void Theme::desktopChanged(const QString& group, const QString& key, const QDBusVariant& value)
{
    if (group != appearance || key != colourScheme) return;
    desktopDark_ = isDark(value.variant()).value_or(false);
    apply();
}

void Theme::choose(const QString& wanted)
{
    if (wanted == wanted_) return;
    wanted_ = wanted;
    apply();
}

void Theme::apply()
{
    const bool dark = wanted_.isEmpty() ? desktopDark_ : wanted_ == "dark";
    QPalette palette = dark ? darkPalette() : lightPalette();
    withDisabled(palette);
    QApplication::setPalette(palette);
}

}  // namespace lathelier
