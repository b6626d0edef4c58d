#include "engine/series/series_task.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/archive/archive_kind.h"
#include "engine/core/json.h"
#include "engine/series/series_codes.h"
#include "engine/series/series_report.h"

namespace lathelier::series {
namespace {

using archive::ArchivedCharacteristic;
using archive::SeriesPoint;

constexpr const char* answerCharacteristic = "answer";
constexpr std::size_t largestResult_bytes = std::size_t{1} << 20;  ///< of which a picture is looked for

/// A file rules over a database, as its input does in the window.
std::string locationOf(const project::PanelState& state, const SeriesQuestion& question)
{
    const project::Source* const file = task::sourceOf(state, archiveRole);
    return file ? file->path : question.database;
}

task::Input archiveInput()
{
    task::Input input;
    input.role = archiveRole;
    input.label = LT_TEXT("Engine", "Archive");
    input.help = LT_TEXT("Engine", "Evaluations kept by the command archive, in a file.");
    input.kinds = {&archive::archiveFiles()};
    return input;
}

std::string latestTask(const std::vector<ArchivedCharacteristic>& all)
{
    const auto latest = std::max_element(
        all.begin(), all.end(), [](const auto& a, const auto& b) { return a.last_recorded_at < b.last_recorded_at; });
    return latest->task;
}

void choose(SeriesOutcome& outcome, std::vector<ArchivedCharacteristic> all)
{
    if (all.empty()) throw Error(errors::archiveEmpty, {});
    const SeriesQuestion& question = outcome.question;
    std::string task = question.task;
    const auto has = [](const std::string& key) {
        return [&key](const ArchivedCharacteristic& one) { return one.key == key; };
    };
    if (task.empty() && !question.characteristic.empty())
        if (const auto found = std::find_if(all.begin(), all.end(), has(question.characteristic)); found != all.end())
            task = found->task;
    if (task.empty()) task = latestTask(all);
    std::erase_if(all, [&task](const ArchivedCharacteristic& one) { return one.task != task; });
    const std::string& wanted = question.characteristic.empty() ? answerCharacteristic : question.characteristic;
    const auto found = std::find_if(all.begin(), all.end(), has(wanted));
    if (found != all.end())
        outcome.chosen = *found;
    else if (question.characteristic.empty() && !all.empty())
        outcome.chosen = all.front();
    else
        throw Error(errors::seriesEmpty, {{"characteristic", wanted}});
    outcome.characteristics = std::move(all);
}

archive::Filter filterOf(const SeriesQuestion& question, const std::string& task)
{
    archive::Filter filter;
    filter.task = task;
    filter.recipe_sha256 = question.recipe;
    filter.from = question.from;
    filter.to = question.to;
    filter.most = question.most;
    return filter;
}

/// How far a value is beyond a limit, as a share of the width; negative within.
double beyond(const SeriesPoint& point)
{
    double most = -std::numeric_limits<double>::infinity();
    const double width = point.lower_limit && point.upper_limit ? *point.upper_limit - *point.lower_limit : 1;
    if (!(width > 0)) return most;
    if (point.upper_limit) most = (point.value - *point.upper_limit) / width;
    if (point.lower_limit) most = std::max(most, (*point.lower_limit - point.value) / width);
    return most;
}

int rankOf(const SeriesPoint& point)
{
    if (point.verdict == Verdict::Fail) return 2;
    return point.verdict == Verdict::Undecided ? 1 : 0;
}

/// Of the worst verdict the one farthest out; without limits the latest.
std::size_t worstOf(const std::vector<SeriesPoint>& points)
{
    std::size_t worst = points.size() - 1;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::pair(rankOf(points[i]), beyond(points[i])) > std::pair(rankOf(points[worst]), beyond(points[worst])))
            worst = i;
    return worst;
}

Json resultIn(const archive::Record& record)
{
    if (record.evaluation.result.size() > largestResult_bytes) return nullptr;
    return Json::parse(record.evaluation.result, nullptr, false);
}

void addPictures(SeriesOutcome& outcome, const archive::Archive& source, const Progress& progress)
{
    const std::size_t first = outcome.points.size() > mostPictures ? outcome.points.size() - mostPictures : 0;
    for (std::size_t i = first; i < outcome.points.size(); ++i) {
        progress.check();
        const SeriesPoint& point = outcome.points[i];
        const archive::Record record = source.show(point.uuid, progress.quiet());
        auto map = mapOf(resultIn(record));
        if (!map) continue;
        map->title = point.file;
        outcome.pictures.push_back({point.uuid, point.file, record.entry.verdict, *std::move(map)});
    }
    scaleAlike(outcome.pictures);
}

void addPart(SeriesOutcome& outcome, const archive::Archive& source, const Progress& progress)
{
    const std::string& asked = outcome.question.part;
    outcome.part = source.show(asked.empty() ? outcome.points.back().uuid : asked, progress);
    for (std::size_t i = 0; i < outcome.points.size(); ++i)
        if (outcome.points[i].uuid == outcome.part.entry.uuid) outcome.shown = i;
    outcome.as_asked = archivedState(outcome.part, progress);
}

task::Outcome run(const project::PanelState& state, Stores& stores, task::Sources& sources, const Progress& progress)
{
    return outcomeOf(std::make_shared<const SeriesOutcome>(answerSeries(state, stores, sources, progress)));
}

}  // namespace

