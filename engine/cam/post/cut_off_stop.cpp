#include "engine/cam/post/cut_off_stop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace lathelier::cam {
namespace {

constexpr std::string_view statedBefore = "CUT OFF TO ", statedAfter = " FIRST";

std::string upperCase(std::string_view text)
{
    std::string upper(text);
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return upper;
}

/// The length in a line such as "(CUT OFF TO 93.0 FIRST)".
std::optional<double> lengthIn(std::string_view line)
{
    const std::size_t at = line.find(statedBefore);
    if (at == std::string_view::npos) return {};
    const std::string_view rest = line.substr(at + statedBefore.size());
    double length = 0;
    const auto [end, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), length);
    if (fault != std::errc() || !(length > 0)) return {};
    return rest.substr(static_cast<std::size_t>(end - rest.data())).starts_with(statedAfter) ? std::optional(length)
                                                                                             : std::nullopt;
}

/// True for a block of a program stop, with a block number or without.
bool isStop(std::string_view line)
{
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    std::string words;
    std::copy_if(line.begin(), line.end(), std::back_inserter(words), [&](char c) { return !is_blank(c); });
    std::size_t at = 0;
    if (words.starts_with('N'))
        for (at = 1; at < words.size() && std::isdigit(static_cast<unsigned char>(words[at]));) ++at;
    const std::string_view code = std::string_view(words).substr(at);
    return code == "M0" || code == "M00";
}

}  // namespace

std::string cutOffComment(double length_mm)
{
    std::string length = fmt::format("{:.3f}", length_mm);
    while (length.back() == '0' && length[length.size() - 2] != '.') length.pop_back();
    return "cut off to " + length + " first";
}

std::optional<double> cutOffOf(std::string_view program)
{
    std::optional<double> stated;
    for (std::size_t from = 0; from < program.size();) {
        const std::size_t end = std::min(program.find('\n', from), program.size());
        const std::string line = upperCase(program.substr(from, end - from));
        from = end + 1;
        if (stated && isStop(line)) return stated;
        stated = lengthIn(line);
    }
    return {};
}

}  // namespace lathelier::cam
