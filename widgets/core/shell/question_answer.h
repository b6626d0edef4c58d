// What a box of the question bar says: the state of its question and a short answer.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/report/answer.h"

namespace lathelier {

class PanelBase;
struct PartAnswer;

struct QuestionAnswer {
    enum class State {
        Empty,      ///< nothing was asked
        Computing,  ///< `text` may be that of the earlier answer
        Answered,
        Failed,    ///< an error
        Outdated,  ///< an input has changed since
    };
    State state = State::Empty;
    std::optional<Verdict> verdict;  ///< of an answer; none: no limit
    QString text;                    ///< "126.8 mm"
    QString tooltip;                 ///< the whole answer, or the error
    bool assumed = false;            ///< it rests on assumed values
};

/// Value and unit of the screen, with the decimals of the answer strip and without the uncertainty: "126.8 mm". Without
/// a value the words of the verdict, without a verdict the quantity.
QString shortAnswer(const report::Answer& answer);

/// "✓", "✗", "?"; empty: no limit.
QString signOf(const std::optional<Verdict>& verdict);

/// An answer as a box says it.
QuestionAnswer questionAnswer(const report::Answer& answer);

/// An answer of the background likewise.
QuestionAnswer questionAnswer(const PartAnswer& answer);

/// Of the first of the panels of a question that shows a result; without one, whether any computes or has failed.
QuestionAnswer answerOfPanels(const std::vector<const PanelBase*>& panels);

}  // namespace lathelier
