// Whatever is changed behind the archive's back is found and named.
#include "engine/archive/chain.h"

#include "engine/archive/archive_rows.h"
#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::archive {
namespace {

std::string uuidAt(const std::string& location, std::int64_t sequence)
{
    for (const Entry& entry : Archive::open(location, Access::Read).list())
        if (entry.sequence == sequence) return entry.uuid;
    return {};
}

std::optional<BrokenRow> brokenOf(const std::string& location)
{
    return Archive::open(location, Access::Read).verify().broken;
}

class EveryField : public EitherArchive {
protected:
    /// The third of five rows is altered; it is named.
    void expectFound(const std::string& statement, const std::string& fault, std::int64_t sequence = 3)
    {
        SCOPED_TRACE(statement);
        const std::string location = archiveOf(5);
        const std::string uuid = uuidAt(location, 3);
        std::string filled = statement;
        for (std::size_t at = filled.find('@'); at != std::string::npos; at = filled.find('@'))
            filled.replace(at, 1, "'" + uuid + "'");
        EXPECT_FALSE(brokenOf(location));
        alter(location, filled);
        const auto broken = brokenOf(location);
        ASSERT_TRUE(broken);
        EXPECT_EQ(key(broken->fault), fault);
        EXPECT_EQ(broken->sequence, sequence);
        EXPECT_EQ(Archive::open(location, Access::Read).verify().chains.front().checked, sequence - 1);
    }
};

TEST_P(EveryField, of_an_evaluation_is_found_when_it_is_altered)
{
    for (const char* text :
         {"previous_hash = 'x'", "hash = 'x'", "recorded_at = '2020-01-01T00:00:00.000Z'", "person = 'x'",
          "person = NULL", "instrument = 'x'", "calibrated_on = '2020-01-01'", "version = '9'", "recipe_sha256 = 'x'",
          "recipe_content_sha256 = 'x'", "recipe_content_sha256 = NULL", "key = 'x'", "exit_code = 4",
          "verdict = 'undecided'", "supersedes = 'x'", "reason = 'x'", "inputs = '[]'", "uuid = 'x'"}) {
        const std::string field = text;
        const bool is_file = field.starts_with("inputs");  // the name of the file beside the values is another then
        expectFound("UPDATE evaluation SET " + field + " WHERE uuid = @", is_file ? "values" : "content");
    }
    expectFound("UPDATE evaluation SET task = 'roundness' WHERE uuid = @", "content");
    expectFound("UPDATE evaluation SET result = replace(result, '0.0122', '0.0121') WHERE uuid = @", "values");
    expectFound("UPDATE evaluation SET result = replace(result, 'parts', 'party') WHERE uuid = @", "content");
    expectFound("UPDATE evaluation SET sequence = 30 WHERE uuid = @", "missing");
    expectFound("UPDATE evaluation SET writer = 'zzzz' WHERE uuid = @", "missing");
    expectFound("DELETE FROM measured WHERE evaluation = @; DELETE FROM evaluation WHERE uuid = @", "missing");
}

TEST_P(EveryField, of_a_value_is_found_when_it_is_altered)
{
    const std::string of_rmse =
        " WHERE evaluation = @ AND characteristic = (SELECT id FROM characteristic WHERE key = 'zones.seat.mean_mm')";
    for (const char* field : {"value = 1", "expanded_uncertainty = 1", "expanded_uncertainty = NULL", "lower_limit = 1",
                              "upper_limit = NULL", "file = 'x'"})
        expectFound(std::string("UPDATE measured SET ") + field + of_rmse, "values");
    for (const char* field : {"verdict = NULL", "verdict = 'fail'", "recorded_at = 'x'", "sequence = 9",
                              "evaluation = 'x'", "place = 0", "characteristic = 99"})
        expectFound(std::string("UPDATE measured SET ") + field + of_rmse, "content");
    // The answer stands in no result: the hash alone tells.
    expectFound("UPDATE measured SET value = 1 WHERE evaluation = @ AND place = 1", "content");
    expectFound("DELETE FROM measured WHERE evaluation = @ AND place = 1", "content");
}

TEST_P(EveryField, of_characteristics_and_recipes_is_found_when_it_is_altered)
{
    expectFound("UPDATE characteristic SET unit = 'm' WHERE key = 'answer'", "content", 1);
    expectFound("UPDATE characteristic SET key = 'x' WHERE key = 'answer'", "content", 1);
    expectFound("UPDATE characteristic SET task = 'x' WHERE key = 'answer'", "content", 1);
    expectFound("UPDATE recipe SET content = '{}'", "recipe", 1);
    expectFound("DELETE FROM recipe", "recipe", 1);
}

TEST_P(EveryField, a_row_that_was_hashed_anew_does_not_fit_the_next)
{
    const std::string location = archiveOf(5);
    const std::string uuid = uuidAt(location, 3);
    const auto raw = rawConnection(location);
    Row row = *rowOfUuid(*raw, uuid);
    row.attestation.person = "Somebody Else";
    alter(location,
          "UPDATE evaluation SET person = 'Somebody Else', hash = '" + hashOf(row) + "' WHERE uuid = '" + uuid + "'");
    const auto broken = brokenOf(location);
    ASSERT_TRUE(broken);
    EXPECT_EQ(broken->fault, Fault::Order);
    EXPECT_EQ(broken->sequence, 4);
    EXPECT_EQ(broken->uuid, uuidAt(location, 4));
}

TEST_P(EveryField, a_place_that_is_taken_twice_is_named)
{
    const std::string location = archiveOf(3);
    const std::string cascade = isDatabase(location) ? " CASCADE" : "";
    alter(location,
          "CREATE TABLE again AS SELECT * FROM evaluation; UPDATE again SET uuid = '~' WHERE sequence = 2;"
          "INSERT INTO again SELECT * FROM evaluation WHERE sequence = 2;"
          "DROP TABLE evaluation" +
              cascade + "; ALTER TABLE again RENAME TO evaluation");
    const auto broken = brokenOf(location);
    ASSERT_TRUE(broken);
    EXPECT_EQ(broken->fault, Fault::Duplicated);
    EXPECT_EQ(broken->sequence, 2);
    EXPECT_EQ(broken->uuid, "~");
}

TEST_P(EveryField, values_that_belong_to_no_row_are_found)
{
    const std::string location = archiveOf(3);
    alter(location,
          "INSERT INTO measured (characteristic, recorded_at, sequence, evaluation, place, value, file) "
          "VALUES (1, '2026-01-01T00:00:00.000Z', 2, '" +
              uuidAt(location, 2) + "', 9, 7, 'x')");
    const auto broken = brokenOf(location);
    ASSERT_TRUE(broken);
    EXPECT_EQ(broken->fault, Fault::StrayValues);
    EXPECT_EQ(broken->uuid, uuidAt(location, 2));
}

TEST_P(EveryField, values_that_were_never_those_of_the_result_are_found)
{
    const std::string location = archiveOf(1);
    Evaluation made = partEvaluation(1);
    made.characteristics.back().value = 7;
    Archive::open(location, Access::Write).add({made}, {});
    const auto broken = brokenOf(location);
    ASSERT_TRUE(broken);
    EXPECT_EQ(broken->fault, Fault::Values);
    EXPECT_EQ(broken->sequence, 2);
}

TEST_P(EveryField, a_broken_end_of_a_chain_is_told_on_opening)
{
    const std::string location = archiveOf(3);
    alter(location, "UPDATE evaluation SET person = 'x' WHERE sequence = 3");
    EXPECT_EQ(codeOf([&] { Archive::open(location, Access::Write); }), "chain_broken");
    const Archive archive = Archive::open(location, Access::Read);
    EXPECT_TRUE(contains(archive.notes(), notes::chainBroken));
    EXPECT_EQ(archive.list().size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(Databases, EveryField, ::testing::Values(Backend::Sqlite, Backend::Postgres), backendName);

TEST(Chain, fields_of_different_lengths_do_not_run_into_each_other)
{
    Row one, other;
    one.attestation = {"ab", "c", ""};
    other.attestation = {"a", "bc", ""};
    EXPECT_NE(hashOf(one), hashOf(other));
    one = other = {};
    one.values = {{"a", "", 1, {}, 2.0, {}, {}}};
    other.values = {{"a", "", 1, 2.0, {}, {}, {}}};
    EXPECT_NE(hashOf(one), hashOf(other));
}

TEST(Chain, hash_is_the_same_for_ever)
{
    Row row = rowOf(partEvaluation(1));
    row.uuid = "f81d4fae-7dec-41d0-a765-00a0c91e6bf6";
    row.writer = "w";
    row.sequence = 1;
    row.previous_hash = firstHash;
    row.recorded_at = "2026-11-29T00:00:00.000Z";
    EXPECT_EQ(hashOf(row), "9143a123700410133c30e55c6f860fe45e5db1f3ad481f961a674d1e0d055eba");
}

}  // namespace
}  // namespace lathelier::archive
