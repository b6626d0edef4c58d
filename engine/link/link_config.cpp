#include "engine/link/link_config.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/fields_make.h"
#include "engine/core/units.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_strict.h"
#include "engine/io/relative_path.h"
#include "engine/link/link_codes.h"
#include "engine/stability/task/speed_task.h"
#include "engine/task/needed.h"
#include "engine/task/task_fields.h"

namespace lathelier::link {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestComponent = 24;
constexpr double longestHeartbeat_ms = 1000;  // a second assistant watches for 2.5 of them, see LoopSettings

const auto& unknownMember = errors::linkMemberUnknown;

std::vector<std::string> inputRoles()
{
    std::vector<std::string> roles;
    for (const task::Input& input : stability::speedTask().inputs)
        if (input.takes_files) roles.push_back(input.role);
    return roles;
}

template <class P>
P strictly(const io::JsonCursor& object)
{
    return fromValues<P>(
        io::strictValuesOf(object, infos<P>(), LT_TEXT("Engine", "a value of this part"), unknownMember));
}

template <class P>
std::optional<P> partOf(const io::JsonCursor& root, const char* key)
{
    const auto member = root.member(key);
    return member ? std::optional(strictly<P>(*member)) : std::nullopt;
}

/// That HAL takes with the longest name of a pin behind it.
bool isComponentName(const std::string& name)
{
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !name.empty() && name.size() <= longestComponent && is_letter(name.front()) &&
           std::all_of(name.begin(), name.end(),
                       [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
}

void requireAssistSchema(const io::JsonCursor& root)
{
    const io::JsonCursor schema = root.at("schema", std::string(assistSchema));
    if (schema.string() != assistSchema) schema.reject(std::string(assistSchema));
    const io::JsonCursor version = root.at("schema_version", std::int64_t{assistVersion});
    if (version.integer() != assistVersion) version.reject(std::int64_t{assistVersion});
}

Registers registersFrom(const io::JsonCursor& object, double highest_rpm)
{
    std::vector<std::string> known = readNames();
    known.insert(known.end(), writtenNames().begin(), writtenNames().end());
    io::requireMembers(object, known, unknownMember);
    Registers all;
    object.members(io::mostJsonMembers, [&](const std::string& name, const io::JsonCursor& member) {
        const auto made = strictly<Register>(member);
        if (made.bytes != 1 && made.bytes != 2 && made.bytes != 4)
            member.at("bytes", std::string("1 | 2 | 4")).reject(std::string("1 | 2 | 4"));
        if (made.scale == 0) member.at("scale", LT_TEXT("Engine", "not 0")).reject(LT_TEXT("Engine", "not 0"));
        all[name] = made;
    });
    // What the rules of the link need: without `running` a machine that cuts could not be told from one that stands.
    for (const char* name :
         {requestName, runningName, diameterName, speedName, correctedName, stateName, answeredName, heartbeatName})
        if (all.count(name) == 0) object.at(name, LT_TEXT("Engine", "a register"));
    if (const auto name = sharedRegister(all))
        object.at(*name, {}).reject(LT_TEXT("Engine", "bytes of its own: what is written there changes another value"));
    if (const auto one = narrowRegister(all, highest_rpm))
        object.at(one->name, {}).reject(LT_TEXT("Engine", "bytes and a scale that hold each number that is written"));
    return all;
}

/// A library without a slash is looked up by the loader, as everywhere on the system.
bool isPath(const std::string& library)
{
    return library.find('/') != std::string::npos;
}

FocasSettings focasFrom(const io::JsonCursor& object, const std::string& folder, double highest_rpm)
{
    io::requireMembers(object, {"library", "host", "port", "registers"}, unknownMember);
    FocasSettings made;
    Notes unused;
    made = io::readFields<FocasSettings>(object, unused, {"registers"}, made);
    if (isPath(made.library)) made.library = io::openablePath(folder, made.library);
    made.registers = registersFrom(object.at("registers", LT_TEXT("Engine", "the registers by name")), highest_rpm);
    return made;
}

void inputsFrom(const io::JsonCursor& object, const std::string& folder, project::PanelState& question)
{
    io::requireMembers(object, inputRoles(), unknownMember);
    object.members(io::mostJsonMembers, [&](const std::string& role, const io::JsonCursor& member) {
        io::requireMembers(member, {"path", "reading"}, unknownMember);
        project::Source& source = question.inputs[role];
        const io::JsonCursor path = member.at("path", LT_TEXT("Engine", "the path of a file"));
        if (path.string().empty()) path.reject(LT_TEXT("Engine", "the path of a file"));
        source.path = io::openablePath(folder, path.string());
        if (const auto reading = member.member("reading"))
            source.import = io::strictValuesOf(*reading, task::readingFields(stability::speedTask()),
                                               LT_TEXT("Engine", "a reading option"), unknownMember);
    });
}

/// Values that the control states at each request, and no configuration beside it.
void parametersFrom(const io::JsonCursor& object, project::PanelState& question)
{
    question.parameters = io::strictValuesOf(object, task::questionFields(stability::speedTask()),
                                             LT_TEXT("Engine", "a parameter of speed"), unknownMember);
    const Values left = machineQuestion(question).parameters;
    for (const auto& [key, value] : question.parameters)
        if (const Value* const same = find(left, key); !same || *same != value)
            object.at(key, {}).reject(LT_TEXT("Engine", "nothing: the control states it at each request"));
}

/// One response, and no file that would not be used, such as a spindle beside modes.
void requireUsed(const io::JsonCursor& root, project::PanelState question)
{
    const task::Task& speed = stability::speedTask();
    const auto inputs = root.member("inputs");
    const std::vector<std::string> given = task::givenOf(speed, question);
    if (given.size() > 1) {
        const bool is_file = inputs && inputs->member(given[1]);
        (is_file ? *inputs : root.at("parameters", {}))
            .at(given[1], {})
            .reject(LT_TEXT("Engine", "nothing: the response is stated otherwise"));
    }
    if (given.empty()) set(question.parameters, stability::barLengthKey, 1.0);  // of the control
    for (const task::Input& input : speed.inputs)
        if (inputs && inputs->member(input.role) && task::saysNothing(speed, question, input))
            inputs->at(input.role, {}).reject(LT_TEXT("Engine", "nothing: the response is stated otherwise"));
}

Label plain(Text label, Text help, Text in = {})
{
    return Label{label, help, in};
}

}  // namespace

const std::vector<Field<Limits>>& fieldsOf(const Limits*)
{
    using L = Limits;
    static const std::vector<Field<L>> all = [] {
        std::vector<Field<L>> made{field("highest_rpm", &L::highest_rpm, Range{1, 1e6},
                                         plain(LT_TEXT("Engine", "Highest speed of the machine"),
                                               LT_TEXT("Engine", "A stable speed above is refused."), unit::rpm)),
                                   field("lowest_diameter_mm", &L::lowest_diameter_mm, Range{1e-3, 1e5},
                                         plain(LT_TEXT("Engine", "Least diameter"),
                                               LT_TEXT("Engine", "Below it a request is refused."), unit::mm)),
                                   field("highest_diameter_mm", &L::highest_diameter_mm, Range{1e-3, 1e5},
                                         plain(LT_TEXT("Engine", "Greatest diameter"),
                                               LT_TEXT("Engine", "Above it a request is refused."), unit::mm)),
                                   field("lowest_length_mm", &L::lowest_length_mm, Range{1e-3, 1e5},
                                         plain(LT_TEXT("Engine", "Least overhang"),
                                               LT_TEXT("Engine", "Below it a request is refused."), unit::mm)),
                                   field("highest_length_mm", &L::highest_length_mm, Range{1e-3, 1e5},
                                         plain(LT_TEXT("Engine", "Greatest overhang"),
                                               LT_TEXT("Engine", "Above it a request is refused."), unit::mm))};
        made.front().info.required = true;
        return made;
    }();
    return all;
}

const std::vector<Field<OfProgram>>& fieldsOf(const OfProgram*)
{
    static const std::vector<Field<OfProgram>> all{
        field("clearance_mm", &OfProgram::clearance_mm, Range{0, 1e5},
              plain(LT_TEXT("Engine", "Clearance"),
                    LT_TEXT("Engine", "From the turned length to the chuck; the overhang is both."), unit::mm))};
    return all;
}

const std::vector<Field<LoopFields>>& fieldsOf(const LoopFields*)
{
    using L = LoopFields;
    static const std::vector<Field<L>> all{
        field("poll_ms", &L::poll_ms, Range{1, 1000},
              plain(LT_TEXT("Engine", "Polling period"), LT_TEXT("Engine", "Between two looks at the request."),
                    Text{"ms"})),
        field("heartbeat_ms", &L::heartbeat_ms, Range{50, longestHeartbeat_ms},
              plain(LT_TEXT("Engine", "Heartbeat"), LT_TEXT("Engine", "Its period."), Text{"ms"})),
        field("reconnect_ms", &L::reconnect_ms, Range{10, 600000},
              plain(LT_TEXT("Engine", "Pause"), LT_TEXT("Engine", "Before a lost link is opened again."), Text{"ms"})),
        field("timeout_ms", &L::timeout_ms, Range{10, 60000},
              plain(LT_TEXT("Engine", "Time-out"), LT_TEXT("Engine", "Of one answer of the control."), Text{"ms"}))};
    return all;
}

const std::vector<Field<LoopbackSettings>>& fieldsOf(const LoopbackSettings*)
{
    using L = LoopbackSettings;
    static const std::vector<Field<L>> all{
        field("host", &L::host, plain(LT_TEXT("Engine", "Host"), LT_TEXT("Engine", "Of the simulated control."))),
        field("port", &L::port, Range{1, 65535},
              plain(LT_TEXT("Engine", "Port"), LT_TEXT("Engine", "Of the simulated control.")))};
    return all;
}

const std::vector<Field<LinuxCncSettings>>& fieldsOf(const LinuxCncSettings*)
{
    using L = LinuxCncSettings;
    static const std::vector<Field<L>> all{
        field("component", &L::component,
              plain(LT_TEXT("Engine", "Component"), LT_TEXT("Engine", "Its name in HAL, before that of each pin."))),
        field("program_port", &L::program_port, Range{0, 65535},
              plain(LT_TEXT("Engine", "Port of linuxcncrsh"),
                    LT_TEXT("Engine", "That names the loaded program; 0: it is not asked."))),
        field("program_password", &L::program_password,
              plain(LT_TEXT("Engine", "Password of linuxcncrsh"), LT_TEXT("Engine", "For this port.")))};
    return all;
}

const std::vector<Field<Register>>& fieldsOf(const Register*)
{
    using R = Register;
    static const std::vector<Field<R>> all = [] {
        std::vector<Field<R>> made{
            field("address", &R::address, Range{0, 65532},
                  plain(LT_TEXT("Engine", "Address"), LT_TEXT("Engine", "Of its first byte in the R area."))),
            field("bytes", &R::bytes, Range{1, 4}, plain(LT_TEXT("Engine", "Bytes"), LT_TEXT("Engine", "1, 2 or 4."))),
            field("scale", &R::scale, Range{-1e9, 1e9},
                  plain(LT_TEXT("Engine", "Scale"), LT_TEXT("Engine", "The value is the number times it.")))};
        made.front().info.required = true;
        return made;
    }();
    return all;
}

const std::vector<Field<FocasSettings>>& fieldsOf(const FocasSettings*)
{
    using F = FocasSettings;
    static const std::vector<Field<F>> all = [] {
        std::vector<Field<F>> made{
            field("library", &F::library,
                  plain(LT_TEXT("Engine", "Library"), LT_TEXT("Engine", "FOCAS2 of the vendor, as it is installed."))),
            field("host", &F::host, plain(LT_TEXT("Engine", "Host"), LT_TEXT("Engine", "Of the control."))),
            field("port", &F::port, Range{1, 65535},
                  plain(LT_TEXT("Engine", "Port"), LT_TEXT("Engine", "Of the control.")))};
        made[1].info.required = true;
        return made;
    }();
    return all;
}

LoopSettings loopSettings(const LinkConfig& config, bool is_once)
{
    LoopSettings made{config.loop.poll_ms, config.loop.heartbeat_ms, config.loop.reconnect_ms};
    made.is_once = is_once;
    return made;
}

LinkConfig readConfig(const std::string& text, const std::string& folder)
{
    const io::JsonDocument document(text);
    const io::JsonCursor root = document.root();
    requireAssistSchema(root);
    io::requireMembers(root,
                       {"schema", "schema_version", "inputs", "parameters", "limits", "program", "loop", "loopback",
                        "linuxcnc", "focas"},
                       unknownMember);
    LinkConfig config;
    if (const auto inputs = root.member("inputs")) inputsFrom(*inputs, folder, config.question);
    if (const auto parameters = root.member("parameters")) parametersFrom(*parameters, config.question);
    requireUsed(root, config.question);
    config.limits = strictly<Limits>(root.at("limits", LT_TEXT("Engine", "the limits of the machine")));
    config.program = partOf<OfProgram>(root, "program");
    config.loop = partOf<LoopFields>(root, "loop").value_or(LoopFields{});
    config.loopback = partOf<LoopbackSettings>(root, "loopback");
    config.linuxcnc = partOf<LinuxCncSettings>(root, "linuxcnc");
    if (config.linuxcnc && !isComponentName(config.linuxcnc->component))
        root.at("linuxcnc", {})
            .at("component", {})
            .reject(LT_TEXT("Engine", "1 to 24 letters, digits, hyphens or underscores, a letter first"));
    if (const auto focas = root.member("focas")) config.focas = focasFrom(*focas, folder, config.limits.highest_rpm);
    return config;
}

LinkConfig loadConfig(const std::string& path, const Progress& progress)
{
    try {
        const io::FileBytes bytes(path, progress);
        const std::string text(bytes.view());
        LinkConfig config = readConfig(text, fs::absolute(path).lexically_normal().parent_path().string());
        config.file = {path, static_cast<std::int64_t>(text.size()), io::sha256(text, progress)};
        return config;
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

std::string textOf(const LinkConfig& config, const std::string& folder)
{
    Json inputs = Json::object();
    for (const auto& [role, source] : config.question.inputs) {
        if (source.path.empty()) continue;
        inputs[role] = {{"path", io::relativePath(folder, source.path)},
                        {"reading", io::objectOf(task::readingFields(stability::speedTask()), source.import)}};
    }
    const auto object = [](const auto& part) {
        using P = std::decay_t<decltype(part)>;
        return io::objectOf(infos<P>(), toValues(part));
    };
    Json json{{"schema", assistSchema},
              {"schema_version", assistVersion},
              {"inputs", std::move(inputs)},
              {"parameters", io::objectOf(task::questionFields(stability::speedTask()), config.question.parameters)},
              {"limits", object(config.limits)},
              {"loop", object(config.loop)}};
    if (config.program) json["program"] = object(*config.program);
    if (config.loopback) json["loopback"] = object(*config.loopback);
    if (config.linuxcnc) json["linuxcnc"] = object(*config.linuxcnc);
    if (config.focas) {
        json["focas"] = object(*config.focas);
        if (isPath(config.focas->library)) {
            const std::string path = io::relativePath(folder, config.focas->library);
            json["focas"]["library"] = isPath(path) ? path : "./" + path;
        }
        for (const auto& [name, one] : config.focas->registers) json["focas"]["registers"][name] = object(one);
    }
    return json.dump(2).append("\n");
}

}  // namespace lathelier::link
