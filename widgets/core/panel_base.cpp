#include "widgets/core/panel_base.h"

#include <QEvent>
#include <QMenu>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/core/answer_parts.h"
#include "widgets/core/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/notes_label.h"
#include "widgets/core/session.h"
#include "widgets/core/wait_parts.h"

namespace lathelier {
namespace {

constexpr int pollInterval_ms = 33;

bool isComplete(const PanelInputs& inputs, const PanelState& state)
{
    return std::all_of(inputs.roles.begin(), inputs.roles.end(),
                       [&](const InputRole& role) { return !role.required || state.inputs.count(role.role) > 0; });
}

/// Reads what is there, so that its facts can be shown before the other inputs come.
Worker::Job reading(std::shared_ptr<ScanStore> scans, const PanelState& state)
{
    return [scans, inputs = state.inputs](const Progress& progress) -> std::shared_ptr<const void> {
        for (const auto& [role, source] : inputs)
            scans->load(source, progress.part(0, 1, LT_TEXT("Engine", "Reading")));
        return nullptr;
    };
}

}  // namespace

PanelBase::PanelBase(Session& session, const PanelFacts& facts, const PanelInputs& inputs, QWidget* parent)
    : QWidget(parent), session_(session), facts_(facts), inputs_(inputs)
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

    poll_.setInterval(pollInterval_ms);
    connect(&poll_, &QTimer::timeout, this, &PanelBase::pollWorker);
    connect(column_, &InputColumn::sourceChosen, this, &PanelBase::setSource);
    connect(column_, &InputColumn::parameterEdited, this, &PanelBase::editParameter);
    connect(&session_, &Session::changed, this, &PanelBase::readProject);
    // A virtual call: only once the panel is complete.
    QTimer::singleShot(0, this, &PanelBase::readProject);
}

PanelBase::~PanelBase() = default;

QWidget* PanelBase::makeResultColumn()
{
    headline_ = new HeadlineLabel;
    notes_ = new NotesLabel;
    message_ = new MessageLine;
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
    layout->setSpacing(8);
    layout->addWidget(headline_);
    layout->addWidget(notes_);
    layout->addWidget(message_);
    layout->addWidget(stack_, 1);
    layout->addWidget(progress_);

    connect(empty_, &EmptyState::openWanted, this, &PanelBase::askForFiles);
    connect(empty_, &EmptyState::sampleWanted, this, &PanelBase::sampleWanted);
    connect(progress_, &ProgressRow::cancelWanted, this, &PanelBase::cancel);
    connect(progress_, &ProgressRow::reportWanted, this, &PanelBase::reportWanted);
    connect(progress_, &ProgressRow::addToReportToggled, this, [this](bool in) {
        session_.edit(in ? tr("Add to the report") : tr("Take out of the report"), [&](Project& project) {
            std::erase(project.report, facts_.id);
            if (in) project.report.push_back(facts_.id);
        });
    });
    connect(progress_->exportMenu(), &QMenu::aboutToShow, this, &PanelBase::fillExportMenu);
    return column;
}

void PanelBase::setViews(QWidget* views)
{
    viewsPage_->layout()->addWidget(views);
    shade_->raise();
}

void PanelBase::readProject()
{
    PanelState state = session_.panel(facts_.id);
    Values parameters = inputs_.defaults;
    for (const auto& [name, value] : state.parameters) lathelier::set(parameters, name, value);
    state.parameters = parameters;
    for (auto& [role, source] : state.inputs) source.sha256.clear();
    const auto& report = session_.project().report;
    progress_->setInReport(std::find(report.begin(), report.end(), facts_.id) != report.end());
    if (asked_ && state == state_) return;
    asked_ = true;
    state_ = state;
    column_->showState(state_);
    request();
}

void PanelBase::recompute()
{
    request();
}

void PanelBase::request()
{
    error_.reset();
    stopped_ = false;
    column_->showFacts(session_.scans(), error_);
    message_->clear();
    if (!isComplete(inputs_, state_)) result_.reset();  // the old picture answers nothing any more
    if (state_.inputs.empty()) {
        worker_.cancel();
    } else {
        try {
            worker_.request(isComplete(inputs_, state_) ? makeJob(state_) : reading(session_.sharedScans(), state_));
        } catch (const Error& error) {  // a parameter of the project file is out of its range
            worker_.cancel();
            refuse(error);
        }
    }
    const bool wasBusy = isBusy();
    poll_.start();
    if (!wasBusy) emit busyChanged(true);
    updateStack();
}

void PanelBase::pollWorker()
{
    const Worker::State state = worker_.state();
    progress_->showState(state);
    if (auto outcome = worker_.take()) {
        if (auto* value = std::get_if<std::shared_ptr<const void>>(&*outcome))
            accept(std::move(*value));
        else if (const auto* error = std::get_if<Error>(&*outcome))
            refuse(*error);
        else
            stopped_ = !state_.inputs.empty();
    } else if (state.busy) {
        return;
    }
    poll_.stop();
    progress_->showState({});
    column_->showFacts(session_.scans(), error_);
    updateStack();
    emit busyChanged(false);
    if (isCurrent()) emit resultShown();
}

void PanelBase::accept(std::shared_ptr<const void> result)
{
    if (!result) return;  // only read
    result_ = std::move(result);
    showValue(result_);
    for (const Note& note : notesOf(result_.get())) emit messageRaised({note, facts_.title});
}

void PanelBase::refuse(const Error& error)
{
    error_ = error;
    emit messageRaised({error, facts_.title});
}

void PanelBase::cancel()
{
    worker_.cancel();
}

void PanelBase::updateStack()
{
    QStringList missing;
    for (const InputRole& role : inputs_.roles)
        if (role.required && !state_.inputs.count(role.role)) missing << screenText(role.label);
    const bool begun = !state_.inputs.empty() && !missing.isEmpty();
    empty_->setInvitation(screenText(inputs_.invitation),
                          begun ? tr("Still missing: %1").arg(missing.join(", ")) : QString());
    stack_->setCurrentWidget(hasResult() || (missing.isEmpty() && isBusy()) ? viewsPage_
                                                                            : static_cast<QWidget*>(empty_));
    progress_->setResultThere(isCurrent());
    shade_->setVisible(!isCurrent());
    showAnswer();
}

void PanelBase::showAnswer()
{
    if (hasResult()) {
        headline_->setHeadline(headlineOf(result_.get()));
        notes_->setNotes(notesOf(result_.get()));
    } else {
        headline_->clear();
        notes_->setNotes({});
    }
    headline_->setEnabled(isCurrent());
    notes_->setEnabled(isCurrent());
    if (error_)
        message_->setError(*error_);
    else if (stopped_ && !isBusy())
        message_->setHint(tr("Stopped. Change an input or press F5 to compute again."));
    else
        message_->clear();
}

std::optional<Document> PanelBase::reportDocument() const
{
    if (!hasResult()) return std::nullopt;
    return documentOf(result_.get());
}

void PanelBase::setPresenting(bool presenting)
{
    notes_->setPresenting(presenting);
}

void PanelBase::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange) return;
    retranslate();
    updateStack();
}

}  // namespace lathelier
