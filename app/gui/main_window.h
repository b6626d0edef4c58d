// The window: panels in docks, workspaces, menus.
#pragma once

#include <QMainWindow>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "app/gui/layouts.h"
#include "app/gui/project_files.h"
#include "app/gui/settings.h"
#include "app/gui/workspaces.h"
#include "widgets/core/files/kind_finder.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/message_log.h"
#include "widgets/core/panel/workspace_strip.h"

class QLabel;
class QToolButton;

namespace lathelier {

class HelpWindow;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// `recoveryFolder` empty: no autosave and no recovery (screenshots, tests).
    MainWindow(Session& session, Languages& languages, const std::vector<PanelFacts>& panels,
               const QString& recoveryFolder = {}, const std::vector<StripFacts>& strips = {});
    ~MainWindow() override;

    /// A project is opened at once; other files go to the panel that takes all of them (file_taker.h), as soon as their
    /// heads were looked at in the background.
    void openPaths(const QStringList& paths);
    bool isOpening() const { return finder_.isBusy(); }  ///< files are still being looked at

    void enterWorkspace(const std::string& id);
    PanelDock* activeDock() const;
    const std::vector<PanelDock*>& docks() const { return docks_; }
    ProjectFiles& files() { return files_; }
    MessageLog& messages() { return *log_; }
    QAction* action(const QString& name) const;  ///< by object name: "undo"
    void setPresenting(bool presenting);
    void stepPanel(int by);  ///< to the next panel of the workspace, or an earlier one, round about
    void applySettings(const Settings& settings);

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void useTheme();
    void showDock(PanelDock* dock);
    void makeDocks(const std::vector<PanelFacts>& panels);
    void makeActions();
    void makeMenus();
    void makeWorkspaceBar();
    void makeStrips(const std::vector<StripFacts>& strips);
    void showStrips();
    QAction* makeAction(const char* name, const char* picture, const QList<QKeySequence>& keys,
                        std::function<void()> run);
    void retranslate();
    void panelMade(PanelDock* dock, PanelBase* panel);
    void announce(const Message& message);
    void updateTitle();
    void updateUndo();
    void fillRecent();
    void askForFiles();
    void openFound(const std::vector<FoundFile>& files);
    void useItem(const std::string& name, const project::Item& item, bool synthetic);
    void showPanel(PanelDock* dock);
    void askForSettings();
    void useStartingValues();
    void askForTitleBlock();
    void showPalette();
    void showHelp();
    void writeReport(const std::vector<PanelDock*>& docks, const QString& suffix);
    void writeProjectReport(const QString& suffix);

    Session& session_;
    Languages& languages_;
    Settings settings_;
    ProjectFiles files_;
    std::vector<Workspace> workspaces_;
    KindFinder finder_;  ///< of all files that any panel works on
    std::vector<PanelDock*> docks_;
    MessageLog* log_;
    QDockWidget* logDock_;
    QDockWidget* dataDock_;
    std::unique_ptr<Layouts> layouts_;
    std::map<std::string, PanelDock*> lastActive_;  ///< by workspace
    std::map<QString, QAction*> actions_;
    std::map<std::string, QAction*> workspaceActions_;
    std::map<QString, QMenu*> menus_;
    QToolBar* bar_ = nullptr;
    std::map<std::string, QToolBar*> strips_;  ///< over the panels of a workspace, by its id
    QLabel* status_ = nullptr;
    QToolButton* openSaved_ = nullptr;  ///< beside a message that a report was saved
    HelpWindow* help_ = nullptr;
    bool presenting_ = false;
    bool wasFullScreen_ = false;
    QByteArray stateBeforePresenting_;
    QFont ordinaryFont_;
};

}  // namespace lathelier
