// Reading from an archive: list(), show(), characteristics(), series().
#include <algorithm>

#include "engine/archive/archive_codes.h"
#include "engine/archive/archive_rows.h"
#include "engine/archive/archive_state.h"
#include "engine/archive/dates.h"

namespace lathelier::archive {
namespace {

using sql::Cell;
using sql::Cells;
using sql::Connection;
using sql::RowView;
using sql::TransactionKind;

/// Conditions of a statement with their parameters, in order.
class Conditions {
public:
    /// `condition` ends where the place of its parameter follows.
    void add(const std::string& condition, const Cell& value, const std::string& behind = {})
    {
        parameters_.push_back(value);
        std::string whole = condition;
        add(whole.append("$").append(std::to_string(parameters_.size())).append(behind));
    }
    void add(const std::string& condition) { text_ += (text_.empty() ? " WHERE " : " AND ") + condition; }

    void addDates(const std::string& column, const Filter& filter)
    {
        if (!filter.from.empty()) {
            requireDate("from", filter.from);
            add(column + " >= ", filter.from);
        }
        if (!filter.to.empty()) {
            requireDate("to", filter.to);
            add(column + " < ", filter.to + "~");  // behind every time of the day
        }
    }

    std::string limit(std::int64_t most)
    {
        if (most <= 0) return {};
        parameters_.push_back(most);
        return std::string(" LIMIT $").append(std::to_string(parameters_.size()));
    }

