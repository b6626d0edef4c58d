#include "widgets/core/panel/panel_base.h"

#include <QEvent>
#include <QMenu>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/core/form/form.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/message_line.h"
#include "widgets/core/panel/next_part_bar.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/session.h"
#include "widgets/core/task/progress_row.h"

namespace lathelier {
namespace {

constexpr int pollInterval_ms = 33;
constexpr int quickInterval_ms = 5;  // initial poll interval, so that quick answers are shown at once
constexpr int quick_ms = 100;        // duration of the initial poll interval
constexpr int patience_ms = 150;     // delay before the old result is dimmed

}  // namespace

PanelBase::PanelBase(Session& session, const PanelFacts& facts, const PanelInputs& inputs, QWidget* parent)
    : QWidget(parent), session_(session), facts_(facts), inputs_(inputs), finder_(acceptedKinds())
{
    setObjectName(QString::fromStdString("panel_" + facts.id));
    setAcceptDrops(true);
    splitter_ = new QSplitter(Qt::Horizontal);
    column_ = new InputColumn(inputs);
    splitter_->addWidget(column_);
    splitter_->addWidget(makeResultColumn());
    splitter_->setStretchFactor(1, 1);
    splitter_->setCollapsible(1, false);
    const int width = fontMetrics().averageCharWidth() * 42;
    splitter_->setSizes({width, width * 4});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter_);

    connect(&poll_, &QTimer::timeout, this, &PanelBase::pollWorker);
    connect(column_, &InputColumn::sourcesChosen, this, &PanelBase::takeSources);
    connect(column_, &InputColumn::filesChosen, this, &PanelBase::takeFiles);
    connect(column_, &InputColumn::parameterEdited, this, &PanelBase::editParameter);
    connect(&session_, &Session::changed, this, &PanelBase::readProject);
    connect(&session_, &Session::filesTaken, this, &PanelBase::request);
    connect(&session_, &Session::viewsRequested, this, [this] {
        if (!asked_ || opened_ != session_.projectsOpened()) return;  // still shows another project, or none
        for (const auto& [key, value] : view()) session_.setView(facts_.id, key, value);
    });
    connect(&session_.watch(), &SourceWatch::changed, this, &PanelBase::showAnswer);
    connect(&session_, &Session::stopRequested, this, [this](const std::string& state) {
        if (state != facts_.stateKey()) return;
        again_ = false;
        worker_.cancel();
    });
    // A virtual call, only after construction.
    QTimer::singleShot(0, this, &PanelBase::readProject);
}

PanelBase::~PanelBase() = default;

QWidget* PanelBase::makeResultColumn()
{
    answer_ = new AnswerStrip;
    connect(answer_, &AnswerStrip::placeRequested, this, &PanelBase::showPlace);
    connect(answer_, &AnswerStrip::offerTaken, this, &PanelBase::takeOffer);
    message_ = new MessageLine;
    nextPart_ = new NextPartBar;
    stack_ = new QStackedWidget;
    empty_ = new EmptyState;
    viewsPage_ = new QWidget;
    auto* viewsLayout = new QVBoxLayout(viewsPage_);
    viewsLayout->setContentsMargins(0, 0, 0, 0);
    shade_ = new Shade(viewsPage_);
    stack_->addWidget(empty_);
    stack_->addWidget(viewsPage_);
    progress_ = new ProgressRow;

    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setSpacing(6);
    layout->setContentsMargins(8, 2, 8, 2);  // height is the views'
    layout->addWidget(answer_);
    layout->addWidget(message_);
    layout->addWidget(nextPart_);
    layout->addWidget(stack_, 1);
    layout->addWidget(progress_);

    connect(empty_, &EmptyState::openRequested, this, &PanelBase::askForFiles);
    connect(empty_, &EmptyState::sampleRequested, this, &PanelBase::sampleRequested);
    connect(progress_, &ProgressRow::cancelRequested, this, &PanelBase::cancel);
    connect(progress_, &ProgressRow::reportRequested, this, &PanelBase::reportRequested);
    connect(progress_, &ProgressRow::addToReportToggled, this, [this](bool in) {
        session_.edit(in ? tr("Add to the report") : tr("Take out of the report"), [&](project::Project& project) {
            std::erase(project.report, facts_.id);
            if (in) project.report.push_back(facts_.id);
        });
    });
    connect(progress_->exportMenu(), &QMenu::aboutToShow, this, &PanelBase::fillExportMenu);
    return column;
}

