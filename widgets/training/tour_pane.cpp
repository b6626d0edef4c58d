#include "widgets/training/tour_pane.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>

#include "engine/core/quantities.h"
#include "engine/io/file.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"

namespace lathelier::training_panel {
namespace {

constexpr const char* english = "en";

/// The program's own lesson; in English where there is none in this language.
std::string ownLesson(std::string& name)
{
    for (const QString& language : {QLocale().name().section('_', 0, 0), QString(english)}) {
        name = (":/training/" + language + "/tour.md").toStdString();
        std::string text = resourceText(name.c_str());
        if (!text.empty()) return text;
    }
    return {};
}

}  // namespace

TourPane::TourPane(QWidget* parent)
    : QWidget(parent),
      place_(new QLabel),
      text_(new QTextBrowser),
      task_(new QLabel),
      hint_(new QLabel),
      back_(new QPushButton),
      help_(new QPushButton),
      next_(new QPushButton),
      other_(new QPushButton)
{
    setObjectName("tour");
    place_->setObjectName("tourPlace");
    text_->setObjectName("tourText");
    task_->setObjectName("tourTask");
    hint_->setObjectName("tourHint");
    back_->setObjectName("tourBack");
    help_->setObjectName("tourHelp");
    next_->setObjectName("tourNext");
    other_->setObjectName("tourOther");
    text_->setFrameShape(QFrame::NoFrame);
    text_->setOpenLinks(false);
    task_->setWordWrap(true);
    hint_->setWordWrap(true);
    hint_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(place_);
    layout->addWidget(text_, 1);
    layout->addWidget(task_);
    layout->addWidget(hint_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(back_);
    buttons->addWidget(help_);
    buttons->addWidget(next_, 1);
    layout->addLayout(buttons);
    layout->addWidget(other_);
    connect(back_, &QPushButton::clicked, this, [this] { goTo(step_ - 1); });
    connect(next_, &QPushButton::clicked, this, [this] { goTo(step_ + 1); });
    connect(help_, &QPushButton::clicked, this, [this] { hint_->setVisible(!hint_->isVisible()); });
    connect(other_, &QPushButton::clicked, this, &TourPane::lessonRequested);
    open({});
    retranslate();
}

void TourPane::open(const QString& path)
{
    std::string name = path.toStdString();
    lesson_ = path.isEmpty() ? training::readLesson(ownLesson(name), name)
                             : training::readLesson(io::FileBytes(name).view(), name);
    path_ = path;
    step_ = -1;
    doneSteps_.assign(lesson_.steps.size(), false);
    show();
}

void TourPane::goTo(int step)
{
    if (step < -1 || step >= steps()) return;
    step_ = step;
    done_ = false;
    hint_->hide();
    show();
    if (step < 0) return emit viewsRequested({});
    const training::Step& now = lesson_.steps[static_cast<std::size_t>(step)];
    emit stepBegun();
    emit settingRequested(now.set);
    QStringList keys;
    for (const training::View view : now.show)
        keys << QString::fromStdString(training::viewChoices()[static_cast<std::size_t>(view)].key);
    if (!keys.isEmpty()) emit viewsRequested(keys);
}

void TourPane::setState(const training::LessonState& state)
{
    state_ = state;
    if (step_ < 0) return;
    const auto now = static_cast<std::size_t>(step_);
    // Once done it stays done: the pupil may go on trying.
    done_ = done_ || training::isDone(lesson_.steps[now], state);
    if (done_) doneSteps_[now] = true;
    show();
}

void TourPane::show()
{
    const auto markdown = [this](const std::string& body) {
        const std::string filled = fill(body, describedValues(state_), screenLanguage());
        return QString::fromStdString(filled);
    };
    const bool begun = step_ >= 0;
    const training::Step* const now = begun ? &lesson_.steps[static_cast<std::size_t>(step_)] : nullptr;
    const QString heading = QString::fromStdString(now ? now->heading : lesson_.title);
    const QString shown = "# " + heading + "\n\n" + markdown(now ? now->body : lesson_.introduction);
    if (text_->property("shown").toString() != shown) {
        text_->setProperty("shown", shown);
        text_->setMarkdown(shown);
    }
    const auto done = std::count(doneSteps_.begin(), doneSteps_.end(), true);
    place_->setText(begun ? tr("Step %1 of %2 · %3 done").arg(step_ + 1).arg(steps()).arg(done)
                          : tr("%n step(s)", nullptr, steps()));
    task_->setVisible(now && !now->task.empty());
    if (now) {
        const QString task = QString::fromStdString(now->task).toHtmlEscaped();
        task_->setText(done_ ? "<b>✓ " + tr("Done.") + "</b> " + task : "<b>☐ " + tr("Task:") + "</b> " + task);
        hint_->setText(QString::fromStdString(now->hint));
    }
    help_->setVisible(now && !now->hint.empty());
    back_->setEnabled(begun);
    next_->setEnabled(step_ + 1 < steps());
    next_->setText(!begun ? tr("Begin") : done_ || now->checks.empty() ? tr("Next") : tr("Skip"));
    next_->setDefault(done_);
}

void TourPane::retranslate()
{
    back_->setText(tr("Back"));
    help_->setText(tr("Hint"));
    other_->setText(tr("Another lesson…"));
    other_->setToolTip(tr("A lesson of your own, written in Markdown"));
    text_->setAccessibleName(tr("Text of the step"));
    if (path_.isEmpty()) {
        std::string name;
        lesson_ = training::readLesson(ownLesson(name), name);
        doneSteps_.resize(lesson_.steps.size());
        step_ = std::min(step_, steps() - 1);
    }
    show();
}

}  // namespace lathelier::training_panel
