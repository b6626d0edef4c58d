#include "engine/batch/batch.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "engine/batch/batch_codes.h"
#include "engine/batch/ordered_jobs.h"
#include "engine/batch/recipe_file.h"
#include "engine/core/failure.h"
#include "engine/core/parallel.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"

namespace lathelier::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostDuplicatesNamed = 100;

/// What became of a part.
struct PartOutcome {
    enum class Kind { Computed, TakenOver, Duplicate, Unreadable };
    Kind kind = Kind::Computed;
    Standing standing = Standing::None;
    std::string line;                ///< to be written; empty: none
    std::string key;                 ///< of a refusal that was taken over
    std::optional<Failure> failure;  ///< of one of this run
    std::size_t same_as = 0;         ///< place of the part with this content
};

using Kind = PartOutcome::Kind;

void makeFolder(const std::string& path)
{
    std::error_code problem;
    fs::create_directories(path, problem);
    if (problem) throw Error(errors::fileNotWritable, {{"path", path}, {"reason", problem.message()}});
}

void requireOtherFolder(const std::vector<std::string>& inputs, const std::string& folder)
{
    for (const std::string& input : inputs) {
        std::error_code unknown;
        if (fs::is_directory(input, unknown) && fs::equivalent(input, folder, unknown))
            throw Error(errors::outputIsInput, {{"parameter", std::string("--out")}, {"file", input}});
    }
}

/// The names of the reports of all parts: two parts of one file name have two reports in every shard.
std::vector<std::string> reportNames(const std::vector<Part>& parts)
{
    std::map<std::string, int> taken;
    std::vector<std::string> names;
    names.reserve(parts.size());
    for (const Part& part : parts) {
        const std::string stem = fs::path(part.name()).filename().string();
        std::string name = stem;
        for (int again = ++taken[stem]; again > 1 && taken[name = stem + "-" + std::to_string(again)]++ > 0; ++again) {
        }
        names.push_back(name + ".html");
    }
    return names;
}

