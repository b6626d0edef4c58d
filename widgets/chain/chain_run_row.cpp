#include "widgets/chain/chain_run_row.h"

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

#include "engine/chain/dossier_cover.h"
#include "engine/chain/of_project/chain_memory.h"
#include "engine/chain/of_project/settled_chain.h"
#include "engine/chain/step_state.h"
#include "engine/io/file.h"
#include "engine/report/html.h"
#include "widgets/chain/chain_landing.h"
#include "widgets/chain/chain_steps.h"
#include "widgets/chain/run_dialog.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"
#include "widgets/core/report/report_files.h"

namespace lathelier::chain_panel {
namespace {

constexpr int settling_ms = 150;
constexpr int watching_ms = 2000;

/// Of the panel, whose messages these are.
const Text chainTitle = LT_TEXT("Engine", "Proof of the copy");

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

ChainRunRow::ChainRunRow(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      start_(new QPushButton),
      running_(new QWidget),
      phase_(new QLabel),
      bar_(new QProgressBar),
      cancel_(new QPushButton),
      more_(new QToolButton),
      report_(new QAction(this)),
      dossier_(new QAction(this)),
      folder_(new QAction(this))
{
    setObjectName("chainRunRow");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(9, 2, 9, 0);
    row->setSpacing(9);
    start_->setObjectName("runChainWanted");
    cancel_->setObjectName("cancelChain");
    phase_->setObjectName("chainPhase");
    phase_->setTextFormat(Qt::PlainText);
    phase_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setMaximumHeight(fontMetrics().height() / 2);
    auto* columns = new QHBoxLayout(running_);
    columns->setContentsMargins(0, 0, 0, 0);
    auto* words = new QVBoxLayout;
    words->setSpacing(1);
    words->addWidget(phase_);
    words->addWidget(bar_);
    columns->addLayout(words, 1);
    columns->addWidget(cancel_);
    QSizePolicy kept(QSizePolicy::Expanding, QSizePolicy::Fixed);
    kept.setRetainSizeWhenHidden(true);
    running_->setSizePolicy(kept);
    running_->hide();
    row->addWidget(start_);
    row->addWidget(running_, 1);
    more_->setObjectName("chainMore");
    more_->setPopupMode(QToolButton::InstantPopup);
    more_->setIcon(icon("export"));
    auto* menu = new QMenu(more_);
    for (QAction* action : {report_, dossier_, folder_}) menu->addAction(action);
    more_->setMenu(menu);
    row->addWidget(more_);
    connect(start_, &QPushButton::clicked, this, &ChainRunRow::askToRun);
    connect(cancel_, &QPushButton::clicked, &run_, &Task::cancel);
    connect(report_, &QAction::triggered, this, &ChainRunRow::exportReport);
    connect(dossier_, &QAction::triggered, this, &ChainRunRow::exportDossier);
    connect(folder_, &QAction::triggered, this, &ChainRunRow::openFolder);
    connect(&run_, &Task::progressed, this, &ChainRunRow::showProgress);
    due_.setSingleShot(true);
    due_.setInterval(settling_ms);
    connect(&due_, &QTimer::timeout, this, &ChainRunRow::look);
    connect(&session_, &Session::changed, this, &ChainRunRow::followProject);
    connect(&session_, &Session::filesTaken, this, &ChainRunRow::lookSoon);
    connect(&session_.watch(), &SourceWatch::changed, this, &ChainRunRow::lookSoon);
    turn_.setInterval(watching_ms);
    connect(&turn_, &QTimer::timeout, this, &ChainRunRow::watchFiles);
    turn_.start();
    retranslate();
    lookSoon();
}

ChainRunRow::~ChainRunRow() = default;

void ChainRunRow::look()
{
    if (!isVisible()) return;  // repeated in showEvent()
    try {
        asked_ = chain::askedChain(session_.project());
    } catch (const Error& error) {  // a parameter of the project file is out of its range
        emit messageRaised({error, chainTitle});
        return;
    }
    look_.compute<Looked>(
        [unsettled = asked_, walk = session_.walk(), stores = session_.sharedStores()](const Progress& progress) {
            const chain::AskedChain asked = chain::settled(unsettled, *walk, *stores, progress);
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
void ChainRunRow::watchFiles()
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

void ChainRunRow::show(const std::shared_ptr<const chain::Dossier>& dossier)
{
    looked_ = dossier;
    const auto waiting = stepsToRun(*dossier).size();
    start_->setText(waiting > 0 ? tr("Run %n step(s)…", "", waiting) : tr("Up to date"));
    start_->setEnabled(waiting > 0 && !isRunning());
    start_->setToolTip(stepsToRun(*dossier).join('\n'));
    emit lookedAgain(dossier);
    for (QAction* action : {report_, dossier_, folder_}) action->setEnabled(hasDossier_);
}

void ChainRunRow::openStep(const std::string& step)
{
    const char* const panel = panelOf(step);
    const chain::ChainStep* const made = looked_ ? looked_->step(step) : nullptr;
    if (!panel) return;
    const auto state = made && made->state == chain::StepState::Done ? chain::stateOf(*made, question_.out)
                                                                     : std::optional<project::PanelState>();
    if (state) {
        session_.edit(tr("Open a step of the chain"), [&](project::Project& project) {
            chain::pinInputs(project, question_);
            project::PanelState& shown = project.panels[panel];
            shown.inputs = state->inputs;
            shown.parameters = state->parameters;
        });
    }
    emit panelRequested(panel);
}

void ChainRunRow::askToRun()
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

void ChainRunRow::run(const chain::AskedChain& unsettled)
{
    setRunning(true);
    run_.start(
        [unsettled, walk = session_.walk(),
         stores = session_.sharedStores()](const Progress& progress) -> std::shared_ptr<const void> {
            const chain::AskedChain asked = chain::settled(unsettled, *walk, *stores, progress);
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

void ChainRunRow::reportRun(const chain::ChainQuestion& question, const chain::Dossier& dossier)
{
    if (const auto error = dossier.error()) {
        emit messageRaised({*error, chainTitle});
        return;
    }
    const Phrase done{LT_TEXT("Engine", "The chain was run; its files are in {path}."), {{"path", question.out}}};
    emit messageRaised({done, chainTitle});
}

void ChainRunRow::followProject()
{
    if (opened_ != session_.projectsOpened()) {
        opened_ = session_.projectsOpened();
        if (isRunning()) run_.cancel();
    }
    lookSoon();
}

void ChainRunRow::showProgress(const Worker::State& state)
{
    bar_->setValue(static_cast<int>(state.fraction * 1000));
    const QString phase = state.stopping ? tr("Stopping…") : screenText(state.stage);
    phase_->setText(phase);
    phase_->setToolTip(phase);
}

void ChainRunRow::setRunning(bool running)
{
    bar_->setValue(0);
    phase_->clear();
    running_->setVisible(running);
    start_->setEnabled(!running && looked_ && !stepsToRun(*looked_).isEmpty());
}

void ChainRunRow::exportReport()
{
    const auto dossier = session_.stores().of<chain::ChainMemory>()->find(asked_.question.out, {});
    const QString path = QFileDialog::getSaveFileName(this, tr("Write the report of the chain"), "chain.html",
                                                      tr("HTML (*.html)") + ";;" + tr("PDF (*.pdf)"));
    if (!dossier || path.isEmpty()) return;
    try {
        writeReport(path, chain::dossierReport(*dossier, screenLanguage()));
    } catch (const Error& error) {
        emit messageRaised({error, chainTitle});
    }
}

void ChainRunRow::exportDossier()
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

void ChainRunRow::openFolder()
{
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(asked_.question.out)));
}

void ChainRunRow::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    lookSoon();
}

void ChainRunRow::retranslate()
{
    setAccessibleName(tr("Chain from the scan to the proof of the copy"));
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

void ChainRunRow::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier::chain_panel
