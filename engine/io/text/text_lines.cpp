#include "engine/io/text/text_lines.h"

#include <algorithm>

#include "engine/io/io_codes.h"
#include "engine/io/text/encoding.h"

namespace lathelier::io {
namespace {

constexpr std::size_t longestLine = std::size_t{1} << 20;

}  // namespace

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool Lines::next()
{
    if (next_ >= text_.size()) return false;
    begin_ = next_;
    std::size_t p = begin_;
    while (p < text_.size() && text_[p] != '\n' && text_[p] != '\r') ++p;
    length_ = p - begin_;
    if (length_ > longestLine) {
        const std::string_view start = text_.substr(begin_, 100);
        throw malformed(number_ + 1, start, start, LT_TEXT("Engine", "a line of at most 1 MiB"));
    }
    if (p < text_.size()) p += text_[p] == '\r' && p + 1 < text_.size() && text_[p + 1] == '\n' ? 2U : 1U;
    next_ = p;
    ++number_;
    return true;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

void splitWords(std::string_view line, std::vector<std::string_view>& words)
{
    words.clear();
    std::size_t p = 0;
    while (p < line.size()) {
        if (isBlank(line[p])) {
            ++p;
            continue;
        }
        const std::size_t begin = p;
        while (p < line.size() && !isBlank(line[p])) ++p;
        words.push_back(line.substr(begin, p - begin));
    }
}

Error malformed(std::int64_t number, std::string_view line, std::string_view part, Text expected)
{
    const auto offset = static_cast<std::size_t>(part.data() - line.data());
    Value found = LT_TEXT("Engine", "the end of the line");
    if (!trimmed(part).empty() || offset + part.size() < line.size()) found = excerpt(part);
    return Error(errors::malformed,
                 {{"line", number}, {"column", columnAt(line, offset)}, {"found", found}, {"expected", expected}});
}

Error malformedEnd(const Lines& lines, Text expected)
{
    return Error(errors::malformed, {{"line", std::max<std::int64_t>(lines.number(), 1)},
                                     {"column", columnAt(lines.line(), lines.line().size())},
                                     {"found", LT_TEXT("Engine", "the end of the file")},
                                     {"expected", expected}});
}

}  // namespace lathelier::io
