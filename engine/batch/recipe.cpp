#include "engine/batch/recipe.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/batch/batch_codes.h"
#include "engine/core/json.h"
#include "engine/core/version.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_fields.h"
#include "engine/task/asked_state.h"
#include "engine/task/task_fields.h"

namespace lathelier::batch {
namespace {

namespace fs = std::filesystem;

/// Files of an input with their digests: the file itself, then those that its reader opened besides.
std::vector<RecipeFile> filesBehind(const task::Input& input, const project::PanelState& state,
                                    const Progress& progress)
{
    const std::string& path = state.inputs.at(input.role).path;
    std::vector<RecipeFile> files;
    if (input.read) {
        Stores stores;
        input.read(state, stores, progress);
        for (const FileSeen& seen : stores.seen()) files.push_back({seen.path, seen.sha256});
    }
    const auto itself =
        std::find_if(files.begin(), files.end(), [&](const RecipeFile& one) { return one.path == path; });
    if (itself == files.end())
        files.insert(files.begin(), {path, io::fileSha256(path, progress)});
    else
        std::rotate(files.begin(), itself, itself + 1);
    return files;
}

Values readingOf(const task::Task& task, const project::Source& source)
{
    Values reading = task::readingDefaults(task);
    for (const auto& [key, value] : source.import) set(reading, key, value);
    return task::asRead(task::readingFields(task), reading);
}

bool isPlace(const FieldInfo& info, const Value& value)
{
    const bool is_word = info.kind == FieldInfo::Kind::Word || info.is_open;
    const auto* const word = std::get_if<std::string>(&value);
    if (!is_word || !word || word->empty()) return false;
    const auto is_choice = [&](const FieldChoice& choice) { return choice.key == *word; };
    if (std::any_of(info.choices.begin(), info.choices.end(), is_choice)) return false;
    std::error_code unknown;
    return fs::exists(*word, unknown);
}

Values parametersFrom(const task::Task& task, const project::PanelState& state)
{
    Values parameters;
    const std::vector<FieldInfo> fields = task::questionFields(task);
    for (const FieldInfo& info : fields) {
        const Value* const given = find(state.parameters, info.key);
        const Value& standard = *find(task.defaults, info.key);
        const Value& value = given ? *given : standard;
        if (value != standard && isPlace(info, value))
            throw Error(errors::recipeNamesPlace, {{"parameter", task::optionName(info.key)}, {"found", value}});
        set(parameters, info.key, value);
    }
    return task::asRead(fields, parameters);
}

bool isVaried(const task::Input& input, const project::PanelState& state)
{
    return input.is_of_part && task::isOfCommandLine(input) && task::sourceOf(state, input.role);
}

/// Contents in an order that does not depend on names.
Json contentOf(const FixedInput& input)
{
    std::vector<std::string> others;
    for (std::size_t i = 1; i < input.files.size(); ++i) others.push_back(input.files[i].sha256);
    std::sort(others.begin(), others.end());
    Json content = Json::array({input.files.front().sha256});
    for (std::string& other : others) content.push_back(std::move(other));
    return content;
}

void requireContent(const RecipeFile& file, const std::string& role, const Progress& progress)
{
    const Values known{{"path", file.path}, {"role", role}};
    std::string found;
    try {
        found = io::fileSha256(file.path, progress);
    } catch (const Error& error) {
        if (!(error.code() == errors::fileNotFound)) throw;
        Error missing(errors::recipeInputMissing, known);
        throw missing.with("expected", file.sha256);
    }
    if (found == file.sha256) return;
    Error changed(errors::recipeInputChanged, known);
    throw changed.with("found", found).with("expected", file.sha256);
}

}  // namespace

bool hasVaried(const task::Task& task, const project::PanelState& state)
{
    return std::any_of(task.inputs.begin(), task.inputs.end(),
                       [&state](const task::Input& input) { return isVaried(input, state); });
}

void requireVaried(const task::Task& task, const project::PanelState& state)
{
    if (hasVaried(task, state)) return;
    std::string roles;
    for (const task::Input& input : task.inputs) {
        if (input.is_of_part && task::isOfCommandLine(input)) roles += (roles.empty() ? "" : ", ") + input.role;
    }
    if (roles.empty()) throw Error(errors::recipeOfNoPart, {{"task", task.key}});
    throw Error(errors::recipeNothingVaries, {{"task", task.key}, {"roles", roles}});
}

Recipe recipeOf(const task::Task& task, const project::PanelState& state, const Progress& progress)
{
    requireVaried(task, state);
    Recipe recipe;
    recipe.task = &task;
    recipe.version = programVersion;
    recipe.parameters = parametersFrom(task, state);
    for (const task::Input& input : task.inputs) {
        const project::Source* const source = task::sourceOf(state, input.role);
        if (!source) continue;
        if (isVaried(input, state)) {
            if (recipe.varied.empty()) recipe.reading = readingOf(task, *source);
            recipe.varied.push_back(input.role);
        } else if (!input.is_of_part) {
            if (!source->item.empty())
                throw Error(errors::recipeHoldsNoItem, {{"role", input.role}, {"item", source->item}});
            recipe.inputs.push_back({input.role, filesBehind(input, state, progress), readingOf(task, *source)});
        }
    }
    return recipe;
}

std::string identityOf(const Recipe& recipe)
{
    Json inputs = Json::object();
    const std::vector<FieldInfo> reading = task::readingFields(*recipe.task);
    for (const FixedInput& input : recipe.inputs)
        inputs[input.role] = {{"content", contentOf(input)}, {"reading", io::objectOf(reading, input.reading)}};
    std::vector<std::string> varied = recipe.varied;
    std::sort(varied.begin(), varied.end());
    const Json whole{{"task", recipe.task->key},
                     {"parameters", io::objectOf(task::questionFields(*recipe.task), recipe.parameters)},
                     {"reading", io::objectOf(reading, recipe.reading)},
                     {"varied", varied},
                     {"inputs", inputs},
                     {"shop", recipe.shop.file.path.empty() ? recipe.shop.name : recipe.shop.file.sha256}};
    // Sorted keys: the order of the fields may change from version to version.
    return io::sha256(nlohmann::json::parse(whole.dump(-1, ' ', true, Json::error_handler_t::replace)).dump());
}

project::PanelState stateOf(const Recipe& recipe)
{
    project::PanelState state;
    state.parameters = recipe.parameters;
    for (const FixedInput& input : recipe.inputs) {
        project::Source& source = state.inputs[input.role];
        source.path = input.files.front().path;
        source.import = input.reading;
    }
    return state;
}

void requireUnchanged(const Recipe& recipe, const Progress& progress)
{
    for (const FixedInput& input : recipe.inputs)
        for (const RecipeFile& file : input.files) requireContent(file, input.role, progress);
    if (!recipe.shop.file.path.empty()) requireContent(recipe.shop.file, "shop", progress);
}

std::vector<RecipeFile> filesOf(const Recipe& recipe)
{
    std::vector<RecipeFile> files;
    for (const FixedInput& input : recipe.inputs) files.insert(files.end(), input.files.begin(), input.files.end());
    if (!recipe.shop.file.path.empty()) files.push_back(recipe.shop.file);
    return files;
}

}  // namespace lathelier::batch
