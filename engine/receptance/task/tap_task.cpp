#include "engine/receptance/task/tap_task.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/field_within.h"
#include "engine/core/frf_item.h"
#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/io/text/number.h"
#include "engine/io/time_record/time_record_input.h"
#include "engine/receptance/frf_checks.h"
#include "engine/receptance/tap/tap_codes.h"
#include "engine/receptance/tap/tap_report.h"

namespace lathelier::receptance {
namespace {

constexpr const char* tapCsvExport = "csv";
constexpr const char* tapUffExport = "uff";
constexpr double sameTapRate = 1e-6;  ///< relative

/// A node with its direction: "12", "12x".
struct NodePlace {
    int node = 0;
    int direction = 0;
};

std::optional<NodePlace> nodePlace(std::string_view word)
{
    constexpr std::string_view letters = " xyz";
    NodePlace place;
    if (!word.empty())
        if (const std::size_t letter = letters.find(word.back(), 1); letter != std::string_view::npos) {
            place.direction = static_cast<int>(letter);
            word.remove_suffix(1);
        }
    const auto node = io::wholeInteger(word);
    constexpr std::int64_t mostNode = 2000000000;
    if (!node || *node < 1 || *node > mostNode) return std::nullopt;
    place.node = static_cast<int>(*node);
    return place;
}

/// Error valueNotUnderstood.
void setNodes(const std::string& nodes, io::MeasuredFrf& response)
{
    if (nodes.empty()) return;
    const std::size_t slash = nodes.find('/');
    const auto of_response = nodePlace(std::string_view(nodes).substr(0, slash));
    const auto of_force =
        slash == std::string::npos ? std::nullopt : nodePlace(std::string_view(nodes).substr(slash + 1));
    if (!of_response || !of_force)
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", "nodes"},
                     {"found", nodes},
                     {"expected", LT_TEXT("Engine", "nodes of response and force such as 12/5 or 12x/5x")}});
    response.response_node = of_response->node;
    response.response_direction = of_response->direction;
    response.reference_node = of_force->node;
    response.reference_direction = of_force->direction;
}

void requireSameTests(const TapMeasured& first, const TapMeasured& other, const std::string& path)
{
    const bool has_rate = std::abs(first.both.rate_hz - other.both.rate_hz) <= sameTapRate * first.both.rate_hz;
    if (has_rate && first.quantity == other.quantity) return;
    const Text quantity = has_rate ? LT_TEXT("Engine",
                                             "another quantity of the sensor, as displacement 0, velocity 1, "
                                             "acceleration 2")
                                   : LT_TEXT("Engine", "samples a second");
    throw Error(errors::tapChannelsDiffer,
                {{"path", path},
                 {"channel", path},
                 {"found", has_rate ? static_cast<double>(other.quantity) : other.both.rate_hz},
                 {"expected", has_rate ? static_cast<double>(first.quantity) : first.both.rate_hz},
                 {"quantity", quantity}});
}

std::vector<TapMeasured> takeRecordsOf(TapOutcome& outcome, const project::PanelState& state, Stores& stores,
                                       task::Sources& sources, const Progress& progress)
{
    std::vector<TapMeasured> taken;
    const std::vector<std::string> keys = project::keysOf(state, tapRecordRole);
    const auto count = static_cast<double>(keys.size());
    for (const std::string& key : keys) {
        const auto done = static_cast<double>(taken.size());
        const Progress reading = progress.part(done / count, (done + 1) / count, LT_TEXT("Engine", "Reading"));
        const auto loaded = task::takeFile<io::TimeRecordInput>(state, key, stores, reading, sources);
        const project::Source& source = state.inputs.at(key);
        if (!loaded) task::throwItemNotThere(source.item, io::TimeRecordInput::item);
        taken.push_back(takeSignals(loaded->file.record, source.path, outcome.question.channels, sources.notes));
        requireSameTests(taken.front(), taken.back(), source.path);
    }
    return taken;
}

report::Section tapSummary(const TapOutcome& outcome, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(outcome.study, language), hitsTable(outcome.study)}};
    if (!outcome.notes.empty()) section.blocks.emplace_back(outcome.notes);
    return section;
}

std::string itemName(const TapOutcome& outcome)
{
    const std::string pair = io::nodePair(outcome.response);
    return outcome.study.names.front() + (pair.empty() ? "" : " " + pair);
}

}  // namespace

