// All commands of the window in one list, found by typing.
#pragma once

#include <QAction>
#include <QDialog>
#include <QList>

class QLineEdit;
class QListWidget;

namespace lathelier {

/// Words typed in any order narrow the list; Enter runs the chosen command after the palette has closed.
class CommandPalette : public QDialog {
    Q_OBJECT
public:
    struct Command {
        QString path;  ///< "File › Save"
        QAction* action;
    };

    explicit CommandPalette(const QList<Command>& commands, QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void narrow(const QString& typed);
    void run();

    QList<Command> commands_;
    QLineEdit* search_;
    QListWidget* list_;
};

/// The commands under a menu bar or menu, with their paths.
QList<CommandPalette::Command> commandsOf(const QList<QAction*>& actions, const QString& path = {});

}  // namespace lathelier
