// The characters of UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lathelier {

struct Utf8Character {
    char32_t code = 0;       ///< Unicode code point; 0 when there is none
    std::size_t length = 0;  ///< bytes; 0: no UTF-8
};

/// The character at byte `at`, which lies within `text`. Overlong forms, surrogates and what lies beyond U+10FFFF are
/// none.
Utf8Character utf8At(std::string_view text, std::size_t at);

bool isUtf8(std::string_view text);

/// Does this byte begin a character? In text that is UTF-8.
constexpr bool beginsCharacter(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

std::size_t countCharacters(std::string_view text);

/// The beginning of `text`, at most so many bytes, without a part of a character at its end.
std::string_view firstBytes(std::string_view text, std::size_t most);

/// The beginning of `text`, at most so many characters.
std::string_view firstCharacters(std::string_view text, std::size_t most);

/// Appends the character in UTF-8.
void appendUtf8(std::string& text, char32_t character);

}  // namespace lathelier
