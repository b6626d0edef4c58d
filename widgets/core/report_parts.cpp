#include "widgets/core/report_parts.h"

#include "engine/core/text.h"

namespace lathelier {

Document partWithoutAnswer(const PanelFacts& facts, const PanelState& state, const std::optional<Error>& error,
                           const Language& language)
{
    Section section{facts.title, {}};
    const std::vector<Text> missing = facts.missing ? facts.missing(state) : std::vector<Text>();
    for (const Text label : missing)
        section.blocks.push_back(Paragraph{LT_TEXT("Engine", "No answer: {input} is missing."), {{"input", label}}});
    if (missing.empty() && error)
        section.blocks.push_back(
            Paragraph{LT_TEXT("Engine", "No answer: {reason}"), {{"reason", text(*error, language)}}});
    if (section.blocks.empty())
        section.blocks.push_back(Paragraph{LT_TEXT("Engine", "No answer: the computation was stopped."), {}});
    Document document;
    document.title = facts.title;
    document.sections = {std::move(section)};
    return document;
}

}  // namespace lathelier
