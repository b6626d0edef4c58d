#include "app/gui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>
#include <algorithm>

#include "app/gui/data_column.h"
#include "app/gui/file_taker.h"
#include "app/gui/parts_box.h"
#include "app/gui/settings_dialog.h"
#include "app/gui/shop_choice.h"
#include "app/gui/shop_dialog.h"
#include "app/gui/theme.h"
#include "engine/walk/shop_supply.h"
#include "widgets/core/panel/primary_views.h"

namespace lathelier {
namespace {

io::FileKinds kindsOf(const std::vector<PanelFacts>& panels)
{
    io::FileKinds kinds;
    for (const PanelFacts& panel : panels) io::unite(kinds, panel.kinds);
    return kinds;
}

}  // namespace

MainWindow::MainWindow(Session& session, Languages& languages, const std::vector<PanelFacts>& panels,
                       const QString& recoveryFolder)
    : session_(session),
      languages_(languages),
      settings_(readSettings()),
      files_(session, recoveryFolder, this),
      questions_(questionsOf(panels)),
      finder_(kindsOf(panels)),
      log_(new MessageLog),
      logDock_(new QDockWidget(this)),
      dataDock_(new QDockWidget(this)),
      status_(new QLabel),
      openSaved_(new QToolButton),
      ordinaryFont_(QApplication::font())
{
    session_.setPlaces(placesOf(panels));
    session_.setStartingShop(startingShop());
    useShop();
    useStartingValues();
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    logDock_->setObjectName("dock_messages");
    logDock_->setWidget(log_);
    auto* column = new DataColumn(session_, panels);
    dataDock_->setObjectName("dock_data");
    dataDock_->setWidget(underParts(session_, column));
    connect(column, &DataColumn::panelRequested, this, [this](const std::string& id) {
        for (PanelDock* dock : docks_)
            if (dock->facts().id == id) return showPanel(dock);
    });
    connect(column, &DataColumn::itemRequested, this, [this](const std::string& name) {
        const auto& items = session_.project().items;
        if (const auto item = items.find(name); item != items.end())
            for (PanelDock* dock : docks_)
                if (dock->facts().item_inputs.count(item->second.kind) > 0) return showPanel(dock);
    });
    status_->setObjectName("status");
    status_->setTextFormat(Qt::PlainText);
    status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    statusBar()->addWidget(status_, 1);
    openSaved_->setObjectName("openSaved");
    statusBar()->addWidget(openSaved_);
    makeDocks(panels);
    std::vector<AskedQuestion> asked;
    for (const Question& question : questions_) {
        asked.push_back({question.id, {}});
        std::vector<std::string>& speakers = asked.back().panels;
        for (const PanelDock* dock : docksIn(docks_, question.id))
            speakers.insert(dock->facts().speaks_first ? speakers.begin() : speakers.end(), dock->facts().id);
    }
    answers_ = std::make_unique<PartAnswers>(session_, std::move(asked));
    connect(answers_.get(), &PartAnswers::answered, this, &MainWindow::answerQuestion);
    makeActions();
    makeMenus();
    makeQuestionBar();
    makeTools();
    retranslate();

    connect(&session_, &Session::pathChanged, this, &MainWindow::updateTitle);
    connect(&session_, &Session::modifiedChanged, this, &MainWindow::updateTitle);
    connect(&session_, &Session::changed, this, &MainWindow::useShop);
    connect(&session_, &Session::changed, this, &MainWindow::clearStatus);  // it belonged to the previous state
    connect(&session_, &Session::workspaceChanged, this, [this] { enterQuestion(session_.project().workspace); });
    connect(&files_, &ProjectFiles::messageRaised, this, &MainWindow::announce);
    connect(&files_, &ProjectFiles::recentChanged, this, &MainWindow::fillRecent);

    const QSize frame(0, 2 * fontMetrics().height());  // the title bar, which counts on the screen as well
    resize(QSize(1280, 800).boundedTo(screen()->availableSize() - frame));
    restoreGeometry(QSettings().value("geometry").toByteArray());
    enterQuestion(session_.project().workspace);
    updateTitle();
    useTheme();
}

/// Called at every change of the project: its shop is read only where that has changed.
void MainWindow::useShop()
{
    const Values& stated = session_.project().shop;
    if (usedShop_ && *usedShop_ == stated) return;
    usedShop_ = stated;
    session_.setSupply(walk::supplyOf(shopOf(session_.project())));
}

void MainWindow::askForShop()
{
    ShopDialog dialog(shopOf(session_.project()), this);
    if (dialog.exec() == QDialog::Accepted) keepShop(session_, dialog.shop());
}

void MainWindow::useTheme()
{
    if (auto* theme = qApp->findChild<Theme*>()) theme->choose(settings_.theme);
}

MainWindow::~MainWindow()
{
    session_.disconnect(this);
    session_.undoStack().disconnect(this);
}

/// Keeps the item in the project, gives it to the first panel that takes its kind, and shows that panel: one undo step.
void MainWindow::useItem(const std::string& name, const project::Item& item, bool synthetic)
{
    const auto taker = std::find_if(docks_.begin(), docks_.end(), [&](const PanelDock* dock) {
        return dock->facts().item_inputs.count(item.kind) > 0;
    });
    session_.edit(tr("Use “%1”").arg(QString::fromStdString(name)), [&](project::Project& project) {
        project.items[name] = item;
        if (taker == docks_.end()) return;
        const PanelFacts& facts = (*taker)->facts();
        project::Source source;
        source.item = name;
        source.synthetic = synthetic;
        project.panels[facts.stateKey()].inputs[facts.item_inputs.at(item.kind)] = source;
    });
    if (taker != docks_.end()) showPanel(*taker);
}

void MainWindow::openPaths(const QStringList& paths)
{
    QStringList others;
    for (const QString& path : paths) {
        if (ProjectFiles::isProject(path))
            files_.open(path);
        else
            others << path;
    }
    if (others.isEmpty()) return;
    finder_.find(others, [this](const std::vector<FoundFile>& files) { openFound(files); });
}

/// The panel of the first file comes to the front. Files of no panel's kind are refused.
void MainWindow::openFound(const std::vector<FoundFile>& files)
{
    std::vector<const PanelFacts*> panels;
    io::FileKinds kinds;
    std::optional<std::size_t> active;
    for (PanelDock* dock : docks_) {
        if (dock == activeDock()) active = panels.size();
        panels.push_back(&dock->facts());
        io::unite(kinds, dock->facts().kinds);
    }
    std::vector<FoundFile> taken;
    for (const FoundFile& file : files) {
        if (const auto refusal = refusalOf(file, kinds))
            announce({*refusal, {}});
        else
            taken.push_back(file);
    }
    const std::vector<Opening> openings = openingsOf(taken, panels, active, session_.project());
    for (const Opening& opening : openings) docks_[opening.panel]->panel().openFound(opening.files);
    if (!openings.empty()) showPanel(docks_[openings.front().panel]);
}

void MainWindow::askForFiles()
{
    const QStringList paths = QFileDialog::getOpenFileNames(this, tr("Open a project or measured files"), {},
                                                            tr("All files (*)") + ";;" + ProjectFiles::filter());
    openPaths(paths);
}

/// The status line speaks of the panel in front and of the window; the log keeps what others say.
void MainWindow::announce(const Message& message)
{
    log_->add(message);
    const auto speaks = [&](const PanelDock* dock) { return dock->facts().title == message.source; };
    const bool ofAPanel = std::any_of(docks_.begin(), docks_.end(), speaks);
    if (ofAPanel && !(activeDock() && speaks(activeDock()))) return;
    openSaved_->hide();
    status_->setText(shortText(message));
    status_->setToolTip(screenText(message));
    // Messages without a panel have no message line.
    if (kindOf(message) == MessageKind::Error && message.source.empty()) {
        logDock_->show();
        logDock_->raise();
    }
}

void MainWindow::clearStatus()
{
    status_->clear();
    status_->setToolTip({});
    openSaved_->hide();
}

void MainWindow::setPresenting(bool presenting)
{
    if (presenting == presenting_) return;
    presenting_ = presenting;
    if (presenting) {
        stateBeforePresenting_ = saveState();
        sizeBeforePresenting_ = size();
        wasFullScreen_ = isFullScreen();
    }
    if (isVisible() && !wasFullScreen_) setWindowState(windowState() ^ Qt::WindowFullScreen);
    QFont font = ordinaryFont_;
    if (presenting) font.setPointSizeF(font.pointSizeF() * settings_.presenter_percent / 100.0);
    QApplication::setFont(font);
    for (PanelDock* dock : docks_) {
        if (presenting && dock != activeDock()) dock->hide();
        if (presenting && dock == activeDock()) dock->setFloating(false);
        if (dock->madePanel()) dock->madePanel()->setPresenting(presenting);
    }
    for (QDockWidget* side : {logDock_, dataDock_}) side->setVisible(!presenting && side->isVisible());
    menuBar()->setVisible(!presenting);
    bar_->setVisible(!presenting);
    statusBar()->setVisible(!presenting);
    if (!presenting) {
        restoreState(stateBeforePresenting_);
        // What comes back still asks for the room of the large type until its fonts are applied.
        QTimer::singleShot(0, this, [this] {
            if (!presenting_ && !isMaximized()) resize(sizeBeforePresenting_);
        });
    }
    layouts_->ensureSeen(activeDock());
    action("presenter")->setChecked(presenting);
    PanelBase* const shown = activeDock() ? activeDock()->madePanel() : nullptr;
    if (!presenting || !shown) return;
    if (auto* views = shown->findChild<PrimaryViews*>())
        views->setFocus();  // the arrow keys go through them at once
    else
        shown->setFocus();
}

void MainWindow::applySettings(const Settings& settings)
{
    const bool presenting = presenting_;
    setPresenting(false);
    settings_ = settings;
    writeSettings(settings);
    languages_.use(settings.language);
    setScreenUnits(settings.units);
    useStartingValues();
    useTheme();
    setPresenting(presenting);
}

void MainWindow::useStartingValues()
{
    Values values;
    if (!settings_.decision.isEmpty()) values.emplace_back("decision", settings_.decision.toStdString());
    session_.setStartingValues(values);
}

void MainWindow::askForSettings()
{
    SettingsDialog dialog(settings_, this);
    if (dialog.exec() == QDialog::Accepted) applySettings(dialog.settings());
}

void MainWindow::updateTitle()
{
    const QString name =
        session_.path().isEmpty() ? tr("Unnamed project") : QFileInfo(session_.path()).completeBaseName();
    setWindowTitle(name + "[*] – Lathelier");
    setWindowModified(session_.isModified());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!files_.mayLeave()) {
        event->ignore();
        return;
    }
    setPresenting(false);
    if (!layouts_->question().empty()) layouts_->save();
    QSettings().setValue("geometry", saveGeometry());
    event->accept();
}

void MainWindow::changeEvent(QEvent* event)
{
    QMainWindow::changeEvent(event);
    if (event->type() != QEvent::LanguageChange) return;
    unsetLocale();  // the numbers of all views follow, also in docks that float
    for (QWidget* part : findChildren<QWidget*>())
        if (part->isWindow()) part->unsetLocale();
    retranslate();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    event->acceptProposedAction();
    openPaths(paths);
}

}  // namespace lathelier
