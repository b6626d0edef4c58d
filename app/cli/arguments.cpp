#include "app/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <iostream>

#include "app/cli/help.h"
#include "app/cli/outputs.h"
#include "engine/core/texts.h"
#include "engine/core/version.h"

namespace lathelier::cli {
namespace {

/// Raw arguments of one verb.
struct Typed {
    CLI::App* command = nullptr;
    std::vector<std::vector<std::string>> operands;  ///< by operand
    std::map<std::string, std::string> values;       ///< by field key
    std::map<std::string, std::string> outputs;      ///< by option name
    CommonOptions common;
};

constexpr const char* outputGroup = "Output";

void addOption(CLI::App& command, const Option& option, const std::string& group, Typed& typed)
{
    const std::string& key = option.info.key;
    CLI::Option* added = nullptr;
    const bool is_rows = option.info.kind == FieldInfo::Kind::Rows;
    const bool is_flag = option.info.kind == FieldInfo::Kind::Flag || option.info.kind == FieldInfo::Kind::Group;
    if (is_flag)
        added = command.add_flag_callback(optionName(key), [&typed, key] { typed.values[key] = "yes"; });
    else
        added = command.add_option_function<std::vector<std::string>>(
            optionName(key), [&typed, key, is_rows](const auto& words) {
                for (const std::string& word : words) {
                    std::string& all = typed.values[key];
                    all += (all.empty() ? "" : is_rows ? ";" : ",") + word;
                }
            });
    // Ranges and rows may be given one by one; every other option once.
    const bool several = option.info.kind == FieldInfo::Kind::Intervals || is_rows;
    if (!is_flag)
        added->type_name(placeholder(option.info))
            ->type_size(1)
            ->expected(1)
            ->allow_extra_args(false)  // what follows the value is an operand
            ->multi_option_policy(several ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::Throw);
    added->description(describe(option))->group(group);
}

void addVerb(CLI::App& app, const Verb& verb, Typed& typed)
{
    typed.command = app.add_subcommand(verb.name, verb.summary);
    CLI::App& command = *typed.command;
    typed.operands.resize(verb.operands.size());
    for (std::size_t i = 0; i < verb.operands.size(); ++i) {
        const Operand& operand = verb.operands[i];
        std::vector<std::string>& words = typed.operands[i];
        CLI::Option* added = nullptr;
        if (operand.repeated) {
            added = command.add_option(operand.name, words);
        } else {
            words.resize(1);
            added = command.add_option(operand.name, words.front());
        }
        added->required(!operand.optional)
            ->description(wrapHelp(operand.help))
            ->type_name(operand.repeated ? "..." : "");
    }
    for (const Option& option : verb.parameters) addOption(command, option, "Parameters", typed);
    for (const Option& option : readingOptions(verb)) addOption(command, option, "Reading files", typed);
    for (const OutputOption& output : verb.outputs)
        command.add_option(output.name, typed.outputs[output.name], wrapHelp(output.help))
            ->type_name("FILE")
            ->group(outputGroup);
    CommonOptions& common = typed.common;
    command
        .add_option("--json", common.json,
                    wrapHelp("Write the result as one JSON object to FILE, or to standard output (-)."))
        ->type_name("FILE|-")
        ->group(outputGroup);
    if (verb.has_report)
        command.add_option("--report", common.report, wrapHelp("Write the report as one self-contained HTML file."))
            ->type_name("FILE.html")
            ->group(outputGroup);
    command.add_flag("--strict", common.strict, wrapHelp("Exit with 1 when the verdict is \"out of tolerance\"."))
        ->group(outputGroup);
    command.add_flag("--quiet", common.quiet, wrapHelp("No progress and no text for people; errors are still said."))
        ->group(outputGroup);
    command.add_option("--threads", common.threads, wrapHelp("Use at most N cores (0: all). The result is the same."))
        ->type_name("N")
        ->check(CLI::Range(0, 4096).description(""))
        ->group(outputGroup);
}

/// Checks what was typed for a field; the message names the option as it was typed.
Value understand(const FieldInfo& info, const std::string& typed)
{
    try {
        return parse(info, typed);
    } catch (const Error& error) {
        Values values = error.values();
        set(values, "parameter", optionName(info.key));
        throw Error(error.code(), values);
    }
}

/// An empty file name is rejected, since the result would be lost.
void checkNames(const Typed& typed)
{
    const auto check = [&typed](const std::string& option, const std::string& path) {
        if (path.empty() && typed.command->get_option_no_throw(option) && typed.command->count(option) > 0)
            throw CLI::ValidationError(option, "a file name is missing");
    };
    for (const auto& [name, path] : typed.outputs) check(name, path);
    check("--json", typed.common.json);
    check("--report", typed.common.report);
}

/// An operand may be left out where an option stands in its place.
void checkOperands(const Verb& verb, const Typed& typed)
{
    for (std::size_t i = 0; i < typed.operands.size(); ++i) {
        const std::vector<std::string>& options = verb.operands[i].replaced_by;
        if (options.empty() || !typed.operands[i].empty()) continue;
        if (std::none_of(options.begin(), options.end(), [&](const auto& key) { return typed.values.count(key) > 0; }))
            throw CLI::RequiredError(verb.operands[i].name);
    }
}

Invocation toInvocation(const Verb& verb, const Typed& typed)
{
    checkNames(typed);
    checkOperands(verb, typed);
    Invocation result{&verb, {}, typed.common};
    for (std::size_t i = 0; i < typed.operands.size(); ++i)
        for (const std::string& word : typed.operands[i])
            if (!word.empty() || !verb.operands[i].optional) result.request.operands.push_back(word);
    const std::vector<Option> reading = readingOptions(verb);
    for (const auto* options : {&verb.parameters, &reading})
        for (const Option& option : *options) {
            const auto given = typed.values.find(option.info.key);
            set(result.request.parameters, option.info.key,
                given == typed.values.end() ? option.standard : understand(option.info, given->second));
            if (given == typed.values.end()) continue;
            result.request.typed.insert(option.info.key);
            if (!option.info.group_key.empty()) set(result.request.parameters, option.info.group_key, true);
        }
    for (const auto& [name, path] : typed.outputs)
        if (!path.empty()) result.request.outputs.emplace(name, path);
    result.request.in_full = !typed.common.json.empty() || !typed.common.report.empty();
    checkOutputs(result);
    return result;
}

int usageError(const std::string& message, const CLI::App* command)
{
    std::cerr << programName << ": " << message << "\nSee " << programName << (command ? " " + command->get_name() : "")
              << " --help.\n";
    return 2;
}

bool isNumber(const std::string& word)
{
    double number = 0;
    const char* end = word.data() + word.size();
    const auto [stop, problem] = std::from_chars(word.data(), end, number);
    return !word.empty() && problem == std::errc() && stop == end;
}

/// Of a list of numbers the further ones may stand behind the first ("--speed-rpm 2016 2154"): each gets the option's
/// name before it.
std::vector<std::string> withLists(int argc, char** argv)
{
    std::vector<std::string> words(argv, argv + argc);
    if (argc < 2) return words;
    for (const Verb& verb : verbs()) {
        if (verb.name != words[1]) continue;
        for (const Option& option : verb.parameters) {
            const bool is_list = option.info.kind == FieldInfo::Kind::Rows && option.info.columns.size() == 1 &&
                                 option.info.columns.front().kind == FieldInfo::Kind::Number;
            const std::string name = is_list ? optionName(option.info.key) : std::string();
            for (std::size_t i = 2; is_list && i + 2 < words.size(); ++i)
                if (words[i] == name && isNumber(words[i + 1]) && isNumber(words[i + 2]))
                    words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 2, name);
        }
    }
    return words;
}

/// Distinguishes an unknown verb from a missing one.
bool isUnknownCommand(const std::string& word)
{
    const auto same = [&word](const Verb& verb) { return verb.name == word; };
    return !word.empty() && word[0] != '-' && std::none_of(verbs().begin(), verbs().end(), same);
}

}  // namespace

