// Rows go from archive to archive as they are, once each.
#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::archive {
namespace {

Pushed push(const std::string& from, const std::string& to)
{
    Archive target = Archive::open(to, Access::Write);
    return Archive::open(from, Access::Read).push(target);
}

class PushTo : public EitherArchive {
protected:
    std::string file(const std::string& name) { return scratch_ / name; }
};

TEST_P(PushTo, rows_arrive_as_they_are_and_once)
{
    const std::string from = file("file");
    {
        Archive archive = Archive::open(from, Access::Create);
        archive.add(partEvaluations(0, 250), inspector, partRecipes());
        archive.supersede(archive.list().front().uuid, partEvaluation(249, 0.5), "better", inspector);
    }
    const std::string to = archiveOf(2);
    const Pushed first = push(from, to);
    EXPECT_EQ(first.pushed, 251);
    EXPECT_EQ(first.already_there, 0);
    const Pushed second = push(from, to);
    EXPECT_EQ(second.pushed, 0);
    EXPECT_EQ(second.already_there, 251);
    const Archive source = Archive::open(from, Access::Read), target = Archive::open(to, Access::Read);
    const Verification made = target.verify();
    EXPECT_FALSE(made.broken);
    EXPECT_EQ(made.checked(), 253);
    EXPECT_EQ(made.chains.size(), 2u);
    for (const Entry& entry : source.list()) EXPECT_EQ(target.show(entry.uuid).entry.hash, entry.hash);
    EXPECT_EQ(linesOf(source, true), linesOf(target, true));
    // And back into a new file: the two chains of the target.
    const std::string back = file("back");
    Archive::open(back, Access::Create);
    EXPECT_EQ(push(to, back).pushed, 253);
    EXPECT_FALSE(Archive::open(back, Access::Read).verify().broken);
}

TEST_P(PushTo, interrupted_anywhere_and_repeated_it_ends_the_same)
{
    const std::string from = file("file");
    Archive::open(from, Access::Create).add(partEvaluations(0, 230), inspector, partRecipes());
    const std::string to = archiveOf(0);
    const Archive source = Archive::open(from, Access::Read);
    int stopped = 0;
    for (const std::int64_t most : {30, 120, 205}) {
        // A target that fails at a certain row: another connection holds nothing, but the row is refused.
        const std::string refuse = "CREATE TRIGGER halt BEFORE INSERT ON evaluation ";
        const std::string number = std::to_string(most);
        const auto raw = rawConnection(to);
        if (isDatabase(to))
            raw->run(
                "CREATE OR REPLACE FUNCTION halt() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN IF new.sequence = " +
                number + " THEN RAISE EXCEPTION 'halt'; END IF; RETURN new; END $$; " + refuse +
                "FOR EACH ROW EXECUTE FUNCTION halt()");
        else
            raw->run(refuse + "WHEN new.sequence = " + number + " BEGIN SELECT RAISE(ABORT, 'halt'); END");
        stopped += codeOf([&] { push(from, to); }) == "archive_not_written" ? 1 : 0;
        raw->run(isDatabase(to) ? "DROP TRIGGER halt ON evaluation" : "DROP TRIGGER halt");
        EXPECT_FALSE(Archive::open(to, Access::Read).verify().broken);
    }
    EXPECT_EQ(stopped, 3);
    Archive target = Archive::open(to, Access::Write);
    const Pushed last = source.push(target);
    EXPECT_EQ(last.pushed + last.already_there, 230);
    EXPECT_GT(last.already_there, 0);
    EXPECT_EQ(linesOf(source, false), linesOf(target, false));
}

TEST_P(PushTo, a_copy_that_was_continued_in_two_places_is_refused)
{
    const std::string from = file("file"), copy = file("copy");
    Archive::open(from, Access::Create).add(partEvaluations(0, 5), inspector);
    std::filesystem::copy_file(from, copy);
    Archive::open(from, Access::Write).add(partEvaluations(5, 8), inspector);
    Archive::open(copy, Access::Write).add(partEvaluations(20, 22), inspector);
    const std::string to = archiveOf(0);
    EXPECT_EQ(push(from, to).pushed, 8);
    try {
        push(copy, to);
        FAIL() << "it was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::chainForked);
        EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "sequence")), 6);
    }
    EXPECT_EQ(Archive::open(to, Access::Read).list().size(), 8u);
}

TEST_P(PushTo, a_copy_that_is_only_older_has_nothing_to_give)
{
    const std::string from = file("file"), copy = file("copy");
    Archive::open(from, Access::Create).add(partEvaluations(0, 5), inspector);
    std::filesystem::copy_file(from, copy);
    Archive::open(from, Access::Write).add(partEvaluations(5, 8), inspector);
    const std::string to = archiveOf(0);
    push(from, to);
    EXPECT_EQ(push(copy, to).pushed, 0);
}

TEST_P(PushTo, what_is_broken_is_not_passed_on)
{
    const std::string from = file("file");
    Archive::open(from, Access::Create).add(partEvaluations(0, 5), inspector);
    alter(from, "UPDATE evaluation SET person = 'x' WHERE sequence = 3");
    const std::string to = archiveOf(0);
    EXPECT_EQ(codeOf([&] { push(from, to); }), "chain_broken");
    EXPECT_TRUE(Archive::open(to, Access::Read).list().empty());
}

INSTANTIATE_TEST_SUITE_P(Databases, PushTo, ::testing::Values(Backend::Sqlite, Backend::Postgres), backendName);

}  // namespace
}  // namespace lathelier::archive
