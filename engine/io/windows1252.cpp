#include "engine/io/windows1252.h"

#include <algorithm>

#include "engine/io/encoding.h"

namespace lathelier {
namespace {

/// The next character of valid UTF-8.
char32_t takeCharacter(std::string_view utf8, std::size_t& at)
{
    const auto byte = [&utf8](std::size_t i) { return i < utf8.size() ? static_cast<unsigned char>(utf8[i]) : 0U; };
    const char32_t lead = byte(at);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    char32_t c = length == 1 ? lead : lead & (0xFFU >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) c = (c << 6) | (byte(at + k) & 0x3F);
    at += length;
    return c;
}

}  // namespace

std::optional<std::string> toWindows1252(std::string_view utf8)
{
    std::string result;
    for (std::size_t at = 0; at < utf8.size();) {
        const char32_t c = takeCharacter(utf8, at);
        if (c < 0x80 || (c >= 0xA0 && c <= 0xFF)) {
            result += static_cast<char>(c);
            continue;
        }
        const auto known = std::find(windows1252.begin(), windows1252.end(), c);
        if (known == windows1252.end()) return std::nullopt;
        result += static_cast<char>(0x80 + (known - windows1252.begin()));
    }
    const bool isAscii =
        std::all_of(result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    if (!isAscii && decodeText(result, Encoding::Auto).encoding() != "latin-1") return std::nullopt;
    return result;
}

}  // namespace lathelier
