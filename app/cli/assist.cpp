// assist: the assistant beside a control; its simulator; the replay of its log.
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/verbs.h"
#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_document.h"
#include "engine/link/link_codes.h"
#include "engine/link/loopback/simulated_control.h"
#include "engine/link/transports.h"

namespace lathelier {

namespace cli {
namespace {

constexpr int lookEvery_ms = 20;           // of the simulator at a stop and at what was written
constexpr std::size_t mostTyped = 100000;  // characters of a line that is typed to the simulator

struct AssistOptions {
    std::string link;
    std::string config;
    bool once = false;
    std::string log;
    std::string replay;
    std::optional<double> simulate;
};

const std::vector<Field<AssistOptions>>& fieldsOf(const AssistOptions*)
{
    using A = AssistOptions;
    static const std::vector<Field<A>> all{
        field("link", &A::link, Label{{"Link"}, {"Kind of the control: loopback, linuxcnc or focas."}}),
        field("config", &A::config,
              Label{{"Configuration"}, {"ASSIST.json: machine, limits, address of the control."}}),
        field("once", &A::once, Label{{"Once"}, {"End after one request was answered."}}),
        field("log", &A::log, Label{{"Log"}, {"Append every exchange to this file, JSON Lines."}}),
        field("replay", &A::replay, Label{{"Replay"}, {"Answer the exchanges of this log anew, without a control."}}),
        field("simulate", &A::simulate, Range{1, 65535},
              Label{{"Simulate"},
                    {"Be a simulated control on this port; lines of standard input set its values and ask: "
                     "{\"diameter_mm\": 32, \"request\": true}."}})};
    return all;
}

/// Appends lines to a file; each is whole or, after a power cut, torn at the end. Error fileNotWritable.
class LogFile {
public:
    explicit LogFile(std::string path) : path_(std::move(path))
    {
        if (path_.empty()) return;
        file_.open(path_, std::ios::app | std::ios::binary);
        requireWritten();
    }
    void append(const Json& entry)
    {
        if (path_.empty()) return;
        file_ << entry.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
        requireWritten();
    }

private:
    void requireWritten() const
    {
        if (!file_)
            throw Error(errors::fileNotWritable, {{"path", path_}, {"reason", std::string(std::strerror(errno))}});
    }

