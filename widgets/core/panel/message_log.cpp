#include "widgets/core/panel/message_log.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QShortcut>
#include <QToolButton>

#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

QToolButton* logButton(const char* picture)
{
    auto* result = new QToolButton;
    result->setIcon(icon(picture));
    result->setAutoRaise(true);
    result->setFocusPolicy(Qt::StrongFocus);
    return result;
}

}  // namespace

MessageLog::MessageLog(QWidget* parent)
    : QWidget(parent), list_(new QTreeWidget), copy_(logButton("copy")), clear_(logButton("remove"))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(list_, 1);
    auto* buttons = new QVBoxLayout;
    buttons->addWidget(copy_);
    buttons->addWidget(clear_);
    buttons->addStretch();
    layout->addLayout(buttons);

    list_->setObjectName("messages");
    list_->setColumnCount(3);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(false);
    list_->setWordWrap(true);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    auto* copyKey = new QShortcut(QKeySequence::Copy, list_);
    copyKey->setContext(Qt::WidgetShortcut);
    connect(copyKey, &QShortcut::activated, this, &MessageLog::copy);
    connect(copy_, &QToolButton::clicked, this, &MessageLog::copy);
    connect(clear_, &QToolButton::clicked, this, [this] {
        messages_.clear();
        list_->clear();
    });
    retranslate();
}

void MessageLog::add(const Message& message)
{
    for (auto last = messages_.rbegin(); last != messages_.rend() && last->source == message.source; ++last)
        if (screenText(*last) == screenText(message)) return;
    messages_.push_back(message);
    auto* item = new QTreeWidgetItem(list_);
    show(item, message);
    list_->scrollToItem(item);
}

void MessageLog::show(QTreeWidgetItem* item, const Message& message) const
{
    static const char* const icons[] = {"info", "warning", "error"};
    const auto kind = static_cast<std::size_t>(kindOf(message));
    const QString words[] = {tr("Note"), tr("Warning"), tr("Error")};
    item->setIcon(0, icon(icons[kind]));
    item->setText(0, QLocale().toString(message.time.time(), QLocale::LongFormat).section(' ', 0, 0));
    item->setToolTip(0, words[kind]);
    item->setText(1, screenText(message.source));
    item->setText(2, screenText(message));
    item->setToolTip(2, screenText(message));
    item->setData(0, Qt::AccessibleTextRole, words[kind]);
}

QString MessageLog::plainText() const
{
    QStringList lines;
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* item = list_->topLevelItem(i);
        if (list_->selectedItems().isEmpty() || item->isSelected())
            lines << QStringList{item->text(0), item->toolTip(0), item->text(1), item->text(2)}.join('\t');
    }
    return lines.join('\n');
}

void MessageLog::copy() const
{
    QGuiApplication::clipboard()->setText(plainText());
}

void MessageLog::retranslate()
{
    list_->setHeaderLabels({tr("Time"), tr("Panel"), tr("Message")});
    list_->setAccessibleName(tr("Message log"));
    copy_->setToolTip(tr("Copy the selected messages, or all"));
    copy_->setAccessibleName(copy_->toolTip());
    clear_->setToolTip(tr("Clear the log"));
    clear_->setAccessibleName(clear_->toolTip());
    for (int i = 0; i < list_->topLevelItemCount(); ++i)
        show(list_->topLevelItem(i), messages_[static_cast<std::size_t>(i)]);
}

void MessageLog::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier
