// The rows of an archive in its tables: reading and adding, within the transaction of the caller.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/archive/chain.h"
#include "engine/archive/sql/connection.h"

namespace lathelier::archive {

/// The end of the chain of one writer.
struct Tail {
    std::int64_t sequence = 0;     ///< 0: no row yet
    std::string hash = firstHash;  ///< of the row `sequence`
};

std::vector<std::string> writersOf(sql::Connection& connection);
Tail tailOf(sql::Connection& connection, const std::string& writer);

/// The hash that stands in a row; none: no such row.
std::optional<std::string> hashAt(sql::Connection& connection, const std::string& writer, std::int64_t sequence);

/// Calls use() for every row of a writer behind the row `sequence`, in order, with its values.
void eachRow(sql::Connection& connection, const std::string& writer, std::int64_t sequence,
             const std::function<void(const Row&)>& use);

/// At most `most` rows behind the place (sequence, uuid), in order, with their values.
std::vector<Row> rowsBehind(sql::Connection& connection, const std::string& writer, std::int64_t sequence,
                            const std::string& uuid, int most);

/// None: no such row.
std::optional<Row> rowOfUuid(sql::Connection& connection, const std::string& uuid);

/// The UUID that begins so. Errors evaluationNotFound, evaluationAmbiguous (also of less than 4 characters).
std::string wholeUuid(sql::Connection& connection, const std::string& begin);

std::optional<std::string> recipeOf(sql::Connection& connection, const std::string& sha256);

/// Adds the row as it is.
void insertRow(sql::Connection& connection, const Row& row);

/// Error recipeContradicts.
void insertRecipe(sql::Connection& connection, const ArchivedRecipe& recipe);

/// Other writers wait until the transaction of the caller ends. SQLite has seen to it at its beginning.
void lockForWriting(sql::Connection& connection);

/// The last row of every chain, looked at with the one before it; the first that is broken.
std::optional<BrokenRow> brokenTail(sql::Connection& connection);

}  // namespace lathelier::archive