const std::vector<Field<TapQuestion>>& fieldsOf(const TapQuestion*)
{
    using Q = TapQuestion;
    static const std::vector<Field<Q>> all = [] {
        std::vector<Field<Q>> made;
        for (const FieldInfo& info : infos<TapChannels>()) made.push_back(within(&Q::channels, info.key));
        for (const FieldInfo& info : infos<TapParameters>()) made.push_back(within(&Q::evaluation, info.key));
        made.push_back(field("nodes", &Q::nodes,
                             Label{LT_TEXT("Engine", "Nodes"),
                                   LT_TEXT("Engine",
                                           "Of response and force, as 12/5 or 12x/5x, for a universal file. Empty: "
                                           "those of the record."),
                                   {},
                                   true}));
        return made;
    }();
    return all;
}

TapOutcome answerTap(const project::PanelState& state, Stores& stores, task::Sources& sources, const Progress& progress)
{
    TapOutcome outcome;
    outcome.question = fromValues<TapQuestion>(state.parameters);
    setNodes(outcome.question.nodes, outcome.response);
    std::vector<TapMeasured> taken = takeRecordsOf(outcome, state, stores, sources, progress.part(0, 0.4));
    std::vector<TapSignals> records;
    std::vector<std::string> names;
    for (TapMeasured& one : taken) {
        names.push_back(one.both.path.substr(one.both.path.find_last_of('/') + 1));
        records.push_back(std::move(one.both));
    }
    TapResult result =
        evaluateTaps(records, taken.front().quantity, outcome.question.evaluation, progress.part(0.4, 0.9));
    outcome.study = studyTaps(records, std::move(names), std::move(result));
    outcome.response.frf = outcome.study.result.response;
    if (outcome.question.nodes.empty()) {
        const TapMeasured& first = taken.front();
        outcome.response.response_node = first.response_node;
        outcome.response.response_direction = first.response_direction;
        outcome.response.reference_node = first.hammer_node;
        outcome.response.reference_direction = first.hammer_direction;
    }
    Notes notes = outcome.study.result.notes;
    const Notes of_physics = checkResponse(outcome.response, records.front().path);
    notes.insert(notes.end(), of_physics.begin(), of_physics.end());
    outcome.response.frf.name = itemName(outcome);
    outcome.record(state, sources, notes);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const TapOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.json = [outcome] { return toJson(outcome->study); };
    all.answer = [outcome](const Language& language) { return answer(outcome->study, language); };
    all.summary = [outcome](const Language& language) { return tapSummary(*outcome, language); };
    all.report = [outcome](const Language& language) { return tapReport(outcome->study, outcome->notes, language); };
    all.writers[tapCsvExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFrfCsv(path, outcome->response.frf);
    };
    all.writers[tapUffExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeUff(path, {&outcome->response, 1});
    };
    all.products = [outcome](const Language&) {
        return std::vector<task::Product>{
            {frfItem, {}, outcome->response.frf.name, [outcome] { return toValues(outcome->response.frf); }}};
    };
    return settled(tapTask(), std::move(all), outcome->understanding);
}

const task::Task& tapTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "tap";
        made.title = LT_TEXT("Engine", "Tap test");
        made.summary = "Frequency response from the time records of an impact test: hammer and sensor.";
        made.question = "machine";
        made.products = {frfItem};
        task::Input record = task::input<io::TimeRecordInput>(
            tapRecordRole, "", LT_TEXT("Engine", "Time record"),
            LT_TEXT("Engine", "Force and motion over time (CSV, UFF or WAV), or one record for each hit."));
        record.several = true;
        record.is_of_part = true;
        made.inputs = {std::move(record)};
        task::askFor<TapQuestion>(made);
        made.exports = {{tapCsvExport, "Write the receptance as FILE.csv.", LT_TEXT("Engine", "Receptance (CSV)…"),
                         LT_TEXT("Engine", "Table (*.csv)"), "csv"},
                        {tapUffExport, "Write the receptance as a universal file (58).",
                         LT_TEXT("Engine", "Receptance (UFF)…"), LT_TEXT("Engine", "Universal file (*.uff)"), "uff"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const TapOutcome>(answerTap(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::receptance
