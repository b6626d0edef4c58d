// archive ACTION ARCHIVE [WHAT...]: evaluations kept so that they prove themselves.
#include "engine/archive/archive.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/archive_answer.h"
#include "app/cli/standard_streams.h"
#include "app/cli/verbs.h"
#include "engine/archive/archive_codes.h"
#include "engine/archive/archive_json.h"
#include "engine/archive/result_lines.h"
#include "engine/archive/sql/location.h"
#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/io/file.h"

namespace lathelier {

namespace cli {
namespace {

using archive::Access;
using archive::Archive;

constexpr const char* outputOption = "--output";

enum class ShownVerdict { Any, Pass, Fail, Undecided };

struct ArchiveParameters {
    std::string person, instrument, calibrated_on;
    std::string supersedes, reason;
    bool canonical = false;
    std::string to;
    std::string task, characteristic, recipe;
    ShownVerdict verdict = ShownVerdict::Any;
    std::string from, to_date;
    int most = 1000;
};

const std::vector<Field<ArchiveParameters>>& fieldsOf(const ArchiveParameters*)
{
    using P = ArchiveParameters;
    static const std::vector<Field<P>> all{
        field("person", &P::person, Label{{"Person"}, {"add: who answers for the evaluations."}}),
        field("instrument", &P::instrument, Label{{"Instrument"}, {"add: what the parts were measured with."}}),
        field("calibrated_on", &P::calibrated_on,
              Label{{"Calibrated on"}, {"add: date of the last calibration of the instrument, 2026-11-29."}}),
        field("supersedes", &P::supersedes,
              Label{{"Supersedes"}, {"add: UUID of the row whose place the one evaluation takes; it stays, marked."}}),
        field("reason", &P::reason, Label{{"Reason"}, {"add: why a row is superseded."}}),
        field("canonical", &P::canonical,
              Label{{"Canonical"},
                    {"export: sorted, each evaluation once, without time, person, UUID and chain: equal bytes however "
                     "it was computed."}}),
        field("to", &P::to, Label{{"To"}, {"push: the archive that the rows go to."}}),
        field("task", &P::task, Label{{"Task"}, {"Only this task, such as compare."}}),
        field("characteristic", &P::characteristic, Label{{"Characteristic"}, {"Only this characteristic."}}),
        field("recipe", &P::recipe, Label{{"Recipe"}, {"Only the recipe with this SHA-256."}}),
        field("verdict", &P::verdict,
              {{"any", {"any"}}, {"pass", {"pass"}}, {"fail", {"fail"}}, {"undecided", {"undecided"}}},
              Label{{"Verdict"}, {"Only this verdict; of series that of the value."}}),
        field("from", &P::from, Label{{"From"}, {"Not before this date (UTC), 2026-11-29."}}),
        field("to_date", &P::to_date, Label{{"To date"}, {"Not after this date (UTC)."}}),
        field("most", &P::most, Range{0, 1e9}, Label{{"Most"}, {"The latest so many; 0: all."}})};
    return all;
}

archive::Filter filterOf(const ArchiveParameters& parameters)
{
    archive::Filter filter;
    filter.task = parameters.task;
    filter.characteristic = parameters.characteristic;
    filter.recipe_sha256 = parameters.recipe;
    if (parameters.verdict == ShownVerdict::Pass) filter.verdict = Verdict::Pass;
    if (parameters.verdict == ShownVerdict::Fail) filter.verdict = Verdict::Fail;
    if (parameters.verdict == ShownVerdict::Undecided) filter.verdict = Verdict::Undecided;
    filter.from = parameters.from;
    filter.to = parameters.to_date;
    filter.most = parameters.most;
    return filter;
}

/// One run of the verb.
struct Asked {
    std::string location;
    std::vector<std::string> what;
    ArchiveParameters parameters;
    std::string output;    ///< empty: standard output
    bool in_full = false;  ///< JSON is asked for
    io::InputFiles& inputs;
    const Progress& progress;
    Answer& answer;

