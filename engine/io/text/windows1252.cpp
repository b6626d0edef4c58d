#include "engine/io/text/windows1252.h"

#include <algorithm>

#include "engine/core/utf8.h"
#include "engine/io/text/encoding.h"

namespace lathelier::io {
std::optional<std::string> toWindows1252(std::string_view utf8)
{
    std::string result;
    for (std::size_t at = 0; at < utf8.size();) {
        const auto [c, length] = utf8At(utf8, at);
        if (length == 0) return std::nullopt;
        at += length;
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

}  // namespace lathelier::io