std::string lineOf(const PartRun::Answer& answer)
{
    Json json = archive::toJson(answer.evaluation);
    if (answer.error) json["message"] = failureOf(0, {}, *answer.error).message;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

class Run {
public:
    Run(const std::vector<std::string>& inputs, const Recipe& recipe, const BatchSettings& settings,
        const Progress& progress)
        : settings_(settings), progress_(progress), run_(recipe, settings.complete, progress)
    {
        result_.task = recipe.task->key;
        result_.recipe_sha256 = identityOf(recipe);
        takeParts(partsOf(inputs, recipe, progress));
        makeFolder(settings.folder);
        requireOtherFolder(inputs, settings.folder);
        if (settings.reports) makeFolder(pathOf("reports"));
        requireRecipe(settings.folder, result_.recipe_sha256);
        result_.results_file = pathOf(settings.shard.fileName("results", ".jsonl"));
        result_.failures_file = pathOf(settings.shard.fileName("failures", ".csv"));
        file_.emplace(result_.results_file, Json{{"recipe", contentOf(recipe)}, {"sha256", result_.recipe_sha256}});
        if (!settings.asked.recipe.empty()) remember(settings.folder, settings.asked);
        known_.emplace(settings.folder, progress.part(0, 0.01));
    }

    BatchResult answer()
    {
        const std::size_t threads = threadsAllowed();
        const std::size_t asked = settings_.jobs > 0 ? static_cast<std::size_t>(settings_.jobs) : threads;
        const std::size_t jobs = std::max<std::size_t>(1, std::min(asked, parts_.size()));
        // The jobs are threads themselves; the loops inside share what is left.
        const ThreadLimit limit(static_cast<int>(threads > jobs ? threads - jobs + 1 : 1));
        OrderedJobs<PartOutcome> ordered(parts_.size(), jobs);
        try {
            ordered.run(
                jobs, onThreads, [&](std::size_t place) { return work(place, ordered); },
                [&](std::size_t place, PartOutcome& outcome) { leave(place, outcome); });
        } catch (...) {
            close();
            throw;
        }
        close();
        return std::move(result_);
    }

private:
    std::string pathOf(const std::string& name) const { return (fs::path(settings_.folder) / name).string(); }

    void takeParts(std::vector<Part> all)
    {
        std::vector<std::string> names;
        if (settings_.reports) names = reportNames(all);
        const auto count = static_cast<std::size_t>(settings_.shard.count);
        for (auto place = static_cast<std::size_t>(settings_.shard.number - 1); place < all.size(); place += count) {
            if (settings_.reports) reports_.push_back(pathOf("reports/" + names[place]));
            places_.push_back(place);
            parts_.push_back(std::move(all[place]));
        }
        result_.parts = static_cast<std::int64_t>(parts_.size());
    }

    Failure failure(std::size_t place, const Error& error) const
    {
        return failureOf(places_[place], parts_[place].name(), error);
    }

    PartOutcome work(std::size_t place, OrderedJobs<PartOutcome>& ordered)
    {
        progress_.check();
        PartOutcome outcome;
        archive::Evaluation begun;
        std::string key;
        try {
            begun = run_.begin(parts_[place]);
            key = begun.key();
        } catch (const Cancelled&) {
            throw;
        } catch (const std::exception& problem) {
            outcome.kind = Kind::Unreadable;
            outcome.failure = failure(place, toError(problem));
        }
        ordered.turn(place, [&] { decide(place, key, outcome); });
        if (outcome.kind == Kind::Computed)
            compute(place, std::move(begun), outcome);
        else if (outcome.kind == Kind::TakenOver && lacksReport(place, outcome))
            writeReport(place, std::move(begun), outcome);
        return outcome;
    }

    /// In the order of the parts: which of two of one content is the first.
    void decide(std::size_t place, const std::string& key, PartOutcome& outcome)
    {
        if (outcome.kind == Kind::Unreadable) return;
        const auto [first, isNew] = seen_.emplace(beginOf(key), place);
        if (!isNew) {
            outcome.kind = Kind::Duplicate;
            outcome.same_as = first->second;
        } else if (const auto standing = known_->find(key)) {
            outcome.kind = Kind::TakenOver;
            outcome.standing = *standing;
            if (*standing == Standing::Failed) outcome.key = key;
        }
    }

    void compute(std::size_t place, archive::Evaluation begun, PartOutcome& outcome)
    {
        const std::string key = begun.key();
        PartRun::Answer answer = run_.answer(parts_[place], std::move(begun), settings_.reports);
        keepReport(place, answer);
        if (answer.error) outcome.failure = failure(place, *answer.error);
        outcome.standing = answer.error ? Standing::Failed : standingOf(answer.evaluation.verdict);
        // With files of its own that its name does not tell, a part is known only after it was read.
        const std::string whole = answer.evaluation.key();
        if (answer.is_lasting && (whole == key || !known_->find(whole))) outcome.line = lineOf(answer);
    }

    bool lacksReport(std::size_t place, const PartOutcome& outcome) const
    {
        std::error_code unknown;
        return settings_.reports && outcome.standing != Standing::Failed && !fs::exists(reports_[place], unknown);
    }

    /// Of a part that was answered without.
    void writeReport(std::size_t place, archive::Evaluation begun, PartOutcome& outcome)
    {
        PartRun::Answer answer = run_.answer(parts_[place], std::move(begun), true);
        keepReport(place, answer);
        if (answer.error) outcome.failure = failure(place, *answer.error);
    }

    void keepReport(std::size_t place, PartRun::Answer& answer) const
    {
        if (answer.report.empty()) return;
        try {
            io::writeFile(reports_[place], answer.report);
        } catch (const Error& error) {
            answer.error = error;
            answer.is_lasting = false;
        }
    }

    void leave(std::size_t place, PartOutcome& outcome)
    {
        if (!outcome.line.empty()) file_->append(std::move(outcome.line));
        switch (outcome.kind) {
            case Kind::Computed: ++result_.computed; break;
            case Kind::TakenOver: ++result_.taken_over; break;
            case Kind::Duplicate: noteDuplicate(place, outcome.same_as); break;
            case Kind::Unreadable: break;
        }
        if (outcome.failure)
            result_.failures.push_back(*std::move(outcome.failure));
        else if (!outcome.key.empty())
            refusedBefore_.emplace_back(std::move(outcome.key), place);
        else if (outcome.kind != Kind::Duplicate)
            ++result_.verdicts[static_cast<std::size_t>(outcome.standing)];
        const double done = static_cast<double>(place + 1) / static_cast<double>(parts_.size());
        progress_.part(0.01, 1, LT_TEXT("Engine", "Evaluating the parts")).report(done);
    }

    void noteDuplicate(std::size_t place, std::size_t first)
    {
        ++result_.duplicates;
        if (static_cast<std::size_t>(result_.duplicates) <= mostDuplicatesNamed)
            result_.notes.push_back(
                {notes::partRepeated, {{"path", parts_[place].name()}, {"other", parts_[first].name()}}});
    }

    /// What was finished is on the disk and listed, whatever ended the run.
    void close()
    {
        file_->flush();
        std::sort(refusedBefore_.begin(), refusedBefore_.end());
        std::vector<std::string> keys;
        keys.reserve(refusedBefore_.size());
        for (const auto& [key, place] : refusedBefore_) keys.push_back(key);
        forFailed(settings_.folder, keys,
                  [&](const std::string& key, const Json& line) {
                      const auto at =
                          static_cast<std::size_t>(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin());
                      const std::size_t place = refusedBefore_[at].second;
                      if (!listed_.insert(key).second) return;  // two shards had parts of one content
                      result_.failures.push_back(failureFrom(places_[place], parts_[place].name(), line));
                  },
                  {});
        std::sort(result_.failures.begin(), result_.failures.end(),
                  [](const Failure& a, const Failure& b) { return a.place < b.place; });
        writeFailures(result_.failures_file, result_.failures);
        if (const auto more = result_.duplicates - static_cast<std::int64_t>(mostDuplicatesNamed); more > 0)
            result_.notes.push_back({notes::partsRepeated, {{"count", more}}});
    }

    const BatchSettings& settings_;
    const Progress& progress_;
    PartRun run_;
    BatchResult result_;
    std::vector<Part> parts_;           ///< of this shard
    std::vector<std::size_t> places_;   ///< in the whole list, from 0
    std::vector<std::string> reports_;  ///< paths of their reports; empty: none are asked for
    std::optional<ResultsFile> file_;
    std::optional<KnownResults> known_;
    std::map<KeyBegin, std::size_t> seen_;                            ///< first part of each key of this run
    std::vector<std::pair<std::string, std::size_t>> refusedBefore_;  ///< key and part of refusals taken over
    std::set<std::string> listed_;                                    ///< those among the failures
};

}  // namespace

std::optional<bool> BatchResult::pass() const
{
    const auto of = [this](Standing standing) { return verdicts[static_cast<std::size_t>(standing)]; };
    if (of(Standing::Fail) + of(Standing::Undecided) > 0) return false;
    if (of(Standing::Pass) > 0) return true;
    return std::nullopt;
}

BatchResult runBatch(const std::vector<std::string>& inputs, const Recipe& recipe, const BatchSettings& settings,
                     const Progress& progress)
{
    requireUnchanged(recipe, progress);
    return Run(inputs, recipe, settings, progress).answer();
}

}  // namespace lathelier::batch