    const std::string& text() const { return text_; }
    const Cells& parameters() const { return parameters_; }

private:
    std::string text_;
    Cells parameters_;
};

Conditions conditionsOf(const Filter& filter)
{
    Conditions conditions;
    if (!filter.task.empty()) conditions.add("e.task = ", filter.task);
    if (!filter.recipe_sha256.empty()) conditions.add("e.recipe_sha256 = ", filter.recipe_sha256);
    if (filter.verdict) conditions.add("e.verdict = ", std::string(lathelier::key(*filter.verdict)));
    conditions.addDates("e.recorded_at", filter);
    // Row by row, from the latest on. With the OFFSET PostgreSQL keeps to that, and does not join all rows first.
    if (!filter.characteristic.empty())
        conditions.add(
            "EXISTS (SELECT 1 FROM characteristic c CROSS JOIN measured m WHERE c.task = e.task AND m.characteristic = "
            "c.id AND m.recorded_at = e.recorded_at AND m.sequence = e.sequence AND m.evaluation = e.uuid AND c.key = ",
            filter.characteristic, " LIMIT 1 OFFSET 0)");
    return conditions;
}

Entry entryOf(const Row& row)
{
    Entry entry;
    entry.uuid = row.uuid;
    entry.recorded_at = row.recorded_at;
    entry.attestation = row.attestation;
    entry.task = row.task;
    entry.version = row.version;
    entry.recipe_sha256 = row.recipe_sha256;
    entry.file = fileOf(row.inputs);
    entry.exit_code = row.exit_code;
    entry.verdict = verdictOf(row.verdict);
    entry.supersedes = row.supersedes;
    entry.reason = row.reason;
    entry.writer = row.writer;
    entry.sequence = row.sequence;
    entry.hash = row.hash;
    return entry;
}

const std::string selectEntry =
    "SELECT e.uuid, e.recorded_at, e.person, e.instrument, e.calibrated_on, e.task, e.version, e.recipe_sha256, "
    "e.inputs, e.exit_code, e.verdict, e.supersedes, e.reason, e.writer, e.sequence, e.hash, "
    "(SELECT min(s.uuid) FROM evaluation s WHERE s.supersedes = e.uuid) FROM evaluation e";

Entry entryFrom(const RowView& view)
{
    return {view.string(0),
            view.string(1),
            {view.string(2), view.string(3), view.string(4)},
            view.string(5),
            view.string(6),
            view.string(7),
            fileOf(view.string(8)),
            static_cast<int>(view.integer(9)),
            verdictOf(view.text(10)),
            view.string(11),
            view.string(16),
            view.string(12),
            view.string(13),
            view.integer(14),
            view.string(15)};
}

/// The one characteristic of this key.
std::int64_t characteristicId(Connection& connection, const std::string& key, const std::string& task)
{
    Conditions conditions;
    conditions.add("key = ", key);
    if (!task.empty()) conditions.add("task = ", task);
    std::vector<std::int64_t> ids;
    std::string found;
    connection.each("SELECT id, task, unit FROM characteristic" + conditions.text() + " ORDER BY task, unit",
                    conditions.parameters(), [&](const RowView& view) {
                        ids.push_back(view.integer(0));
                        found.append(found.empty() ? "" : ", ").append(view.text(1));
                        if (!view.text(2).empty()) found.append(" (").append(view.text(2)).append(")");
                    });
    if (ids.empty()) throw Error(errors::characteristicNotFound, {{"characteristic", key}});
    if (ids.size() > 1) throw Error(errors::characteristicAmbiguous, {{"characteristic", key}, {"found", found}});
    return ids.front();
}

}  // namespace

std::vector<Entry> Archive::list(const Filter& filter, const Progress& progress) const
{
    Conditions conditions = conditionsOf(filter);
    const std::string limit = conditions.limit(filter.most);
    std::vector<Entry> entries;
    const Call call(state_->mutex, *state_->connection, TransactionKind::Read, progress);
    state_->connection->each(
        selectEntry + conditions.text() + " ORDER BY e.recorded_at DESC, e.sequence DESC, e.uuid DESC" + limit,
        conditions.parameters(), [&entries](const RowView& view) { entries.push_back(entryFrom(view)); });
    return entries;
}

Record Archive::show(const std::string& uuid, const Progress& progress) const
{
    Connection& connection = *state_->connection;
    const Call call(state_->mutex, connection, TransactionKind::Read, progress);
    const Row row = *rowOfUuid(connection, wholeUuid(connection, uuid));
    Record record{entryOf(row), evaluationOf(row), row.previous_hash,
                  recipeOf(connection, row.recipe_sha256).value_or("")};
    record.entry.superseded_by =
        connection.word("SELECT min(uuid) FROM evaluation WHERE supersedes = $1", {row.uuid}).value_or("");
    return record;
}

std::vector<ArchivedCharacteristic> Archive::characteristics(const Filter& filter, const Progress& progress) const
{
    Conditions conditions;
    if (!filter.task.empty()) conditions.add("c.task = ", filter.task);
    if (!filter.characteristic.empty()) conditions.add("c.key = ", filter.characteristic);
    std::vector<ArchivedCharacteristic> found;
    const Call call(state_->mutex, *state_->connection, TransactionKind::Read, progress);
    state_->connection->each(
        "SELECT c.task, c.key, c.unit, (SELECT m.recorded_at FROM measured m WHERE m.characteristic = c.id "
        "ORDER BY m.recorded_at DESC LIMIT 1) FROM characteristic c" +
            conditions.text() + " ORDER BY c.task, c.key, c.unit",
        conditions.parameters(), [&found](const RowView& view) {
            found.push_back({view.string(0), view.string(1), view.string(2), view.string(3)});
        });
    return found;
}

std::vector<SeriesPoint> Archive::series(const std::string& characteristic, const Filter& filter,
                                         const Progress& progress) const
{
    Connection& connection = *state_->connection;
    const Call call(state_->mutex, connection, TransactionKind::Read, progress);
    Conditions conditions;
    conditions.add("m.characteristic = ", characteristicId(connection, characteristic, filter.task));
    conditions.addDates("m.recorded_at", filter);
    if (filter.verdict) conditions.add("m.verdict = ", std::string(lathelier::key(*filter.verdict)));
    if (!filter.recipe_sha256.empty())
        conditions.add("EXISTS (SELECT 1 FROM evaluation e WHERE e.uuid = m.evaluation AND e.recipe_sha256 = ",
                       filter.recipe_sha256, ")");
    if (connection.word("SELECT uuid FROM evaluation WHERE supersedes IS NOT NULL LIMIT 1"))
        conditions.add("NOT EXISTS (SELECT 1 FROM evaluation s WHERE s.supersedes = m.evaluation)");
    // The latest so many are found from behind.
    const bool is_from_behind = filter.most > 0;
    const std::string order = is_from_behind
                                  ? " ORDER BY m.recorded_at DESC, m.sequence DESC, m.evaluation DESC, m.place DESC"
                                  : " ORDER BY m.recorded_at, m.sequence, m.evaluation, m.place";
    const std::string limit = conditions.limit(filter.most);
    std::vector<SeriesPoint> points;
    connection.each(
        "SELECT m.evaluation, m.recorded_at, m.file, m.value, m.expanded_uncertainty, m.lower_limit, m.upper_limit, "
        "m.verdict FROM measured m" +
            conditions.text() + order + limit,
        conditions.parameters(), [&points](const RowView& view) {
            points.push_back({view.string(0), view.string(1), view.string(2), view.number(3), view.numberIfAny(4),
                              view.numberIfAny(5), view.numberIfAny(6), verdictOf(view.text(7))});
        });
    if (is_from_behind) std::reverse(points.begin(), points.end());
    return points;
}

}  // namespace lathelier::archive