    std::string path_;
    std::ofstream file_;
};

std::string lineFor(const link::Exchange& exchange)
{
    Values values{{"request", exchange.request}, {"state", link::textOf(exchange.reply.state)}};
    set(values, "selected", exchange.reply.selected_rpm.value_or(notANumber));
    set(values, "corrected", exchange.reply.n_cor_rpm.value_or(notANumber));
    if (exchange.reply.state == link::State::Ok)
        return fill("Request {request}: {selected:0} -> {corrected:0} 1/min\n", values);
    return fill("Request {request} refused: {state}\n", values);
}

std::string lineFor(const link::LogEntry& entry)
{
    if (entry.exchange) return lineFor(*entry.exchange);
    if (entry.error) return text(*entry.error) + "\n";
    return entry.event == link::LinkEvent::Opened ? fill("Linked to {peer}\n", {{"peer", entry.peer}})
                                                  : std::string("Closed\n");
}

/// Members of a line of standard input: values by name, "program", and "request": true.
void typed(const std::string& line, link::SimulatedControl& control)
{
    const io::JsonDocument document(line);
    bool asks = false;
    document.root().members(io::mostJsonMembers, [&](const std::string& name, const io::JsonCursor& value) {
        const auto& known = link::readNames();
        if (name == link::requestName)
            asks = value.flag();
        else if (name == "program")
            control.setProgram(value.string());
        else if (std::find(known.begin(), known.end(), name) != known.end())
            control.set(name, value.number());
        else
            value.reject(LT_TEXT("Engine", "the name of a value that a control states"));
    });
    if (asks) control.request();
}

bool isAnswered(const link::ControlValues& values)
{
    return values.at(link::answeredName) == values.at(link::requestName);
}

Json asJson(const link::ControlValues& values)
{
    Json json = Json::object();
    for (const auto& [name, value] : values) json[name] = value;
    return json;
}

/// Serves until standard input ends and nothing asked is unanswered, or until it is stopped.
void simulate(int port, const Request& request, const Progress& progress, Answer& answer)
{
    link::SimulatedControl control(port);
    if (!request.in_full)
        std::cout << fill("Simulated control on port {port}\n", {{"port", std::int64_t{port}}}) << std::flush;
    std::string pending;
    bool is_open = true;
    std::optional<double> shown;
    while (is_open || !isAnswered(control.values())) {
        progress.check();
        const link::ControlValues now = control.values();
        const bool is_idle = isAnswered(now);  // one request after another
        pollfd input{STDIN_FILENO, POLLIN, 0};
        const bool is_ready = is_open && is_idle && ::poll(&input, 1, lookEvery_ms) > 0;
        if (!is_idle) std::this_thread::sleep_for(std::chrono::milliseconds(lookEvery_ms));
        if (now.at(link::answeredName) != 0 && is_idle && shown != now.at(link::answeredName)) {
            shown = now.at(link::answeredName);
            if (!request.in_full) std::cout << asJson(now).dump() << '\n' << std::flush;
        }
        if (!is_ready) continue;
        char sign = 0;
        const ssize_t got = ::read(STDIN_FILENO, &sign, 1);
        if (got <= 0) is_open = false;
        if (got == 1 && sign != '\n') pending += sign;
        if (pending.size() > mostTyped)
            refuseOption("simulate", pending.substr(0, 80), LT_TEXT("Engine", "shorter lines"));
        if (pending.empty() || (got == 1 && sign != '\n')) continue;
        typed(pending, control);
        pending.clear();
    }
    answer.json = [values = control.values()] { return Json{{"values", asJson(values)}}; };
    if (control.correctedRpm()) answer.summary = fill("N_cor {value:0} 1/min\n", {{"value", *control.correctedRpm()}});
}

void replayLog(const link::Log& log, link::Assistant& assistant, const Progress& progress, Answer& answer)
{
    const link::Replayed found = link::replay(log.exchanges, assistant, progress);
    answer.summary = fill("{exchanges} exchanges, {differing} answered otherwise today.\n",
                          {{"exchanges", found.exchanges}, {"differing", found.differing}});
    answer.json = [found] { return Json{{"exchanges", found.exchanges}, {"differing", found.differing}}; };
    if (found.differing > 0)
        answer.errors.emplace_back(errors::linkLogDiffers, Values{{"path", log.file.path},
                                                                  {"line", found.first_differing_line},
                                                                  {"count", found.differing},
                                                                  {"exchanges", found.exchanges}});
}

void assist(const AssistOptions& options, const link::LinkConfig& config, link::Assistant& assistant,
            const Request& request, const Progress& progress, Answer& answer)
{
    const auto transport = link::transportOf(options.link, config);
    if (!transport->isVerified()) answer.notes.push_back({notes::linkNotVerified, {{"kind", options.link}}});
    LogFile log(options.log);
    std::optional<Error> refused;
    const auto tell = [&](link::LogEntry entry) {
        if (entry.event == link::LinkEvent::Refused) refused = entry.error;
        entry.kind = options.link;
        entry.config_sha256 = config.file.sha256;
        log.append(link::toJson(entry));
        if (!request.in_full) std::cout << lineFor(entry) << std::flush;
    };
    link::LinkLoop loop(*transport, assistant, link::loopSettings(config, options.once), tell);
    loop.run(progress);
    progress.check();
    if (!loop.last() && refused) throw Error(*refused);  // a request that is none
    const link::Exchange last = loop.last().value_or(link::Exchange{});
    answer.json = [last] { return link::toJson(last); };
    if (last.reply.state == link::State::Ok) return;
    Values values{{"state", link::textOf(last.reply.state)}, {"number", static_cast<std::int64_t>(last.reply.state)}};
    set(values, "request", last.request);
    answer.errors.emplace_back(errors::linkRefused, values);
    if (last.reply.error) answer.errors.push_back(*last.reply.error);
}

void runAssist(const Request& request, io::InputFiles&, const Progress& progress, Answer& answer)
{
    const auto options = fromValues<AssistOptions>(request.parameters);
    if (options.simulate) return simulate(static_cast<int>(*options.simulate), request, progress, answer);
    if (options.config.empty()) refuseOption("config", "", LT_TEXT("Engine", "the path of ASSIST.json"));
    if (options.link.empty() == options.replay.empty())
        refuseOption("link", options.link, LT_TEXT("Engine", "a kind of link, or --replay"));
    const link::LinkConfig config = link::loadConfig(options.config, progress.quiet());
    std::optional<link::Log> log;
    if (!options.replay.empty()) log = link::readLog(options.replay, progress.quiet());
    task::Sources sources;
    sources.inputs.push_back(config.file);
    if (log) sources.inputs.push_back(log->file);
    answer.sources = std::make_shared<const task::Sources>(std::move(sources));
    link::Assistant assistant(config.question, config.limits, config.program);
    assistant.prepare(progress.quiet());
    if (log) return replayLog(*log, assistant, progress.quiet(), answer);
    assist(options, config, assistant, request, progress.quiet(), answer);
}

}  // namespace

Verb assistVerb()
{
    Verb verb;
    verb.name = "assist";
    verb.summary =
        "The assistant beside a control: reads diameter, overhang and cutting speeds from it, writes the stable speed "
        "back. Nothing else is written, nothing is started.";
    verb.parameters = optionsOf<AssistOptions>();
    for (Option& option : verb.parameters) option.is_output = option.info.key == "log";
    verb.run = runAssist;
    return verb;
}

}  // namespace cli
}  // namespace lathelier
