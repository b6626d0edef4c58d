#include "engine/series/archived_state.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/file.h"

namespace lathelier::series {
namespace {

FileState stateOf(const std::string& path, const std::string& sha256, const Progress& progress)
{
    try {
        return io::fileSha256(path, progress) == sha256 ? FileState::Same : FileState::Changed;
    } catch (const Error&) {
        return FileState::Missing;
    }
}

/// A member that is an object; an empty one where there is none.
Json objectIn(const Json& json, const char* key)
{
    const auto found = json.is_object() ? json.find(key) : json.end();
    return json.is_object() && found != json.end() && found->is_object() ? *found : Json::object();
}

std::string wordIn(const Json& json, const char* key)
{
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Where the file of this content lay; empty: the result does not say.
std::string pathOf(const Json& result, const std::string& sha256)
{
    const auto inputs = result.is_object() ? result.find("inputs") : result.end();
    if (!result.is_object() || inputs == result.end() || !inputs->is_array()) return {};
    for (const Json& input : *inputs)
        if (input.is_object() && wordIn(input, "sha256") == sha256) return wordIn(input, "path");
    return {};
}

}  // namespace

Text name(FileState state)
{
    switch (state) {
        case FileState::Same: return LT_TEXT("Engine", "unchanged");
        case FileState::Changed: return LT_TEXT("Engine", "changed since");
        case FileState::Missing: return LT_TEXT("Engine", "not there any more");
    }
    return {};
}

bool ArchivedState::isWhole() const
{
    return !files.empty() &&
           std::all_of(files.begin(), files.end(), [](const auto& file) { return file.state == FileState::Same; });
}

ArchivedState archivedState(const archive::Record& record, const Progress& progress)
{
    ArchivedState made;
    const Json recipe = record.recipe.empty() ? Json::object() : Json::parse(record.recipe, nullptr, false);
    const Json result = Json::parse(record.evaluation.result, nullptr, false);
    const auto add = [&](const std::string& role, const std::string& path, const std::string& sha256,
                         const Json& reading) {
        project::Source source;
        source.path = path;
        source.import = valuesFromJson(reading);
        source.sha256 = sha256;
        made.state.inputs[role] = source;
        made.files.push_back({role, path, sha256, stateOf(path, sha256, progress)});
    };
    const Json reading = objectIn(recipe, "reading");
    for (const archive::EvaluatedInput& input : record.evaluation.inputs)
        add(input.role, input.file.path, input.file.sha256, reading);
    const Json fixed = objectIn(recipe, "inputs");
    for (const auto& [role, input] : fixed.items()) {
        if (!input.is_object()) continue;
        const std::string sha256 = wordIn(input, "sha256");
        add(role, pathOf(result, sha256), sha256, objectIn(input, "reading"));
    }
    made.state.parameters = valuesFromJson(objectIn(recipe, "parameters"));
    return made;
}

}  // namespace lathelier::series
