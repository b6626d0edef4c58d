#include "engine/core/verdict_json.h"

#include <nlohmann/json.hpp>

namespace lathelier {

Json verdictJson(const std::optional<Verdict>& verdict)
{
    return verdict ? Json(std::string(key(*verdict))) : Json(nullptr);
}

std::optional<Verdict> verdictOf(std::string_view word)
{
    for (const Verdict verdict : {Verdict::Pass, Verdict::Fail, Verdict::Undecided})
        if (word == key(verdict)) return verdict;
    return std::nullopt;
}

}  // namespace lathelier
