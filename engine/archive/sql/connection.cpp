#include "engine/archive/sql/connection.h"

namespace lathelier::archive::sql {

Cell textOrNull(const std::string& text)
{
    if (text.empty()) return std::monostate();
    return text;
}

Cell numberOrNull(const std::optional<double>& number)
{
    if (!number) return std::monostate();
    return *number;
}

std::optional<double> RowView::numberIfAny(int column) const
{
    return isNull(column) ? std::nullopt : std::optional(number(column));
}

std::optional<std::string> Connection::word(const std::string& statement, const Cells& parameters)
{
    std::optional<std::string> found;
    each(statement, parameters, [&found](const RowView& row) {
        if (!found && !row.isNull(0)) found = row.string(0);
    });
    return found;
}

std::int64_t Connection::count(const std::string& statement, const Cells& parameters)
{
    std::int64_t found = 0;
    each(statement, parameters, [&found](const RowView& row) { found = row.integer(0); });
    return found;
}

Transaction::Transaction(Connection& connection, TransactionKind kind) : connection_(connection)
{
    connection_.isWriting_ = kind == TransactionKind::Write;
    try {
        connection_.begin(kind);
    } catch (...) {
        connection_.isWriting_ = false;
        throw;
    }
}

Transaction::~Transaction()
{
    if (isOpen_) connection_.rollback();
    connection_.isWriting_ = false;
}

void Transaction::commit()
{
    connection_.commit();
    isOpen_ = false;
}

}  // namespace lathelier::archive::sql
