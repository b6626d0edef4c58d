// The window's panels under their questions: made, shown, floated, closed and brought back; what the bar says of them.
#include <QContextMenuEvent>
#include <QMenu>
#include <QTabBar>
#include <QTimer>
#include <algorithm>

#include "app/gui/main_window.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

constexpr int computingAfter_ms = 200;

}

void MainWindow::makeDocks(const std::vector<PanelFacts>& panels)
{
    emptyPlace_ = new EmptyPlace;
    setCentralWidget(emptyPlace_);
    emptyPlace_->hide();
    connect(emptyPlace_, &EmptyPlace::panelsRequested, this, [this] { action("resetLayout")->trigger(); });
    for (const PanelFacts& facts : panels) {
        auto* dock = new PanelDock(session_, facts, this);
        docks_.push_back(dock);
        connect(dock, &PanelDock::panelMade, this, [this, dock](PanelBase* panel) { panelMade(dock, panel); });
        connect(dock, &PanelDock::showRequested, this, [this, dock] { showPanel(dock); });
        connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool seen) {
            if (seen) QTimer::singleShot(0, dock, [this, dock] { followTab(dock); });
            QTimer::singleShot(0, this, &MainWindow::showEmptyPlace);
        });
        connect(dock, &QDockWidget::topLevelChanged, this,
                [this] { QTimer::singleShot(0, this, &MainWindow::showEmptyPlace); });
    }
    layouts_ = std::make_unique<Layouts>(*this, docks_, *logDock_, *dataDock_);
}

void MainWindow::panelMade(PanelDock* dock, PanelBase* panel)
{
    panel->setPresenting(presenting_);
    connect(panel, &PanelBase::messageRaised, this, &MainWindow::announce);
    connect(panel, &PanelBase::filesDropped, this, [this, dock](const QStringList& paths) {
        lastActive_[layouts_->question()] = dock;
        openPaths(paths);
    });
    connect(panel, &PanelBase::sampleRequested, this, [this] {
        const std::string here = layouts_->question();
        files_.openSample();
        enterQuestion(here);  // where it was asked for, whatever question the sample was saved in
    });
    connect(panel, &PanelBase::itemOffered, this, &MainWindow::useItem);
    connect(panel, &PanelBase::panelRequested, this, [this](const std::string& id) {
        for (PanelDock* each : docks_)
            if (each->facts().id == id) return showPanel(each);
    });
    connect(panel, &PanelBase::reportRequested, this,
            [this, dock](const QString& suffix) { writeReport({dock}, suffix); });
    const auto say = [this, id = dock->facts().question.id] { answerQuestion(id); };
    connect(panel, &PanelBase::resultShown, this, say);
    connect(panel, &PanelBase::busyChanged, this, [this, say](bool busy) {
        if (busy)
            QTimer::singleShot(computingAfter_ms, this, say);  // a quick one does not flicker
        else
            say();
    });
    say();
}

/// A dock whose tab was in front in a restored arrangement says that it is seen, though another was raised meanwhile.
void MainWindow::followTab(PanelDock* dock)
{
    if (dock->facts().question.id == layouts_->question() && !dock->visibleRegion().isEmpty()) followFront(dock);
}

/// The panel in front: the status line spoke of another one.
void MainWindow::followFront(PanelDock* dock)
{
    PanelDock*& last = lastActive_[layouts_->question()];
    if (last != dock) clearStatus();
    last = dock;
}

void MainWindow::showPanel(PanelDock* dock)
{
    const std::string& question = dock->facts().question.id;
    lastActive_[question] = dock;
    enterQuestion(question);
    showDock(dock);
}

void MainWindow::showDock(PanelDock* dock)
{
    dock->show();
    dock->raise();
    dock->panel().setFocus();
    followFront(dock);
}

void MainWindow::enterQuestion(const std::string& id)
{
    const std::string entered = questionFor(id, questions_);
    if (entered.empty()) return;
    if (layouts_->question() != entered) {
        clearStatus();
        const auto active = lastActive_.find(entered);
        layouts_->enter(entered, active == lastActive_.end() ? nullptr : active->second);
        showEmptyPlace();
    }
    for (const auto& [name, action] : questionActions_) action->setChecked(name == entered);
    questionBar_->setCurrent(entered);
    session_.setWorkspace(entered);
}

