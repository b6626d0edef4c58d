#include "engine/core/item_numbers.h"

#include <algorithm>
#include <cmath>

#include "engine/core/item_codes.h"

namespace lathelier {

std::optional<std::vector<double>> numbersIn(const Values& values, std::string_view name)
{
    const Value* const value = find(values, name);
    if (!value) return std::nullopt;
    std::vector<double> result;
    if (const auto* numbers = std::get_if<std::vector<double>>(value))
        result = *numbers;
    else if (const auto* whole = std::get_if<std::vector<std::int64_t>>(value))
        result.assign(whole->begin(), whole->end());
    else
        return std::nullopt;
    const bool finite = std::all_of(result.begin(), result.end(), [](double number) { return std::isfinite(number); });
    return finite ? std::optional(std::move(result)) : std::nullopt;
}

void requireKeepable(std::size_t lines)
{
    if (lines > mostItemNumbers)
        throw Error(errors::linesTooMany, {{"lines", static_cast<std::int64_t>(lines)},
                                           {"maximum", static_cast<std::int64_t>(mostItemNumbers)}});
}

}  // namespace lathelier