void PanelBase::setViews(QWidget* views, PrimaryViews* primaryViews)
{
    viewsPage_->layout()->addWidget(views);
    primaryViews_ = primaryViews;
    if (primaryViews_)
        connect(primaryViews_, &PrimaryViews::primaryChanged, this, [this](const QString& key) {
            keptPrimary_ = key.toStdString();
            session_.setView(facts_.id, "hero", keptPrimary_);
        });
    shade_->raise();
}

void PanelBase::readProject()
{
    const auto walk = session_.walk();
    project::PanelState state =
        walk->place(facts_.id) ? walk->promised(facts_.id) : project::resolved(session_.project(), facts_.stateKey());
    Values parameters = inputs_.defaults;
    for (const auto& [name, value] : state.parameters) lathelier::set(parameters, name, value);
    state.parameters = parameters;
    for (auto& [role, source] : state.inputs) source.sha256.clear();
    const auto& report = session_.project().report;
    const Value primary = session_.view(facts_.id, "hero");
    if (primaryViews_ && primary != keptPrimary_) {  // a different project, not a change of this one
        const QSignalBlocker quiet(primaryViews_);
        const auto* key = std::get_if<std::string>(&primary);
        primaryViews_->setPrimary(key ? QString::fromStdString(*key) : primaryViews_->keys().value(0));
        keptPrimary_ = primary;
    }
    if (opened_ != session_.projectsOpened()) {
        opened_ = session_.projectsOpened();
        result_.reset();  // of another project or part
        asked_ = false;
        taken_.reset();
        const auto kept = session_.project().views.find(facts_.id);
        restoreView(kept == session_.project().views.end() ? Values() : kept->second);
    }
    progress_->setInReport(std::find(report.begin(), report.end(), facts_.id) != report.end());
    column_->showItems(session_.project());
    column_->showTaken(walk->taken(facts_.id));
    if (asked_ && state == state_) return;
    asked_ = true;
    state_ = state;
    if (state_.inputs != takenInputs_) nextPart_->hide();
    column_->showState(state_);
    if (restoring_) {
        error_.reset();
        return;
    }
    refusal_.reset();
    request();
}

void PanelBase::recompute()
{
    session_.takeNewFiles();
    request();
}

/// While a handle is dragged a running quick computation is completed and shown before the next one starts: cancelling
/// it at each pointer motion would show no result until the pointer rests.
void PanelBase::request()
{
    again_ = isComplete(state_) && hasResult() && worker_.state().busy && !worker_.state().stopping &&
             asking_.elapsed() < quick_ms;
    if (!again_) begin();
}

void PanelBase::begin()
{
    again_ = false;
    error_.reset();
    stopped_ = false;
    showFacts();
    message_->clear();
    const bool complete = isComplete(state_);
    if (!complete) result_.reset();  // the old result no longer applies
    if (!hasInputs()) {
        worker_.cancel();
    } else {
        try {
            worker_.request(complete ? makeJob(state_) : makeReadingJob(state_));
        } catch (const Error& error) {  // a parameter of the project file is out of its range
            worker_.cancel();
            refuse(error);
        }
    }
    const bool wasBusy = isBusy();
    asking_.start();
    poll_.start(quickInterval_ms);
    if (!wasBusy) emit busyChanged(true);
    updateStack();
}

bool PanelBase::isLate() const
{
    return isBusy() && asking_.elapsed() > patience_ms;
}

void PanelBase::pollWorker()
{
    const Worker::State state = worker_.state();
    progress_->showState(state);
    if (asking_.elapsed() >= quick_ms) {
        if (poll_.interval() != pollInterval_ms) poll_.setInterval(pollInterval_ms);
        if (again_) return begin();
    }
    if (auto outcome = worker_.take()) {
        if (again_) {  // belongs to an outdated request
            if (auto* value = std::get_if<std::shared_ptr<const void>>(&*outcome)) accept(std::move(*value));
            return begin();
        }
        if (auto* value = std::get_if<std::shared_ptr<const void>>(&*outcome)) {
            accept(std::move(*value));
        } else if (const auto* error = std::get_if<Error>(&*outcome)) {
            if (!takeBack(*error))
                refuse(*error);
            else if (again_ || worker_.state().busy)  // computes for the files that came back
                return;
        } else {
            stopped_ = hasInputs();
        }
    } else if (state.busy) {
        if (isLate() && !shade_->isVisibleTo(viewsPage_)) updateStack();
        return;
    }
    poll_.stop();
    progress_->showState({});
    showFacts();
    updateStack();
    layOutAgain();
    emit busyChanged(false);
    if (isCurrent()) emit resultShown();
}

