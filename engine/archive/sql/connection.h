// One connection to an SQL database, SQLite or PostgreSQL: statements with parameters, and transactions. What differs
// between the two is asked from dialect(); statements that both understand are written once.
//
// One caller at a time; the callers see to it.
//
// Parameters are $1, $2… in both. Statements of each(), execute() and change() are prepared once and kept. Numbers pass
// exactly; text is UTF-8 without NUL.
//
// Errors: archiveNotRead, within a transaction for writing archiveNotWritten, each with the location and a reason.
// Cancelled, once the progress of watch() is stopped, also while another program holds the database.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"

namespace lathelier::archive::sql {

/// A parameter or a cell. monostate is NULL.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;
using Cells = std::vector<Cell>;

/// NULL for an empty text.
Cell textOrNull(const std::string& text);
Cell numberOrNull(const std::optional<double>& number);

enum class Dialect { Sqlite, Postgres };

enum class TransactionKind {
    Read,  ///< one state of the database throughout
    Write  ///< SQLite: no other writer from the beginning
};

/// The row that a statement stands on. Columns count from 0. Texts are valid until the next row.
class RowView {
public:
    virtual ~RowView() = default;
    virtual bool isNull(int column) const = 0;
    virtual std::int64_t integer(int column) const = 0;   ///< 0 for NULL
    virtual double number(int column) const = 0;          ///< 0 for NULL
    virtual std::string_view text(int column) const = 0;  ///< empty for NULL
    std::optional<double> numberIfAny(int column) const;  ///< none for NULL
    std::string string(int column) const { return std::string(text(column)); }
};

class Connection {
public:
    virtual ~Connection() = default;
    Connection() = default;
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    virtual Dialect dialect() const = 0;
    virtual const std::string& location() const = 0;  ///< as it may be shown

    /// Calls use() for every row of the answer. use() may not call this connection.
    virtual void each(const std::string& statement, const Cells& parameters,
                      const std::function<void(const RowView&)>& use) = 0;

    /// A statement without an answer. Returns the number of rows that it changed.
    virtual std::int64_t change(const std::string& statement, const Cells& parameters = {}) = 0;

    /// Statements without parameters and answers, not kept: definitions.
    virtual void run(const std::string& statements) = 0;

    /// The first cell of the first row as text; none: no row, or NULL.
    std::optional<std::string> word(const std::string& statement, const Cells& parameters = {});
    std::int64_t count(const std::string& statement, const Cells& parameters = {});

    /// Looked at while waiting from now on.
    void watch(const Progress& progress) { progress_ = progress; }

protected:
    friend class Transaction;
    virtual void begin(TransactionKind kind) = 0;
    virtual void commit() = 0;
    virtual void rollback() noexcept = 0;

    Progress progress_;
    bool isWriting_ = false;  ///< errors are those of writing
};

/// From its making to commit(); without it the destructor takes everything back. They do not nest.
class Transaction {
public:
    Transaction(Connection& connection, TransactionKind kind);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    void commit();

private:
    Connection& connection_;
    bool isOpen_ = true;
};

}  // namespace lathelier::archive::sql
