#include "engine/chain/dossier.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/core/texts.h"
#include "engine/core/understanding.h"
#include "engine/io/file.h"
#include "engine/io/json/json_document.h"
#include "engine/report/result_json.h"
#include "engine/shop/shop_codes.h"

namespace lathelier::chain {
namespace {

Json filesJson(const std::vector<InputFile>& files)
{
    Json list = Json::array();
    for (const InputFile& file : files)
        list.push_back({{"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}});
    return list;
}

/// Notes and error of a step as English sentences.
std::vector<std::string> remarksOf(const ChainStep& step)
{
    std::vector<std::string> remarks = step.remarks;
    for (const Note& note : step.notes) remarks.push_back(text(note));
    if (step.error) remarks.push_back(text(*step.error));
    return remarks;
}

Json stepJson(const ChainStep& step)
{
    Json json = {{"step", step.id},
                 {"state", key(step.state)},
                 {"verdict", step.verdict ? Json(lathelier::key(*step.verdict)) : Json(nullptr)},
                 {"result", step.result.empty() ? Json(nullptr) : Json(step.result)},
                 {"inputs", filesJson(step.inputs)},
                 {"outputs", filesJson(step.outputs)},
                 {"roles", step.roles},
                 {"parameters", lathelier::toJson(step.parameters)},
                 {"request", step.request.empty() ? Json(nullptr) : Json(step.request)},
                 {"remarks", remarksOf(step)}};
    if (step.error) json["error"] = lathelier::toJson(*step.error);
    return json;
}

Json numberJson(const TracedNumber& number)
{
    return {
        {"step", number.step},
        {"key", number.key},
        {"value", lathelier::number(number.value)},
        {"file", number.file},
        {"pointer", number.pointer},
        {"uncertainty", lathelier::number(number.uncertainty)},
        {"coverage_factor", number.uncertainty ? Json(number.coverage_factor) : Json(nullptr)},
        {"uncertainty_pointer", number.uncertainty_pointer.empty() ? Json(nullptr) : Json(number.uncertainty_pointer)}};
}

/// True for a note on an assumed value, which a person has to confirm.
bool isAssumption(const Json& note)
{
    if (!note.is_object() || !note.contains("code") || !note["code"].is_string()) return false;
    const std::string code = note["code"];
    return code.find("assumed") != std::string::npos || code.find("guessed") != std::string::npos ||
           code == notes::ofShop.key;
}

/// Notes of all steps, including steps reused from an earlier run.
Json notesOf(const Dossier& dossier)
{
    Json notes = lathelier::toJson(dossier.notes);
    for (const ChainStep& step : dossier.steps)
        if (step.past_notes)
            for (const Json& note : *step.past_notes) notes.push_back(note);
    return notes;
}

/// The files of a dossier on the disk, each read once.
class FilesOnDisk {
public:
    FilesOnDisk(std::filesystem::path folder, const Progress& progress)
        : folder_(std::move(folder)), progress_(progress)
    {
    }

    /// Digest of a file; empty: missing.
    const std::string& sha256(const std::string& path)
    {
        const auto [found, is_new] = digests_.try_emplace(path);
        if (is_new) {
            progress_.check();
            try {
                found->second = io::fileSha256((folder_ / path).string(), progress_);
            } catch (const Error&) {
                found->second.clear();
            }
        }
        return found->second;
    }

    std::int64_t count() const { return static_cast<std::int64_t>(digests_.size()); }

    /// The value at a place of a JSON file; null: missing, or the file is not JSON.
    const Json* value(const std::string& path, const std::string& pointer)
    {
        auto found = documents_.find(path);
        if (found == documents_.end()) {
            found = documents_.emplace(path, nullptr).first;
            try {
                const io::FileBytes bytes((folder_ / path).string(), progress_);
                found->second = Json::parse(bytes.view(), nullptr, false);
            } catch (const Error&) {
                return nullptr;
            }
        }
        if (found->second.is_discarded() || pointer.empty() || pointer.front() != '/') return nullptr;
        try {
            const Json::json_pointer place(pointer);
            return found->second.contains(place) ? &found->second.at(place) : nullptr;
        } catch (const nlohmann::json::exception&) {
            return nullptr;
        }
    }

private:
    std::filesystem::path folder_;
    const Progress& progress_;
    std::map<std::string, std::string> digests_;
    std::map<std::string, Json> documents_;
};

/// Visits a list member of the object, if present.
void eachOf(const io::JsonCursor& object, const char* name, const std::function<void(const io::JsonCursor&)>& use)
{
    if (const auto list = object.member(name)) list->items(mostDossierItems, use);
}

std::string stringAt(const io::JsonCursor& object, const char* name)
{
    return object.at(name, LT_TEXT("Engine", "a text")).string();
}

/// Checks the digests of one step, and that its inputs within the folder are outputs of earlier steps or preparation
/// files.
void checkStep(const io::JsonCursor& step, FilesOnDisk& disk, std::map<std::string, std::string>& made,
               DossierCheck& check)
{
    const std::string id = stringAt(step, "step");
    const auto compare = [&](const io::JsonCursor& file, const char* what) {
        const std::string path = stringAt(file, "path"), stated = stringAt(file, "sha256");
        const std::string& found = disk.sha256(path);
        if (found != stated) check.faults.push_back({id, what, path, {}, found.empty()});
        return std::pair{path, stated};
    };
    std::map<std::string, std::string> taken, own;
    eachOf(step, "inputs", [&](const io::JsonCursor& file) { taken.insert(compare(file, "input")); });
    eachOf(step, "outputs", [&](const io::JsonCursor& file) { own.insert(compare(file, "output")); });
    for (const auto& [path, stated] : taken) {
        if (std::filesystem::path(path).has_parent_path())
            continue;  // an external file: only steps write into the folder
        const auto earlier = made.find(path), same = own.find(path);
        const bool is_known = earlier != made.end() ? earlier->second == stated : same != own.end();
        if (!is_known) check.faults.push_back({id, "input", path, {}, false});
    }
    made.insert(own.begin(), own.end());
}

void checkNumber(const io::JsonCursor& number, FilesOnDisk& disk, const std::map<std::string, std::string>& made,
                 DossierCheck& check)
{
    ++check.numbers;
    const std::string step = stringAt(number, "step"), file = stringAt(number, "file");
    const auto look = [&](const char* value_name, const char* pointer_name) {
        const auto stated = number.member(value_name);
        if (!stated) return;
        const std::string pointer = stringAt(number, pointer_name);
        const Json* const found = made.count(file) ? disk.value(file, pointer) : nullptr;
        const bool is_gone = !found || !found->is_number();
        if (is_gone || found->get<double>() != stated->number())
            check.faults.push_back({step, "number", file, pointer, is_gone});
    };
    look("value", "pointer");
    look("uncertainty", "uncertainty_pointer");
}

}  // namespace

const char* key(StepState state)
{
    constexpr const char* keys[] = {"done", "missing", "failed", "not_reached", "out_of_date"};
    return keys[static_cast<std::size_t>(state)];
}

Text nameOf(StepState state)
{
    switch (state) {
        case StepState::Done: return LT_TEXT("Engine", "done");
        case StepState::Missing: return LT_TEXT("Engine", "missing");
        case StepState::Failed: return LT_TEXT("Engine", "failed");
        case StepState::OutOfDate: return LT_TEXT("Engine", "out of date");
        case StepState::NotReached: break;
    }
    return LT_TEXT("Engine", "not reached");
}

Text nameOf(const StepStanding& standing)
{
    if (standing.state != StepState::Done || standing.isSound()) return nameOf(standing.state);
    return *standing.verdict == Verdict::Fail ? LT_TEXT("Engine", "made, out of tolerance")
                                              : LT_TEXT("Engine", "made, not decided");
}

StepStanding standingOf(const ChainStep& step)
{
    return {step.state, step.state == StepState::Done ? step.verdict : std::nullopt};
}

const ChainStep* Dossier::step(const std::string& id) const
{
    const auto found = std::find_if(steps.begin(), steps.end(), [&id](const ChainStep& step) { return step.id == id; });
    return found == steps.end() ? nullptr : &*found;
}

std::optional<Error> Dossier::error() const
{
    for (const ChainStep& step : steps)
        if (step.state == StepState::Failed) return step.error;
    return std::nullopt;
}

std::optional<Verdict> Dossier::settledVerdict() const
{
    const Json found = understandingOf(*this);
    for (const Json& gap : found["not_modelled"])
        if (gap.value("effect", std::string()) != lathelier::key(GapEffect::None)) return Verdict::Undecided;
    return verdict;
}

bool Dossier::isCorrected(const ChainStep& step) const
{
    const ChainStep* const check = this->step("corrected_check");
    return step.id.starts_with("deflection") && check && check->state == StepState::Done &&
           std::any_of(step.outputs.begin(), step.outputs.end(),
                       [](const InputFile& file) { return file.path.starts_with("program_corrected"); });
}

std::optional<Verdict> Dossier::coverVerdict() const
{
    std::optional<Verdict> worst = settledVerdict();
    for (const ChainStep& step : steps) {
        const StepStanding standing = standingOf(step);
        std::optional<Verdict> found = standing.isSound() || isCorrected(step) ? std::nullopt : standing.verdict;
        if (step.state == StepState::Failed) found = Verdict::Fail;
        if (found) worst = worst ? worse(*worst, *found) : *found;
    }
    return worst;
}

Json understandingOf(const Dossier& dossier)
{
    Json whole = lathelier::toJson(Understanding{});
    for (const ChainStep& step : dossier.steps) {
        if (!step.understanding) continue;
        for (auto& [name, list] : whole.items())
            if (step.understanding->contains(name))
                for (const Json& entry : (*step.understanding)[name]) list.push_back(entry);
    }
    return whole;
}

void add(Dossier& dossier, ChainStep step, const Json& result)
{
    for (Note note : step.notes) {
        lathelier::set(note.values, "step", step.id);
        dossier.notes.push_back(std::move(note));
    }
    if (!step.understanding && result.contains("understanding")) {  // a reused step has what was recorded of it
        Json understanding = result["understanding"];
        for (Json& list : understanding)
            for (Json& entry : list) entry["step"] = step.id;
        step.understanding = std::make_shared<const Json>(std::move(understanding));
    }
    if (step.state == StepState::Done && !step.result.empty())
        for (TracedNumber& number : numbersOf(step.id, result, step.result))
            dossier.numbers.push_back(std::move(number));
    dossier.steps.push_back(std::move(step));
}

Json toJson(const Dossier& dossier)
{
    Json steps = Json::array(), numbers = Json::array(), confirmed = Json::array(), assumed = Json::array();
    for (const ChainStep& step : dossier.steps) steps.push_back(stepJson(step));
    for (const TracedNumber& number : dossier.numbers) numbers.push_back(numberJson(number));
    for (const Json& note : notesOf(dossier))
        if (isAssumption(note)) assumed.push_back(note);
    for (const Confirmation& word : dossier.confirmed)
        confirmed.push_back(
            {{"what", word.what}, {"file", word.file}, {"by", word.by.empty() ? Json(nullptr) : Json(word.by)}});
    const auto word = [](const std::optional<Verdict>& verdict) { return verdict ? Json(key(*verdict)) : Json(); };
    return {{"schema", dossierSchema},
            {"verdict", word(dossier.settledVerdict())},
            {"cover_verdict", word(dossier.coverVerdict())},
            {"steps", steps},
            {"numbers", numbers},
            {"assumed", assumed},
            {"confirmed", confirmed}};
}

Json wholeDossier(const Dossier& dossier, const std::vector<InputFile>& inputs, const Values& parameters)
{
    Json whole = report::wholeResult("remanufacture", inputs, parameters, toJson(dossier), {});
    whole["understanding"] = understandingOf(dossier);
    whole["notes"] = notesOf(dossier);
    return whole;
}

DossierCheck checkDossier(const std::string& path, const Progress& progress)
{
    const io::FileBytes bytes(path, progress);
    const io::JsonDocument document{std::string(bytes.view())};
    const io::JsonCursor root = document.root();
    const Text schema = LT_TEXT("Engine", "the schema of a dossier");
    if (root.at("schema", schema).string() != dossierSchema) root.at("schema", schema).reject(schema);
    DossierCheck check;
    FilesOnDisk disk(std::filesystem::path(path).parent_path(), progress);
    std::map<std::string, std::string> made;
    eachOf(root, "steps", [&](const io::JsonCursor& step) { checkStep(step, disk, made, check); });
    eachOf(root, "numbers", [&](const io::JsonCursor& number) { checkNumber(number, disk, made, check); });
    check.files = disk.count();
    return check;
}

}  // namespace lathelier::chain