void PanelBase::showFacts()
{
    column_->showFacts(
        [this](const InputRole& role, const project::Source& source) { return understood(role, source); }, error_);
}

void PanelBase::accept(std::shared_ptr<const void> result)
{
    taken_.reset();
    if (!result) return;  // files were only read
    result_ = std::move(result);
    showValue(result_);
    if (auto problem = problemOf(result_.get())) return refuse(*problem);
    logNotes(notesOf(result_.get()));
}

/// Notes of the previous result are not logged again: the log would fill up while a tolerance is dragged.
void PanelBase::logNotes(const Notes& notes)
{
    for (const Note& note : notes)
        if (std::none_of(loggedNotes_.begin(), loggedNotes_.end(), [&](const Note& earlier) {
                return earlier.code == note.code && earlier.values == note.values;
            }))
            emit messageRaised({note, facts_.title});
    loggedNotes_ = notes;
}

void PanelBase::refuse(const Error& error)
{
    error_ = error;
    emit messageRaised({error, facts_.title});
}

void PanelBase::cancel()
{
    session_.stop(facts_.stateKey());
}

void PanelBase::updateStack()
{
    const bool complete = isComplete(state_);
    QStringList missing;
    for (const Text label : missingInputs(state_)) missing << screenText(label);
    const bool begun = hasInputs() && !missing.isEmpty();
    empty_->setInvitation(screenText(inputs_.invitation),
                          begun ? tr("Still missing: %1").arg(missing.join(", ")) : QString());
    empty_->setWaiting(complete && isBusy());
    stack_->setCurrentWidget(hasResult() ? viewsPage_ : static_cast<QWidget*>(empty_));
    progress_->setResultThere(isCurrent());
    const bool onlyFacts = error_ && hasResult() && problemOf(result_.get());
    shade_->setVisible(isBusy() ? isLate() || !hasResult() : !isCurrent() && !onlyFacts);
    showAnswer();
}

void PanelBase::showAnswer()
{
    if (hasResult() && !problemOf(result_.get())) {
        const report::Answer answer = answerOf(result_.get());
        answer_->setAnswer(answer);
        column_->form().setUsed(answer.used);
        Notes notes = session_.watch().notesOf(state_);
        for (Note& note : notesOf(result_.get())) notes.push_back(std::move(note));
        answer_->setNotes(notes);
    } else {
        answer_->clear();
        answer_->setNotes({});
        column_->form().setUsed({});
    }
    const bool dimmed = shade_->isVisibleTo(viewsPage_);
    answer_->setEnabled(!dimmed);
    if (error_ || refusal_)
        message_->setError(error_ ? *error_ : *refusal_);
    else if (stopped_ && !isBusy())
        message_->setHint(tr("Stopped. Change an input or press F5 to compute again."));
    else
        message_->clear();
}

std::optional<report::Answer> PanelBase::shownAnswer() const
{
    if (!hasResult() || problemOf(result_.get())) return std::nullopt;
    return answerOf(result_.get());
}

std::optional<report::Document> PanelBase::reportDocument() const
{
    if (!hasResult() || problemOf(result_.get())) return std::nullopt;
    report::Document document = documentOf(result_.get());
    const Notes notes = session_.watch().notesOf(state_);
    if (!notes.empty() && !document.sections.empty()) document.sections.front().blocks.push_back(notes);
    return document;
}

void PanelBase::setPresenting(bool presenting)
{
    column_->setVisible(!presenting);
    progress_->setVisible(!presenting);
    answer_->setPresenting(presenting);
    if (primaryViews_) primaryViews_->setPresenting(presenting);
}

/// Size changes while the panel was hidden behind another tab were not propagated.
void PanelBase::layOutAgain()
{
    QTimer::singleShot(0, this, [this] {
        for (QLayout* layout : findChildren<QLayout*>()) layout->invalidate();
    });
}

void PanelBase::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    layOutAgain();
}

void PanelBase::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange) return;
    retranslate();
    showFacts();
    updateStack();
}

}  // namespace lathelier
