#include "widgets/core/panel/swing_button.h"

#include <numbers>

#include "widgets/core/icons.h"

namespace lathelier {
namespace {

constexpr int swingFrame_ms = 40;
constexpr int framesOfSwing = 50;

}  // namespace

SwingButton::SwingButton(const char* name)
{
    setObjectName(name);
    setCheckable(true);
    setAutoRaise(true);
    setIcon(lathelier::icon("play"));
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    clock_.setInterval(swingFrame_ms);
    connect(&clock_, &QTimer::timeout, this, [this] {
        tick_ = (tick_ + 1) % framesOfSwing;
        emit moved();
    });
    connect(this, &QToolButton::toggled, this, &SwingButton::play);
}

double SwingButton::phaseOfSwing() const
{
    return 2 * std::numbers::pi * tick_ / framesOfSwing;
}

void SwingButton::setWords(const QString& text, const QString& help)
{
    setText(text);
    setToolTip(help);
    setAccessibleName(help);
}

void SwingButton::play(bool on)
{
    setIcon(lathelier::icon(on ? "pause" : "play"));
    tick_ = 0;
    if (on)
        clock_.start();
    else
        clock_.stop();
    emit moved();
}

}  // namespace lathelier
