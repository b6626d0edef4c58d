#include "widgets/chain/step_tile.h"

#include <QPainter>
#include <QStyleOption>
#include <algorithm>

namespace lathelier::chain_panel {
namespace {

constexpr int margin_px = 6;
constexpr int radius_px = 4;

bool isDark(const QPalette& palette)
{
    return palette.window().color().lightness() < 128;
}

/// Distinguished by lightness as well; symbol and text repeat the state.
QColor colourOf(const chain::StepStanding& standing, const QPalette& palette)
{
    const bool dark = isDark(palette);
    QColor bad = dark ? QColor(0xff, 0x80, 0x60) : QColor(0xb0, 0x2a, 0x00);
    QColor unsure = dark ? QColor(0xf0, 0xb4, 0x40) : QColor(0x8a, 0x5a, 0x00);
    switch (standing.state) {
        case chain::StepState::Done:
            if (!standing.isSound()) return *standing.verdict == Verdict::Fail ? bad : unsure;
            return dark ? QColor(0x56, 0xb4, 0x8c) : QColor(0x00, 0x6d, 0x4f);
        case chain::StepState::OutOfDate: return unsure;
        case chain::StepState::Failed: return bad;
        case chain::StepState::Missing:
        case chain::StepState::NotReached: break;
    }
    return palette.color(QPalette::Disabled, QPalette::WindowText);
}

}  // namespace

QString signOf(const chain::StepStanding& standing)
{
    switch (standing.state) {
        case chain::StepState::Done:
            if (standing.isSound()) return QStringLiteral("✓");
            return *standing.verdict == Verdict::Fail ? QStringLiteral("✗") : QStringLiteral("?");
        case chain::StepState::OutOfDate: return QStringLiteral("!");
        case chain::StepState::Failed: return QStringLiteral("✗");
        case chain::StepState::NotReached: return QStringLiteral("○");
        case chain::StepState::Missing: break;
    }
    return QStringLiteral("–");
}

QString wordOf(const chain::StepStanding& standing)
{
    switch (standing.state) {
        case chain::StepState::Done:
            if (standing.isSound()) return StepTile::tr("done");
            return *standing.verdict == Verdict::Fail ? StepTile::tr("out of tolerance") : StepTile::tr("not decided");
        case chain::StepState::OutOfDate: return StepTile::tr("out of date");
        case chain::StepState::Failed: return StepTile::tr("failed");
        case chain::StepState::NotReached: return StepTile::tr("not made yet");
        case chain::StepState::Missing: break;
    }
    return StepTile::tr("missing");
}

StepTile::StepTile(QWidget* parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StepTile::say(const QString& title, const chain::StepStanding& standing)
{
    setText(title);
    standing_ = standing;
    setAccessibleName(title + ": " + wordOf(standing));
    updateGeometry();
    update();
}

/// Wide enough for every state, so that the layout is stable.
QSize StepTile::sizeHint() const
{
    int width = fontMetrics().horizontalAdvance(text());
    for (const auto state : {chain::StepState::Done, chain::StepState::OutOfDate, chain::StepState::Failed,
                             chain::StepState::NotReached, chain::StepState::Missing})
        width = std::max(width, fontMetrics().horizontalAdvance(signOf({state, {}}) + " " + wordOf({state, {}})));
    return {width + 2 * margin_px, 2 * fontMetrics().height() + 8};
}

QSize StepTile::minimumSizeHint() const
{
    return {std::min(sizeHint().width(), 9 * fontMetrics().averageCharWidth()), sizeHint().height()};
}

void StepTile::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = colourOf(standing_, palette());
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QColor fill = palette().color(QPalette::Base);
    if (underMouse() || isDown()) fill = palette().color(QPalette::AlternateBase);
    painter.setPen(
        QPen(hasFocus() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Mid), hasFocus() ? 2 : 1));
    painter.setBrush(fill);
    painter.drawRoundedRect(box, radius_px, radius_px);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRect(QRectF(box.left() + 1, box.bottom() - 3, box.width() - 2, 3));
    const QRect inner = rect().adjusted(margin_px, 2, -margin_px, -5);
    const QFontMetrics metrics = fontMetrics();
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop, metrics.elidedText(text(), Qt::ElideRight, inner.width()));
    painter.setPen(colour);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignBottom,
                     metrics.elidedText(signOf(standing_) + " " + wordOf(standing_), Qt::ElideRight, inner.width()));
}

void StepTile::enterEvent(QEvent* event)
{
    QAbstractButton::enterEvent(event);
    update();
}

void StepTile::leaveEvent(QEvent* event)
{
    QAbstractButton::leaveEvent(event);
    update();
}

}  // namespace lathelier::chain_panel
