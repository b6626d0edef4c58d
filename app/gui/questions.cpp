#include "app/gui/questions.h"

#include <algorithm>
#include <map>

namespace lathelier {

std::vector<Question> questionsOf(const std::vector<PanelFacts>& panels)
{
    std::vector<Question> all;
    for (const PanelFacts& panel : panels)
        if (std::none_of(all.begin(), all.end(), [&](const Question& known) { return known.id == panel.question.id; }))
            all.push_back(panel.question);
    std::stable_sort(all.begin(), all.end(), [](const Question& a, const Question& b) { return a.order < b.order; });
    return all;
}

/// "roundness", "deflection" and "training" were workspaces and are questions. A project kept with "copy" was at the
/// chain from the scan on; now Copy is the comparison, so that such a project opens there.
std::string questionFor(const std::string& kept, const std::vector<Question>& questions)
{
    static const std::map<std::string, std::string> workspaces{{"inspection", "copy"}, {"chatter", "speed"}};
    const auto old = workspaces.find(kept);
    const std::string& wanted = old == workspaces.end() ? kept : old->second;
    const auto known = std::find_if(questions.begin(), questions.end(),
                                    [&](const Question& question) { return question.id == wanted; });
    if (known != questions.end()) return wanted;
    return questions.empty() ? std::string() : questions.front().id;
}

}  // namespace lathelier
