#include "engine/link/exchange.h"

#include <nlohmann/json.hpp>

#include "engine/core/quantities.h"
#include "engine/core/units.h"
#include "engine/core/version.h"
#include "engine/io/file.h"
#include "engine/io/json/json_document.h"

namespace lathelier::link {
namespace {

constexpr const char* eventNames[] = {"opened", "exchange", "refused", "lost", "taken", "closed"};

Json orNull(const std::optional<double>& value)
{
    return value ? Json(*value) : Json();
}

Json errorObject(const std::optional<Error>& error)
{
    if (!error) return {};
    Json json = nestedJson(error->values());
    json["code"] = error->code().key;
    return json;
}

std::optional<double> numberAt(const io::JsonCursor& object, const char* key)
{
    const auto member = object.member(key);
    return member ? std::optional(member->number()) : std::nullopt;
}

Exchange exchangeFrom(const io::JsonCursor& line)
{
    Exchange made;
    made.time = line.at("time", LT_TEXT("Engine", "a time")).string();
    made.request = line.at("request", LT_TEXT("Engine", "the number of a request")).integer();
    line.at("read", LT_TEXT("Engine", "the values that were read"))
        .members(io::mostJsonMembers, [&](const std::string& name, const io::JsonCursor& value) {
            made.read[name] = value.isNull() ? notANumber : value.number();
        });
    const io::JsonCursor state = line.at("state", LT_TEXT("Engine", "the number of a state"));
    const std::optional<State> known = stateOfNumber(state.integer());
    if (!known) state.reject(LT_TEXT("Engine", "the number of a state"));
    made.reply.state = *known;
    made.reply.n_cor_rpm = numberAt(line, "n_cor_rpm");
    made.reply.selected_rpm = numberAt(line, "selected_rpm");
    if (const auto program = line.member("program")) {
        ProgramBar bar;
        bar.path = program->at("path", LT_TEXT("Engine", "the path of a file")).string();
        bar.sha256 = program->at("sha256", LT_TEXT("Engine", "a SHA-256")).string();
        made.reply.program = bar;
    }
    return made;
}

}  // namespace

Json toJson(const Exchange& exchange)
{
    Json read = Json::object();
    for (const auto& [name, value] : exchange.read) read[name] = value;
    Json json{{"time", exchange.time},
              {"event", eventNames[static_cast<int>(LinkEvent::Exchanged)]},
              {"request", exchange.request},
              {"read", std::move(read)},
              {"state", static_cast<int>(exchange.reply.state)},
              {"state_name", nameOf(exchange.reply.state)},
              {"selected_rpm", orNull(exchange.reply.selected_rpm)},
              {"n_cor_rpm", orNull(exchange.reply.n_cor_rpm)},
              {"written_rpm", orNull(exchange.written_rpm)},
              {"read_back_rpm", orNull(exchange.read_back_rpm)},
              {"duration_ms", exchange.duration_ms}};
    if (const auto& program = exchange.reply.program)
        json["program"] = {{"path", program->path},
                           {"sha256", program->sha256},
                           {"diameter_mm", program->diameter_mm},
                           {"length_mm", program->length_mm}};
    for (const Assumed& one : exchange.reply.assumed)
        json["assumed"].push_back({{"what", one.what}, {"value", one.value}});
    if (exchange.reply.error) json["error"] = errorObject(exchange.reply.error);
    return json;
}

Json toJson(const LogEntry& entry)
{
    if (entry.exchange) return toJson(*entry.exchange);
    Json json{{"time", entry.time}, {"event", eventNames[static_cast<int>(entry.event)]}};
    if (entry.event == LinkEvent::Opened)
        json.update({{"link", entry.kind},
                     {"peer", entry.peer},
                     {"version", programVersion},
                     {"config_sha256", entry.config_sha256},
                     {"is_verified", entry.is_verified}});
    if (entry.error) json["error"] = errorObject(entry.error);
    return json;
}

std::vector<LoggedExchange> exchangesOf(std::string_view log, const Progress& progress)
{
    std::vector<LoggedExchange> all;
    std::int64_t number = 0;
    for (std::size_t end = log.find('\n'); end != std::string_view::npos; end = log.find('\n')) {
        progress.check();
        ++number;
        try {
            const io::JsonDocument document{std::string(log.substr(0, end))};
            const io::JsonCursor line = document.root();
            const std::string event = line.at("event", LT_TEXT("Engine", "an event of the link")).string();
            if (event == eventNames[static_cast<int>(LinkEvent::Exchanged)])
                all.push_back({number, exchangeFrom(line)});
        } catch (const Error& error) {
            Error placed(error.code(), {{"line", number}});  // of the log, not of its one line
            for (const auto& [name, value] : error.values()) placed.with(name, value);
            throw Error(placed);
        }
        log.remove_prefix(end + 1);
    }
    return all;
}

Log readLog(const std::string& path, const Progress& progress)
{
    try {
        const io::FileBytes file(path, progress);
        const auto bytes = static_cast<std::int64_t>(file.view().size());
        return {exchangesOf(file.view(), progress), {path, bytes, io::sha256(file.view(), progress)}};
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace lathelier::link
