// Archive::push().
#include <algorithm>

#include "engine/archive/archive_codes.h"
#include "engine/archive/archive_rows.h"
#include "engine/archive/archive_state.h"

namespace lathelier::archive {
namespace {

using sql::Connection;
using sql::Transaction;
using sql::TransactionKind;

constexpr int rowsOfOneTransaction = 100;

/// Two hashes that are equal stand for equal rows before them too, so the first row that differs is found by halves.
void refuseFork(Connection& from, Connection& to, const std::string& writer)
{
    std::int64_t same = 0;
    std::int64_t other = std::min(tailOf(from, writer).sequence, tailOf(to, writer).sequence);
    const auto is_same = [&](std::int64_t at) { return hashAt(from, writer, at) == hashAt(to, writer, at); };
    if (other == 0 || is_same(other)) return;
    while (other - same > 1) {
        const std::int64_t middle = same + (other - same) / 2;
        (is_same(middle) ? same : other) = middle;
    }
    throw Error(errors::chainForked, {{"writer", writer}, {"sequence", other}, {"location", to.location()}});
}

/// Rows as they are, behind the last one that the target has.
class Copying {
public:
    Copying(Connection& from, Connection& to) : from_(from), to_(to) {}

    /// Returns how many rows were written.
    std::int64_t copy(const std::string& writer, const Progress& progress)
    {
        std::int64_t written = 0;
        while (true) {
            progress.check();
            Transaction transaction(to_, TransactionKind::Write);
            lockForWriting(to_);
            refuseFork(from_, to_, writer);  // the target may have got rows from elsewhere
            Tail tail = tailOf(to_, writer);
            const std::vector<Row> rows = rowsBehind(from_, writer, tail.sequence, "~", rowsOfOneTransaction);
            for (const Row& row : rows) {
                put(row, tail);
                progress.check();
            }
            transaction.commit();
            written += static_cast<std::int64_t>(rows.size());
            if (rows.size() < static_cast<std::size_t>(rowsOfOneTransaction)) return written;
        }
    }

private:
    /// What is broken here is not passed on.
    void put(const Row& row, Tail& tail)
    {
        const auto recipe = recipeOf(from_, row.recipe_sha256);
        auto fault = faultOf(row, recipe);
        if (!fault && row.sequence != tail.sequence + 1) fault = Fault::Missing;
        if (!fault && row.previous_hash != tail.hash) fault = Fault::Order;
        if (fault)
            throw Error(errors::chainBroken, valuesOf({row.writer, row.sequence, row.uuid, *fault}, from_.location()));
        if (recipe) insertRecipe(to_, {row.recipe_sha256, *recipe});
        insertRow(to_, row);
        tail = {row.sequence, row.hash};
    }

    Connection& from_;
    Connection& to_;
};

}  // namespace

Pushed Archive::push(Archive& target, const Progress& progress) const
{
    Pushed pushed;
    if (target.state_ == state_) return pushed;
    Connection& from = *state_->connection;
    Connection& to = *target.state_->connection;
    const std::scoped_lock locks(state_->mutex, target.state_->mutex);
    const Watch watchFrom(from, progress), watchTo(to, progress);
    const Transaction one_state(from, TransactionKind::Read);
    const std::vector<std::string> writers = writersOf(from);
    for (const std::string& writer : writers) {
        refuseFork(from, to, writer);
        pushed.already_there += std::min(tailOf(from, writer).sequence, tailOf(to, writer).sequence);
    }
    Copying copying(from, to);
    double done = 0;
    for (const std::string& writer : writers) {
        progress.report(done++ / static_cast<double>(writers.size()));
        pushed.pushed += copying.copy(writer, progress);
    }
    return pushed;
}

}  // namespace lathelier::archive
