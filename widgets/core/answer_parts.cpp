#include "widgets/core/answer_parts.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QStyle>

#include "engine/report/abbreviations.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

QFont scaled(const QFont& font, double factor)
{
    QFont result = font;
    result.setPointSizeF(font.pointSizeF() * factor);
    return result;
}

}  // namespace

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
    setMinimumHeight(0);  // heightForWidth() never answers less than the minimum
    // Before it is seen its width is only a guess: a panel behind a tab would make the window grow.
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

HeadlineLabel::HeadlineLabel(QWidget* parent)
    : QWidget(parent), text_(new WrappingLabel("headline")), verdict_(new QLabel)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(14);
    layout->addWidget(text_, 1);
    layout->addWidget(verdict_, 0, Qt::AlignVCenter);
    verdict_->setObjectName("verdict");
    applyFonts();
    clear();
}

void HeadlineLabel::setHeadline(const Headline& headline)
{
    text_->say(QString::fromStdString(headline.text));
    text_->setToolTip(QString::fromStdString(expansion(headline.text, screenLanguage())));
    verdict_->setVisible(headline.verdict.has_value());
    verdict_->clear();
    if (headline.verdict) {
        const bool pass = *headline.verdict;
        verdict_->setText(pass ? tr("✓ within tolerance") : tr("✗ out of tolerance"));
        // Told apart by symbol and word; dark enough for white text in light and dark themes alike.
        verdict_->setStyleSheet(
            QString("QLabel { background: %1; color: white; border-radius: 6px; padding: 4px 12px; }")
                .arg(pass ? "#1d6f42" : "#a32020"));
    }
    setAccessibleName(text());
}

void HeadlineLabel::clear()
{
    text_->say({});
    text_->setToolTip({});
    verdict_->clear();
    verdict_->hide();
}

QString HeadlineLabel::text() const
{
    return verdict_->text().isEmpty() ? text_->text() : text_->text() + " " + verdict_->text();
}

void HeadlineLabel::applyFonts()
{
    QFont large = scaled(font(), 1.65);
    large.setWeight(QFont::DemiBold);
    text_->setFont(large);
    verdict_->setFont(scaled(font(), 1.25));
}

void HeadlineLabel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange) applyFonts();
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
