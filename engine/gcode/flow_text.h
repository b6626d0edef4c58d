// Parsing helpers for control statements. Internal to the room.
#pragma once

#include <cctype>
#include <cstdlib>
#include <string>
#include <string_view>

namespace lathelier::gcode {

inline std::string capitals(std::string_view text)
{
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return result;
}

inline std::string_view trimmedFront(std::string_view text)
{
    const std::size_t from = text.find_first_not_of(" \t");
    return from == std::string_view::npos ? std::string_view() : text.substr(from);
}

/// The letters that `text` begins with, in capitals.
inline std::string keywordOf(std::string_view text)
{
    std::size_t end = 0;
    while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end]))) ++end;
    return capitals(text.substr(0, end));
}

inline long numberIn(std::string_view text)
{
    const std::size_t digit = text.find_first_of("0123456789");
    return digit == std::string_view::npos ? -1 : std::atol(std::string(text.substr(digit, 9)).c_str());
}

}  // namespace lathelier::gcode
