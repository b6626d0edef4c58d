#include "engine/report/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lathelier::report {
namespace {

std::string grouped(std::int64_t number)
{
    std::string digits = std::to_string(number);
    const std::size_t first = number < 0 ? 1 : 0;
    if (digits.size() - first <= 4) return digits;
    for (std::size_t at = digits.size(); at > first + 3;) {
        at -= 3;
        digits.insert(at, "\u202F");
    }
    return digits;
}

}  // namespace

std::string cellText(const Value& value, Text unit, int decimals, const Language& language)
{
    if (std::holds_alternative<std::monostate>(value)) return "–";
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return grouped(*whole);
    if (const auto* number = std::get_if<double>(&value))
        return std::isfinite(*number) ? shownNumber(*number, unit, decimals, language) : "–";
    if (const auto* ranges = std::get_if<std::vector<Interval>>(&value); ranges && ranges->empty()) return "–";
    return text(shownValue(value, unit, language), language);
}

std::string csvCell(const Value& value)
{
    if (const auto* number = std::get_if<double>(&value))
        return std::isfinite(*number) ? fmt::format("{}", *number) : std::string();
    std::string cell = std::holds_alternative<bool>(value) ? (std::get<bool>(value) ? "1" : "0") : text(value);
    if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
    std::string quoted = "\"";
    for (const char c : cell) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
}

bool isNumeric(const Value& value)
{
    return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value) ||
           std::holds_alternative<std::monostate>(value);
}

std::string keptTogether(std::string line)
{
    for (const std::string unit : {" mm", " µm", " in", " µin", " %", " UPR"})
        for (std::size_t at = line.find(unit); at != std::string::npos; at = line.find(unit, at + 1))
            line.replace(at, 1, "\u00A0");
    return line;
}

}  // namespace lathelier::report
