#include "engine/archive/dates.h"

#include <charconv>
#include <chrono>
#include <optional>
#include <string_view>

#include "engine/core/core_codes.h"

namespace lathelier::archive {
namespace {

std::optional<unsigned> digits(std::string_view word)
{
    unsigned number = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (problem != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
}

bool isDate(std::string_view date)
{
    if (date.size() != 10 || date[4] != '-' || date[7] != '-') return false;
    const auto year = digits(date.substr(0, 4)), month = digits(date.substr(5, 2)), day = digits(date.substr(8, 2));
    if (!year || !month || !day) return false;
    return std::chrono::year_month_day(std::chrono::year(static_cast<int>(*year)), std::chrono::month(*month),
                                       std::chrono::day(*day))
        .ok();
}

}  // namespace

void requireDate(const std::string& name, const std::string& date)
{
    if (!isDate(date))
        throw Error(
            errors::valueNotUnderstood,
            {{"parameter", name}, {"found", date}, {"expected", LT_TEXT("Engine", "a date such as 2026-11-29")}});
}

}  // namespace lathelier::archive
