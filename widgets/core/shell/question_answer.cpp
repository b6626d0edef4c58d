#include "widgets/core/shell/question_answer.h"

#include <QStringList>
#include <algorithm>

#include "widgets/core/language.h"
#include "widgets/core/panel/panel_base.h"
#include "widgets/core/walk/part_answers.h"

namespace lathelier {
namespace {

using State = QuestionAnswer::State;

QString toQString(const std::string& text)
{
    return QString::fromStdString(text);
}

/// Words of a verdict begin with its sign, which the box draws.
QString withoutSign(const QString& words)
{
    static const QStringList signs{QStringLiteral("✓"), QStringLiteral("✗"), QStringLiteral("?")};
    return !words.isEmpty() && signs.contains(words.left(1)) ? words.mid(1).trimmed() : words;
}

QString wholeAnswer(const report::Answer& answer)
{
    const Language language = screenLanguage();
    QStringList lines{toQString(report::valueLine(answer, language)), toQString(report::verdictText(answer, language)),
                      toQString(report::sentenceText(answer, language)),
                      toQString(report::assumedText(answer, language))};
    lines.removeAll(QString());
    return lines.join('\n');
}

State stateOf(const PanelBase& panel)
{
    if (panel.isBusy()) return State::Computing;
    if (panel.error()) return State::Failed;
    return panel.isCurrent() ? State::Answered : State::Outdated;
}

}  // namespace

QString signOf(const std::optional<Verdict>& verdict)
{
    if (!verdict) return {};
    switch (*verdict) {
        case Verdict::Pass: return QStringLiteral("✓");
        case Verdict::Fail: return QStringLiteral("✗");
        case Verdict::Undecided: return QStringLiteral("?");
    }
    return {};
}

QString shortAnswer(const report::Answer& answer)
{
    report::Answer bare = answer;
    bare.expanded_uncertainty.reset();
    const Language language = screenLanguage();
    if (QString value = toQString(report::valueText(bare, language)); !value.isEmpty()) return value;
    if (answer.verdict) return withoutSign(toQString(report::verdictText(answer, language)));
    return toQString(report::valueLine(answer, language));
}

QuestionAnswer questionAnswer(const report::Answer& answer)
{
    const bool assumed = std::any_of(answer.used.begin(), answer.used.end(),
                                     [](const UsedValue& used) { return used.origin == ValueOrigin::Assumed; });
    return {State::Answered, answer.verdict, shortAnswer(answer), wholeAnswer(answer), assumed};
}

QuestionAnswer questionAnswer(const PartAnswer& answer)
{
    QuestionAnswer box = answer.answer ? questionAnswer(*answer.answer) : QuestionAnswer{};
    box.assumed = box.assumed || answer.is_assumed;
    switch (answer.state) {
        case PartAnswer::State::Missing: box.state = State::Empty; break;
        case PartAnswer::State::Computing: box.state = State::Computing; break;
        case PartAnswer::State::Answered: box.state = State::Answered; break;
        case PartAnswer::State::Failed:
            box.state = State::Failed;
            if (answer.error) box.tooltip = screenText(*answer.error);
            if (box.text.isEmpty()) box.text = box.tooltip;
            break;
    }
    return box;
}

QuestionAnswer answerOfPanels(const std::vector<const PanelBase*>& panels)
{
    for (const PanelBase* panel : panels) {
        const auto shown = panel->shownAnswer();
        if (!shown) continue;
        QuestionAnswer answer = questionAnswer(*shown);
        answer.state = stateOf(*panel);
        if (panel->error()) answer.tooltip = screenText(*panel->error());
        return answer;
    }
    QuestionAnswer none;
    for (const PanelBase* panel : panels) {
        if (panel->isBusy()) return {State::Computing, {}, {}, {}, false};
        if (panel->error() && none.state == State::Empty)
            none = {State::Failed, {}, screenText(*panel->error()), screenText(*panel->error()), false};
    }
    return none;
}

}  // namespace lathelier
