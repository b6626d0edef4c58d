#include "engine/gcode/cycle_arguments.h"

#include <algorithm>

#include "engine/gcode/declared_names.h"

namespace lathelier::gcode {

CycleArguments::CycleArguments(std::string_view call, const Variables& variables)
{
    const std::size_t open = call.find('('), close = call.rfind(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return;
    for (const std::string_view part : splitArguments(call.substr(open + 1, close - open - 1))) {
        values_.emplace_back();
        texts_.emplace_back();
        if (part.empty()) continue;
        if (part.front() == '"') {
            texts_.back() = part.substr(1, part.find('"', 1) - 1);
            continue;
        }
        const Computed found = compute(part, variables);
        if (found.end < part.size())
            throw ExpressionFailure{LT_TEXT("Engine", "something is left behind it"), found.end};
        if (!found.unknown.empty() && unknown_.empty()) unknown_ = found.unknown;
        values_.back() = found.value;
    }
}

const std::string& CycleArguments::text(std::size_t at) const
{
    static const std::string none;
    return at < texts_.size() ? texts_[at] : none;
}

bool CycleArguments::hasMore(std::size_t from) const
{
    for (std::size_t i = from; i < values_.size(); ++i)
        if (number(i) != 0 || !texts_[i].empty()) return true;
    return false;
}

bool CycleArguments::isNegative(std::initializer_list<std::size_t> places) const
{
    return std::any_of(places.begin(), places.end(), [this](std::size_t at) { return number(at) < 0; });
}

}  // namespace lathelier::gcode
