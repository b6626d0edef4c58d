// What an archive takes and gives, on both databases.
#include "engine/archive/archive.h"

#include <thread>

#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::archive {
namespace {

TEST_P(EitherArchive, gives_back_what_was_added)
{
    const std::string location = newLocation();
    Archive archive = Archive::open(location, Access::Create);
    EXPECT_TRUE(archive.notes().empty());
    const Added added = archive.add(partEvaluations(0, 5), inspector, partRecipes());
    EXPECT_EQ(added.added, 5);
    EXPECT_EQ(added.already_there, 0);
    ASSERT_EQ(added.uuids.size(), 5u);
    Archive again = Archive::open(location, Access::Read);
    const Record record = again.show(added.uuids[3]);
    EXPECT_EQ(toJson(record.evaluation), toJson(partEvaluation(3)));
    EXPECT_EQ(record.entry.attestation.person, "A. Nowak");
    EXPECT_EQ(record.entry.attestation.instrument, "scanner 7");
    EXPECT_EQ(record.entry.attestation.calibrated_on, "2026-03-01");
    EXPECT_EQ(record.entry.sequence, 4);
    EXPECT_EQ(record.entry.file, "part_3.ply");
    EXPECT_EQ(record.entry.recorded_at.size(), 24u);
    EXPECT_EQ(record.recipe, partRecipes().front().content);
    EXPECT_EQ(record.previous_hash, again.show(added.uuids[2]).entry.hash);
}

TEST_P(EitherArchive, skips_what_is_there_already)
{
    const std::string location = archiveOf(3);
    Archive archive = Archive::open(location, Access::Write);
    std::vector<Evaluation> more = partEvaluations(1, 5);
    more.push_back(partEvaluation(4));  // twice in one call
    const Added added = archive.add(more, inspector);
    EXPECT_EQ(added.added, 2);
    EXPECT_EQ(added.already_there, 3);
    EXPECT_EQ(archive.list().size(), 5u);
}

TEST_P(EitherArchive, lists_the_latest_first_and_by_filter)
{
    Archive archive = Archive::open(archiveOf(7), Access::Read);
    const std::vector<Entry> all = archive.list();
    ASSERT_EQ(all.size(), 7u);
    EXPECT_EQ(all.front().file, "part_6.ply");
    EXPECT_EQ(all.back().file, "part_0.ply");
    Filter filter;
    filter.verdict = Verdict::Fail;
    EXPECT_EQ(archive.list(filter).size(), 3u);
    filter.most = 1;
    ASSERT_EQ(archive.list(filter).size(), 1u);
    EXPECT_EQ(archive.list(filter).front().file, "part_6.ply");
    EXPECT_TRUE(archive.list({.task = "roundness"}).empty());
    EXPECT_EQ(archive.list({.characteristic = "rmse_mm"}).size(), 7u);
    EXPECT_TRUE(archive.list({.characteristic = "nothing_mm"}).empty());
    EXPECT_TRUE(archive.list({.recipe_sha256 = "b"}).empty());
    const std::string today = all.front().recorded_at.substr(0, 10);
    EXPECT_FALSE(archive.list({.from = today, .to = today}).empty());
    EXPECT_TRUE(archive.list({.from = "2200-01-01"}).empty());
    EXPECT_TRUE(archive.list({.to = "2000-01-01"}).empty());
    EXPECT_EQ(codeOf([&] { archive.list({.to = "2026-02-30"}); }), "value_not_understood");
}

TEST_P(EitherArchive, gives_the_series_of_a_characteristic)
{
    Archive archive = Archive::open(archiveOf(7), Access::Read);
    const std::vector<SeriesPoint> points = archive.series("zones.seat.mean_mm");
    ASSERT_EQ(points.size(), 7u);
    EXPECT_EQ(points.front().file, "part_0.ply");
    EXPECT_EQ(points[5].value, 0.005);
    EXPECT_EQ(points[5].expanded_uncertainty, 0.002);
    EXPECT_EQ(points[5].lower_limit, -0.05);
    EXPECT_EQ(points[5].upper_limit, 0.05);
    EXPECT_EQ(points[3].verdict, Verdict::Fail);
    EXPECT_EQ(points[5].uuid, archive.list()[1].uuid);
    const std::vector<SeriesPoint> last = archive.series("zones.seat.mean_mm", {.most = 2});
    ASSERT_EQ(last.size(), 2u);
    EXPECT_EQ(last.front().file, "part_5.ply");
    EXPECT_EQ(archive.series("rmse_mm", {.recipe_sha256 = std::string(64, 'a')}).size(), 7u);
    EXPECT_TRUE(archive.series("rmse_mm", {.recipe_sha256 = "b"}).empty());
    EXPECT_EQ(archive.series("answer", {.verdict = Verdict::Fail}).size(), 3u);
    EXPECT_EQ(codeOf([&] { archive.series("nothing_mm"); }), "characteristic_not_found");
}

TEST_P(EitherArchive, knows_its_characteristics)
{
    Archive archive = Archive::open(archiveOf(2), Access::Write);
    Evaluation other = partEvaluation(9);
    other.task = "roundness";
    archive.add({other}, {});
    const std::vector<ArchivedCharacteristic> found = archive.characteristics();
    ASSERT_EQ(found.size(), 6u);
    EXPECT_EQ(found.front().task, "compare");
    EXPECT_EQ(found.front().key, "answer");
    EXPECT_EQ(found.front().unit, "mm");
    EXPECT_FALSE(found.front().last_recorded_at.empty());
    EXPECT_EQ(archive.characteristics({.task = "roundness"}).size(), 3u);
    EXPECT_EQ(codeOf([&] { archive.series("answer"); }), "characteristic_ambiguous");
    EXPECT_EQ(archive.series("answer", {.task = "roundness"}).size(), 1u);
}

TEST_P(EitherArchive, a_superseded_row_stays_and_leaves_the_series)
{
    Archive archive = Archive::open(archiveOf(3), Access::Write);
    const std::string old = archive.list().back().uuid;
    Evaluation better = partEvaluation(0, 0.5);
    const std::string uuid = archive.supersede(old, better, "wrong scale", inspector);
    EXPECT_EQ(archive.show(old).entry.superseded_by, uuid);
    EXPECT_EQ(archive.show(uuid).entry.supersedes, old);
    EXPECT_EQ(archive.show(uuid).entry.reason, "wrong scale");
    EXPECT_EQ(archive.list().size(), 4u);
    const std::vector<SeriesPoint> points = archive.series("rmse_mm");
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points.back().value, 0.5);
    EXPECT_EQ(codeOf([&] { archive.supersede(old, better, "again", inspector); }), "already_superseded");
    EXPECT_EQ(codeOf([&] { archive.supersede(uuid, better, "", inspector); }), "reason_missing");
    EXPECT_EQ(archive.add({better}, {}).already_there, 1);
    EXPECT_FALSE(archive.verify().broken);
}

