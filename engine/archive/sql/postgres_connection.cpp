#include "engine/archive/sql/postgres_connection.h"

#include <libpq-fe.h>
#include <poll.h>

#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <unordered_map>
#include <utility>

#include "engine/archive/archive_codes.h"
#include "engine/archive/sql/location.h"
#include "engine/archive/sql/sql_reasons.h"

namespace lathelier::archive::sql {
namespace {

constexpr int pollTime_ms = 50;
constexpr int standardConnectTime_s = 10;

using Link = std::unique_ptr<PGconn, void (*)(PGconn*)>;
using Result = std::unique_ptr<PGresult, void (*)(PGresult*)>;
using Options = std::unique_ptr<PQconninfoOption, void (*)(PQconninfoOption*)>;

/// The library's message on one line.
std::string messageOf(const char* message)
{
    std::string line;
    for (const char* sign = message ? message : ""; *sign != '\0'; ++sign) {
        if (*sign == '\n' || *sign == '\t')
            line += line.empty() || line.back() == ' ' ? "" : " ";
        else
            line += *sign;
    }
    while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
    return line;
}

std::string valueOf(const PQconninfoOption* options, std::string_view key)
{
    for (const PQconninfoOption* one = options; one && one->keyword; ++one)
        if (key == one->keyword) return one->val ? one->val : "";
    return {};
}

class PostgresRow final : public RowView {
public:
    explicit PostgresRow(const PGresult* result) : result_(result) {}
    bool isNull(int column) const override { return PQgetisnull(result_, row, column) != 0; }
    std::int64_t integer(int column) const override { return parsed<std::int64_t>(column); }
    double number(int column) const override { return parsed<double>(column); }
    std::string_view text(int column) const override
    {
        return {PQgetvalue(result_, row, column), static_cast<std::size_t>(PQgetlength(result_, row, column))};
    }
    int row = 0;

private:
    template <class Number>
    Number parsed(int column) const
    {
        const std::string_view word = text(column);
        Number number{};
        std::from_chars(word.data(), word.data() + word.size(), number);
        return number;
    }

    const PGresult* result_;
};

std::string textOf(const Cell& cell)
{
    std::array<char, 40> buffer{};
    char* const end = buffer.data() + buffer.size();
    if (const auto* integer = std::get_if<std::int64_t>(&cell))
        return {buffer.data(), std::to_chars(buffer.data(), end, *integer).ptr};
    if (const auto* number = std::get_if<double>(&cell))
        return {buffer.data(), std::to_chars(buffer.data(), end, *number).ptr};
    const auto* text = std::get_if<std::string>(&cell);
    return text ? *text : std::string();
}

void waitFor(const PGconn* link, bool reading)
{
    struct pollfd socket {
        PQsocket(link), static_cast<short>(reading ? POLLIN : POLLOUT), 0
    };
    ::poll(&socket, 1, pollTime_ms);
}

class PostgresConnection final : public Connection {
public:
    PostgresConnection(Link link, std::string shown) : location_(std::move(shown)), link_(std::move(link)) {}

    Dialect dialect() const override { return Dialect::Postgres; }
    const std::string& location() const override { return location_; }

    void each(const std::string& statement, const Cells& parameters,
              const std::function<void(const RowView&)>& use) override
    {
        const Result result = answered(statement, parameters);
        PostgresRow row(result.get());
        for (row.row = 0; row.row < PQntuples(result.get()); ++row.row) use(row);
    }

    std::int64_t change(const std::string& statement, const Cells& parameters) override
    {
        const Result result = answered(statement, parameters);
        const std::string_view count = PQcmdTuples(result.get());
        std::int64_t changed = 0;
        std::from_chars(count.data(), count.data() + count.size(), changed);
        return changed;
    }

