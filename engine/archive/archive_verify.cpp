// Archive::verify().
#include <limits>

#include "engine/archive/archive_rows.h"
#include "engine/archive/archive_state.h"

namespace lathelier::archive {
namespace {

using sql::Connection;
using sql::RowView;
using sql::TransactionKind;

/// Follows the chain of one writer, row by row, up to the first that is broken.
class Follower {
public:
    Follower(Connection& connection, std::string writer) : connection_(connection)
    {
        chain_.writer = std::move(writer);
        chain_.last_hash = firstHash;
    }

    std::optional<BrokenRow> look(const Row& row)
    {
        const std::int64_t expected = chain_.checked + 1;
        const auto broken = [&row](Fault fault) { return BrokenRow{row.writer, row.sequence, row.uuid, fault}; };
        if (row.sequence > expected) return BrokenRow{row.writer, expected, {}, Fault::Missing};
        if (row.sequence < expected) return broken(Fault::Duplicated);
        if (const auto fault = faultOf(row, recipe(row.recipe_sha256))) return broken(*fault);
        if (row.previous_hash != chain_.last_hash) return broken(Fault::Order);
        ++chain_.checked;
        chain_.last_hash = row.hash;
        values_ += static_cast<std::int64_t>(row.values.size());
        return std::nullopt;
    }

    const CheckedChain& chain() const { return chain_; }
    std::int64_t values() const { return values_; }

private:
    /// The rows of a batch have one recipe.
    const std::optional<std::string>& recipe(const std::string& sha256)
    {
        if (!recipe_ || recipeSha256_ != sha256) {
            recipe_ = recipeOf(connection_, sha256);
            recipeSha256_ = sha256;
        }
        return recipe_;
    }

    Connection& connection_;
    CheckedChain chain_;
    std::int64_t values_ = 0;
    std::string recipeSha256_;
    std::optional<std::string> recipe_;
};

/// Values that no row of the chains has: put in from outside, or left behind by a row that was taken away.
std::optional<BrokenRow> strayValues(Connection& connection)
{
    std::optional<BrokenRow> found;
    connection.each(
        "SELECT m.evaluation, m.sequence, (SELECT min(e.writer) FROM evaluation e WHERE e.uuid = m.evaluation) "
        "FROM measured m WHERE NOT EXISTS (SELECT 1 FROM characteristic c CROSS JOIN evaluation e "
        "WHERE c.id = m.characteristic AND e.uuid = m.evaluation AND e.recorded_at = m.recorded_at "
        "AND e.sequence = m.sequence AND e.task = c.task) LIMIT 1",
        {}, [&found](const RowView& view) {
            found = BrokenRow{view.string(2), view.integer(1), view.string(0), Fault::StrayValues};
        });
    return found;
}

}  // namespace

Verification Archive::verify(const Progress& progress) const
{
    Connection& connection = *state_->connection;
    const Call call(state_->mutex, connection, TransactionKind::Read, progress);
    const auto all = static_cast<double>(connection.count("SELECT count(*) FROM evaluation"));
    Verification made;
    double done = 0;
    std::int64_t values = 0;
    for (const std::string& writer : writersOf(connection)) {
        Follower follower(connection, writer);
        std::optional<BrokenRow> broken;
        eachRow(connection, writer, std::numeric_limits<std::int64_t>::min(), [&](const Row& row) {
            progress.report(done++ / all);
            if (!broken) broken = follower.look(row);
        });
        made.chains.push_back(follower.chain());
        values += follower.values();
        if (broken && !made.broken) made.broken = broken;
    }
    if (!made.broken && connection.count("SELECT count(*) FROM measured") != values)
        made.broken = strayValues(connection);
    return made;
}

}  // namespace lathelier::archive
