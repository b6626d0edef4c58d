#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>

#include "engine/cam/plan_codes.h"
#include "engine/cam/post/program_writer.h"

namespace lathelier::cam {

std::string commentText(const Post& post, const std::string& text)
{
    static constexpr std::pair<const char*, const char*> replaced[]{
        {"Ø", "D"},  {"µ", "U"},  {"·", "."},  {"×", "X"}, {"–", "-"}, {"…", "-"}, {"°", " DEG"}, {"ä", "AE"},
        {"ö", "OE"}, {"ü", "UE"}, {"ß", "SS"}, {"ą", "A"}, {"ć", "C"}, {"ę", "E"}, {"ł", "L"},    {"ń", "N"},
        {"ó", "O"},  {"ś", "S"},  {"ź", "Z"},  {"ż", "Z"}, {"Ł", "L"}, {"Ś", "S"}, {"Ż", "Z"},    {"Ó", "O"}};
    std::string ascii;
    for (std::size_t at = 0; at < text.size();) {
        const auto byte = static_cast<unsigned char>(text[at]);
        if (byte < 0x80) {
            ascii += text[at++];
            continue;
        }
        std::size_t length = 1;
        while (at + length < text.size() && (static_cast<unsigned char>(text[at + length]) & 0xC0) == 0x80) ++length;
        const std::string letter = text.substr(at, length);
        const auto* found = std::find_if(std::begin(replaced), std::end(replaced),
                                         [&](const auto& pair) { return letter == pair.first; });
        ascii += found != std::end(replaced) ? found->second : "?";
        at += length;
    }
    std::string result;
    for (const char c : ascii) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte > 0x7E || c == '%')
            result += ' ';
        else if (c == '(' || c == '[' || c == '{')
            result += '[';
        else if (c == ')' || c == ']' || c == '}')
            result += ']';
        else if (c == ';')
            result += ',';
        else
            result += static_cast<char>(std::toupper(byte));
    }
    if (result.size() > static_cast<std::size_t>(post.comment_length))
        result.resize(static_cast<std::size_t>(post.comment_length));
    return result;
}

std::string twoDigits(const Post& post, int tool)
{
    constexpr int largest = 99;
    if (tool > largest)
        throw Error(errors::postCannot, {{"post", post.name},
                                         {"what", LT_TEXT("Engine", "call a tool by a number above 99")},
                                         {"tool", std::int64_t{tool}}});
    return fmt::format("{:02}", tool);
}

}  // namespace lathelier::cam