    void run(const std::string& statements) override
    {
        require(PQsendQuery(link_.get(), statements.c_str()) == 1);
        taken();
    }

protected:
    void begin(TransactionKind kind) override
    {
        run(kind == TransactionKind::Write ? "BEGIN ISOLATION LEVEL READ COMMITTED"
                                           : "BEGIN ISOLATION LEVEL REPEATABLE READ, READ ONLY");
    }
    void commit() override { run("COMMIT"); }
    void rollback() noexcept override
    {
        try {
            const Progress stoppable = std::exchange(progress_, Progress());
            if (PQtransactionStatus(link_.get()) != PQTRANS_IDLE) run("ROLLBACK");
            progress_ = stoppable;
        } catch (const std::exception&) {  // the connection is gone, and the server takes it back
        }
    }

private:
    Result answered(const std::string& statement, const Cells& parameters)
    {
        const std::string& name = prepared(statement);
        std::vector<std::string> texts;
        std::vector<const char*> values;
        texts.reserve(parameters.size());
        values.reserve(parameters.size());
        for (const Cell& cell : parameters) {
            texts.push_back(textOf(cell));
            values.push_back(std::holds_alternative<std::monostate>(cell) ? nullptr : texts.back().c_str());
        }
        require(PQsendQueryPrepared(link_.get(), name.c_str(), static_cast<int>(values.size()), values.data(), nullptr,
                                    nullptr, 0) == 1);
        return taken();
    }

    const std::string& prepared(const std::string& statement)
    {
        const auto found = statements_.find(statement);
        if (found != statements_.end()) return found->second;
        const std::string name = std::string("s").append(std::to_string(statements_.size()));
        require(PQsendPrepare(link_.get(), name.c_str(), statement.c_str(), 0, nullptr) == 1);
        taken();
        return statements_.emplace(statement, name).first->second;
    }

    void require(bool is_sent) const
    {
        if (!is_sent) fail(nullptr);
    }

    /// Waits for the whole answer; of several the last, or the first that is an error.
    Result taken()
    {
        Result last(nullptr, &PQclear);
        bool is_stopped = false;
        while (true) {
            while (PQflush(link_.get()) == 1) waitFor(link_.get(), false);
            while (PQisBusy(link_.get()) != 0) {
                if (progress_.stopped() && !std::exchange(is_stopped, true)) cancel();
                waitFor(link_.get(), true);
                if (PQconsumeInput(link_.get()) == 0) fail(nullptr);
            }
            Result next(PQgetResult(link_.get()), &PQclear);
            if (!next) break;
            if (!last || PQresultStatus(last.get()) != PGRES_FATAL_ERROR) last = std::move(next);
        }
        const ExecStatusType status = last ? PQresultStatus(last.get()) : PGRES_FATAL_ERROR;
        if (status != PGRES_TUPLES_OK && status != PGRES_COMMAND_OK) {
            if (is_stopped) throw Cancelled();
            fail(last.get());
        }
        return last;
    }

    void cancel()
    {
        PGcancel* const request = PQgetCancel(link_.get());
        std::array<char, 256> ignored{};
        PQcancel(request, ignored.data(), static_cast<int>(ignored.size()));
        PQfreeCancel(request);
    }

    Value reasonOf(const PGresult* result) const
    {
        const char* state = result ? PQresultErrorField(result, PG_DIAG_SQLSTATE) : nullptr;
        const std::string_view code = state ? state : "";
        if (PQstatus(link_.get()) != CONNECTION_OK || code.starts_with("08") || code.starts_with("57P"))
            return reasons::connectionLost;
        if (code == "42501") return reasons::notPermitted;
        if (code == "25006") return reasons::readOnly;
        if (code == "53100") return reasons::diskFull;
        if (code == "53200") return reasons::memory;
        if (code == "55P03") return reasons::held;
        if (code == "57014") return reasons::tooSlow;
        const char* primary = result ? PQresultErrorField(result, PG_DIAG_MESSAGE_PRIMARY) : nullptr;
        return messageOf(primary ? primary : PQerrorMessage(link_.get()));
    }

    [[noreturn]] void fail(const PGresult* result) const
    {
        throw Error(isWriting_ ? errors::archiveNotWritten : errors::archiveNotRead,
                    {{"location", location_}, {"reason", reasonOf(result)}});
    }

