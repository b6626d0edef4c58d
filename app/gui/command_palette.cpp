#include "app/gui/command_palette.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPointer>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/core/icons.h"

namespace lathelier {
namespace {

QString withoutMnemonic(QString text)
{
    return text.remove('&');
}

bool matches(const QString& path, const QStringList& words)
{
    return std::all_of(words.begin(), words.end(),
                       [&](const QString& word) { return path.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

CommandPalette::CommandPalette(const QList<Command>& commands, std::function<void(const QString&)> nothingFound,
                               QWidget* parent)
    : QDialog(parent),
      commands_(commands),
      nothingFound_(std::move(nothingFound)),
      search_(new QLineEdit),
      list_(new QListWidget)
{
    setWindowTitle(tr("Commands"));
    setObjectName("commandPalette");
    search_->setPlaceholderText(tr("Type what you want to do"));
    search_->setAccessibleName(search_->placeholderText());
    search_->installEventFilter(this);
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setAccessibleName(windowTitle());
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search_);
    layout->addWidget(list_);
    const int character = fontMetrics().averageCharWidth();
    resize(character * 70, fontMetrics().height() * 22);
    connect(search_, &QLineEdit::textChanged, this, &CommandPalette::narrow);
    connect(search_, &QLineEdit::returnPressed, this, &CommandPalette::run);
    connect(list_, &QListWidget::itemActivated, this, &CommandPalette::run);
    connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
    narrow({});
}

void CommandPalette::narrow(const QString& typed)
{
    const QStringList words = typed.split(' ', Qt::SkipEmptyParts);
    list_->clear();
    for (int i = 0; i < commands_.size(); ++i) {
        const Command& command = commands_[i];
        if (!command.enabled || !matches(command.path, words)) continue;
        auto* item = new QListWidgetItem(
            command.icon, command.keys.isEmpty() ? command.path : command.path + "   " + command.keys, list_);
        item->setData(Qt::UserRole, i);
    }
    if (list_->count() == 0) list_->addItem(new QListWidgetItem(icon("help"), tr("Nothing found: open the manual")));
    list_->setCurrentRow(0);
}

void CommandPalette::run()
{
    const QListWidgetItem* item = list_->currentItem();
    accept();
    if (!item) return;
    const QVariant command = item->data(Qt::UserRole);
    if (command.isValid())
        QTimer::singleShot(0, parentWidget(), commands_[command.toInt()].run);
    else
        QTimer::singleShot(0, parentWidget(), [run = nothingFound_, words = search_->text()] { run(words); });
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (step && list_->count()) {
            list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

QList<CommandPalette::Command> commandsOf(const QList<QAction*>& actions, const QString& path)
{
    QList<CommandPalette::Command> result;
    for (QAction* action : actions) {
        if (action->isSeparator() || !action->isVisible()) continue;
        const QString text = withoutMnemonic(action->text());
        const QString here = path.isEmpty() ? text : path + QStringLiteral(" › ") + text;
        if (action->menu())
            result += commandsOf(action->menu()->actions(), here);
        else
            result.append({here,
                           [action = QPointer<QAction>(action)] {
                               if (action) action->trigger();
                           },
                           action->icon(), action->shortcut().toString(QKeySequence::NativeText), action->isEnabled()});
    }
    return result;
}

}  // namespace lathelier
