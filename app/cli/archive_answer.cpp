#include "app/cli/archive_answer.h"

#include <nlohmann/json.hpp>

#include "engine/archive/archive_json.h"
#include "engine/core/texts.h"
#include "engine/core/verdict_json.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr std::size_t shownOfUuid = 8;

Value verdictCell(const std::optional<Verdict>& verdict)
{
    return verdict ? Value(shortName(*verdict)) : Value();
}

Value numberCell(const std::optional<double>& number)
{
    return number ? Value(*number) : Value();
}

std::string tableText(Text heading, report::Table table)
{
    return report::toPlainText({heading, {std::move(table)}});
}

std::string quantitiesText(Text heading, std::vector<report::Quantity> rows)
{
    return report::toPlainText({heading, {report::QuantityTable{{}, std::move(rows)}}});
}

/// "2026-11-29 08:15:30" of the time in the archive.
std::string shownTime(const std::string& recorded_at)
{
    std::string shown = recorded_at.substr(0, 19);
    if (shown.size() > 10) shown[10] = ' ';
    return shown;
}

}  // namespace

Json entryJson(const archive::Entry& entry)
{
    return {{"uuid", entry.uuid},
            {"recorded_at", entry.recorded_at},
            {"person", archive::textOrNothing(entry.attestation.person)},
            {"instrument", archive::textOrNothing(entry.attestation.instrument)},
            {"calibrated_on", archive::textOrNothing(entry.attestation.calibrated_on)},
            {"task", entry.task},
            {"version", entry.version},
            {"recipe_sha256", entry.recipe_sha256},
            {"file", archive::textOrNothing(entry.file)},
            {"exit_code", entry.exit_code},
            {"verdict", verdictJson(entry.verdict)},
            {"supersedes", archive::textOrNothing(entry.supersedes)},
            {"superseded_by", archive::textOrNothing(entry.superseded_by)},
            {"reason", archive::textOrNothing(entry.reason)},
            {"writer", entry.writer},
            {"sequence", entry.sequence},
            {"hash", entry.hash}};
}

Json recordJson(const archive::Record& record)
{
    Json json{{"entry", entryJson(record.entry)},
              {"previous_hash", record.previous_hash},
              {"recipe", nullptr},
              {"evaluation", archive::toJson(record.evaluation)}};
    if (!record.recipe.empty()) json["recipe"] = Json::parse(record.recipe);
    return json;
}

Json verificationJson(const archive::Verification& verification)
{
    Json json{{"checked", verification.checked()}, {"writers", Json::array()}, {"broken", nullptr}};
    for (const archive::CheckedChain& chain : verification.chains)
        json["writers"].push_back(
            {{"writer", chain.writer}, {"checked", chain.checked}, {"last_hash", chain.last_hash}});
    if (const auto& broken = verification.broken)
        json["broken"] = {{"writer", broken->writer},
                          {"sequence", broken->sequence},
                          {"uuid", archive::textOrNothing(broken->uuid)},
                          {"reason", std::string(archive::key(broken->fault))}};
    json["verdict"] = std::string(key(verification.broken ? Verdict::Fail : Verdict::Pass));
    return json;
}

std::string entriesText(const std::vector<archive::Entry>& entries)
{
    report::Table table{{},
                        {LT_TEXT("Engine", "Row"), LT_TEXT("Engine", "Time (UTC)"), LT_TEXT("Engine", "Task"),
                         LT_TEXT("Engine", "File"), LT_TEXT("Engine", "Person"), LT_TEXT("Engine", "Verdict"),
                         LT_TEXT("Engine", "Superseded by")},
                        {},
                        {}};
    table.rows.reserve(entries.size());
    for (const archive::Entry& entry : entries)
        table.rows.push_back({entry.uuid.substr(0, shownOfUuid), shownTime(entry.recorded_at), entry.task, entry.file,
                              entry.attestation.person, verdictCell(entry.verdict),
                              entry.superseded_by.substr(0, shownOfUuid)});
    return tableText(LT_TEXT("Engine", "Evaluations"), std::move(table));
}

