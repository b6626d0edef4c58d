#include "widgets/core/panel/message_line.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QStyle>

#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
WrappingLabel::WrappingLabel(const char* name)
{
    setObjectName(name);
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
}

void WrappingLabel::say(const QString& text)
{
    setText(text);
    keepLines();
}

void WrappingLabel::keepLines()
{
    setMinimumHeight(0);  // heightForWidth() would not return less than the minimum
    // Before it is shown its width is undefined: a panel behind a tab would enlarge the window.
    if (isVisible() && !text().isEmpty()) setMinimumHeight(heightForWidth(width()));
}

void WrappingLabel::showEvent(QShowEvent* event)
{
    QLabel::showEvent(event);
    keepLines();
}

void WrappingLabel::resizeEvent(QResizeEvent* event)
{
    QLabel::resizeEvent(event);
    keepLines();
}

void WrappingLabel::changeEvent(QEvent* event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange) keepLines();
}

MessageLine::MessageLine(QWidget* parent) : QFrame(parent), symbol_(new QLabel), text_(new WrappingLabel("message"))
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(symbol_, 0, Qt::AlignTop);
    layout->addWidget(text_, 1);
    hide();
}

void MessageLine::setError(const Error& error)
{
    show("error", screenText(error));
}
void MessageLine::setHint(const QString& text)
{
    show("info", text);
}

void MessageLine::clear()
{
    text_->clear();
    hide();
}

void MessageLine::show(const QString& name, const QString& text)
{
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, this);
    symbol_->setPixmap(icon(name).pixmap(size, size));
    text_->say(text);
    setAccessibleName(text);
    setVisible(true);
}

}  // namespace lathelier