TEST_P(EitherArchive, finds_a_row_by_the_unique_beginning_of_its_uuid)
{
    Archive archive = Archive::open(archiveOf(20), Access::Read);
    const std::string uuid = archive.list().front().uuid;
    EXPECT_EQ(archive.show(uuid.substr(0, 13)).entry.uuid, uuid);
    EXPECT_EQ(codeOf([&] { archive.show(uuid.substr(0, 3)); }), "evaluation_ambiguous");
    EXPECT_EQ(codeOf([&] { archive.show("zzzzzz"); }), "evaluation_not_found");
}

TEST_P(EitherArchive, canonical_export_does_not_depend_on_how_it_came_about)
{
    Archive one = Archive::open(archiveOf(6), Access::Write);
    Archive other = Archive::open(newLocation(), Access::Create);
    for (int number = 5; number >= 0; --number) {
        Evaluation made = partEvaluation(number);
        for (std::string* text : {&made.inputs.front().file.path, &made.result})
            for (std::size_t at = text->find("/parts/"); at != std::string::npos; at = text->find("/parts/", at + 1))
                text->replace(at, 7, "/elsewhere/");
        if (number == 2) {
            const std::string wrong = other.add({partEvaluation(2, 3)}, {}).uuids.front();
            other.supersede(wrong, made, "wrong", {});
        }
        other.add({made}, {"B. Other", "", ""});
    }
    EXPECT_EQ(linesOf(one, true), linesOf(other, true));
    EXPECT_NE(linesOf(one, false), linesOf(other, false));
    const std::string lines = linesOf(one, true);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 6);
    for (const char* absent : {"uuid", "recorded_at", "Nowak", "hash", "writer", "/parts/"})
        EXPECT_EQ(lines.find(absent), std::string::npos) << absent;
}

