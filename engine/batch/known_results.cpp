#include "engine/batch/known_results.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/batch/batch_codes.h"
#include "engine/core/verdict_json.h"
#include "engine/io/io_codes.h"

namespace lathelier::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t keyLength = 64;
constexpr std::int64_t linesBetweenChecks = 16;

/// The members of an evaluation before its characteristics: what follows is long and is not needed.
class EvaluationHead : public nlohmann::json_sax<Json> {
public:
    const std::string& keyOfEvaluation() const { return evaluationKey_; }
    bool isWhole() const { return evaluationKey_.size() == keyLength && exitCode_; }
    Standing standing() const { return *exitCode_ != 0 ? Standing::Failed : standingOf(verdict_); }

    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool number_integer(number_integer_t value) override { return takeNumber(value); }
    bool number_unsigned(number_unsigned_t value) override { return takeNumber(static_cast<std::int64_t>(value)); }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }
    bool string(string_t& value) override
    {
        if (depth_ != 1) return true;
        if (member_ == "key") evaluationKey_ = value;
        if (member_ == "verdict") verdict_ = verdictOf(value);
        return true;
    }
    bool start_object(std::size_t /*size*/) override { return enter(); }
    bool key(string_t& name) override
    {
        if (depth_ == 1) member_ = name;
        return depth_ != 1 || name != "characteristics";
    }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t /*size*/) override { return enter(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                     const nlohmann::detail::exception& /*problem*/) override
    {
        return false;
    }

private:
    bool enter()
    {
        ++depth_;
        return true;
    }
    bool leave()
    {
        --depth_;
        return true;
    }
    bool takeNumber(std::int64_t value)
    {
        if (depth_ == 1 && member_ == "exit_code") exitCode_ = value;
        return true;
    }

    std::size_t depth_ = 0;
    std::string member_;
    std::string evaluationKey_;
    std::optional<std::int64_t> exitCode_;
    std::optional<Verdict> verdict_;
};

[[noreturn]] void refuseLine(const std::string& path, std::int64_t number, const std::string& line,
                             const Value& expected)
{
    constexpr std::size_t shown = 40;
    throw Error(errors::malformed,
                {{"path", path}, {"line", number}, {"found", line.substr(0, shown)}, {"expected", expected}});
}

/// Calls use(number, line) for each complete line; what follows the last end of line is still being written, or was
/// when its writer was killed.
void forLines(const std::string& path, const Progress& progress,
              const std::function<void(std::int64_t number, const std::string& line)>& use)
{
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw Error(errors::fileNotReadable, {{"path", path}, {"reason", LT_TEXT("Engine", "it does not open")}});
    std::string line;
    for (std::int64_t number = 1; std::getline(file, line) && !file.eof(); ++number) {
        if (number % linesBetweenChecks == 0) progress.check();
        use(number, line);
    }
}

/// Calls use(line, head) for each evaluation of the folder.
void forEvaluations(const std::string& folder, const Progress& progress,
                    const std::function<void(const std::string& line, const EvaluationHead& head)>& use)
{
    for (const std::string& path : resultsIn(folder))
        forLines(path, progress, [&](std::int64_t number, const std::string& line) {
            if (number == 1) return;  // the recipe
            EvaluationHead head;
            Json::sax_parse(line, &head);
            if (!head.isWhole()) refuseLine(path, number, line, LT_TEXT("Engine", "an evaluation on one line"));
            use(line, head);
        });
}

}  // namespace

Standing standingOf(const std::optional<Verdict>& verdict)
{
    if (!verdict) return Standing::None;
    switch (*verdict) {
        case Verdict::Pass: return Standing::Pass;
        case Verdict::Fail: return Standing::Fail;
        case Verdict::Undecided: return Standing::Undecided;
    }
    return Standing::None;
}

std::vector<std::string> resultsIn(const std::string& folder)
{
    std::vector<std::string> paths;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
        const std::string name = entry->path().filename().string();
        const bool isOfShard = name.starts_with("results-") && name.find("-of-") != std::string::npos;
        if (name.ends_with(".jsonl") && (isOfShard || name == "results.jsonl")) paths.push_back(entry->path().string());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

void requireRecipe(const std::string& folder, const std::string& recipe_sha256)
{
    for (const std::string& path : resultsIn(folder)) {
        std::ifstream file(path, std::ios::binary);
        std::string line;
        if (!std::getline(file, line) || file.eof()) continue;  // nothing but a line that was never whole
        const Json json = Json::parse(line, nullptr, false);
        const auto stated = json.is_object() ? json.find("sha256") : json.end();
        if (!json.is_object() || stated == json.end() || !stated->is_string() || !json.contains("recipe"))
            refuseLine(path, 1, line, LT_TEXT("Engine", "a recipe and its SHA-256"));
        if (stated->get<std::string>() != recipe_sha256)
            throw Error(errors::batchOtherRecipe,
                        {{"path", path}, {"found", stated->get<std::string>()}, {"expected", recipe_sha256}});
    }
}

KeyBegin beginOf(const std::string& key)
{
    KeyBegin begin{};
    for (std::size_t i = 0; i < begin.size() && 2 * i + 2 <= key.size(); ++i)
        std::from_chars(key.data() + 2 * i, key.data() + 2 * i + 2, begin[i], 16);
    return begin;
}

KnownResults::KnownResults(const std::string& folder, const Progress& progress)
{
    forEvaluations(folder, progress, [this](const std::string&, const EvaluationHead& head) {
        entries_.push_back({beginOf(head.keyOfEvaluation()), head.standing()});
    });
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
}

std::optional<Standing> KnownResults::find(const std::string& key) const
{
    const KeyBegin begin = beginOf(key);
    const auto found = std::lower_bound(entries_.begin(), entries_.end(), begin,
                                        [](const Entry& entry, const auto& sought) { return entry.key < sought; });
    if (found == entries_.end() || found->key != begin) return std::nullopt;
    return found->standing;
}

void forFailed(const std::string& folder, const std::vector<std::string>& keys,
               const std::function<void(const std::string& key, const Json& line)>& use, const Progress& progress)
{
    if (keys.empty()) return;
    forEvaluations(folder, progress, [&](const std::string& line, const EvaluationHead& head) {
        const std::string& key = head.keyOfEvaluation();
        if (head.standing() == Standing::Failed && std::binary_search(keys.begin(), keys.end(), key))
            use(key, Json::parse(line));
    });
}

}  // namespace lathelier::batch
