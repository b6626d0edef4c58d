#include "widgets/chain/chain_strip.h"

#include <QDesktopServices>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLocale>
#include <QMenu>
#include <QUrl>
#include <algorithm>
#include <filesystem>

#include "engine/chain/dossier_report.h"
#include "engine/chain/of_project/chain_memory.h"
#include "engine/chain/of_project/settled_chain.h"
#include "engine/chain/step_state.h"
#include "engine/io/file.h"
#include "engine/report/html.h"
#include "widgets/chain/chain_landing.h"
#include "widgets/chain/run_dialog.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"
#include "widgets/core/report/report_files.h"

namespace lathelier::chain_panel {
namespace {

constexpr int settling_ms = 150;
constexpr int watching_ms = 2000;

const Text chainTitle = LT_TEXT("Engine", "Chain");

/// Stamp of a folder that detects changes without reading its files.
std::string stampsOf(const chain::Dossier& dossier, const std::string& folder, const Progress& progress)
{
    std::string stamps = io::fileStamp((std::filesystem::path(folder) / chain::dossierFile).string());
    for (const chain::ChainStep& step : dossier.steps)
        for (const auto* files : {&step.inputs, &step.outputs})
            for (const InputFile& file : *files) {
                progress.check();
                stamps += '\n';
                stamps += io::fileStamp((std::filesystem::path(folder) / file.path).string());
            }
    return stamps;
}

struct Looked {
    chain::ChainQuestion question;
    std::shared_ptr<const chain::Dossier> dossier;
    std::string stamps;
    bool has_dossier = false;
};

struct Ran {
    chain::ChainQuestion question;
    std::shared_ptr<const chain::Dossier> dossier;
    std::string sha256;  // digest of the dossier file
};

void writeMade(const chain::AskedChain& asked)
{
    for (const chain::MadeInput& made : asked.made) {
        std::error_code ignored;
        std::filesystem::create_directories(std::filesystem::path(made.path).parent_path(), ignored);
        io::writeFile(made.path, made.text);
    }
}

}  // namespace

ChainStrip::ChainStrip(Session& session, QWidget* parent)
    : WorkspaceStrip(parent),
      session_(session),
      stack_(new QStackedWidget),
      start_(new QPushButton),
      phase_(new QLabel),
      bar_(new QProgressBar),
      cancel_(new QPushButton),
      more_(new QToolButton),
      report_(new QAction(this)),
      dossier_(new QAction(this)),
      folder_(new QAction(this))
{
    setObjectName("chainStrip");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 4, 2);
    row->setSpacing(4);
    for (const StripStep& step : stripSteps()) {
        auto* tile = new StepTile;
        tile->setObjectName(QString("step_") + step.key);
        connect(tile, &QAbstractButton::clicked, this, [this, &step] { openStep(step); });
        tiles_.push_back(tile);
        row->addWidget(tile, 1);
    }
    start_->setObjectName("runChainWanted");
    cancel_->setObjectName("cancelChain");
    phase_->setObjectName("chainPhase");
    phase_->setTextFormat(Qt::PlainText);
    phase_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setMaximumHeight(fontMetrics().height() / 2);
    auto* running = new QWidget;
    auto* columns = new QHBoxLayout(running);
    columns->setContentsMargins(0, 0, 0, 0);
    auto* words = new QVBoxLayout;
    words->setSpacing(1);
    words->addWidget(phase_);
    words->addWidget(bar_);
    columns->addLayout(words, 1);
    columns->addWidget(cancel_);
    stack_->addWidget(start_);
    stack_->addWidget(running);
    stack_->setFixedWidth(fontMetrics().averageCharWidth() * 32);
    stack_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    start_->setFixedHeight(tiles_.front()->sizeHint().height());
    row->addWidget(stack_);
    more_->setObjectName("chainMore");
    more_->setPopupMode(QToolButton::InstantPopup);
    more_->setIcon(icon("export"));
    auto* menu = new QMenu(more_);
    for (QAction* action : {report_, dossier_, folder_}) menu->addAction(action);
    more_->setMenu(menu);
    row->addWidget(more_);
    connect(start_, &QPushButton::clicked, this, &ChainStrip::askToRun);
    connect(cancel_, &QPushButton::clicked, &run_, &Task::cancel);
    connect(report_, &QAction::triggered, this, &ChainStrip::exportReport);
    connect(dossier_, &QAction::triggered, this, &ChainStrip::exportDossier);
    connect(folder_, &QAction::triggered, this, &ChainStrip::openFolder);
    connect(&run_, &Task::progressed, this, &ChainStrip::showProgress);
    due_.setSingleShot(true);
    due_.setInterval(settling_ms);
    connect(&due_, &QTimer::timeout, this, &ChainStrip::look);
    connect(&session_, &Session::changed, this, &ChainStrip::followProject);
    connect(&session_, &Session::filesTaken, this, &ChainStrip::lookSoon);
    connect(&session_.watch(), &SourceWatch::changed, this, &ChainStrip::lookSoon);
    turn_.setInterval(watching_ms);
    connect(&turn_, &QTimer::timeout, this, &ChainStrip::watchFiles);
    turn_.start();
    retranslate();
    lookSoon();
}

