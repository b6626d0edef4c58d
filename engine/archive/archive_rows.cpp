#include "engine/archive/archive_rows.h"

#include "engine/archive/archive_codes.h"

namespace lathelier::archive {
namespace {

using sql::Cells;
using sql::Connection;
using sql::RowView;

constexpr int rowsAtOnce = 100;

const std::string selectRow =
    "SELECT uuid, writer, sequence, previous_hash, hash, recorded_at, person, instrument, calibrated_on, task, "
    "version, "
    "recipe_sha256, recipe_content_sha256, key, exit_code, verdict, supersedes, reason, inputs, result FROM "
    "evaluation ";

Row rowFrom(const RowView& view)
{
    Row row;
    row.uuid = view.string(0);
    row.writer = view.string(1);
    row.sequence = view.integer(2);
    row.previous_hash = view.string(3);
    row.hash = view.string(4);
    row.recorded_at = view.string(5);
    row.attestation = {view.string(6), view.string(7), view.string(8)};
    row.task = view.string(9);
    row.version = view.string(10);
    row.recipe_sha256 = view.string(11);
    row.recipe_content_sha256 = view.string(12);
    row.key = view.string(13);
    row.exit_code = static_cast<int>(view.integer(14));
    row.verdict = view.string(15);
    row.supersedes = view.string(16);
    row.reason = view.string(17);
    row.inputs = view.string(18);
    row.result = view.string(19);
    return row;
}

/// By the characteristics of its task: there are few, and no further index over all values is needed. CROSS JOIN keeps
/// SQLite to this order.
void readValues(Connection& connection, Row& row)
{
    const std::string file = fileOf(row.inputs);
    connection.each(
        "SELECT c.key, c.unit, m.value, m.expanded_uncertainty, m.lower_limit, m.upper_limit, m.verdict, m.file "
        "FROM characteristic c CROSS JOIN measured m WHERE c.task = $1 AND m.characteristic = c.id "
        "AND m.recorded_at = $2 AND m.sequence = $3 AND m.evaluation = $4 ORDER BY m.place",
        {row.task, row.recorded_at, row.sequence, row.uuid}, [&](const RowView& view) {
            row.values.push_back({view.string(0), view.string(1), view.number(2), view.numberIfAny(3),
                                  view.numberIfAny(4), view.numberIfAny(5), verdictOf(view.text(6))});
            row.is_file_right = row.is_file_right && view.text(7) == file;
        });
}

std::vector<Row> rowsOf(Connection& connection, const std::string& condition, const Cells& parameters)
{
    std::vector<Row> rows;
    connection.each(selectRow + condition, parameters, [&rows](const RowView& view) { rows.push_back(rowFrom(view)); });
    for (Row& row : rows) readValues(connection, row);
    return rows;
}

std::int64_t idOf(Connection& connection, const std::string& task, const task::Characteristic& value)
{
    const Cells names{task, value.key, value.unit};
    const std::string select = "SELECT id FROM characteristic WHERE task = $1 AND key = $2 AND unit = $3";
    if (const std::int64_t known = connection.count(select, names); known > 0) return known;
    connection.change("INSERT INTO characteristic (task, key, unit) VALUES ($1, $2, $3)", names);
    return connection.count(select, names);
}

}  // namespace

std::vector<std::string> writersOf(Connection& connection)
{
    std::vector<std::string> writers;
    std::optional<std::string> next = connection.word("SELECT min(writer) FROM evaluation");
    while (next) {  // step by step along the index, whose length does not count then
        writers.push_back(*next);
        next = connection.word("SELECT min(writer) FROM evaluation WHERE writer > $1", {writers.back()});
    }
    return writers;
}

Tail tailOf(Connection& connection, const std::string& writer)
{
    Tail tail;
    connection.each("SELECT sequence, hash FROM evaluation WHERE writer = $1 ORDER BY sequence DESC LIMIT 1", {writer},
                    [&tail](const RowView& view) {
                        tail = {view.integer(0), view.string(1)};
                    });
    return tail;
}

std::optional<std::string> hashAt(Connection& connection, const std::string& writer, std::int64_t sequence)
{
    return connection.word("SELECT hash FROM evaluation WHERE writer = $1 AND sequence = $2", {writer, sequence});
}

std::vector<Row> rowsBehind(Connection& connection, const std::string& writer, std::int64_t sequence,
                            const std::string& uuid, int most)
{
    return rowsOf(connection, "WHERE writer = $1 AND (sequence, uuid) > ($2, $3) ORDER BY sequence, uuid LIMIT $4",
                  {writer, sequence, uuid, std::int64_t{most}});
}

void eachRow(Connection& connection, const std::string& writer, std::int64_t sequence,
             const std::function<void(const Row&)>& use)
{
    const std::string behindAll = "~";
    std::string uuid = behindAll;
    while (true) {
        const std::vector<Row> rows = rowsBehind(connection, writer, sequence, uuid, rowsAtOnce);
        for (const Row& row : rows) use(row);
        if (rows.size() < static_cast<std::size_t>(rowsAtOnce)) return;
        sequence = rows.back().sequence;
        uuid = rows.back().uuid;
    }
}

std::optional<Row> rowOfUuid(Connection& connection, const std::string& uuid)
{
    std::vector<Row> rows = rowsOf(connection, "WHERE uuid = $1", {uuid});
    return rows.empty() ? std::nullopt : std::optional(std::move(rows.front()));
}

std::string wholeUuid(Connection& connection, const std::string& begin)
{
    constexpr std::size_t shortest = 4;
    std::vector<std::string> found;
    if (begin.size() >= shortest)
        connection.each("SELECT uuid FROM evaluation WHERE uuid >= $1 AND uuid <= $2 ORDER BY uuid LIMIT 2",
                        {begin, begin + "~"}, [&found](const RowView& view) { found.push_back(view.string(0)); });
    if (begin.size() < shortest || found.size() > 1)
        throw Error(errors::evaluationAmbiguous,
                    {{"uuid", begin}, {"expected", LT_TEXT("Engine", "more characters of the UUID, at least 4")}});
    if (found.empty()) throw Error(errors::evaluationNotFound, {{"uuid", begin}});
    return found.front();
}

std::optional<std::string> recipeOf(Connection& connection, const std::string& sha256)
{
    return connection.word("SELECT content FROM recipe WHERE sha256 = $1", {sha256});
}

void insertRow(Connection& connection, const Row& row)
{
    using sql::textOrNull;
    connection.change(
        "INSERT INTO evaluation (uuid, writer, sequence, previous_hash, hash, recorded_at, person, instrument, "
        "calibrated_on, task, version, recipe_sha256, recipe_content_sha256, key, exit_code, verdict, supersedes, "
        "reason, inputs, result) VALUES ($1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13, $14, $15, $16, $17, "
        "$18, $19, $20)",
        {row.uuid,
         row.writer,
         row.sequence,
         row.previous_hash,
         row.hash,
         row.recorded_at,
         textOrNull(row.attestation.person),
         textOrNull(row.attestation.instrument),
         textOrNull(row.attestation.calibrated_on),
         row.task,
         row.version,
         row.recipe_sha256,
         textOrNull(row.recipe_content_sha256),
         row.key,
         std::int64_t{row.exit_code},
         textOrNull(row.verdict),
         textOrNull(row.supersedes),
         textOrNull(row.reason),
         row.inputs,
         row.result});
    const std::string file = fileOf(row.inputs);
    std::int64_t place = 0;
    for (const task::Characteristic& value : row.values) {
        ++place;
        const std::string verdict = value.verdict ? std::string(lathelier::key(*value.verdict)) : std::string();
        connection.change(
            "INSERT INTO measured (characteristic, recorded_at, sequence, evaluation, place, value, "
            "expanded_uncertainty, lower_limit, upper_limit, verdict, file) VALUES ($1, $2, $3, $4, $5, $6, $7, $8, "
            "$9, "
            "$10, $11)",
            {idOf(connection, row.task, value), row.recorded_at, row.sequence, row.uuid, place, value.value,
             sql::numberOrNull(value.expanded_uncertainty), sql::numberOrNull(value.lower_limit),
             sql::numberOrNull(value.upper_limit), textOrNull(verdict), file});
    }
}

void insertRecipe(Connection& connection, const ArchivedRecipe& recipe)
{
    const auto known = recipeOf(connection, recipe.sha256);
    if (known && *known != recipe.content) throw Error(errors::recipeContradicts, {{"sha256", recipe.sha256}});
    if (!known)
        connection.change("INSERT INTO recipe (sha256, content) VALUES ($1, $2)", {recipe.sha256, recipe.content});
}

void lockForWriting(Connection& connection)
{
    constexpr std::int64_t ours = 0x4C614172;
    if (connection.dialect() == sql::Dialect::Postgres)
        connection.each("SELECT pg_advisory_xact_lock($1)", {ours}, [](const RowView&) {});
}

std::optional<BrokenRow> brokenTail(Connection& connection)
{
    for (const std::string& writer : writersOf(connection)) {
        const Tail tail = tailOf(connection, writer);
        const std::vector<Row> rows = rowsBehind(connection, writer, tail.sequence - 1, "~", 1);
        if (rows.empty()) continue;
        const Row& row = rows.front();
        const auto broken = [&row](Fault fault) { return BrokenRow{row.writer, row.sequence, row.uuid, fault}; };
        if (const auto fault = faultOf(row, recipeOf(connection, row.recipe_sha256))) return broken(*fault);
        const auto before = row.sequence == 1 ? firstHash : hashAt(connection, writer, row.sequence - 1).value_or("");
        if (before != row.previous_hash) return broken(Fault::Order);
    }
    return std::nullopt;
}

}  // namespace lathelier::archive
