#include "engine/archive/evaluation.h"

#include <map>
#include <nlohmann/json.hpp>

#include "engine/archive/archive_codes.h"
#include "engine/core/verdict_json.h"
#include "engine/io/file.h"
#include "engine/io/json/json_document.h"

namespace lathelier::archive {
namespace {

constexpr std::size_t mostInputs = 10000;

std::optional<Verdict> verdictFrom(const io::JsonCursor& object)
{
    const auto word = object.member("verdict");
    if (!word) return std::nullopt;
    if (const auto verdict = verdictOf(word->string())) return verdict;
    word->reject(LT_TEXT("Engine", "pass, fail, undecided or null"));
}

std::string fileName(const std::string& path)
{
    const std::size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

bool isPath(const std::string& key)
{
    return key == "path" || key.ends_with("_path");
}

/// `known`: paths of the inputs, which stand in parameters and notes under other names too.
void dropFolders(Json& json, const std::map<std::string, std::string>& known, bool is_path)
{
    if (json.is_string()) {
        const auto& word = json.get_ref<const std::string&>();
        if (const auto found = known.find(word); found != known.end())
            json = found->second;
        else if (is_path)
            json = fileName(word);
        return;
    }
    if (json.is_object())
        for (auto& [key, value] : json.items()) dropFolders(value, known, isPath(key));
    else if (json.is_array())
        for (Json& value : json) dropFolders(value, known, is_path);
}

}  // namespace

std::string Evaluation::key() const
{
    Json content{{"task", task}, {"recipe", recipe_sha256}, {"version", version}, {"inputs", Json::array()}};
    for (const EvaluatedInput& input : inputs)
        content["inputs"].push_back(Json::array({input.role, input.file.sha256}));
    return io::sha256(content.dump());
}

Json toJson(const Evaluation& evaluation)
{
    Json json{{"key", evaluation.key()},
              {"task", evaluation.task},
              {"recipe_sha256", evaluation.recipe_sha256},
              {"version", evaluation.version},
              {"inputs", Json::array()},
              {"exit_code", evaluation.exit_code},
              {"verdict", verdictJson(evaluation.verdict)},
              {"characteristics", Json::array()},
              {"result", Json::parse(evaluation.result)}};
    for (const EvaluatedInput& input : evaluation.inputs)
        json["inputs"].push_back({{"role", input.role},
                                  {"path", input.file.path},
                                  {"bytes", input.file.bytes},
                                  {"sha256", input.file.sha256}});
    for (const task::Characteristic& one : evaluation.characteristics)
        json["characteristics"].push_back(task::toJson(one));
    return json;
}

Evaluation evaluationFrom(std::string_view line)
{
    io::JsonDocument document{std::string(line)};
    const io::JsonCursor root = document.root();
    Evaluation made;
    const std::string stated = root.at("key", LT_TEXT("Engine", "the key of the evaluation")).string();
    made.task = root.at("task", LT_TEXT("Engine", "the key of a task")).string();
    made.recipe_sha256 = root.at("recipe_sha256", LT_TEXT("Engine", "the SHA-256 of the recipe")).string();
    made.version = root.at("version", LT_TEXT("Engine", "a version")).string();
    root.at("inputs", LT_TEXT("Engine", "a list of inputs")).items(mostInputs, [&](const io::JsonCursor& input) {
        made.inputs.push_back({input.at("role", LT_TEXT("Engine", "a role")).string(),
                               {input.at("path", LT_TEXT("Engine", "a path")).string(),
                                input.at("bytes", LT_TEXT("Engine", "a number of bytes")).integer(),
                                input.at("sha256", LT_TEXT("Engine", "a SHA-256")).string()}});
    });
    made.exit_code = static_cast<int>(root.at("exit_code", LT_TEXT("Engine", "an exit code")).integer());
    made.verdict = verdictFrom(root);
    const Json& json = document.json();
    const auto characteristics = json.find("characteristics");
    if (characteristics == json.end() || !characteristics->is_array())
        root.at("characteristics", LT_TEXT("Engine", "a list of characteristics"))
            .reject(LT_TEXT("Engine", "a list of characteristics"));
    std::size_t place = 0;
    for (const Json& one : *characteristics) {
        auto characteristic = task::characteristicFrom(one);
        if (!characteristic)
            throw io::misfit(document.text(), {"characteristics", std::to_string(place)},
                             LT_TEXT("Engine", "a characteristic"));
        made.characteristics.push_back(*std::move(characteristic));
        ++place;
    }
    if (const auto result = json.find("result"); result != json.end()) made.result = result->dump();
    if (const std::string key = made.key(); key != stated)
        throw Error(errors::evaluationAltered, {{"found", stated}, {"expected", key}});
    return made;
}

Json canonicalOf(const Evaluation& evaluation)
{
    Json json = toJson(evaluation);
    std::map<std::string, std::string> known;
    const auto learn = [&known](const Json& inputs) {
        for (const Json& input : inputs)
            if (const auto path = input.find("path"); path != input.end() && path->is_string())
                known.emplace(path->get<std::string>(), fileName(path->get<std::string>()));
    };
    learn(json["inputs"]);
    const Json& result = json["result"];
    if (result.is_object() && result.contains("inputs") && result["inputs"].is_array()) learn(result["inputs"]);
    dropFolders(json, known, false);
    return json;
}

}  // namespace lathelier::archive