    Archive open(Access access) const
    {
        Archive opened = Archive::open(location, access, progress);
        answer.notes.insert(answer.notes.end(), opened.notes().begin(), opened.notes().end());
        return opened;
    }
};

/// At most one word behind the archive.
std::string oneWord(const Asked& asked, Text expected)
{
    if (asked.what.size() != 1) refuseOption("WHAT", asked.what.empty() ? "" : asked.what[1], expected);
    return asked.what.front();
}

void noWord(const Asked& asked)
{
    if (!asked.what.empty()) refuseOption("WHAT", asked.what.front(), LT_TEXT("Engine", "nothing behind the archive"));
}

void runCreate(const Asked& asked)
{
    noWord(asked);
    const Archive made = asked.open(Access::Create);
    const std::string& location = made.location();
    asked.answer.json = [location = std::string(location)] { return Json{{"location", location}}; };
    asked.answer.summary = fill(text(LT_TEXT("Engine", "Made: {location}")), {{"location", location}}) + "\n";
}

archive::ResultLines readAll(const Asked& asked)
{
    archive::ResultLines all;
    for (const std::string& path : asked.what) {
        try {
            const std::string_view bytes = asked.inputs.open(path, asked.progress);
            archive::ResultLines lines = archive::readResultLines(bytes, asked.progress);
            asked.inputs.drop();
            std::move(lines.evaluations.begin(), lines.evaluations.end(), std::back_inserter(all.evaluations));
            std::move(lines.recipes.begin(), lines.recipes.end(), std::back_inserter(all.recipes));
        } catch (Error& error) {
            throw error.with("path", path);
        }
    }
    return all;
}

/// A missing file is made; one that another program makes meanwhile is taken.
Archive openOrMake(const Asked& asked)
{
    std::error_code ignored;
    if (archive::isDatabase(asked.location) || std::filesystem::exists(asked.location, ignored))
        return asked.open(Access::Write);
    try {
        return asked.open(Access::Create);
    } catch (const Error& error) {
        if (!(error.code() == errors::archiveExists)) throw;
        return asked.open(Access::Write);
    }
}

void runAdd(const Asked& asked)
{
    if (asked.what.empty()) refuseOption("WHAT", "", LT_TEXT("Engine", "the files of results to add"));
    const ArchiveParameters& parameters = asked.parameters;
    const archive::ResultLines lines = readAll(asked);
    const bool is_correction = !parameters.supersedes.empty();
    if (!is_correction && !parameters.reason.empty())
        refuseOption("--reason", parameters.reason, LT_TEXT("Engine", "--supersedes beside it"));
    if (is_correction && lines.evaluations.size() != 1)
        throw Error(errors::countOfEvaluations, {{"found", static_cast<std::int64_t>(lines.evaluations.size())}});
    const archive::Attestation attestation{parameters.person, parameters.instrument, parameters.calibrated_on};
    Archive opened = openOrMake(asked);
    archive::Added added;
    if (is_correction) {
        added.uuids.push_back(opened.supersede(parameters.supersedes, lines.evaluations.front(), parameters.reason,
                                               attestation, lines.recipes, asked.progress));
        added.added = 1;
    } else {
        added = opened.add(lines.evaluations, attestation, lines.recipes, asked.progress);
    }
    const std::int64_t superseded = is_correction ? 1 : 0;
    asked.answer.json = [added, superseded] {
        return Json{{"added", added.added},
                    {"already_there", added.already_there},
                    {"superseded", superseded},
                    {"uuids", added.uuids}};
    };
    asked.answer.summary =
        fill(text(LT_TEXT("Engine", "Added: {added}. Already there: {already_there}. Superseded: {superseded}.")),
             {{"added", added.added}, {"already_there", added.already_there}, {"superseded", superseded}}) +
        "\n";
}

void runList(const Asked& asked)
{
    noWord(asked);
    const auto entries = asked.open(Access::Read).list(filterOf(asked.parameters), asked.progress);
    asked.answer.json = [entries] {
        Json json{{"entries", Json::array()}};
        for (const archive::Entry& entry : entries) json["entries"].push_back(entryJson(entry));
        return json;
    };
    asked.answer.summary = entriesText(entries);
}

void runShow(const Asked& asked)
{
    const std::string uuid = oneWord(asked, LT_TEXT("Engine", "one UUID, or its first characters"));
    const auto record = asked.open(Access::Read).show(uuid, asked.progress);
    asked.answer.json = [record] { return recordJson(record); };
    asked.answer.summary = recordText(record);
}

void runCharacteristics(const Asked& asked)
{
    noWord(asked);
    const auto found = asked.open(Access::Read).characteristics(filterOf(asked.parameters), asked.progress);
    asked.answer.json = [found] {
        Json json{{"characteristics", Json::array()}};
        for (const archive::ArchivedCharacteristic& one : found)
            json["characteristics"].push_back(archive::toJson(one));
        return json;
    };
    asked.answer.summary = characteristicsText(found);
}

void runSeries(const Asked& asked)
{
    const bool is_option = asked.what.empty() && !asked.parameters.characteristic.empty();
    const std::string characteristic = is_option ? asked.parameters.characteristic
                                                 : oneWord(asked, LT_TEXT("Engine", "the key of one characteristic"));
    const Archive opened = asked.open(Access::Read);
    const auto points = opened.series(characteristic, filterOf(asked.parameters), asked.progress);
    archive::Filter same;
    same.task = asked.parameters.task;
    same.characteristic = characteristic;
    const archive::ArchivedCharacteristic named = opened.characteristics(same).front();
    asked.answer.json = [named, points] {
        Json json{{"task", named.task}, {"characteristic", named.key}, {"unit", named.unit}, {"points", Json::array()}};
        for (const archive::SeriesPoint& point : points) json["points"].push_back(archive::toJson(point));
        return json;
    };
    asked.answer.summary = seriesText(characteristic + (named.unit.empty() ? "" : " (" + named.unit + ")"), points);
}

void runExport(const Asked& asked)
{
    noWord(asked);
    if (asked.output.empty() && asked.in_full)  // both might go to standard output
        refuseOption(outputOption, "", LT_TEXT("Engine", "a file for the lines where --json is given"));
    const Archive opened = asked.open(Access::Read);
    std::int64_t lines = 0;
    const bool canonical = asked.parameters.canonical;
    const auto writeTo = [&](const std::function<void(std::string_view)>& write) {
        opened.exportLines(
            [&](std::string_view line) {
                write(line);
                ++lines;
            },
            canonical, asked.progress);
    };
    if (asked.output.empty())
        writeTo([&](std::string_view line) { print(Stream::Answers, line, asked.progress); });
    else
        io::writeFile(asked.output, [&](const io::Append& append) { writeTo(append); });
    asked.answer.json = [lines] { return Json{{"lines", lines}}; };
    if (!asked.output.empty())
        asked.answer.summary = fill(text(LT_TEXT("Engine", "Lines written: {lines}")), {{"lines", lines}}) + "\n";
}

void runVerify(const Asked& asked)
{
    noWord(asked);
    const auto made = asked.open(Access::Read).verify(asked.progress);
    asked.answer.always_strict = true;
    asked.answer.pass = !made.broken.has_value();
    asked.answer.json = [made] { return verificationJson(made); };
    asked.answer.summary = verificationText(made);
}

void runPush(const Asked& asked)
{
    noWord(asked);
    if (asked.parameters.to.empty()) refuseOption("--to", "", LT_TEXT("Engine", "the archive that the rows go to"));
    const Archive from = asked.open(Access::Read);
    Archive to = Archive::open(asked.parameters.to, Access::Write, asked.progress);
    const archive::Pushed pushed = from.push(to, asked.progress);
    asked.answer.json = [pushed] { return Json{{"pushed", pushed.pushed}, {"already_there", pushed.already_there}}; };
    asked.answer.summary = fill(text(LT_TEXT("Engine", "Pushed: {pushed}. Already there: {already_there}.")),
                                {{"pushed", pushed.pushed}, {"already_there", pushed.already_there}}) +
                           "\n";
}

struct Action {
    const char* name;
    void (*run)(const Asked&);
};

constexpr std::array<Action, 9> actions{{{"create", runCreate},
                                         {"add", runAdd},
                                         {"list", runList},
                                         {"show", runShow},
                                         {"characteristics", runCharacteristics},
                                         {"series", runSeries},
                                         {"export", runExport},
                                         {"verify", runVerify},
                                         {"push", runPush}}};

void runArchive(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    // As they may be shown: a location that holds a password is refused, and does not stand in the answer either.
    answer.parameters = request.parameters;
    if (const Value* to = find(request.parameters, "to"))
        set(answer.parameters, "to", archive::sql::withoutSecrets(std::get<std::string>(*to)));
    const auto output = request.outputs.find(outputOption);
    const Asked asked{request.operands.at(1),
                      {request.operands.begin() + 2, request.operands.end()},
                      fromValues<ArchiveParameters>(request.parameters),
                      output == request.outputs.end() ? std::string() : output->second,
                      request.in_full,
                      inputs,
                      progress,
                      answer};
    for (const Action& action : actions)
        if (request.operands.front() == action.name) {
            action.run(asked);
            return;
        }
    refuseOption("ACTION", request.operands.front(),
                 LT_TEXT("Engine", "create, add, list, show, characteristics, series, export, verify or push"));
}

}  // namespace

Verb archiveVerb()
{
    return {"archive",
            "Keep evaluations so that they prove themselves: add, list, chart, export, verify.",
            {{"ACTION", "create, add, list, show, characteristics, series, export, verify or push."},
             {"ARCHIVE", "A file, or a database: postgresql://user@host/name, host=… dbname=… or service=…"},
             {"WHAT", "add: JSON Lines of a batch; show: a UUID; series: a characteristic.", true, false, true}},
            optionsOf<ArchiveParameters>(),
            {},
            {{outputOption, "export: write the lines into this file; else to standard output."}},
            false,
            runArchive};
}

}  // namespace cli
}  // namespace lathelier
