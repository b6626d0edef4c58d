#include "engine/cam/post/word_text.h"

#include <cmath>
#include <cstdlib>

namespace lathelier::cam {

std::string numberText(std::int64_t units, int decimals, bool point)
{
    std::string digits = std::to_string(std::abs(units));
    if (digits.size() <= static_cast<std::size_t>(decimals))
        digits.insert(0, static_cast<std::size_t>(decimals) + 1 - digits.size(), '0');
    std::string text = digits.substr(0, digits.size() - static_cast<std::size_t>(decimals));
    std::string fraction = digits.substr(digits.size() - static_cast<std::size_t>(decimals));
    while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
    if (!fraction.empty())
        text.append(1, '.').append(fraction);
    else if (point)
        text += ".";
    if (units < 0) text.insert(text.begin(), '-');
    return text;
}

std::string wordText(const char* letter, std::int64_t units, int decimals, bool point)
{
    std::string text(letter);  // appended: GCC 12 warns wrongly of literal + string
    text += numberText(units, decimals, point);
    return text;
}

std::int64_t unitsOf(double value, int decimals)
{
    return std::llround(value * std::pow(10, decimals));
}

std::string filledTemplate(const std::string& pattern, const std::function<std::string(const std::string&)>& value_of)
{
    std::string text;
    for (std::size_t at = 0; at < pattern.size();) {
        const std::size_t end = pattern[at] == '{' ? pattern.find('}', at) : std::string::npos;
        if (end == std::string::npos) {
            text += pattern[at++];
            continue;
        }
        text += value_of(pattern.substr(at + 1, end - at - 1));
        at = end + 1;
    }
    return text;
}

}  // namespace lathelier::cam
