// Archives in both databases, evaluations for them, and a way past the interface.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/archive_codes.h"
#include "engine/archive/sql/postgres_connection.h"
#include "engine/archive/sql/sqlite_connection.h"
#include "engine/io/file.h"
#include "tests/engine/archive/postgres_server.h"
#include "tests/scratch_folder.h"

namespace lathelier::archive {

/// Of the part `number`, with its values.
inline Evaluation partEvaluation(int number, double rmse_mm = 0.012)
{
    const std::string path = "/parts/part_" + std::to_string(number) + ".ply";
    Evaluation made;
    made.task = "compare";
    made.version = "0.2.0";
    made.inputs = {{"copy", {path, 1000 + number, io::sha256(path)}}};
    made.verdict = number % 3 == 0 ? Verdict::Fail : Verdict::Pass;
    const Json result{{"inputs", {{{"path", path}}}},
                      {"rmse_mm", rmse_mm + number * 1e-4},
                      {"zones",
                       {{{"name", "seat"},
                         {"mean_mm", 0.001 * number},
                         {"uncertainty_mm", 0.002},
                         {"lower_mm", -0.05},
                         {"upper_mm", 0.05},
                         {"verdict", number % 3 == 0 ? "fail" : "pass"}}}}};
    made.result = result.dump();
    made.recipe_sha256 = std::string(64, 'a');
    made.characteristics = {{"answer", "mm", 0.04 + number * 1e-3, 0.002, -0.05, 0.05, made.verdict}};
    for (task::Characteristic& one : task::characteristicsOf(result)) made.characteristics.push_back(std::move(one));
    return made;
}

inline std::vector<Evaluation> partEvaluations(int from, int to)
{
    std::vector<Evaluation> made;
    for (int number = from; number < to; ++number) made.push_back(partEvaluation(number));
    return made;
}

inline const std::vector<ArchivedRecipe>& partRecipes()
{
    static const std::vector<ArchivedRecipe> recipes{{std::string(64, 'a'), R"({"limits":[0.05],"name":"seat"})"}};
    return recipes;
}

inline const Attestation inspector{"A. Nowak", "scanner 7", "2026-03-01"};

inline std::string linesOf(const Archive& archive, bool canonical)
{
    std::string lines;
    archive.exportLines([&lines](std::string_view line) { lines += line; }, canonical);
    return lines;
}

/// A connection past the interface, as its administrator has it.
inline std::unique_ptr<sql::Connection> rawConnection(const std::string& location)
{
    return isDatabase(location) ? sql::openPostgres(location, false, {}) : sql::openSqlite(location, false, {});
}

/// Somebody with all rights takes the guards away and writes.
inline void alter(const std::string& location, const std::string& statements)
{
    const auto connection = rawConnection(location);
    if (isDatabase(location)) {
        for (const char* table : {"evaluation", "measured", "recipe", "characteristic"})
            connection->run(std::string("ALTER TABLE ") + table + " DISABLE TRIGGER ALL");
    } else {
        connection->run("PRAGMA foreign_keys = OFF");
        std::vector<std::string> triggers;
        connection->each("SELECT name FROM sqlite_schema WHERE type = 'trigger'", {},
                         [&](const sql::RowView& row) { triggers.push_back(row.string(0)); });
        for (const std::string& trigger : triggers) connection->run("DROP TRIGGER " + trigger);
    }
    connection->run(statements);
}

/// The code of the error that `work` ends with; "" without one.
inline std::string codeOf(const std::function<void()>& work)
{
    try {
        work();
    } catch (const Error& error) {
        return error.code().key;
    }
    return {};
}

enum class Backend { Sqlite, Postgres };

class EitherArchive : public ::testing::TestWithParam<Backend> {
protected:
    /// Where nothing is yet.
    std::string newLocation()
    {
        if (GetParam() == Backend::Postgres) return PostgresServer::instance().newDatabase();
        return scratch_ / ("archive_" + std::to_string(++files_) + ".lathelier");
    }

    /// An archive of `count` parts.
    std::string archiveOf(int count)
    {
        const std::string location = newLocation();
        Archive::open(location, Access::Create).add(partEvaluations(0, count), inspector, partRecipes());
        return location;
    }

    ScratchFolder scratch_;

private:
    int files_ = 0;
};

inline std::string backendName(const ::testing::TestParamInfo<Backend>& info)
{
    return info.param == Backend::Sqlite ? "Sqlite" : "Postgres";
}

}  // namespace lathelier::archive
