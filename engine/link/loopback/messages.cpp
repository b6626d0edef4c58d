#include "engine/link/loopback/messages.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/core/units.h"
#include "engine/io/json/json_document.h"

namespace lathelier::link {
namespace {

constexpr std::array asks{std::pair{Ask::Hello, "hello"}, std::pair{Ask::Read, "read"}, std::pair{Ask::Write, "write"},
                          std::pair{Ask::Program, "program"}};
constexpr std::size_t mostNames = 100;

Ask askFrom(const io::JsonCursor& member)
{
    const std::string word = member.string();
    for (const auto& [ask, name] : asks)
        if (word == name) return ask;
    member.reject(std::string("hello | read | write | program"));
}

io::JsonCursor answerOf(const io::JsonDocument& document, std::int64_t id)
{
    const io::JsonCursor number = document.root().at("id", id);
    if (number.integer() != id) number.reject(id);
    return document.root();
}

}  // namespace

std::string lineOf(const Message& message)
{
    Json json{{"id", message.id}};
    for (const auto& [ask, name] : asks)
        if (ask == message.ask) json["do"] = name;
    if (message.ask == Ask::Hello) json["version"] = messageVersion;
    if (message.ask == Ask::Read) json["names"] = message.names;
    if (message.ask == Ask::Write) json.update({{"name", message.name}, {"value", message.value}});
    return json.dump().append("\n");
}

Message messageFrom(const std::string& line)
{
    const io::JsonDocument document(line);
    const io::JsonCursor root = document.root();
    Message made;
    made.id = root.at("id", LT_TEXT("Engine", "the number of the message")).integer();
    made.ask = askFrom(root.at("do", std::string("hello | read | write | program")));
    if (made.ask == Ask::Hello) {
        const io::JsonCursor version = root.at("version", std::int64_t{messageVersion});
        if (version.integer() != messageVersion) version.reject(std::int64_t{messageVersion});
    }
    if (made.ask == Ask::Read)
        root.at("names", LT_TEXT("Engine", "names of values")).items(mostNames, [&](const io::JsonCursor& item) {
            made.names.push_back(item.string());
        });
    if (made.ask == Ask::Write) {
        made.name = root.at("name", LT_TEXT("Engine", "the name of a value")).string();
        made.value = root.at("value", LT_TEXT("Engine", "a number")).number();
    }
    return made;
}

std::string errorFrom(const std::string& line, std::int64_t id)
{
    const io::JsonDocument document(line);
    const auto error = answerOf(document, id).member("error");
    return error ? error->string() : std::string();
}

ControlValues valuesFrom(const std::string& line, std::int64_t id, const std::vector<std::string>& names)
{
    const io::JsonDocument document(line);
    const io::JsonCursor values = answerOf(document, id).at("values", LT_TEXT("Engine", "values by name"));
    ControlValues read;
    for (const std::string& name : names) {
        const auto value = values.member(name);  // null: a register that holds no number
        read[name] = value ? value->number() : notANumber;
    }
    return read;
}

void requireHello(const std::string& line, std::int64_t id)
{
    const io::JsonDocument document(line);
    const io::JsonCursor version = answerOf(document, id).at("version", std::int64_t{messageVersion});
    if (version.integer() != messageVersion) version.reject(std::int64_t{messageVersion});
}

void requireWritten(const std::string& line, std::int64_t id)
{
    const io::JsonDocument document(line);
    const io::JsonCursor written = answerOf(document, id).at("written", std::string("true"));
    if (!written.flag()) written.reject(std::string("true"));
}

std::string programFrom(const std::string& line, std::int64_t id)
{
    const io::JsonDocument document(line);
    const auto program = answerOf(document, id).member("program");
    return program ? program->string() : std::string();
}

}  // namespace lathelier::link
