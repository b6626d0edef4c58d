// The window's actions, menus and bars, and their words.
#include <QActionGroup>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLayout>
#include <QLocale>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoCommand>

#include "app/gui/help_window.h"
#include "app/gui/main_window.h"
#include "app/gui/verify_dialog.h"
#include "widgets/core/icons.h"

namespace lathelier {
namespace {

constexpr int toolGap_px = 6;  // between the tools in the row of the menus
constexpr int barGap_px = 1;   // over and under the questions

}  // namespace

QAction* MainWindow::action(const QString& name) const
{
    const auto found = actions_.find(name);
    return found == actions_.end() ? nullptr : found->second;
}

QAction* MainWindow::makeAction(const char* name, const char* picture, const QList<QKeySequence>& keys,
                                std::function<void()> run)
{
    auto* result = new QAction(this);
    result->setObjectName(name);
    if (*picture) result->setIcon(icon(picture));
    result->setShortcuts(keys);
    connect(result, &QAction::triggered, this, [run = std::move(run)] { run(); });
    addAction(result);  // keys work when the menu bar is hidden
    actions_[name] = result;
    return result;
}

void MainWindow::makeActions()
{
    makeAction("new", "new", {QKeySequence::New}, [this] { files_.startNew(); });
    makeAction("open", "open", {QKeySequence::Open}, [this] { askForFiles(); });
    makeAction("sample", "sample", {}, [this] { files_.openSample(); });
    makeAction("save", "save", {QKeySequence::Save}, [this] { files_.save(); });
    makeAction("saveAs", "", {QKeySequence("Ctrl+Shift+S")}, [this] { files_.saveAs(); });
    makeAction("saveRecipe", "", {}, [this] {
        project::PartInputs parts;
        for (const PanelDock* dock : docks_) {
            std::vector<std::string>& roles = parts[dock->facts().stateKey()];
            const std::vector<std::string>& own = dock->facts().part_inputs;
            roles.insert(roles.end(), own.begin(), own.end());
        }
        files_.saveRecipe(parts);
    });
    makeAction("nextPart", "open", {QKeySequence("Ctrl+Shift+O")}, [this] {
        if (activeDock()) activeDock()->panel().askForFiles();
    });
    makeAction("shop", "settings", {}, [this] { askForShop(); });
    makeAction("titleBlock", "", {}, [this] { askForTitleBlock(); });
    makeAction("reportHtml", "report", {}, [this] { writeProjectReport("html"); });
    makeAction("reportPdf", "report", {QKeySequence("Ctrl+P")}, [this] { writeProjectReport("pdf"); });
    makeAction("quit", "", {QKeySequence("Ctrl+Q")}, [this] { close(); });

    QUndoStack& undo = session_.undoStack();
    makeAction("undo", "undo", {QKeySequence("Ctrl+Z")}, [&undo] { undo.undo(); });
    makeAction("redo", "redo", {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")}, [&undo] { undo.redo(); });
    for (const auto& signal : {&QUndoStack::undoTextChanged, &QUndoStack::redoTextChanged})
        connect(&undo, signal, this, &MainWindow::updateUndo);
    for (const auto& signal : {&QUndoStack::canUndoChanged, &QUndoStack::canRedoChanged})
        connect(&undo, signal, this, &MainWindow::updateUndo);
    makeAction("settings", "settings", {}, [this] { askForSettings(); });

    makeAction("compute", "", {QKeySequence("F5")}, [this] {
        if (activeDock()) activeDock()->panel().recompute();
    });
    makeAction("cancel", "stop", {QKeySequence("Esc")}, [this] {
        if (presenting_ && !(activeDock() && activeDock()->panel().isBusy())) return setPresenting(false);
        if (activeDock()) activeDock()->panel().cancel();
    });
    makeAction("nextPanel", "", {QKeySequence("Ctrl+Tab"), QKeySequence("Ctrl+PgDown")}, [this] { stepPanel(1); });
    makeAction("previousPanel", "", {QKeySequence("Ctrl+Shift+Tab"), QKeySequence("Ctrl+PgUp")},
               [this] { stepPanel(-1); });
    makeAction("floatPanel", "", {}, [this] {
        if (activeDock()) setFloating(activeDock(), !activeDock()->isFloating());
    });
    makeAction("closePanel", "", {QKeySequence("Ctrl+W")}, [this] {
        if (activeDock()) activeDock()->close();
    });
    makeAction("resetLayout", "layout", {}, [this] { layouts_->reset(activeDock()); });
    QAction* presenter =
        makeAction("presenter", "presenter", {QKeySequence("F9")}, [this] { setPresenting(!presenting_); });
    presenter->setCheckable(true);
    makeAction("fullScreen", "", {QKeySequence("F11")},
               [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });

    makeAction("help", "help", {QKeySequence("F1")}, [this] { showHelp(); });
    makeAction("palette", "palette", {QKeySequence("Ctrl+Shift+P")}, [this] { showPalette(); });
    makeAction("verify", "", {}, [this] {
        auto* dialog = new VerifyDialog(this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    makeAction("about", "", {}, [this] { showAbout(this); });
}

void MainWindow::makeMenus()
{
    const auto add = [this](const char* name, const QStringList& entries) {
        QMenu* menu = menuBar()->addMenu(QString());
        menus_[name] = menu;
        for (const QString& entry : entries) {
            if (entry.isEmpty())
                menu->addSeparator();
            else if (QAction* known = action(entry))
                menu->addAction(known);
            else
                menus_[entry] = menu->addMenu(QString());
        }
    };
    add("file", {"new", "open", "nextPart", "recent", "sample", "", "save", "saveAs", "saveRecipe", "", "shop",
                 "titleBlock", "reportHtml", "reportPdf", "", "quit"});
    add("edit", {"undo", "redo", "", "settings"});
    add("view", {"questions", "panels", ""});
    for (PanelDock* dock : docks_) menus_["panels"]->addAction(&dock->showAction());
    for (const char* name : {"nextPanel", "previousPanel", "floatPanel", "closePanel"})
        menus_["view"]->addAction(action(name));
    menus_["view"]->addAction(logDock_->toggleViewAction());
    menus_["view"]->addAction(dataDock_->toggleViewAction());
    logDock_->toggleViewAction()->setIcon(icon("log"));
    dataDock_->toggleViewAction()->setIcon(icon("data"));
    dataDock_->toggleViewAction()->setShortcut(QKeySequence("Ctrl+D"));
    menus_["view"]->addSeparator();
    for (const char* name : {"compute", "cancel"}) menus_["view"]->addAction(action(name));
    menus_["view"]->addSeparator();
    for (const char* name : {"resetLayout", "presenter", "fullScreen"}) menus_["view"]->addAction(action(name));
    add("help_menu", {"help", "palette", "", "verify", "about"});
    fillRecent();
}

void MainWindow::makeQuestionBar()
{
    bar_ = addToolBar(QString());
    bar_->setObjectName("questionBar");
    bar_->setMovable(false);
    bar_->setContentsMargins(0, 0, 0, 0);
    bar_->layout()->setContentsMargins(0, barGap_px, 0, barGap_px);
    bar_->toggleViewAction()->setVisible(false);
    questionBar_ = new QuestionBar(questions_);
    bar_->addWidget(questionBar_);
    connect(questionBar_, &QuestionBar::questionRequested, this, &MainWindow::enterQuestion);
    connect(questionBar_, &QuestionBar::menuRequested, this, &MainWindow::showQuestionMenu);
    auto* group = new QActionGroup(this);
    for (const Question& question : questions_) {
        auto* enter = new QAction(icon(question.icon), QString(), this);
        enter->setObjectName(QString::fromStdString("question_" + question.id));
        enter->setCheckable(true);
        group->addAction(enter);
        addAction(enter);  // keys work when the menu bar is hidden
        connect(enter, &QAction::triggered, this, [this, id = question.id] { enterQuestion(id); });
        questionActions_[question.id] = enter;
        if (const auto number = questionActions_.size(); number <= 9)
            enter->setShortcut(QKeySequence(QString("Ctrl+%1").arg(number)));
        menus_["questions"]->addAction(enter);
    }
}

/// At the end of the row of the menus, where they take no height.
void MainWindow::makeTools()
{
    auto* tools = new QWidget;
    tools->setObjectName("tools");
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, toolGap_px, 0);
    row->setSpacing(toolGap_px);
    const int side = fontMetrics().height();
    for (const char* name : {"open", "save", "undo", "redo", "presenter", "palette", "help"}) {
        auto* button = new QToolButton;
        button->setObjectName(QString("tool_") + name);
        button->setDefaultAction(action(name));
        button->setAutoRaise(true);
        button->setIconSize(QSize(side, side));
        row->addWidget(button);
    }
    menuBar()->setNativeMenuBar(false);  // one of the desktop shows no tools
    menuBar()->setCornerWidget(tools, Qt::TopRightCorner);
}

void MainWindow::fillRecent()
{
    QMenu* menu = menus_["recent"];
    menu->clear();
    for (const QString& path : recentFiles()) {
        QString name = screenFileName(path);
        name.replace("&", "&&");  // escapes the mnemonic mark
        QAction* entry = menu->addAction(name, this, [this, path] { files_.open(path); });
        entry->setToolTip(path);
        entry->setStatusTip(path);
    }
    menu->setEnabled(!menu->isEmpty());
}

void MainWindow::updateUndo()
{
    const QUndoStack& undo = session_.undoStack();
    action("undo")->setEnabled(undo.canUndo());
    action("redo")->setEnabled(undo.canRedo());
    // A step named in another language is shown without its name.
    const auto named = [&](int step) {
        const QUndoCommand* command = undo.command(step);
        return command && command->text() == QLocale().name();
    };
    const bool undoNamed = undo.canUndo() && named(undo.index() - 1);
    const bool redoNamed = undo.canRedo() && named(undo.index());
    action("undo")->setText(undoNamed ? tr("&Undo: %1").arg(undo.undoText()) : tr("&Undo"));
    action("redo")->setText(redoNamed ? tr("&Redo: %1").arg(undo.redoText()) : tr("&Redo"));
}

void MainWindow::retranslate()
{
    const auto word = [this](const char* name, const QString& text) { action(name)->setText(text); };
    word("new", tr("&New project"));
    word("open", tr("&Open…"));
    word("sample", tr("Open the sa&mple"));
    word("save", tr("&Save"));
    word("saveAs", tr("Save &as…"));
    word("saveRecipe", tr("Save as &recipe…"));
    word("nextPart", tr("Ne&xt part…"));
    word("shop", tr("S&hop…"));
    word("titleBlock", tr("&Title block of the reports…"));
    word("reportHtml", tr("Project report as &HTML…"));
    word("reportPdf", tr("Project report as &PDF…"));
    word("quit", tr("&Quit"));
    word("settings", tr("&Settings…"));
    word("nextPanel", tr("&Next panel"));
    word("previousPanel", tr("Pre&vious panel"));
    word("floatPanel", tr("F&loat or dock the panel"));
    word("closePanel", tr("&Close the panel"));
    word("compute", tr("C&ompute again"));
    word("cancel", tr("&Stop the computation"));
    word("resetLayout", tr("&Reset layout"));
    word("presenter", tr("&Presenter mode"));
    word("fullScreen", tr("&Full screen"));
    word("help", tr("&Help"));
    word("palette", tr("All &commands…"));
    word("verify", tr("&Verify installation"));
    word("about", tr("&About Lathelier"));
    updateUndo();
    menus_["file"]->setTitle(tr("&File"));
    menus_["recent"]->setTitle(tr("Open &recent"));
    menus_["edit"]->setTitle(tr("&Edit"));
    menus_["view"]->setTitle(tr("&View"));
    menus_["questions"]->setTitle(tr("&Questions"));
    menus_["panels"]->setTitle(tr("P&anels"));
    menus_["help_menu"]->setTitle(tr("&Help"));
    for (const Question& question : questions_) {
        questionActions_[question.id]->setText(screenText(question.title));
        answerQuestion(question.id);
    }
    bar_->setWindowTitle(tr("Questions"));
    showEmptyPlace();
    logDock_->setWindowTitle(tr("Messages"));
    dataDock_->setWindowTitle(tr("Data"));
    openSaved_->setText(tr("Open"));
    openSaved_->setToolTip(tr("Opens the report that was saved last"));
    clearStatus();
    updateTitle();
}

}  // namespace lathelier
