#include "widgets/core/walk/part_answers.h"

#include <algorithm>

#include "engine/core/failure.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"

namespace lathelier {
namespace {

constexpr int settling_ms = 150;  // a drag changes the project at every motion

/// Those of the question that have their inputs, in its order.
std::vector<std::string> answering(const walk::Walk& walk, const AskedQuestion& question)
{
    std::vector<std::string> ready;
    for (const std::string& panel : question.panels)
        if (!walk.promised(panel).inputs.empty() && walk.canAnswer(panel)) ready.push_back(panel);
    return ready;
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
        const std::vector<std::string> panels = answering(*walk, question);
        std::string digest;
        for (const std::string& panel : panels) digest += panel + walk->digest(panel);
        if (digest == digests_[question.id]) continue;
        digests_[question.id] = digest;
        PartAnswer& answer = answers_[question.id];
        if (panels.empty())
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
                const std::vector<std::string> panels = answering(*walk, question);
                if (panels.empty()) continue;
                PartAnswer made = answerBy(*walk, panels.front(), language, progress);
                for (std::size_t i = 1; i < panels.size() && made.state == PartAnswer::State::Failed; ++i)
                    if (PartAnswer other = answerBy(*walk, panels[i], language, progress); other.answer)
                        made = std::move(other);
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