ChainStrip::~ChainStrip() = default;

StepTile* ChainStrip::tile(const std::string& key) const
{
    return findChild<StepTile*>(QString::fromStdString("step_" + key));
}

void ChainStrip::look()
{
    if (!isVisible()) return;  // repeated in showEvent()
    try {
        asked_ = chain::askedChain(session_.project());
    } catch (const Error& error) {  // a parameter of the project file is out of its range
        emit messageRaised({error, chainTitle});
        return;
    }
    look_.compute<Looked>(
        [unsettled = asked_, stores = session_.sharedStores()](const Progress& progress) {
            const chain::AskedChain asked = chain::settled(unsettled, *stores, progress);
            io::InputFiles inputs;
            for (const chain::MadeInput& made : asked.made) inputs.give(made.path, made.text);
            auto earlier = stores->of<chain::ChainMemory>()->find(asked.question.out, progress);
            Looked looked;
            looked.question = asked.question;
            looked.dossier = std::make_shared<const chain::Dossier>(
                chain::remanufacture(asked.question, chain::RunMode::DryRun, earlier, inputs, progress));
            looked.stamps = stampsOf(*looked.dossier, asked.question.out, progress);
            looked.has_dossier = !chain::dossierDigest(asked.question.out, progress).empty();
            return looked;
        },
        [this](const Looked& looked) {
            question_ = looked.question;
            stamps_ = looked.stamps;
            hasDossier_ = looked.has_dossier;
            show(looked.dossier);
        },
        [this](const Error& error) {
            emit messageRaised({error, chainTitle});
        });
}

/// In a separate thread, since a file system may block.
void ChainStrip::watchFiles()
{
    if (!isVisible() || !looked_ || isLooking() || isRunning() || watch_.isBusy()) return;
    watch_.compute<std::string>([dossier = looked_, folder = asked_.question.out](
                                    const Progress& progress) { return stampsOf(*dossier, folder, progress); },
                                [this](const std::string& stamps) {
                                    const bool has_changed = !stamps_.empty() && stamps != stamps_;
                                    stamps_ = stamps;
                                    if (has_changed) look();
                                },
                                [](const Error&) {});
}

void ChainStrip::show(const std::shared_ptr<const chain::Dossier>& dossier)
{
    looked_ = dossier;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        const StripStep& step = stripSteps()[i];
        tiles_[i]->say(screenText(step.title), standingOf(step, *dossier));
        tiles_[i]->setToolTip(aboutOf(step, *dossier));
    }
    const auto waiting = stepsToRun(*dossier).size();
    start_->setText(waiting > 0 ? tr("Run %n step(s)…", "", waiting) : tr("Up to date"));
    start_->setEnabled(waiting > 0);
    for (QAction* action : {report_, dossier_, folder_}) action->setEnabled(hasDossier_);
}

/// Opens the panel of a step with the files and parameters of the chain, in one step that can be undone. What the chain
/// takes from panels becomes its own first, so that they no longer rule its question.
void ChainStrip::openStep(const StripStep& step)
{
    const chain::ChainStep* const made = looked_ ? looked_->step(step.of_chain.front()) : nullptr;
    const auto state = made && made->state == chain::StepState::Done ? chain::stateOf(*made, question_.out)
                                                                     : std::optional<project::PanelState>();
    if (state) {
        session_.edit(tr("Open a step of the chain"), [&](project::Project& project) {
            chain::pinInputs(project, question_);
            project::PanelState& panel = project.panels[step.panel];
            panel.inputs = state->inputs;
            panel.parameters = state->parameters;
        });
    }
    emit panelRequested(step.panel);
}

void ChainStrip::askToRun()
{
    if (isRunning() || !looked_ || dialog_) return;
    dialog_ = new RunDialog(*looked_, asked_, this);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &QDialog::accepted, this, [this] {
        const std::string folder = QFileInfo(dialog_->folder()).absoluteFilePath().toStdString();
        try {
            // Another folder: files written for the chain go there too.
            project::Project project = session_.project();
            set(project.panels[chain::chainKey].parameters, chain::folderKey, folder);
            run(chain::askedChain(project));
        } catch (const Error& error) {
            emit messageRaised({error, chainTitle});
        }
    });
    dialog_->open();
}

