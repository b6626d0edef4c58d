#include "widgets/core/walk/part_answers.h"

#include <algorithm>

#include "engine/core/failure.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"

namespace lathelier {
namespace {

constexpr int settling_ms = 150;  // a drag changes the project at every motion

std::string answering(const walk::Walk& walk, const AskedQuestion& question)
{
    const auto found = std::find_if(question.panels.begin(), question.panels.end(), [&](const std::string& panel) {
        return !walk.promised(panel).inputs.empty() && walk.canAnswer(panel);
    });
    return found == question.panels.end() ? std::string() : *found;
}

PartAnswer answerBy(const walk::Walk& walk, const std::string& panel, const Language& language,
                    const Progress& progress)
{
    PartAnswer made;
    made.panel = panel;
    made.state = PartAnswer::State::Failed;
    try {
        const auto found = walk.answer(panel, progress);
        made.is_assumed = !found->outcome.understanding.assumed.empty();
        if (found->outcome.answer) {
            made.answer = found->outcome.answer(language);
            made.state = PartAnswer::State::Answered;
        } else if (!found->outcome.errors.empty()) {
            made.error = found->outcome.errors.front();
        }
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& failure) {
        made.error = toError(failure);
    }
    return made;
}

}  // namespace

PartAnswers::PartAnswers(Session& session, std::vector<AskedQuestion> questions, QObject* parent)
    : QObject(parent), session_(session), questions_(std::move(questions))
{
    for (const AskedQuestion& question : questions_) answers_[question.id] = {};
    due_.setSingleShot(true);
    due_.setInterval(settling_ms);
    connect(&due_, &QTimer::timeout, this, &PartAnswers::begin);
    connect(&task_, &Task::progressed, this, &PartAnswers::read);
    for (const auto& signal : {&Session::changed, &Session::filesTaken})
        connect(&session_, signal, this, &PartAnswers::mark);
    mark();
}

/// What rests on the change is no longer the answer.
void PartAnswers::mark()
{
    const auto walk = session_.walk();
    task_.cancel();
    board_ = std::make_shared<Board>();  // what is still written is of the state before
    for (const AskedQuestion& question : questions_) {
        const std::string panel = answering(*walk, question);
        const std::string digest = panel.empty() ? std::string() : panel + walk->digest(panel);
        if (digest == digests_[question.id]) continue;
        digests_[question.id] = digest;
        PartAnswer& answer = answers_[question.id];
        if (panel.empty())
            answer = {};
        else
            answer.state = PartAnswer::State::Computing;
        emit answered(question.id);
    }
    due_.start();
}

void PartAnswers::begin()
{
    board_ = std::make_shared<Board>();
    task_.start(
        [walk = session_.walk(), questions = questions_, board = board_,
         language = screenLanguage()](const Progress& progress) -> std::shared_ptr<const void> {
            for (const AskedQuestion& question : questions) {
                const std::string panel = answering(*walk, question);
                if (panel.empty()) continue;
                PartAnswer made = answerBy(*walk, panel, language, progress);
                const std::lock_guard lock(board->mutex);
                board->done[question.id] = std::move(made);
            }
            return nullptr;
        },
        [this](const Worker::Outcome&) { read(); });
}

void PartAnswers::read()
{
    std::map<std::string, PartAnswer> done;
    {
        const std::lock_guard lock(board_->mutex);
        done.swap(board_->done);
    }
    for (auto& [question, answer] : done) {
        answers_[question] = std::move(answer);
        emit answered(question);
    }
}

}  // namespace lathelier
