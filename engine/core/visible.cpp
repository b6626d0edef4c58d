#include "engine/core/visible.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "engine/core/utf8.h"

namespace lathelier {
namespace {

struct Span {
    char32_t first;
    char32_t last;
};

/// Controls; soft hyphen; Arabic letter mark; Mongolian vowel separator; zero-width and direction marks; line and
/// paragraph separators, embeddings, overrides; isolates and invisible operators; code points that are no characters,
/// which XML does not allow; byte order mark; annotations; tags.
constexpr std::array<Span, 12> hidden{{{0x00, 0x1F},
                                       {0x7F, 0x9F},
                                       {0xAD, 0xAD},
                                       {0x61C, 0x61C},
                                       {0x180E, 0x180E},
                                       {0x200B, 0x200F},
                                       {0x2028, 0x202E},
                                       {0x2060, 0x206F},
                                       {0xFDD0, 0xFDEF},
                                       {0xFEFF, 0xFEFF},
                                       {0xFFF9, 0xFFFB},
                                       {0xE0000, 0xE007F}}};

bool isHidden(char32_t code)
{
    constexpr char32_t lastTwo = 0xFFFE;  // the last two code points of each plane are no characters
    if ((code & lastTwo) == lastTwo) return true;
    return std::any_of(hidden.begin(), hidden.end(), [code](Span s) { return code >= s.first && code <= s.last; });
}

}  // namespace

std::string visible(std::string_view text, bool keepLines)
{
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const Utf8Character character = utf8At(text, at);
        const bool isLine = keepLines && (character.code == '\n' || character.code == '\t');
        if (character.length == 0)
            result += fmt::format("<{:02X}>", static_cast<unsigned char>(text[at]));
        else if (isHidden(character.code) && !isLine)
            result += fmt::format("<U+{:04X}>", static_cast<std::uint32_t>(character.code));
        else
            result += text.substr(at, character.length);
        at += std::max<std::size_t>(character.length, 1);
    }
    return result;
}

}  // namespace lathelier
