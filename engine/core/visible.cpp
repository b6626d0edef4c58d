#include "engine/core/visible.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace lathelier {
namespace {

struct Span {
    std::uint32_t first;
    std::uint32_t last;
};

/// Controls; soft hyphen; Arabic letter mark; Mongolian vowel separator; zero-width and direction marks; line and
/// paragraph separators, embeddings, overrides; isolates and invisible operators; byte order mark; annotations; tags.
constexpr std::array<Span, 11> hidden{{{0x00, 0x1F},
                                       {0x7F, 0x9F},
                                       {0xAD, 0xAD},
                                       {0x61C, 0x61C},
                                       {0x180E, 0x180E},
                                       {0x200B, 0x200F},
                                       {0x2028, 0x202E},
                                       {0x2060, 0x206F},
                                       {0xFEFF, 0xFEFF},
                                       {0xFFF9, 0xFFFB},
                                       {0xE0000, 0xE007F}}};

bool isHidden(std::uint32_t code)
{
    return std::any_of(hidden.begin(), hidden.end(), [code](Span s) { return code >= s.first && code <= s.last; });
}

struct Character {
    std::uint32_t code = 0;
    std::size_t length = 0;  ///< bytes; 0: no UTF-8
};

Character characterAt(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
    std::uint32_t code = lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {};
        code = code << 6U | (byte(i) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < least[length] || surrogate || code > 0x10FFFF ? Character{} : Character{code, length};
}

}  // namespace

std::string visible(std::string_view text, bool keepLines)
{
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Character character = characterAt(text);
        const bool isLine = keepLines && (text.front() == '\n' || text.front() == '\t');
        if (character.length == 0)
            result += fmt::format("<{:02X}>", static_cast<unsigned char>(text.front()));
        else if (isHidden(character.code) && !isLine)
            result += fmt::format("<U+{:04X}>", character.code);
        else
            result += text.substr(0, character.length);
        text.remove_prefix(std::max<std::size_t>(character.length, 1));
    }
    return result;
}

}  // namespace lathelier
