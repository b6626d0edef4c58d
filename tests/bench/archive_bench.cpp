// An archive of ten million values: 500 000 parts with 20 characteristics. Made once per run in a temporary file; in
// the empty PostgreSQL database that LATHELIER_BENCH_DATABASE names too, where it is set.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/archive/archive.h"
#include "engine/archive/sql/connection.h"
#include "engine/io/file.h"

namespace lathelier::archive {
namespace {

constexpr int parts = 500'000;
constexpr int characteristics = 20;

/// The parts 1, 2… as rows (n, uuid, recorded_at), of 30 a day.
std::string numberedParts(sql::Dialect dialect)
{
    const std::string all = std::to_string(parts);
    if (dialect == sql::Dialect::Postgres)
        return "SELECT n, lpad(to_hex((n::bigint * 2654435761) % 4294967296), 8, '0') || '-0000-4000-8000-' || "
               "lpad(to_hex(n), 12, '0') AS uuid, to_char(timestamp '2000-01-01' + n * interval '20 minutes', "
               "'YYYY-MM-DD\"T\"HH24:MI:SS.MS\"Z\"') AS recorded_at FROM generate_series(1, " +
               all + ") AS n";
    return "SELECT n, printf('%08x-0000-4000-8000-%012x', (n * 2654435761) % 4294967296, n) AS uuid, "
           "strftime('%Y-%m-%dT%H:%M:%fZ', '2000-01-01', (n * 20) || ' minutes') AS recorded_at FROM "
           "(WITH RECURSIVE number(n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM number WHERE n < " +
           all + ") SELECT n FROM number)";
}

void fill(Archive& archive)
{
    sql::Connection& connection = archive.connection();
    const bool is_file = connection.dialect() == sql::Dialect::Sqlite;
    if (is_file)
        connection.run("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA foreign_keys = OFF");
    else
        connection.run("SET statement_timeout = 0; ALTER TABLE measured DISABLE TRIGGER ALL");
    sql::Transaction transaction(connection, sql::TransactionKind::Write);
    for (int i = 0; i < characteristics; ++i)
        connection.change("INSERT INTO characteristic (task, key, unit) VALUES ('compare', $1, 'mm')",
                          {"zones.zone_" + std::to_string(i) + ".mean_mm"});
    const std::string result = Json{{"text", std::string(400, 'x')}}.dump();
    const std::string numbered = numberedParts(connection.dialect());
    connection.run(
        "INSERT INTO evaluation (uuid, writer, sequence, previous_hash, hash, recorded_at, person, task, version, "
        "recipe_sha256, key, exit_code, verdict, inputs, result) SELECT uuid, 'writer', n, 'p', 'h', recorded_at, "
        "'A. Nowak', 'compare', '0.2.0', 'r', uuid, 0, 'pass', '[{\"role\":\"copy\",\"path\":\"/parts/part_' || n || "
        "'.ply\",\"bytes\":1000,\"sha256\":\"s\"}]', '" +
        result + "' FROM (" + numbered + ") AS part");
    connection.run(
        "INSERT INTO measured (characteristic, recorded_at, sequence, evaluation, place, value, expanded_uncertainty, "
        "lower_limit, upper_limit, verdict, file) SELECT c.id, part.recorded_at, part.n, part.uuid, c.id, "
        "(part.n % 1000) * 0.0001, 0.002, -0.05, 0.05, 'pass', 'part_' || part.n || '.ply' FROM characteristic c CROSS "
        "JOIN (" +
        numbered + ") AS part ORDER BY c.id, part.n");
    transaction.commit();
    if (!is_file) connection.run("ALTER TABLE measured ENABLE TRIGGER ALL");
}

/// The archive of a database, filled with the first use.
Archive& filled(bool is_file)
{
    static const io::PartFolder folder;
    static std::unique_ptr<Archive> archives[2];
    std::unique_ptr<Archive>& archive = archives[is_file ? 0 : 1];
    if (!archive) {
        const std::string location = is_file ? folder.path() + "/archive" : std::getenv("LATHELIER_BENCH_DATABASE");
        archive = std::make_unique<Archive>(Archive::open(location, Access::Create));
        fill(*archive);
        if (!is_file) archive->connection().run("VACUUM ANALYZE evaluation; ");
        if (!is_file) archive->connection().run("VACUUM ANALYZE measured");
        archive.reset();
        archive = std::make_unique<Archive>(Archive::open(location, Access::Read));
    }
    return *archive;
}

/// 0: a file; 1: the database, where there is one.
void inEach(benchmark::internal::Benchmark* of, const std::vector<std::int64_t>& most)
{
    const std::int64_t last = std::getenv("LATHELIER_BENCH_DATABASE") != nullptr ? 1 : 0;
    for (std::int64_t database = 0; database <= last; ++database)
        for (const std::int64_t one : most) of->Args({database, one});
    of->Unit(benchmark::kMillisecond);
}

void listed(benchmark::internal::Benchmark* of)
{
    inEach(of, {1000});
}

void charted(benchmark::internal::Benchmark* of)
{
    inEach(of, {1000, 10'000, 0});
}

void listLatest(benchmark::State& state)
{
    const Archive& archive = filled(state.range(0) == 0);
    for (auto _ : state) benchmark::DoNotOptimize(archive.list({.most = 1000}));
}

void listByCharacteristic(benchmark::State& state)
{
    const Archive& archive = filled(state.range(0) == 0);
    for (auto _ : state)
        benchmark::DoNotOptimize(archive.list({.characteristic = "zones.zone_7.mean_mm", .most = 1000}));
}

void series(benchmark::State& state)
{
    const Archive& archive = filled(state.range(0) == 0);
    for (auto _ : state) benchmark::DoNotOptimize(archive.series("zones.zone_7.mean_mm", {.most = state.range(1)}));
}

BENCHMARK(listLatest)->Apply(listed);
BENCHMARK(listByCharacteristic)->Apply(listed);
BENCHMARK(series)->Apply(charted);

}  // namespace
}  // namespace lathelier::archive

BENCHMARK_MAIN();
