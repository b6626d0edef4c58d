#include "engine/io/json/json_locate.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "engine/io/file.h"
#include "engine/io/text/encoding.h"

namespace lathelier::io {
namespace {

std::optional<std::int64_t> numberOf(const Error& error, const char* name)
{
    const Value* const value = find(error.values(), name);
    const auto* const number = value ? std::get_if<std::int64_t>(value) : nullptr;
    return number && *number > 0 ? std::optional(*number) : std::nullopt;
}

}  // namespace

void locate(Error& error, std::string_view text, const JsonPath& where)
{
    if (find(error.values(), "line")) return;
    try {
        parseJson(text);
    } catch (const Error&) {
        return;
    }
    const JsonPlace place = placeOf(text, where);
    error.with("line", place.line).with("column", place.column);
}

void locateInFile(Error& error, const std::string& path, const JsonPath& where)
{
    error.with("path", path);
    try {
        const FileBytes bytes(path);
        const DecodedText text = decodeText(bytes.view(), Encoding::Auto, {});
        locate(error, text.view(), where);
    } catch (const Error&) {
        return;  // the error that is reported is the one that was found in it
    }
}

void locateRow(Error& error, const std::string& path, const JsonPath& shaft)
{
    const std::optional<std::int64_t> segment = numberOf(error, "segment");
    const std::optional<std::int64_t> row = segment ? segment : numberOf(error, "row");
    if (!row) return;
    const Value* const contour = find(error.values(), "contour");
    const auto* const name = contour ? std::get_if<Text>(contour) : nullptr;
    JsonPath where = shaft;
    if (name && *name != LT_TEXT("Engine", "outside")) {
        where.emplace_back("bores");
    } else {
        where.emplace_back("segments");
        where.push_back(std::to_string(*row - 1));
    }
    locateInFile(error, path, where);
}

}  // namespace lathelier::io
