// Everything as a command, and the manual.
#include <QMenuBar>
#include <QTimer>
#include <algorithm>

#include "app/gui/help_window.h"
#include "app/gui/main_window.h"
#include "engine/task/task.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

const QString between = QStringLiteral(" › ");

}

/// Those of a panel that was made, or its fields by the description of its task; each shows the panel first.
QList<CommandPalette::Command> MainWindow::panelCommands(PanelDock* dock)
{
    QList<CommandPalette::Command> commands;
    const QString title = dock->windowTitle();
    const QIcon picture = icon(dock->facts().icon);
    if (PanelBase* const made = dock->madePanel()) {
        for (const PanelCommand& command : made->commands())
            commands.append({title + between + command.path,
                             [this, dock, run = command.run] {
                                 showPanel(dock);
                                 run();
                             },
                             picture});
        return commands;
    }
    if (!dock->facts().task) return commands;
    for (const FieldInfo& field : dock->facts().task->fields) {
        if (field.is_kept) continue;
        const QString path = PanelBase::tr("Input") + between + screenText(field.label);
        commands.append({title + between + path,
                         [this, dock, path] {
                             showPanel(dock);
                             for (const PanelCommand& command : dock->panel().commands())
                                 if (command.path == path) return command.run();
                         },
                         picture});
    }
    return commands;
}

/// The panel in front first.
void MainWindow::showPalette()
{
    QList<CommandPalette::Command> commands = commandsOf(menuBar()->actions());
    std::vector<PanelDock*> docks = docks_;
    std::stable_partition(docks.begin(), docks.end(), [this](const PanelDock* dock) { return dock == activeDock(); });
    for (PanelDock* dock : docks) commands += panelCommands(dock);
    auto* palette = new CommandPalette(
        commands, [this](const QString& words) { showHelp(words); }, this);
    palette->setAttribute(Qt::WA_DeleteOnClose);
    palette->open();
}

void MainWindow::showHelp(const QString& words)
{
    if (!help_) help_ = new HelpWindow(this);
    const PanelDock* dock = activeDock();
    if (!words.isEmpty())
        help_->searchFor(words);
    else
        help_->showPage(dock && dock->isVisible() ? QString::fromStdString(dock->facts().id) : Manual::indexName);
    help_->show();
    help_->raise();
    help_->activateWindow();
}

}  // namespace lathelier
