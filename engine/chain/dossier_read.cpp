#include "engine/chain/dossier_read.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/verdict_json.h"
#include "engine/io/file.h"
#include "engine/io/json/json_document.h"

namespace lathelier::chain {
namespace {

const Text aText = LT_TEXT("Engine", "a text");

std::string wordAt(const io::JsonCursor& object, const char* name)
{
    const auto member = object.member(name);
    return member ? member->string() : std::string();
}

template <class Item, class Read>
std::vector<Item> listAt(const io::JsonCursor& object, const char* name, const Read& read)
{
    std::vector<Item> all;
    if (const auto list = object.member(name))
        list->items(mostDossierItems, [&](const io::JsonCursor& item) { all.push_back(read(item)); });
    return all;
}

InputFile fileOf(const io::JsonCursor& item)
{
    const auto size = item.member("bytes");
    return {item.at("path", aText).string(), size ? size->integer() : 0, item.at("sha256", aText).string()};
}

StepState stateOf(const io::JsonCursor& word)
{
    for (const StepState state : {StepState::Done, StepState::Missing, StepState::Failed, StepState::NotReached})
        if (word.string() == key(state)) return state;
    word.reject(LT_TEXT("Engine", "done, missing, failed or not_reached"));
}

ChainStep stepOf(const io::JsonCursor& item)
{
    ChainStep step;
    step.id = item.at("step", aText).string();
    step.state = stateOf(item.at("state", aText));
    step.inputs = listAt<InputFile>(item, "inputs", fileOf);
    step.outputs = listAt<InputFile>(item, "outputs", fileOf);
    step.result = wordAt(item, "result");
    step.verdict = verdictOf(wordAt(item, "verdict"));
    step.request = wordAt(item, "request");
    step.remarks = listAt<std::string>(item, "remarks", [](const io::JsonCursor& word) { return word.string(); });
    return step;
}

TracedNumber numberOf(const io::JsonCursor& item)
{
    TracedNumber number;
    number.step = item.at("step", aText).string();
    number.key = wordAt(item, "key");
    number.value = item.at("value", LT_TEXT("Engine", "a number")).number();
    number.file = wordAt(item, "file");
    number.pointer = wordAt(item, "pointer");
    if (const auto uncertainty = item.member("uncertainty")) number.uncertainty = uncertainty->number();
    if (const auto factor = item.member("coverage_factor")) number.coverage_factor = factor->integer();
    number.uncertainty_pointer = wordAt(item, "uncertainty_pointer");
    return number;
}

Confirmation confirmationOf(const io::JsonCursor& item)
{
    return {wordAt(item, "what"), wordAt(item, "file"), wordAt(item, "by")};
}

/// Copies parameters and notes verbatim.
void addAsWritten(const Json& root, Dossier& dossier)
{
    for (std::size_t i = 0; i < dossier.steps.size(); ++i) {
        const Json& written = root["steps"].at(i);
        if (written.contains("parameters") && written["parameters"].is_object())
            dossier.steps[i].parameters = valuesFromJson(written["parameters"]);
        if (written.contains("roles") && written["roles"].is_object())
            for (const auto& [role, file] : written["roles"].items())
                if (file.is_string()) dossier.steps[i].roles[role] = file.get<std::string>();
        Json notes = Json::array();
        if (root.contains("notes") && root["notes"].is_array())
            for (const Json& note : root["notes"])
                if (note.is_object() && note.contains("step") && note["step"] == dossier.steps[i].id)
                    notes.push_back(note);
        Json understanding = Json::object();
        for (const char* name : {"not_modelled", "assumed"}) {
            understanding[name] = Json::array();
            if (!root.contains("understanding") || !root["understanding"].is_object() ||
                !root["understanding"].contains(name) || !root["understanding"][name].is_array())
                continue;
            for (const Json& entry : root["understanding"][name])
                if (entry.is_object() && entry.contains("step") && entry["step"] == dossier.steps[i].id)
                    understanding[name].push_back(entry);
        }
        dossier.steps[i].understanding = std::make_shared<const Json>(std::move(understanding));
        dossier.steps[i].past_notes = std::make_shared<const Json>(std::move(notes));
    }
}

}  // namespace

Dossier dossierFrom(std::string text)
{
    io::JsonDocument document{std::move(text)};
    const io::JsonCursor root = document.root();
    const Text schema = LT_TEXT("Engine", "the schema of a dossier");
    if (root.at("schema", schema).string() != dossierSchema) root.at("schema", schema).reject(schema);
    Dossier dossier;
    dossier.version = wordAt(root, "version");
    dossier.steps = listAt<ChainStep>(root, "steps", stepOf);
    dossier.numbers = listAt<TracedNumber>(root, "numbers", numberOf);
    dossier.confirmed = listAt<Confirmation>(root, "confirmed", confirmationOf);
    dossier.verdict = verdictOf(wordAt(root, "verdict"));
    addAsWritten(document.json(), dossier);
    return dossier;
}

Dossier readDossier(const std::string& path, const Progress& progress)
{
    const io::FileBytes bytes(path, progress);
    return dossierFrom(std::string(bytes.view()));
}

std::optional<Dossier> dossierIn(const std::string& folder, const Progress& progress)
{
    const std::filesystem::path path = std::filesystem::path(folder) / dossierFile;
    std::error_code ignored;
    if (folder.empty() || !std::filesystem::exists(path, ignored)) return std::nullopt;
    try {
        return readDossier(path.string(), progress);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace lathelier::chain