std::optional<Verdict> SeriesOutcome::verdict() const
{
    std::optional<Verdict> all;
    for (const SeriesPoint& point : points)
        if (point.verdict) all = all ? worse(*all, *point.verdict) : *point.verdict;
    return all;
}

SeriesOutcome answerSeries(const project::PanelState& state, Stores&, task::Sources& sources, const Progress& progress)
{
    SeriesOutcome outcome;
    outcome.question = fromValues<SeriesQuestion>(state.parameters);
    const SeriesQuestion& question = outcome.question;
    const Progress reading = progress.part(0, 0.6, LT_TEXT("Engine", "Reading the archive"));
    const archive::Archive source =
        archive::Archive::open(locationOf(state, question), archive::Access::Read, reading.part(0, 0.3));
    outcome.location = source.location();
    Notes found = source.notes();
    choose(outcome, source.characteristics({}, reading.part(0.3, 0.5)));
    const archive::Filter filter = filterOf(question, outcome.chosen.task);
    outcome.points = source.series(outcome.chosen.key, filter, reading.part(0.5, 1));
    if (outcome.points.empty()) throw Error(errors::seriesEmpty, {{"characteristic", outcome.chosen.key}});
    if (std::cmp_equal(outcome.points.size(), question.most))
        found.push_back({notes::seriesShortened, {{"count", std::int64_t{question.most}}}});
    outcome.chart = controlChart(outcome.points, found);
    outcome.worst = worstOf(outcome.points);
    addPart(outcome, source, progress.part(0.6, 0.65));
    addPictures(outcome, source, progress.part(0.65, 1, LT_TEXT("Engine", "Reading the pictures")));
    outcome.record(state, sources, found);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const SeriesOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.verdict = outcome->verdict();
    all.json = [outcome] { return toJson(*outcome); };
    all.answer = [outcome](const Language& language) { return answer(*outcome, language); };
    all.summary = [outcome](const Language& language) {
        return report::Section{LT_TEXT("Engine", "Result"), {answer(*outcome, language), statisticsTable(*outcome)}};
    };
    all.report = [outcome](const Language& language) { return seriesReport(*outcome, language); };
    return settled(seriesTask(), std::move(all), outcome->understanding);
}

const task::Task& seriesTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "spc";
        made.title = LT_TEXT("Engine", "Series");
        made.summary =
            "A characteristic of a series over time, from the archive: limits, control chart, capability, drift.";
        made.question = "series";
        made.inputs = {archiveInput()};
        made.one_of = {{archiveRole, databaseKey}, LT_TEXT("Engine", "Archive or its database")};
        task::askFor<SeriesQuestion>(made);
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) { return run(state, stores, sources, progress); };
        return made;
    }();
    return task;
}

}  // namespace lathelier::series