TEST_P(EitherArchive, refuses_a_recipe_that_changed_and_text_that_is_none)
{
    Archive archive = Archive::open(archiveOf(1), Access::Write);
    EXPECT_EQ(codeOf([&] {
                  archive.add(partEvaluations(1, 2), {}, {{std::string(64, 'a'), "{}"}});
              }),
              "recipe_contradicts");
    EXPECT_EQ(codeOf([&] { archive.add(partEvaluations(1, 2), {"\xFF", "", ""}); }), "text_not_storable");
    EXPECT_EQ(codeOf([&] { archive.add(partEvaluations(1, 2), {"", "", "yesterday"}); }), "value_not_understood");
    Evaluation odd = partEvaluation(1);
    odd.inputs.front().file.path = "/parts/\xFE.ply";
    EXPECT_EQ(codeOf([&] { archive.add({odd}, {}); }), "text_not_storable");
    odd = partEvaluation(1);
    odd.result = "{";
    EXPECT_EQ(codeOf([&] { archive.add({odd}, {}); }), "text_not_storable");
    odd = partEvaluation(1);
    odd.task = std::string("a\0b", 3);
    EXPECT_EQ(codeOf([&] { archive.add({odd}, {}); }), "text_not_storable");
    EXPECT_EQ(archive.list().size(), 1u);
}

TEST_P(EitherArchive, a_stopped_call_has_added_nothing)
{
    Archive archive = Archive::open(archiveOf(1), Access::Write);
    std::stop_source stop;
    int reports = 0;
    const Progress progress(stop.get_token(), [&](double, Text) {
        if (++reports == 5) stop.request_stop();
    });
    EXPECT_THROW(archive.add(partEvaluations(1, 50), {}, {}, progress), Cancelled);
    EXPECT_EQ(archive.list().size(), 1u);
    EXPECT_EQ(archive.add(partEvaluations(1, 50), {}).added, 49);
}

TEST_P(EitherArchive, two_writers_at_once_share_one_chain)
{
    const std::string location = archiveOf(0);
    const auto write = [&](int from) {
        Archive archive = Archive::open(location, Access::Write);
        for (int number = from; number < from + 40; number += 4) archive.add(partEvaluations(number, number + 4), {});
    };
    std::thread first(write, 0), second(write, 20);
    first.join();
    second.join();
    Archive archive = Archive::open(location, Access::Read);
    const Verification made = archive.verify();
    EXPECT_FALSE(made.broken);
    EXPECT_EQ(made.checked(), 60);
    EXPECT_EQ(made.chains.size(), 1u);
}

TEST_P(EitherArchive, rows_cannot_be_altered_or_removed)
{
    const std::string location = archiveOf(2);
    for (const char* statement :
         {"UPDATE evaluation SET person = 'x'", "DELETE FROM evaluation", "UPDATE measured SET value = 0",
          "DELETE FROM measured", "UPDATE recipe SET content = '{}'", "DELETE FROM recipe",
          "UPDATE characteristic SET unit = 'm'", "DELETE FROM characteristic"}) {
        SCOPED_TRACE(statement);
        EXPECT_EQ(codeOf([&] { rawConnection(location)->run(statement); }), "archive_not_read");
    }
    EXPECT_FALSE(Archive::open(location, Access::Read).verify().broken);
}

TEST_P(EitherArchive, is_made_once_and_opened_for_reading_it_takes_nothing)
{
    const std::string location = archiveOf(1);
    EXPECT_EQ(codeOf([&] { Archive::open(location, Access::Create); }), "archive_exists");
    Archive archive = Archive::open(location, Access::Read);
    EXPECT_EQ(codeOf([&] { archive.add(partEvaluations(1, 2), {}); }), "archive_not_written");
    EXPECT_EQ(archive.list().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Databases, EitherArchive, ::testing::Values(Backend::Sqlite, Backend::Postgres), backendName);

}  // namespace
}  // namespace lathelier::archive
