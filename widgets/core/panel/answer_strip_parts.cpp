// What the answer strip consists of: labels that are cut with an ellipsis, links to findings, the ruler.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/core/language.h"
#include "widgets/core/panel/answer_strip.h"

namespace lathelier {

ElidedLabel::ElidedLabel(const char* name)
{
    setObjectName(name);
    setTextInteractionFlags(Qt::NoTextInteraction);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ElidedLabel::say(const QString& text)
{
    setText(text);
    updateGeometry();
}

QSize ElidedLabel::sizeHint() const
{
    return {fontMetrics().horizontalAdvance(text()) + 2, fontMetrics().height()};
}

QSize ElidedLabel::minimumSizeHint() const
{
    return {fontMetrics().averageCharWidth() * 8, fontMetrics().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, width()));
}

FindingLink::FindingLink(const char* name) : ElidedLabel(name)
{
    offer({}, false);
}

void FindingLink::offer(const QString& text, bool leads)
{
    leads_ = leads;
    say(text);
    // A short text leaves what it does not need to the long ones beside it.
    setMaximumWidth(text.isEmpty() ? QWIDGETSIZE_MAX : sizeHint().width());
    setToolTip(text);
    setAccessibleName(text.isEmpty() ? tr("no finding") : text);
    setFocusPolicy(leads ? Qt::StrongFocus : Qt::NoFocus);
    if (leads)
        setCursor(Qt::PointingHandCursor);
    else
        unsetCursor();
}

void FindingLink::mouseReleaseEvent(QMouseEvent* event)
{
    if (leads_ && event->button() == Qt::LeftButton && rect().contains(event->pos())) emit clicked();
}

void FindingLink::keyPressEvent(QKeyEvent* event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
    if (enter && leads_)
        emit clicked();
    else
        ElidedLabel::keyPressEvent(event);
}

void FindingLink::paintEvent(QPaintEvent* event)
{
    ElidedLabel::paintEvent(event);
    if (!leads_) return;
    QPainter painter(this);
    painter.setPen(palette().color(hasFocus() ? QPalette::Highlight : QPalette::Link));
    const int width = std::min(this->width(), fontMetrics().horizontalAdvance(text()));
    painter.drawLine(0, height() - 1, width, height() - 1);
}

AnswerRuler::AnswerRuler(QWidget* parent) : QWidget(parent)
{
    setObjectName("ruler");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void AnswerRuler::setAnswer(const std::optional<report::Answer>& answer)
{
    ruler_ = answer ? report::rulerOf(*answer) : std::nullopt;
    const Text unit = answer ? answer->unit : Text{};
    const auto number = [unit](const std::optional<double>& value) {
        return value ? QString::fromStdString(
                           lathelier::text(shownValue(*value, unit, screenLanguage()), screenLanguage()))
                     : QString();
    };
    lower_ = answer ? number(answer->lower_limit) : QString();
    upper_ = answer ? number(answer->upper_limit) : QString();
    const QString words = answer ? QString::fromStdString(report::limitText(*answer, screenLanguage())) : QString();
    setToolTip(words);
    setAccessibleName(words);
    update();
}

QSize AnswerRuler::sizeHint() const
{
    return {fontMetrics().averageCharWidth() * 40, fontMetrics().height() * 2 + 6};
}

QSize AnswerRuler::minimumSizeHint() const
{
    return {fontMetrics().averageCharWidth() * 14, fontMetrics().height() * 2 + 6};
}

void AnswerRuler::paintEvent(QPaintEvent*)
{
    if (!ruler_) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = fontMetrics().height();
    const double left = line, right = width() - line;
    const double middle = (height() - line) / 2.0;
    const double bar = line / 2.6;
    const auto x = [&](double place) { return left + place * (right - left); };
    QColor ink = palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText);
    QColor track = ink;
    track.setAlphaF(0.15);
    painter.fillRect(QRectF(left, middle - bar / 2, right - left, bar), track);
    QColor within(0x2f, 0x9e, 0x6b);
    within.setAlphaF(isEnabled() ? 0.55 : 0.25);
    painter.fillRect(
        QRectF(x(ruler_->within_from), middle - bar / 2, x(ruler_->within_to) - x(ruler_->within_from), bar), within);
    painter.setPen(QPen(ink, 1.6));
    const auto limit = [&](double place, const QString& words) {
        painter.drawLine(QPointF(x(place), middle - bar), QPointF(x(place), middle + bar));
        const double half = fontMetrics().horizontalAdvance(words) / 2.0 + 1;
        const double centre = std::clamp(x(place), half, std::max(half, width() - half));
        const double under = std::min(height() - line, middle + bar + 2);
        painter.drawText(QRectF(centre - half, under, 2 * half, line), Qt::AlignCenter, words);
    };
    if (ruler_->is_lower_limited) limit(ruler_->within_from, lower_);
    if (ruler_->is_upper_limited) limit(ruler_->within_to, upper_);
    painter.setPen(QPen(ink, std::max(2.0, line / 7)));
    painter.drawLine(QPointF(x(ruler_->low), middle), QPointF(x(ruler_->high), middle));
    const double tip = line / 2.8;
    const double at = x(ruler_->value);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    QPolygonF pointer;
    pointer << QPointF(at - tip, middle - bar / 2 - 1.6 * tip) << QPointF(at + tip, middle - bar / 2 - 1.6 * tip)
            << QPointF(at, middle - bar / 2);
    painter.drawPolygon(pointer);
}

}  // namespace lathelier
