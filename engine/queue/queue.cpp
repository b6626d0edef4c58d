#include "engine/queue/queue.h"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/archive/sql/connection.h"
#include "engine/archive/sql/random_uuid.h"
#include "engine/batch/part_run.h"
#include "engine/io/json/json_text.h"
#include "engine/queue/queue_codes.h"

namespace lathelier::queue {
namespace {

namespace fs = std::filesystem;
namespace sql = archive::sql;

bool isPostgres(const sql::Connection& connection)
{
    return connection.dialect() == sql::Dialect::Postgres;
}

/// The server's clock: those of the workers may differ.
const char* now(const sql::Connection& connection)
{
    return isPostgres(connection) ? "now()" : "strftime('%Y-%m-%dT%H:%M:%f', 'now')";
}

/// The moment so many seconds ago, $1.
const char* lostSince(const sql::Connection& connection)
{
    return isPostgres(connection) ? "now() - $1 * interval '1 second'"
                                  : "strftime('%Y-%m-%dT%H:%M:%f', 'now', '-' || $1 || ' seconds')";
}

std::string absolute(const std::string& path)
{
    return fs::absolute(path).lexically_normal().string();
}

std::string inputOf(const std::string& recipe_path, const batch::Part& part)
{
    Json files = Json::array();
    for (const auto& [key, path] : part.files) files.push_back(Json::array({key, absolute(path)}));
    return Json{{"recipe", absolute(recipe_path)}, {"files", std::move(files)}}.dump(-1, ' ', false,
                                                                                     Json::error_handler_t::replace);
}

/// The reverse of inputOf(), of rows of our own.
void takeInput(const std::string& text, Job& job)
{
    const Json input = io::parseJson(text);
    job.recipe_path = input.at("recipe").get<std::string>();
    for (const Json& file : input.at("files"))
        job.part.files.emplace_back(file.at(0).get<std::string>(), file.at(1).get<std::string>());
}

void write(archive::Archive& archive, const std::function<void(sql::Connection&)>& work)
{
    sql::Transaction transaction(archive.connection(), sql::TransactionKind::Write);
    work(archive.connection());
    transaction.commit();
}

std::string errorText(const Error& error)
{
    return toJson(error).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void change(archive::Archive& archive, const Job& job, const std::string& worker, const std::string& setting,
            const sql::Cell& error)
{
    write(archive, [&](sql::Connection& connection) {
        connection.change(
            "UPDATE job SET " + setting + ", error = $1 WHERE id = $2 AND worker = $3 AND state = 'running'",
            {error, job.id, worker});
    });
}

/// Those whose last worker was lost too.
void failLost(sql::Connection& connection, double lost_after_s)
{
    std::vector<std::pair<std::int64_t, std::string>> lost;
    connection.each(std::string("SELECT id, worker FROM job WHERE state = 'running' AND tries >= $2 AND heartbeat < ") +
                        lostSince(connection) + " ORDER BY id" +
                        (isPostgres(connection) ? " FOR UPDATE SKIP LOCKED" : ""),
                    {lost_after_s, std::int64_t{mostTries}},
                    [&](const sql::RowView& row) { lost.emplace_back(row.integer(0), row.string(1)); });
    for (const auto& [id, worker] : lost)
        connection.change(
            "UPDATE job SET state = 'failed', error = $1 WHERE id = $2",
            {errorText(Error(errors::queueWorkerLost, {{"tries", std::int64_t{mostTries}}, {"worker", worker}})), id});
}

}  // namespace

Queued enqueue(archive::Archive& archive, const std::string& recipe_path, const batch::Recipe& recipe,
               const std::vector<batch::Part>& parts, const Progress& progress)
{
    constexpr std::size_t partsPerTransaction = 100;
    const batch::PartRun run(recipe, {}, progress);
    const Progress queueing = progress.part(0, 1, LT_TEXT("Engine", "Queueing parts"));
    Queued made;
    made.recipe_sha256 = batch::identityOf(recipe);
    for (std::size_t from = 0; from < parts.size(); from += partsPerTransaction) {
        const std::size_t to = std::min(parts.size(), from + partsPerTransaction);
        std::vector<std::pair<std::string, std::string>> rows;  // key and input
        rows.reserve(to - from);
        for (std::size_t i = from; i < to; ++i) {
            progress.check();
            queueing.report(static_cast<double>(i) / static_cast<double>(parts.size()));
            try {
                rows.emplace_back(run.begin(parts[i]).key(), inputOf(recipe_path, parts[i]));
            } catch (const Error& error) {
                made.failures.push_back(batch::failureOf(i, parts[i].name(), error));
            }
        }
        write(archive, [&](sql::Connection& connection) {
            for (const auto& [key, input] : rows) {
                const std::int64_t added = connection.change(
                    "INSERT INTO job (job, recipe_sha256, input, key, state) VALUES ($1, $2, $3, $4, 'waiting') "
                    "ON CONFLICT (key) DO NOTHING",
                    {sql::randomUuid(), made.recipe_sha256, input, key});
                made.queued += added;
                made.already_there += 1 - added;
            }
        });
    }
    return made;
}

std::optional<Job> take(archive::Archive& archive, const std::string& worker, double lost_after_s)
{
    std::optional<Job> taken;
    std::string input;
    write(archive, [&](sql::Connection& connection) {
        failLost(connection, lost_after_s);
        const std::string lock = isPostgres(connection) ? " FOR UPDATE SKIP LOCKED" : "";
        connection.each(std::string("UPDATE job SET state = 'running', tries = tries + 1, worker = $2, heartbeat = ") +
                            now(connection) +
                            " WHERE id = (SELECT id FROM job WHERE state = 'waiting' OR (state = 'running' AND tries < "
                            "$3 AND heartbeat < " +
                            lostSince(connection) + ") ORDER BY id LIMIT 1" + lock +
                            ") RETURNING id, key, recipe_sha256, input, tries",
                        {lost_after_s, worker, std::int64_t{mostTries}}, [&](const sql::RowView& row) {
                            Job& job = taken.emplace();
                            job.id = row.integer(0);
                            job.key = row.string(1);
                            job.recipe_sha256 = row.string(2);
                            input = row.string(3);
                            job.tries = row.integer(4);
                        });
    });
    if (taken) takeInput(input, *taken);
    return taken;
}

void beat(archive::Archive& archive, const Job& job, const std::string& worker)
{
    write(archive, [&](sql::Connection& connection) {
        connection.change(std::string("UPDATE job SET heartbeat = ") + now(connection) +
                              " WHERE id = $1 AND worker = $2 AND state = 'running'",
                          {job.id, worker});
    });
}

void finish(archive::Archive& archive, const Job& job, const std::string& worker)
{
    change(archive, job, worker, "state = 'done'", {});
}

void fail(archive::Archive& archive, const Job& job, const std::string& worker, const Error& error)
{
    change(archive, job, worker, "state = 'failed'", errorText(error));
}

void giveBack(archive::Archive& archive, const Job& job, const std::string& worker)
{
    change(archive, job, worker, "state = 'waiting', tries = tries - 1", {});
}

void retryLater(archive::Archive& archive, const Job& job, const std::string& worker, const Error& error)
{
    change(archive, job, worker, job.tries < mostTries ? "state = 'waiting'" : "state = 'failed'", errorText(error));
}

bool isIdle(archive::Archive& archive)
{
    const sql::Transaction transaction(archive.connection(), sql::TransactionKind::Read);
    return !archive.connection().word("SELECT key FROM job WHERE state IN ('waiting', 'running') LIMIT 1");
}

QueueState stateOf(archive::Archive& archive)
{
    QueueState state;
    sql::Connection& connection = archive.connection();
    const sql::Transaction transaction(connection, sql::TransactionKind::Read);
    const std::map<std::string, std::int64_t QueueState::*> counts{{"waiting", &QueueState::waiting},
                                                                   {"running", &QueueState::running},
                                                                   {"done", &QueueState::done},
                                                                   {"failed", &QueueState::failed}};
    connection.each("SELECT state, count(*) FROM job GROUP BY state", {}, [&](const sql::RowView& row) {
        if (const auto found = counts.find(row.string(0)); found != counts.end())
            state.*(found->second) = row.integer(1);
    });
    connection.each("SELECT input, tries, error FROM job WHERE state = 'failed' ORDER BY id", {},
                    [&](const sql::RowView& row) {
                        Job job;
                        takeInput(row.string(0), job);
                        state.failures.push_back({job.part.name(), row.integer(1), row.string(2)});
                    });
    return state;
}

std::int64_t retryFailed(archive::Archive& archive)
{
    std::int64_t changed = 0;
    write(archive, [&](sql::Connection& connection) {
        changed = connection.change("UPDATE job SET state = 'waiting', tries = 0, error = NULL WHERE state = 'failed'");
    });
    return changed;
}

Json toJson(const QueueState& state)
{
    Json json{{"waiting", state.waiting},
              {"running", state.running},
              {"done", state.done},
              {"failed", state.failed},
              {"failures", Json::array()}};
    for (const FailedJob& one : state.failures)
        json["failures"].push_back({{"path", one.name},
                                    {"tries", one.tries},
                                    {"error", Json::parse(one.error.empty() ? "null" : one.error, nullptr, false)}});
    return json;
}

}  // namespace lathelier::queue