void ChainStrip::run(const chain::AskedChain& unsettled)
{
    setRunning(true);
    run_.start(
        [unsettled, stores = session_.sharedStores()](const Progress& progress) -> std::shared_ptr<const void> {
            const chain::AskedChain asked = chain::settled(unsettled, *stores, progress);
            writeMade(asked);
            io::InputFiles inputs;
            auto memory = stores->of<chain::ChainMemory>();
            auto earlier = memory->find(asked.question.out, progress);
            auto dossier = std::make_shared<const chain::Dossier>(
                chain::remanufacture(asked.question, chain::RunMode::OutOfDate, earlier, inputs, progress));
            chain::writeDossier(asked.question, *dossier, inputs.list(), toValues(asked.question));
            memory->keep(asked.question.out, dossier);
            return std::make_shared<const Ran>(Ran{asked.question, dossier, chain::dossierDigest(asked.question.out)});
        },
        [this, opened = session_.projectsOpened()](const Worker::Outcome& outcome) {
            setRunning(false);
            // The result for a project closed meanwhile stays on disk and is not entered into the current project.
            if (opened != session_.projectsOpened()) return lookSoon();
            if (const auto* value = std::get_if<std::shared_ptr<const void>>(&outcome)) {
                const auto& ran = *static_cast<const Ran*>(value->get());
                landRun(session_, ran.question, *ran.dossier, ran.sha256);
                reportRun(ran.question, *ran.dossier);
                emit panelRequested(chain::chainKey);
            } else if (const auto* error = std::get_if<Error>(&outcome)) {
                emit messageRaised({*error, chainTitle});
            }
            lookSoon();
        });
}

void ChainStrip::reportRun(const chain::ChainQuestion& question, const chain::Dossier& dossier)
{
    if (const auto error = dossier.error()) {
        emit messageRaised({*error, chainTitle});
        return;
    }
    const Phrase done{LT_TEXT("Engine", "The chain was run; its files are in {path}."), {{"path", question.out}}};
    emit messageRaised({done, chainTitle});
}

void ChainStrip::followProject()
{
    if (opened_ != session_.projectsOpened()) {
        opened_ = session_.projectsOpened();
        if (isRunning()) run_.cancel();
    }
    lookSoon();
}

void ChainStrip::showProgress(const Worker::State& state)
{
    bar_->setValue(static_cast<int>(state.fraction * 1000));
    const QString phase = state.stopping ? tr("Stopping…") : screenText(state.stage);
    phase_->setText(phase);
    phase_->setToolTip(phase);
}

void ChainStrip::setRunning(bool running)
{
    bar_->setValue(0);
    phase_->clear();
    stack_->setCurrentIndex(running ? 1 : 0);
}

void ChainStrip::exportReport()
{
    const auto dossier = session_.stores().of<chain::ChainMemory>()->find(asked_.question.out, {});
    const QString path = QFileDialog::getSaveFileName(this, tr("Write the report of the chain"), "chain.html",
                                                      tr("HTML (*.html)") + ";;" + tr("PDF (*.pdf)"));
    if (!dossier || path.isEmpty()) return;
    try {
        writeReport(path, chain::dossierReport(*dossier));
    } catch (const Error& error) {
        emit messageRaised({error, chainTitle});
    }
}

void ChainStrip::exportDossier()
{
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Write the dossier"), "dossier.json", tr("JSON (*.json)"));
    if (path.isEmpty()) return;
    try {
        const io::FileBytes bytes((std::filesystem::path(asked_.question.out) / chain::dossierFile).string());
        io::writeFile(path.toStdString(), bytes.view());
    } catch (const Error& error) {
        emit messageRaised({error, chainTitle});
    }
}

void ChainStrip::openFolder()
{
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(asked_.question.out)));
}

void ChainStrip::showEvent(QShowEvent* event)
{
    WorkspaceStrip::showEvent(event);
    lookSoon();
}

void ChainStrip::retranslate()
{
    setAccessibleName(tr("Chain from the scan to the proof of the copy"));
    for (std::size_t i = 0; i < tiles_.size(); ++i)
        tiles_[i]->say(screenText(stripSteps()[i].title), tiles_[i]->standing());
    start_->setText(tr("Run the chain…"));
    start_->setToolTip(tr("Runs the steps that are not made yet or out of date, after a question"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("What was made before stays"));
    more_->setToolTip(tr("Report and dossier of the chain"));
    more_->setAccessibleName(more_->toolTip());
    report_->setText(tr("&Report…"));
    dossier_->setText(tr("&Dossier…"));
    folder_->setText(tr("&Open the folder"));
    if (looked_) show(looked_);
}

void ChainStrip::changeEvent(QEvent* event)
{
    WorkspaceStrip::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier::chain_panel
