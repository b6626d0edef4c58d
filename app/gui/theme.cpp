#include "app/gui/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

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

}  // namespace

void applyTheme(QApplication& application)
{
    const bool dark = application.palette().color(QPalette::Window).lightness() < 128;
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QPalette palette = dark ? darkPalette() : lightPalette();
    withDisabled(palette);
    QApplication::setPalette(palette);
}

}  // namespace lathelier
