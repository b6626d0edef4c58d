// Conversion to windows-1252, expected by older programs of measuring machines.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace lathelier::io {

/// Characters of the bytes 0x80…0x9F in windows-1252.
inline constexpr std::array<char16_t, 32> windows1252 = {
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

/// UTF-8 as windows-1252; none when a character is not representable, or when the bytes would be valid UTF-8 and be
/// misread.
std::optional<std::string> toWindows1252(std::string_view utf8);

}  // namespace lathelier::io
