#include "engine/io/json/json_head.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

/// Position after the string that begins at `at`; the end of the text when it is unterminated.
std::size_t behindString(std::string_view text, std::size_t at)
{
    for (++at; at < text.size(); ++at) {
        if (text[at] == '\\')
            ++at;
        else if (text[at] == '"')
            return at + 1;
    }
    return text.size();
}

std::vector<std::string> keysOfText(std::string_view text)
{
    std::vector<std::string> keys;
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n")));
    if (!text.starts_with('{')) return keys;
    int depth = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"') {
            const std::size_t end = behindString(text, at);
            const std::size_t next = text.find_first_not_of(" \t\r\n", end);
            if (depth == 1 && next != std::string_view::npos && text[next] == ':')
                keys.emplace_back(text.substr(at + 1, end - at - 2));
            at = end;
            continue;
        }
        depth += (c == '{' || c == '[') - (c == '}' || c == ']');
        if (depth == 0) break;
        ++at;
    }
    return keys;
}

}  // namespace

std::vector<std::string> keysOfHead(std::string_view head)
{
    // Only such heads are decoded. A byte order mark or bytes of UTF-16/32 may precede the brace.
    constexpr std::string_view before("\xef\xbb\xbf\xff\xfe\0 \t\r\n", 10);
    const std::size_t first = head.find_first_not_of(before);
    if (first == std::string_view::npos || head[first] != '{') return {};
    try {
        return keysOfText(decodeText(head, Encoding::Auto).view());
    } catch (const Error&) {  // not a text
        return {};
    }
}

bool hasKey(const std::vector<std::string>& keys, std::string_view key)
{
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace lathelier::io