    std::string location_;
    Link link_;
    std::unordered_map<std::string, std::string> statements_;
};

struct Settings {
    std::vector<const char*> keys, values;
    void add(const char* key, const char* value)
    {
        keys.push_back(key);
        values.push_back(value);
    }
};

/// Begins to connect. `location` is the dbname that libpq expands; what is added behind it has precedence.
Link started(const std::string& location, const char* sslmode)
{
    Settings settings;
    settings.add("dbname", location.c_str());
    settings.add("client_encoding", "UTF8");
    settings.add("fallback_application_name", "lathelier");
    settings.add("keepalives_idle", "30");
    settings.add("tcp_user_timeout", "60000");
    if (sslmode != nullptr) {
        settings.add("sslmode", sslmode);
        settings.add("gssencmode", "disable");  // else it would be tried before TLS, and take its place
    }
    settings.add(nullptr, nullptr);
    return {PQconnectStartParams(settings.keys.data(), settings.values.data(), 1), &PQfinish};
}

/// What sslmode is to be; empty: as it is. Of a mode that only a service file states, and that libpq takes without one,
/// cannot be told that it was stated: it becomes verify-full too.
std::string demandedMode(PGconn* link, const std::string& location, const std::string& shown)
{
    const Options effective(PQconninfo(link), &PQconninfoFree);
    const Options stated(PQconninfoParse(location.c_str(), nullptr), &PQconninfoFree);
    const std::string address = valueOf(effective.get(), "hostaddr");
    const std::string mode = valueOf(effective.get(), "sslmode");
    const bool is_stated =
        !valueOf(stated.get(), "sslmode").empty() || std::getenv("PGSSLMODE") != nullptr || mode != "prefer";
    const auto demanded = demandedTls(address.empty() ? valueOf(effective.get(), "host") : address, mode, is_stated);
    if (!demanded) throw Error(errors::tlsRequired, {{"location", shown}, {"found", mode}});
    return *demanded;
}

int connectTime_s(PGconn* link)
{
    const Options effective(PQconninfo(link), &PQconninfoFree);
    const std::string stated = valueOf(effective.get(), "connect_timeout");
    int seconds = 0;
    std::from_chars(stated.data(), stated.data() + stated.size(), seconds);
    return seconds > 0 ? seconds : standardConnectTime_s;
}

/// Until it is connected, or has failed.
void connect(PGconn* link, const std::string& shown, const Progress& progress)
{
    const auto refuse = [&shown](const Value& reason) {
        throw Error(errors::archiveNotOpened, {{"location", shown}, {"reason", reason}});
    };
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(connectTime_s(link));
    PostgresPollingStatusType state = PGRES_POLLING_WRITING;
    while (state != PGRES_POLLING_OK) {
        progress.check();
        if (PQstatus(link) == CONNECTION_BAD || state == PGRES_POLLING_FAILED) refuse(messageOf(PQerrorMessage(link)));
        if (std::chrono::steady_clock::now() > end) refuse(reasons::noServer);
        struct pollfd socket {
            PQsocket(link), static_cast<short>(state == PGRES_POLLING_READING ? POLLIN : POLLOUT), 0
        };
        if (::poll(&socket, 1, pollTime_ms) > 0) state = PQconnectPoll(link);
    }
}

}  // namespace

std::unique_ptr<Connection> openPostgres(const std::string& location, bool is_read_only, const Progress& progress)
{
    const std::string shown = withoutSecrets(location);
    if (statesPassword(location)) throw Error(errors::passwordInLocation, {{"location", shown}});
    // The library's own message would quote the location.
    if (!Options(PQconninfoParse(location.c_str(), nullptr), &PQconninfoFree))
        throw Error(errors::locationUnclear,
                    {{"location", shown},
                     {"expected", LT_TEXT("Engine", "postgresql://user@host/database, host=… dbname=… or service=…")}});
    Link link = started(location, nullptr);
    if (!link) throw Error(errors::archiveNotOpened, {{"location", shown}, {"reason", reasons::memory}});
    if (const std::string mode = demandedMode(link.get(), location, shown); !mode.empty())
        link = started(location, mode.c_str());
    connect(link.get(), shown, progress);
    PQsetNoticeProcessor(
        link.get(), [](void*, const char*) {}, nullptr);
    auto connection = std::make_unique<PostgresConnection>(std::move(link), shown);
    connection->watch(progress);
    connection->run(std::string("SET search_path TO ") + postgresSchema +
                    ", pg_catalog; SET statement_timeout = '5min'; SET lock_timeout = '1min'; "
                    "SET idle_in_transaction_session_timeout = '10min'; SET extra_float_digits = 1; "
                    "SET standard_conforming_strings = on; SET default_transaction_read_only = " +
                    (is_read_only ? "on" : "off"));
    return connection;
}

}  // namespace lathelier::archive::sql
