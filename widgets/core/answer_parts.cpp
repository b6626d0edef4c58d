#include "widgets/core/answer_parts.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

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

/// As high as its lines: a layout in need of room must not cut them.
void keepLines(QLabel* label)
{
    label->setMinimumHeight(label->text().isEmpty() ? 0 : label->heightForWidth(label->width()));
}

class WrappingLabel : public QLabel {
protected:
    void resizeEvent(QResizeEvent* event) override
    {
        QLabel::resizeEvent(event);
        keepLines(this);
    }
};

void say(QLabel* label, const QString& text)
{
    label->setText(text);
    keepLines(label);
}

QLabel* wrappingLabel(const char* name)
{
    auto* label = new WrappingLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

/// Files by their names: the folders stand in the tooltips of the inputs and in the report.
QString shortText(Note note)
{
    if (const Value* path = find(note.values, "path"))
        if (const auto* whole = std::get_if<std::string>(path))
            set(note.values, "path", QFileInfo(QString::fromStdString(*whole)).fileName().toStdString());
    return screenText(note);
}

}  // namespace

HeadlineLabel::HeadlineLabel(QWidget* parent) : QWidget(parent), text_(wrappingLabel("headline")), verdict_(new QLabel)
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
    say(text_, QString::fromStdString(headline.text));
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
    say(text_, {});
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
    keepLines(text_);
    verdict_->setFont(scaled(font(), 1.25));
}

void HeadlineLabel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange) applyFonts();
}

NotesLabel::NotesLabel(QWidget* parent) : QWidget(parent), text_(wrappingLabel("notes")), fold_(new QToolButton)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(text_, 1);
    layout->addWidget(fold_, 0, Qt::AlignTop);
    fold_->setObjectName("moreNotes");
    fold_->setCheckable(true);
    fold_->setAutoRaise(true);
    connect(fold_, &QToolButton::toggled, this, &NotesLabel::refresh);
    refresh();
}

void NotesLabel::setNotes(const Notes& notes)
{
    notes_ = notes;
    std::stable_partition(notes_.begin(), notes_.end(),
                          [](const Note& note) { return severity(note.code) == Severity::Warning; });
    refresh();
}

void NotesLabel::setPresenting(bool presenting)
{
    presenting_ = presenting;
    refresh();
}

void NotesLabel::refresh()
{
    const std::size_t alwaysSeen = presenting_ ? 1 : 2;
    const bool foldable = notes_.size() > alwaysSeen;
    const std::size_t seen = foldable && !fold_->isChecked() ? alwaysSeen : notes_.size();
    QStringList lines;
    for (std::size_t i = 0; i < seen; ++i) {
        const bool warning = severity(notes_[i].code) == Severity::Warning;
        lines << (warning ? QStringLiteral("⚠ ") : QStringLiteral("· ")) + shortText(notes_[i]);
    }
    say(text_, lines.join('\n'));
    fold_->setVisible(foldable);
    fold_->setText(fold_->isChecked() ? tr("Fewer notes") : tr("%1 more").arg(notes_.size() - alwaysSeen));
    setVisible(!notes_.empty());
}

void NotesLabel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) refresh();
}

MessageLine::MessageLine(QWidget* parent) : QFrame(parent), symbol_(new QLabel), text_(wrappingLabel("message"))
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
    say(text_, text);
    setAccessibleName(text);
    setVisible(true);
}

}  // namespace lathelier
