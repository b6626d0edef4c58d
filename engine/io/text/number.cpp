#include "engine/io/text/number.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

namespace lathelier::io {

double detail::parseNumberSlowly(const char* at, const char* end, char decimal)
{
    if (at != end && *at == '+') ++at;  // from_chars rejects a plus sign
    std::string plain(at, end);
    std::replace(plain.begin(), plain.end(), decimal, '.');
    const std::size_t mark = plain.find_first_of("eEdD");
    if (mark != std::string::npos) {
        plain[mark] = 'e';
        if (mark + 1 < plain.size() && plain[mark + 1] == '+') plain.erase(mark + 1, 1);
    }
    double value = 0;
    const auto [stop, problem] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (problem != std::errc::result_out_of_range) return value;
    // Out of range is either too large or too small: decided by the order of the first significant digit.
    std::int64_t order = 0;
    if (mark != std::string::npos) {
        const auto [rest, failed] = std::from_chars(plain.data() + mark + 1, plain.data() + plain.size(), order);
        if (failed != std::errc()) order = plain[mark + 1] == '-' ? -1000000000000 : 1000000000000;
    }
    const std::string_view digits = std::string_view(plain).substr(0, mark);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::size_t significant = digits.find_first_of("123456789");
    order += static_cast<std::int64_t>(point) - static_cast<std::int64_t>(std::min(significant, digits.size()));
    const double size = order > 0 ? std::numeric_limits<double>::infinity() : 0.0;
    return plain.front() == '-' ? -size : size;
}

std::optional<double> wholeNumber(std::string_view text, char decimal)
{
    double value = 0;
    const char* end = text.data() + text.size();
    if (parseNumber(text.data(), end, decimal, value) != end || text.empty()) return std::nullopt;
    return value;
}

std::optional<std::int64_t> wholeInteger(std::string_view text)
{
    std::int64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem != std::errc() || stop != end) return std::nullopt;
    return value;
}

bool isNotFiniteWord(std::string_view text)
{
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
    if (text.empty() || text.size() > 12) return false;
    std::string word(text);
    for (char& c : word)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    if (word.starts_with("1.#") || word.starts_with("1,#")) return true;  // spellings of Microsoft's C runtime
    for (const char* known : {"nan", "inf", "infinity", "nan(ind)", "nan(snan)", "na", "n/a", "#n/a", "null", "none"})
        if (word == known) return true;
    return false;
}

}  // namespace lathelier::io