PanelDock* MainWindow::activeDock() const
{
    const std::string& question = layouts_->question();
    const auto active = lastActive_.find(question);
    if (active != lastActive_.end()) return active->second;
    // Before the window is shown: opens the files of the command line.
    const std::vector<PanelDock*> here = docksIn(docks_, question);
    return here.empty() ? nullptr : here.front();
}

/// The panels of the question in turn, those that were closed too.
void MainWindow::stepPanel(int by)
{
    const std::vector<PanelDock*> here = docksIn(docks_, layouts_->question());
    if (here.empty()) return;
    const auto now = std::find(here.begin(), here.end(), activeDock());
    const auto count = static_cast<std::ptrdiff_t>(here.size());
    const std::ptrdiff_t place = now == here.end() ? 0 : now - here.begin();
    showDock(here[static_cast<std::size_t>(((place + by) % count + count) % count)]);
}

void MainWindow::setFloating(PanelDock* dock, bool floating)
{
    if (floating) {
        dock->panel();
        dock->floatOver(geometry());
    } else {
        dock->setFloating(false);
        showDock(dock);
    }
}

QMenu* MainWindow::panelMenu(PanelDock* dock)
{
    auto* menu = new QMenu(dock->windowTitle(), this);
    QAction* const floats = menu->addAction(dock->isFloating() ? tr("&Dock") : tr("&Float"), this,
                                            [this, dock] { setFloating(dock, !dock->isFloating()); });
    floats->setObjectName("float");
    QAction* const close = menu->addAction(tr("&Close"), dock, &QDockWidget::close);
    close->setObjectName("close");
    close->setEnabled(!dock->isHidden());
    return menu;
}

/// Of a box: the verbs of its panel, or a menu of them for each of its panels.
void MainWindow::showQuestionMenu(const std::string& id, const QPoint& global)
{
    enterQuestion(id);
    const std::vector<PanelDock*> here = docksIn(docks_, id);
    auto* menu = new QMenu(this);
    menu->setObjectName("questionMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (PanelDock* dock : here) {
        QMenu* const own = panelMenu(dock);
        own->setParent(menu, own->windowFlags());
        if (here.size() > 1)
            menu->addMenu(own);
        else
            menu->addActions(own->actions());
    }
    menu->addSeparator();
    menu->addAction(action("resetLayout"));
    menu->popup(global);
}

/// Of a tab. The main window keeps the address of the dock in the data of its tab.
void MainWindow::contextMenuEvent(QContextMenuEvent* event)
{
    const auto* tabs = qobject_cast<QTabBar*>(childAt(event->pos()));
    const int tab = tabs ? tabs->tabAt(tabs->mapFrom(this, event->pos())) : -1;
    event->ignore();
    if (tab < 0 || tabs->parentWidget() != this) return;
    const auto address = qvariant_cast<quintptr>(tabs->tabData(tab));
    for (PanelDock* dock : docks_)
        if (reinterpret_cast<quintptr>(static_cast<QWidget*>(dock)) == address) {
            QMenu* const menu = panelMenu(dock);
            menu->setObjectName("tabMenu");
            menu->setAttribute(Qt::WA_DeleteOnClose);
            menu->popup(event->globalPos());
            event->accept();
        }
}

void MainWindow::showEmptyPlace()
{
    const std::vector<PanelDock*> here = docksIn(docks_, layouts_->question());
    const bool empty = std::none_of(here.begin(), here.end(),
                                    [](const PanelDock* dock) { return !dock->isHidden() && !dock->isFloating(); });
    if (!here.empty()) emptyPlace_->setQuestion(screenText(here.front()->facts().question.title));
    emptyPlace_->setVisible(empty);
}

void MainWindow::answerQuestion(const std::string& id)
{
    if (!questionBar_) return;
    if (const PartAnswer& answer = answers_->of(id); !answer.panel.empty())
        return questionBar_->setAnswer(id, questionAnswer(answer));
    std::vector<const PanelBase*> panels;
    for (const PanelDock* dock : docksIn(docks_, id))
        if (dock->madePanel()) panels.push_back(dock->madePanel());
    questionBar_->setAnswer(id, answerOfPanels(panels));
}

}  // namespace lathelier
