// roundness PROFILE...: form deviation by the four reference circles, harmonics, uncertainty and verdict.
#include "engine/form/roundness/roundness.h"

#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "app/cli/filter_option.h"
#include "app/cli/records.h"
#include "app/cli/verbs.h"
#include "engine/core/core_codes.h"
#include "engine/form/roundness/roundness_dfq.h"
#include "engine/form/roundness/roundness_quantities.h"
#include "engine/form/roundness/roundness_report.h"
#include "engine/form/roundness/superimpose.h"
#include "engine/form/roundness/superimpose_report.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr const char* dfqOption = "--dfq";
constexpr const char* superimposeKey = "superimpose";
constexpr const char* mirroredKey = "mirrored";

/// Results of a request so far, from which JSON and report are made on request.
struct Found {
    std::vector<std::string> paths;
    std::vector<form::RoundnessResult> results;
    std::optional<form::SuperimposeResult> superimposed;
};

bool isSet(const Request& request, const char* key)
{
    const Value* value = find(request.parameters, key);
    return value && *value == Value(true);
}

std::optional<std::string> statedWord(const Request& request, const char* key)
{
    const Value* value = find(request.parameters, key);
    if (!value || !std::holds_alternative<std::string>(*value)) return std::nullopt;
    return std::get<std::string>(*value);
}

/// Invalid combinations are rejected before the computation.
void checkCombination(const Request& request, const form::RoundnessParameters& parameters)
{
    checkNoFilter(request, parameters);
    if (statedWord(request, superimposeKey) && request.operands.size() != 1)
        throw Error(errors::valueNotUnderstood, {{"parameter", "--superimpose"},
                                                 {"found", static_cast<std::int64_t>(request.operands.size())},
                                                 {"expected", LT_TEXT("Engine", "one profile to lay the other on")}});
}

Json toJson(const Found& found)
{
    Json json{{"profiles", Json::array()}};
    for (std::size_t i = 0; i < found.results.size(); ++i) {
        Json profile{{"path", found.paths[i]}};
        profile.update(form::toJson(found.results[i]));
        json["profiles"].push_back(std::move(profile));
    }
    if (found.superimposed) json["superimposed"] = form::toJson(*found.superimposed);
    return json;
}

/// All pass: pass; any out of tolerance: fail; otherwise none.
std::optional<bool> verdictOf(const std::vector<form::RoundnessResult>& results)
{
    bool all = !results.empty();
    for (const form::RoundnessResult& result : results) {
        if (result.verdict == Verdict::Fail) return false;
        all &= result.verdict == Verdict::Pass;
    }
    return all ? std::optional(true) : std::nullopt;
}

std::string summaryOf(const Found& found)
{
    std::string summary;
    for (std::size_t i = 0; i < found.results.size(); ++i) {
        if (found.results.size() > 1) summary += (i ? "\n" : "") + found.paths[i] + "\n";
        summary += report::toPlainText(roundnessSummary(found.results[i]));
    }
    if (found.superimposed) summary += "\n" + report::toPlainText(superimposeSection(*found.superimposed));
    return summary;
}

/// When the profiles were measured, by their files; now for a pipe.
std::vector<std::string> measuredTimes(const std::vector<std::string>& paths)
{
    std::vector<std::string> times;
    for (const std::string& path : paths) {
        struct stat status {};
        const bool isFile = ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
        times.push_back(isFile ? io::qdasTime(status.st_mtime) : std::string());
    }
    return times;
}

void superimposeOther(const Request& request, const std::string& path, const Profile& first,
                      const form::RoundnessParameters& parameters, io::InputFiles& inputs, const Progress& progress,
                      Answer& answer, Found& found)
{
    const io::ProfileFile other = readProfile(path, request, inputs, progress.part(0, 0.3), answer);
    form::SuperimposeParameters wanted;
    wanted.form = parameters;
    wanted.mirrored = isSet(request, mirroredKey);
    try {
        found.superimposed = superimpose(first, other.profile, wanted, progress.part(0.3, 1));
    } catch (Error& error) {
        error.with("path", path);  // the first profile was evaluated before
        throw;
    }
    const Notes& notes = found.superimposed->notes;
    answer.notes.insert(answer.notes.end(), notes.begin(), notes.end());
}

void runRoundness(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<form::RoundnessParameters>(request.parameters);
    checkCombination(request, parameters);
    const auto found = std::make_shared<Found>();
    answer.json = [found] { return toJson(*found); };
    const auto other = statedWord(request, superimposeKey);
    const double share = 1.0 / static_cast<double>(request.operands.size() + (other ? 1 : 0));
    for (std::size_t i = 0; i < request.operands.size(); ++i) {
        const std::string& path = request.operands[i];
        const Progress part = progress.part(static_cast<double>(i) * share, static_cast<double>(i + 1) * share);
        try {
            const std::size_t before = answer.notes.size();
            const io::ProfileFile file =
                readProfile(path, request, inputs, part.part(0, 0.3, LT_TEXT("Engine", "Reading")), answer);
            form::RoundnessResult result =
                roundness(file.profile, parameters, part.part(0.3, 1, LT_TEXT("Engine", "Evaluating")),
                          request.in_full ? form::MethodTable::Made : form::MethodTable::LeftOut);
            if (result.name.empty()) result.name = path;
            answer.notes.insert(answer.notes.end(), result.notes.begin(), result.notes.end());
            // The report and the profile's own notes hold those of its file as well.
            result.notes.assign(answer.notes.begin() + static_cast<std::ptrdiff_t>(before), answer.notes.end());
            found->paths.push_back(path);
            found->results.push_back(std::move(result));
            if (other)
                superimposeOther(request, *other, file.profile, parameters, inputs, progress.part(1 - share, 1), answer,
                                 *found);
        } catch (Error& error) {  // the other profiles are answered all the same
            answer.errors.push_back(error.with("path", path));
        }
    }
    if (const auto dfq = request.outputs.find(dfqOption); dfq != request.outputs.end() && answer.errors.empty())
        io::writeDfq(dfq->second, qdasFile(found->results, measuredTimes(found->paths)));
    answer.pass = verdictOf(found->results);
    answer.summary = summaryOf(*found);
    answer.report = [found] {
        report::Document document = roundnessReport(found->results, {});
        if (found->superimposed) document.sections.push_back(superimposeSection(*found->superimposed));
        return document;
    };
}

std::vector<Option> roundnessOptions()
{
    std::vector<Option> options = optionsOf<form::RoundnessParameters>();
    options.insert(options.begin(), noFilterOption());
    FieldInfo other;
    other.key = superimposeKey;
    other.kind = FieldInfo::Kind::Word;
    other.label = LT_TEXT("Engine", "Superimpose");
    other.help = LT_TEXT("Engine", "Lay the profile of this file on the one given: rotation and centre fitted.");
    other.optional = true;
    options.push_back({other, {}});
    options.push_back(flagOption(mirroredKey, LT_TEXT("Engine", "Mirrored"),
                                 LT_TEXT("Engine", "Superimpose also the other way round.")));
    return options;
}

}  // namespace

Verb roundnessVerb()
{
    return {"roundness",
            "Roundness of profiles: four reference circles, harmonics, uncertainty, verdict.",
            {{"PROFILE", "A measured profile: x,y or angle,radius in a text table.", true}},
            roundnessOptions(),
            {&io::profileFiles()},
            {{dfqOption, "Write the deviations as Q-DAS characteristics (FILE.dfq)."}},
            true,
            runRoundness};
}

}  // namespace lathelier::cli
