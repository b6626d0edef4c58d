// Adding to an archive: add(), supersede().
#include <chrono>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>

#include "engine/archive/archive_codes.h"
#include "engine/archive/archive_rows.h"
#include "engine/archive/archive_state.h"
#include "engine/archive/dates.h"
#include "engine/archive/sql/random_uuid.h"
#include "engine/core/utc_time.h"
#include "engine/core/utf8.h"
#include "engine/io/file.h"

namespace lathelier::archive {
namespace {

using sql::Connection;
using sql::TransactionKind;

void requireText(const std::string& name, const std::string& text)
{
    if (!isUtf8(text) || text.find('\0') != std::string::npos) throw Error(errors::textNotStorable, {{"name", name}});
}

void checkTexts(const Evaluation& evaluation)
{
    requireText("task", evaluation.task);
    requireText("version", evaluation.version);
    requireText("recipe_sha256", evaluation.recipe_sha256);
    requireText("result", evaluation.result);
    if (!Json::accept(evaluation.result)) throw Error(errors::textNotStorable, {{"name", std::string("result")}});
    for (const EvaluatedInput& input : evaluation.inputs)
        for (const std::string* text : {&input.role, &input.file.path, &input.file.sha256})
            requireText("inputs", *text);
    for (const task::Characteristic& value : evaluation.characteristics) {
        requireText("characteristics", value.key);
        requireText("characteristics", value.unit);
    }
}

void checkTexts(const Attestation& attestation)
{
    requireText("person", attestation.person);
    requireText("instrument", attestation.instrument);
    if (!attestation.calibrated_on.empty()) requireDate("calibrated_on", attestation.calibrated_on);
}

void checkTexts(const ArchivedRecipe& recipe)
{
    requireText("sha256", recipe.sha256);
    requireText("recipe", recipe.content);
}

/// Puts rows at the end of the chain of one writer.
class Writing {
public:
    Writing(Connection& connection, std::string writer, Attestation attestation)
        : connection_(connection), writer_(std::move(writer)), attestation_(std::move(attestation))
    {
        lockForWriting(connection_);
        tail_ = tailOf(connection_, writer_);
        recordedAt_ = utcNow();
    }

    bool holds(const std::string& key)
    {
        return connection_.count(
                   "SELECT count(*) FROM evaluation e WHERE e.key = $1 AND NOT EXISTS (SELECT 1 FROM evaluation s "
                   "WHERE s.supersedes = e.uuid)",
                   {key}) > 0;
    }

    std::string append(Row row)
    {
        row.uuid = sql::randomUuid();
        row.writer = writer_;
        row.sequence = tail_.sequence + 1;
        row.previous_hash = tail_.hash;
        row.recorded_at = recordedAt_;
        row.attestation = attestation_;
        if (const auto recipe = recipeOf(connection_, row.recipe_sha256))
            row.recipe_content_sha256 = io::sha256(*recipe);
        row.hash = hashOf(row);
        insertRow(connection_, row);
        tail_ = {row.sequence, row.hash};
        return row.uuid;
    }

private:
    Connection& connection_;
    std::string writer_;
    Attestation attestation_;
    std::string recordedAt_;
    Tail tail_;
};

}  // namespace

Added Archive::add(const std::vector<Evaluation>& evaluations, const Attestation& attestation,
                   const std::vector<ArchivedRecipe>& recipes, const Progress& progress)
{
    checkTexts(attestation);
    for (const Evaluation& evaluation : evaluations) checkTexts(evaluation);
    for (const ArchivedRecipe& recipe : recipes) checkTexts(recipe);
    Call call(state_->mutex, *state_->connection, TransactionKind::Write, progress);
    Writing writing(*state_->connection, state_->writer, attestation);
    for (const ArchivedRecipe& recipe : recipes) insertRecipe(*state_->connection, recipe);
    Added added;
    double done = 0;
    for (const Evaluation& evaluation : evaluations) {
        progress.report(done++ / static_cast<double>(evaluations.size()));
        Row row = rowOf(evaluation);
        if (writing.holds(row.key)) {
            ++added.already_there;
            continue;
        }
        added.uuids.push_back(writing.append(std::move(row)));
        ++added.added;
    }
    call.commit();
    return added;
}

std::string Archive::supersede(const std::string& uuid, const Evaluation& evaluation, const std::string& reason,
                               const Attestation& attestation, const std::vector<ArchivedRecipe>& recipes,
                               const Progress& progress)
{
    if (reason.empty()) throw Error(errors::reasonMissing, {});
    requireText("reason", reason);
    checkTexts(attestation);
    checkTexts(evaluation);
    for (const ArchivedRecipe& recipe : recipes) checkTexts(recipe);
    Call call(state_->mutex, *state_->connection, TransactionKind::Write, progress);
    Writing writing(*state_->connection, state_->writer, attestation);
    const std::string whole = wholeUuid(*state_->connection, uuid);
    if (const auto other = state_->connection->word("SELECT min(uuid) FROM evaluation WHERE supersedes = $1", {whole}))
        throw Error(errors::alreadySuperseded, {{"uuid", whole}, {"superseded_by", *other}});
    for (const ArchivedRecipe& recipe : recipes) insertRecipe(*state_->connection, recipe);
    Row row = rowOf(evaluation);
    row.supersedes = whole;
    row.reason = reason;
    std::string made = writing.append(std::move(row));
    call.commit();
    return made;
}

}  // namespace lathelier::archive
