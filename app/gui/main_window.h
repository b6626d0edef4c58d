// The window: panels in docks under the questions of the bar, menus.
#pragma once

#include <QMainWindow>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/command_palette.h"
#include "app/gui/layouts.h"
#include "app/gui/project_files.h"
#include "app/gui/questions.h"
#include "app/gui/settings.h"
#include "widgets/core/files/kind_finder.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/message_log.h"
#include "widgets/core/shell/empty_place.h"
#include "widgets/core/shell/question_bar.h"
#include "widgets/core/walk/part_answers.h"

class QLabel;
class QToolButton;

namespace lathelier {

class HelpWindow;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// `recoveryFolder` empty: no autosave and no recovery (screenshots, tests).
    MainWindow(Session& session, Languages& languages, const std::vector<PanelFacts>& panels,
               const QString& recoveryFolder = {});
    ~MainWindow() override;

    /// A project is opened at once; other files go to the panel that takes all of them (file_taker.h), as soon as their
    /// heads were looked at in the background.
    void openPaths(const QStringList& paths);
    bool isOpening() const { return finder_.isBusy(); }  ///< files are still being looked at

    void enterQuestion(const std::string& id);
    const std::string& question() const { return layouts_->question(); }  ///< that is open
    QuestionBar& questionBar() const { return *questionBar_; }
    PanelDock* activeDock() const;
    const std::vector<PanelDock*>& docks() const { return docks_; }
    ProjectFiles& files() { return files_; }
    MessageLog& messages() { return *log_; }
    QAction* action(const QString& name) const;  ///< by object name: "undo"
    void setPresenting(bool presenting);
    void stepPanel(int by);  ///< to the next panel of the question, or an earlier one, round about
    void setFloating(PanelDock* dock, bool floating);  ///< in a window of its own, or back under its question
    QMenu* panelMenu(PanelDock* dock);                 ///< float or dock it, close it; the caller owns it
    void applySettings(const Settings& settings);

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void useTheme();
    void showDock(PanelDock* dock);
    void makeDocks(const std::vector<PanelFacts>& panels);
    void makeActions();
    void makeMenus();
    void makeQuestionBar();
    void makeTools();
    void showQuestionMenu(const std::string& id, const QPoint& global);
    void answerQuestion(const std::string& id);
    void useShop();
    void askForShop();
    void followTab(PanelDock* dock);
    void followFront(PanelDock* dock);
    void showEmptyPlace();
    void clearStatus();
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
    QList<CommandPalette::Command> panelCommands(PanelDock* dock);
    void showHelp(const QString& words = {});  ///< `words`: what the manual is searched for
    void writeReport(const std::vector<PanelDock*>& docks, const QString& suffix);
    void writeProjectReport(const QString& suffix);

    Session& session_;
    Languages& languages_;
    Settings settings_;
    ProjectFiles files_;
    std::optional<Values> usedShop_;        ///< Project::shop that the supply was made of
    std::unique_ptr<PartAnswers> answers_;  ///< of the questions, from the background
    std::vector<Question> questions_;
    KindFinder finder_;  ///< of all files that any panel works on
    std::vector<PanelDock*> docks_;
    MessageLog* log_;
    QDockWidget* logDock_;
    QDockWidget* dataDock_;
    std::unique_ptr<Layouts> layouts_;
    std::map<std::string, PanelDock*> lastActive_;  ///< by question
    std::map<QString, QAction*> actions_;
    std::map<std::string, QAction*> questionActions_;
    std::map<QString, QMenu*> menus_;
    QToolBar* bar_ = nullptr;  ///< of the questions
    QuestionBar* questionBar_ = nullptr;
    EmptyPlace* emptyPlace_ = nullptr;
    QLabel* status_ = nullptr;
    QToolButton* openSaved_ = nullptr;  ///< beside a message that a report was saved
    HelpWindow* help_ = nullptr;
    bool presenting_ = false;
    bool wasFullScreen_ = false;
    QByteArray stateBeforePresenting_;
    QSize sizeBeforePresenting_;
    QFont ordinaryFont_;
};

}  // namespace lathelier