Parsed parseArguments(int argc, char** argv)
{
    CLI::App app(programSummary, programName);
    app.set_version_flag("--version", std::string(programName) + " " + programVersion, "Print the version.");
    app.set_help_flag("-h,--help", "Print this help.");
    app.require_subcommand(1);
    app.footer(exitCodeHelp);
    app.get_formatter()->column_width(helpColumn);
    app.get_formatter()->label("REQUIRED", "");
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app.get_formatter()->label("Subcommands", "Commands");
    std::map<const Verb*, Typed> typed;
    for (const Verb& verb : verbs()) addVerb(app, verb, typed[&verb]);

    if (argc > 1 && isUnknownCommand(argv[1]))
        return {std::nullopt, usageError(std::string(argv[1]) + " is not a command", nullptr)};
    const CLI::App* command = nullptr;
    try {
        std::vector<std::string> words = withLists(argc, argv);
        if (!words.empty()) words.erase(words.begin());
        std::reverse(words.begin(), words.end());  // as the library takes them
        app.parse(std::move(words));
        for (const Verb& verb : verbs())
            if (app.got_subcommand(verb.name)) {
                command = typed[&verb].command;
                return {toInvocation(verb, typed[&verb]), 0};
            }
        return {std::nullopt, usageError("a command is missing", nullptr)};
    } catch (const CLI::Success& success) {  // help or version
        return {std::nullopt, app.exit(success)};
    } catch (const CLI::ParseError& error) {
        const auto parsed = app.get_subcommands();
        if (parsed.empty())
            return {std::nullopt, usageError(argc > 1 ? error.what() : "a command is missing", nullptr)};
        return {std::nullopt, usageError(error.what(), parsed.front())};
    } catch (const Error& error) {
        return {std::nullopt, usageError(text(error), command)};
    }
}

}  // namespace lathelier::cli
