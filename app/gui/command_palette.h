// All commands of the window in one list, found by typing.
#pragma once

#include <QAction>
#include <QDialog>
#include <QIcon>
#include <QList>
#include <functional>

class QLineEdit;
class QListWidget;

namespace lathelier {

/// Words typed in any order narrow the list; Enter runs the chosen command after the palette has closed.
class CommandPalette : public QDialog {
    Q_OBJECT
public:
    struct Command {
        QString path;               ///< "File › Save"
        std::function<void()> run;  ///< no effect after its target is destroyed
        QIcon icon = {};
        QString keys = {};    ///< displayed shortcut
        bool enabled = true;  ///< false: not offered now
    };

    /// `nothingFound`: run with the words typed where no command has them.
    CommandPalette(const QList<Command>& commands, std::function<void(const QString& words)> nothingFound,
                   QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void narrow(const QString& typed);
    void run();

    QList<Command> commands_;
    std::function<void(const QString&)> nothingFound_;
    QLineEdit* search_;
    QListWidget* list_;
};

/// The commands under a menu bar or menu, with their paths.
QList<CommandPalette::Command> commandsOf(const QList<QAction*>& actions, const QString& path = {});

}  // namespace lathelier