std::string recordText(const archive::Record& record)
{
    const archive::Entry& entry = record.entry;
    std::vector<report::Quantity> rows;
    const auto add = [&rows](Text name, const Value& value) {
        const auto* word = std::get_if<std::string>(&value);
        if (!word || !word->empty()) rows.push_back({name, value, {}});
    };
    add(LT_TEXT("Engine", "Row"), entry.uuid);
    add(LT_TEXT("Engine", "Time (UTC)"), shownTime(entry.recorded_at));
    add(LT_TEXT("Engine", "Person"), entry.attestation.person);
    add(LT_TEXT("Engine", "Instrument"), entry.attestation.instrument);
    add(LT_TEXT("Engine", "Calibrated on"), entry.attestation.calibrated_on);
    add(LT_TEXT("Engine", "Task"), entry.task);
    add(LT_TEXT("Engine", "Version"), entry.version);
    add(LT_TEXT("Engine", "Recipe"), entry.recipe_sha256);
    for (const archive::EvaluatedInput& input : record.evaluation.inputs)
        add(LT_TEXT("Engine", "File"), input.file.path);
    add(LT_TEXT("Engine", "Verdict"), verdictCell(entry.verdict));
    add(LT_TEXT("Engine", "Supersedes"), entry.supersedes);
    add(LT_TEXT("Engine", "Superseded by"), entry.superseded_by);
    add(LT_TEXT("Engine", "Reason"), entry.reason);
    add(LT_TEXT("Engine", "Writer"), entry.writer);
    add(LT_TEXT("Engine", "Place in the chain"), entry.sequence);
    add(LT_TEXT("Engine", "Hash"), entry.hash);
    report::Table values{{},
                         {LT_TEXT("Engine", "Characteristic"), LT_TEXT("Engine", "Value"), LT_TEXT("Engine", "U"),
                          LT_TEXT("Engine", "Lower limit"), LT_TEXT("Engine", "Upper limit"), LT_TEXT("Engine", "Unit"),
                          LT_TEXT("Engine", "Verdict")},
                         {},
                         {0, 6, 6, 6, 6}};
    for (const task::Characteristic& one : record.evaluation.characteristics)
        values.rows.push_back({one.key, one.value, numberCell(one.expanded_uncertainty), numberCell(one.lower_limit),
                               numberCell(one.upper_limit), one.unit, verdictCell(one.verdict)});
    return quantitiesText(LT_TEXT("Engine", "Evaluation"), std::move(rows)) +
           tableText(LT_TEXT("Engine", "Values"), std::move(values));
}

std::string characteristicsText(const std::vector<archive::ArchivedCharacteristic>& characteristics)
{
    report::Table table{{},
                        {LT_TEXT("Engine", "Task"), LT_TEXT("Engine", "Characteristic"), LT_TEXT("Engine", "Unit"),
                         LT_TEXT("Engine", "Last value (UTC)")},
                        {},
                        {}};
    for (const archive::ArchivedCharacteristic& one : characteristics)
        table.rows.push_back({one.task, one.key, one.unit, shownTime(one.last_recorded_at)});
    return tableText(LT_TEXT("Engine", "Characteristics"), std::move(table));
}

std::string seriesText(const std::string& characteristic, const std::vector<archive::SeriesPoint>& points)
{
    report::Table table{characteristic,
                        {LT_TEXT("Engine", "Row"), LT_TEXT("Engine", "Time (UTC)"), LT_TEXT("Engine", "File"),
                         LT_TEXT("Engine", "Value"), LT_TEXT("Engine", "U"), LT_TEXT("Engine", "Lower limit"),
                         LT_TEXT("Engine", "Upper limit"), LT_TEXT("Engine", "Verdict")},
                        {},
                        {0, 0, 0, 6, 6, 6, 6}};
    table.rows.reserve(points.size());
    for (const archive::SeriesPoint& point : points)
        table.rows.push_back({point.uuid.substr(0, shownOfUuid), shownTime(point.recorded_at), point.file, point.value,
                              numberCell(point.expanded_uncertainty), numberCell(point.lower_limit),
                              numberCell(point.upper_limit), verdictCell(point.verdict)});
    return tableText(LT_TEXT("Engine", "Series"), std::move(table));
}

std::string verificationText(const archive::Verification& verification)
{
    report::Table table{
        {},
        {LT_TEXT("Engine", "Writer"), LT_TEXT("Engine", "Rows checked"), LT_TEXT("Engine", "Last hash")},
        {},
        {0, 0, 0}};
    for (const archive::CheckedChain& chain : verification.chains)
        table.rows.push_back({chain.writer, chain.checked, chain.last_hash});
    std::string summary = tableText(LT_TEXT("Engine", "Chains"), std::move(table));
    const auto& broken = verification.broken;
    if (!broken) return summary + text(LT_TEXT("Engine", "All rows are what was recorded.")) + "\n";
    return summary +
           fill(text(LT_TEXT("Engine", "BROKEN: the row {sequence} of the writer {writer} ({uuid}): {fault}.")),
                {{"sequence", broken->sequence},
                 {"writer", broken->writer},
                 {"uuid", broken->uuid},
                 {"fault", archive::name(broken->fault)}}) +
           "\n";
}

}  // namespace lathelier::cli
