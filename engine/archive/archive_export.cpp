// Archive::exportLines().
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "engine/archive/archive_json.h"
#include "engine/archive/archive_rows.h"
#include "engine/archive/archive_state.h"

namespace lathelier::archive {
namespace {

using sql::Connection;
using sql::RowView;
using sql::TransactionKind;

using Write = std::function<void(std::string_view line)>;

/// The evaluation as it was added, and what the archive knows of it behind.
Json lineOf(const Row& row)
{
    Json line = toJson(evaluationOf(row));
    line["uuid"] = row.uuid;
    line["writer"] = row.writer;
    line["sequence"] = row.sequence;
    line["previous_hash"] = row.previous_hash;
    line["hash"] = row.hash;
    line["recorded_at"] = row.recorded_at;
    line["person"] = textOrNothing(row.attestation.person);
    line["instrument"] = textOrNothing(row.attestation.instrument);
    line["calibrated_on"] = textOrNothing(row.attestation.calibrated_on);
    line["supersedes"] = textOrNothing(row.supersedes);
    line["reason"] = textOrNothing(row.reason);
    return line;
}

void exportAll(Connection& connection, const Write& write, const Progress& progress)
{
    std::vector<std::string> recipes;
    connection.each("SELECT sha256 FROM recipe ORDER BY sha256", {},
                    [&recipes](const RowView& view) { recipes.push_back(view.string(0)); });
    for (const std::string& sha256 : recipes) {
        const Json content = Json::parse(recipeOf(connection, sha256).value_or("null"));
        write(Json{{"recipe", content}, {"sha256", sha256}}.dump() + "\n");
    }
    const auto all = static_cast<double>(connection.count("SELECT count(*) FROM evaluation"));
    double done = 0;
    for (const std::string& writer : writersOf(connection))
        eachRow(connection, writer, 0, [&](const Row& row) {
            progress.report(done++ / all);
            write(lineOf(row).dump() + "\n");
        });
}

/// What a line is sorted by, and the row that it is made of. Names of files do not count: they may differ for one
/// content.
struct Sorted {
    std::string inputs, recipe, version, task, key, uuid;
    auto rank() const { return std::tie(inputs, recipe, version, task, key, uuid); }
};

std::string contentsOf(const std::string& inputs)
{
    const Json json = Json::parse(inputs, nullptr, false);
    Json contents = Json::array();
    if (json.is_array())
        for (const Json& input : json)
            if (input.is_object())
                contents.push_back(Json::array({input.value("role", Json()), input.value("sha256", Json())}));
    return contents.dump();
}

/// Of several rows of one key the first of their lines, in the order of letters: so it does not count which was added
/// first, nor where.
void exportCanonical(Connection& connection, const Write& write, const Progress& progress)
{
    std::vector<Sorted> rows;
    connection.each(
        "SELECT e.inputs, e.recipe_sha256, e.version, e.task, e.key, e.uuid FROM evaluation e "
        "WHERE NOT EXISTS (SELECT 1 FROM evaluation s WHERE s.supersedes = e.uuid)",
        {}, [&rows](const RowView& view) {
            rows.push_back({contentsOf(view.string(0)), view.string(1), view.string(2), view.string(3), view.string(4),
                            view.string(5)});
        });
    std::sort(rows.begin(), rows.end(), [](const Sorted& a, const Sorted& b) { return a.rank() < b.rank(); });
    for (std::size_t first = 0, next = 0; first < rows.size(); first = next) {
        progress.report(static_cast<double>(first) / static_cast<double>(rows.size()));
        std::set<std::string> lines;
        for (next = first; next < rows.size() && rows[next].key == rows[first].key; ++next)
            if (const auto row = rowOfUuid(connection, rows[next].uuid))
                lines.insert(canonicalOf(evaluationOf(*row)).dump());
        if (!lines.empty()) write(*lines.begin() + "\n");
    }
}

}  // namespace

void Archive::exportLines(const Write& write, bool canonical, const Progress& progress) const
{
    const Call call(state_->mutex, *state_->connection, TransactionKind::Read, progress);
    if (canonical)
        exportCanonical(*state_->connection, write, progress);
    else
        exportAll(*state_->connection, write, progress);
}

}  // namespace lathelier::archive
