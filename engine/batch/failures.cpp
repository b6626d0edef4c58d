#include "engine/batch/failures.h"

#include <nlohmann/json.hpp>

#include "engine/core/texts.h"
#include "engine/io/file.h"
#include "engine/task/reply.h"

namespace lathelier::batch {
namespace {

std::optional<std::int64_t> placeIn(const Json& error, const char* name)
{
    const auto value = error.find(name);
    return value != error.end() && value->is_number_integer() ? std::optional(value->get<std::int64_t>())
                                                              : std::nullopt;
}

std::string wordIn(const Json& object, const char* name)
{
    const auto value = object.find(name);
    return value != object.end() && value->is_string() ? value->get<std::string>() : std::string();
}

Failure failureWith(std::size_t place, const std::string& part, const Json& error)
{
    Failure failure;
    failure.place = place;
    failure.path = wordIn(error, "path");
    if (failure.path.empty()) failure.path = part;
    failure.code = wordIn(error, "code");
    failure.line = placeIn(error, "line");
    failure.column = placeIn(error, "column");
    failure.byte = placeIn(error, "byte");
    return failure;
}

std::string quoted(const std::string& cell)
{
    if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
    std::string result = "\"";
    for (const char c : cell) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

std::string cellOf(const std::optional<std::int64_t>& number)
{
    return number ? std::to_string(*number) : std::string();
}

}  // namespace

Failure failureOf(std::size_t place, const std::string& part, const Error& error)
{
    Failure failure = failureWith(place, part, lathelier::toJson(error));
    failure.exit_code = task::exitCode(error.code().kind);
    failure.message = text(error);
    return failure;
}

Failure failureFrom(std::size_t place, const std::string& part, const Json& line)
{
    const Json none = Json::object();
    const auto result = line.find("result");
    const bool isThere = result != line.end() && result->is_object() && result->contains("error");
    Failure failure = failureWith(place, part, isThere ? (*result)["error"] : none);
    failure.exit_code = static_cast<int>(placeIn(line, "exit_code").value_or(0));
    failure.message = wordIn(line, "message");
    return failure;
}

Json toJson(const Failure& failure)
{
    Json json{{"path", failure.path}, {"exit_code", failure.exit_code}, {"code", failure.code}};
    if (failure.line) json["line"] = *failure.line;
    if (failure.column) json["column"] = *failure.column;
    if (failure.byte) json["byte"] = *failure.byte;
    json["message"] = failure.message;
    return json;
}

void writeFailures(const std::string& path, const std::vector<Failure>& failures)
{
    io::writeFile(path, [&](const io::Append& append) {
        append("file,exit_code,code,line,column,byte,message\r\n");
        for (const Failure& one : failures)
            append(quoted(one.path) + "," + std::to_string(one.exit_code) + "," + one.code + "," + cellOf(one.line) +
                   "," + cellOf(one.column) + "," + cellOf(one.byte) + "," + quoted(one.message) + "\r\n");
    });
}

}  // namespace lathelier::batch
