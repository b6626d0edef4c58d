#include "engine/archive/result_lines.h"

#include <nlohmann/json.hpp>

#include "engine/archive/archive_codes.h"
#include "engine/core/utf8.h"
#include "engine/io/json/json_document.h"

namespace lathelier::archive {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t shownOfTorn = 40;

void readLine(std::string_view line, ResultLines& lines)
{
    if (line.find("\"recipe\"") != std::string_view::npos) {
        io::JsonDocument document{std::string(line)};
        const io::JsonCursor root = document.root();
        if (const auto recipe = root.isObject() ? root.member("recipe") : std::nullopt) {
            if (!recipe->isObject()) recipe->reject("the content of a recipe");
            lines.recipes.push_back(
                {root.at("sha256", "the SHA-256 of the recipe").string(), document.json()["recipe"].dump()});
            return;
        }
    }
    lines.evaluations.push_back(evaluationFrom(line));
}

/// A line knows itself as line 1.
[[noreturn]] void throwAtLine(const Error& error, std::int64_t line)
{
    Values values = error.values();
    set(values, "line", line);
    throw Error(error.code(), values);
}

/// At most so many bytes, without a character cut in two.
std::string beginOf(std::string_view text)
{
    std::size_t size = std::min(text.size(), shownOfTorn);
    while (size > 0 && !isUtf8(text.substr(0, size))) --size;
    return std::string(text.substr(0, size));
}

}  // namespace

ResultLines readResultLines(std::string_view text, const Progress& progress)
{
    ResultLines lines;
    std::int64_t number = 0;
    for (std::size_t from = 0; from < text.size();) {
        progress.report(static_cast<double>(from) / static_cast<double>(text.size()));
        ++number;
        const std::size_t to = text.find('\n', from);
        const std::string_view line = text.substr(from, to - from);
        const bool is_blank = line.find_first_not_of(blanks) == std::string_view::npos;
        if (to == std::string_view::npos && !is_blank)
            throw Error(errors::lineTorn, {{"line", number}, {"column", std::int64_t{1}}, {"found", beginOf(line)}});
        if (!is_blank) {
            try {
                readLine(line, lines);
            } catch (const Error& error) {
                throwAtLine(error, number);
            }
        }
        if (to == std::string_view::npos) break;
        from = to + 1;
    }
    return lines;
}

}  // namespace lathelier::archive
