#include "widgets/core/shell/question_box.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFocusRect>

namespace lathelier {
namespace {

using State = QuestionAnswer::State;

constexpr int side_px = 5;   // left and right of what is written
constexpr int above_px = 3;  // over the name
constexpr int below_px = 6;  // under the answer, with the line of the open question
constexpr int gap_px = 4;    // between icon and name
constexpr int radius_px = 4;

}  // namespace

QuestionBox::QuestionBox(QWidget* parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
}

void QuestionBox::setTitle(const QString& title)
{
    setText(title);
    describe();
    updateGeometry();
}

void QuestionBox::setAnswer(const QuestionAnswer& answer)
{
    answer_ = answer;
    describe();
    update();
}

void QuestionBox::setCompact(bool compact)
{
    if (compact == compact_) return;
    compact_ = compact;
    update();
}

QString QuestionBox::stateWords() const
{
    switch (answer_.state) {
        case State::Empty: return tr("no answer yet");
        case State::Computing: return tr("computing…");
        case State::Failed: return tr("could not be answered");
        case State::Outdated: return tr("out of date");
        case State::Answered: break;
    }
    return {};
}

QString QuestionBox::answerText() const
{
    const QString words = (answer_.assumed ? QStringLiteral("≈ ") : QString()) + answer_.text;
    switch (answer_.state) {
        case State::Empty: return QStringLiteral("○");
        case State::Computing: return QStringLiteral("… ") + answer_.text;
        case State::Failed: return QStringLiteral("! ") + (answer_.text.isEmpty() ? stateWords() : answer_.text);
        case State::Outdated: return QStringLiteral("↻ ") + answer_.text;
        case State::Answered: break;
    }
    const QString sign = signOf(answer_.verdict);
    return sign.isEmpty() ? words : sign + " " + words;
}

void QuestionBox::describe()
{
    QStringList lines{text()};
    if (!stateWords().isEmpty()) lines << stateWords();
    if (!answer_.tooltip.isEmpty()) lines << answer_.tooltip;
    if (answer_.assumed) lines << tr("≈ rests on assumed values");
    setToolTip(lines.join('\n'));
    const QString said = answer_.state == State::Answered ? answerText() : stateWords();
    setAccessibleName(text() + ": " + said);
}

int QuestionBox::neededWidth() const
{
    QFont bold = font();
    bold.setBold(true);
    return 2 * side_px + iconSize() + gap_px + QFontMetrics(bold).horizontalAdvance(text()) + 2;
}

int QuestionBox::compactWidth() const
{
    return 2 * side_px + iconSize() + 2;
}

QSize QuestionBox::sizeHint() const
{
    return {neededWidth(), 2 * fontMetrics().height() + above_px + below_px};
}

QSize QuestionBox::minimumSizeHint() const
{
    return {compactWidth(), sizeHint().height()};
}

/// The same pairs of light and dark as the plates of the answer strip, made lighter on a dark ground.
QColor QuestionBox::answerColour() const
{
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    QColor faint = palette().color(QPalette::PlaceholderText);
    if (answer_.state == State::Failed) return dark ? QColor(0xff, 0x80, 0x60) : QColor(0xa3, 0x20, 0x20);
    if (answer_.state != State::Answered) return faint;
    if (!answer_.verdict) return palette().color(QPalette::WindowText);
    switch (*answer_.verdict) {
        case Verdict::Pass: return dark ? QColor(0x56, 0xb4, 0x8c) : QColor(0x1d, 0x6f, 0x42);
        case Verdict::Fail: return dark ? QColor(0xff, 0x80, 0x60) : QColor(0xa3, 0x20, 0x20);
        case Verdict::Undecided: return dark ? QColor(0xf0, 0xb4, 0x40) : QColor(0x8a, 0x5a, 0x00);
    }
    return faint;
}

/// The open question is a sheet with a line under it, an unanswered one is hollow.
void QuestionBox::paintFrame(QPainter& painter) const
{
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QColor fill = palette().color(isChecked() ? QPalette::Base : QPalette::Button);
    if (answer_.state == State::Empty && !isChecked()) fill = Qt::transparent;
    if ((underMouse() || isDown()) && !isChecked()) fill = palette().color(QPalette::Base);
    QColor line = palette().color(QPalette::Mid);
    if (isChecked()) line = palette().color(QPalette::Highlight);
    painter.setPen(QPen(line, 1, answer_.state == State::Empty && !isChecked() ? Qt::DotLine : Qt::SolidLine));
    painter.setBrush(fill);
    painter.drawRoundedRect(box, radius_px, radius_px);
    if (isChecked())
        painter.fillRect(QRectF(box.left() + 2, box.bottom() - 3, box.width() - 4, 3),
                         palette().color(QPalette::Highlight));
    if (!hasFocus()) return;
    painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), radius_px - 1, radius_px - 1);
}

void QuestionBox::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFrame(painter);
    const int line = fontMetrics().height();
    const QRect inner = rect().adjusted(side_px, above_px, -side_px, -below_px);
    const int icon_px = iconSize();
    const QRect picture(compact_ ? (width() - icon_px) / 2 : inner.left(), inner.top(), icon_px, icon_px);
    icon().paint(&painter, picture, Qt::AlignCenter, isEnabled() ? QIcon::Normal : QIcon::Disabled);
    if (!compact_) {
        QFont name = font();
        name.setBold(isChecked());
        painter.setFont(name);
        painter.setPen(palette().color(QPalette::WindowText));
        const QRect where(picture.right() + 1 + gap_px, inner.top(), inner.right() - picture.right() - gap_px, line);
        painter.drawText(where, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetrics(name).elidedText(text(), Qt::ElideRight, where.width()));
    }
    painter.setFont(font());
    painter.setPen(answerColour());
    const QRect under(inner.left(), inner.top() + line, inner.width(), line);
    const Qt::Alignment side = compact_ ? Qt::AlignHCenter : Qt::AlignLeft;
    const QString words = compact_ ? answerText().left(1) : answerText();
    painter.drawText(under, static_cast<int>(side | Qt::AlignVCenter),
                     fontMetrics().elidedText(words, Qt::ElideRight, under.width()));
}

void QuestionBox::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
        case Qt::Key_Right:
        case Qt::Key_Down: emit stepRequested(1); return;
        case Qt::Key_Left:
        case Qt::Key_Up: emit stepRequested(-1); return;
        case Qt::Key_Return:
        case Qt::Key_Enter: click(); return;
        default: QAbstractButton::keyPressEvent(event);
    }
}

void QuestionBox::contextMenuEvent(QContextMenuEvent* event)
{
    emit menuRequested(event->globalPos());
    event->accept();
}

void QuestionBox::enterEvent(QEvent* event)
{
    QAbstractButton::enterEvent(event);
    update();
}

void QuestionBox::leaveEvent(QEvent* event)
{
    QAbstractButton::leaveEvent(event);
    update();
}

}  // namespace lathelier
