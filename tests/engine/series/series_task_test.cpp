#include "engine/series/series_task.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/archive/archive_kind.h"
#include "engine/series/series_codes.h"
#include "engine/series/series_report.h"
#include "engine/task/reply.h"
#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::series {
namespace {

using archive::Access;
using archive::Archive;

class SeriesTask : public ::testing::Test {
protected:
    /// Parts whose result has a map; every third is out of tolerance.
    void fill(int count)
    {
        Archive archive = Archive::open(location_, Access::Create);
        std::vector<archive::Evaluation> all = archive::partEvaluations(0, count);
        for (archive::Evaluation& one : all) {
            Json result = Json::parse(one.result);
            result["map"] = {{"z_start_mm", 0},
                             {"z_step_mm", 2},
                             {"z_count", 2},
                             {"angle_count", 2},
                             {"mean_mm", {0.01, 0.02, 0.03, -0.04}}};
            one.result = result.dump();
        }
        archive.add(all, archive::inspector, archive::partRecipes());
    }

    task::Reply ask(const Values& parameters) const
    {
        return task::reply(seriesTask(), {{location_}, parameters, {}, true, {}}, {});
    }

    static std::string errorOf(const std::vector<std::string>& operands, const Values& parameters = {})
    {
        const task::Reply reply = task::reply(seriesTask(), {operands, parameters, {}, true, {}}, {});
        return reply.errors.empty() ? std::string() : reply.errors.front().code().key;
    }

    ScratchFolder scratch_;
    std::string location_ = scratch_ / "shop.archive";
};

const SeriesOutcome& outcomeIn(const task::Reply& reply)
{
    return *std::static_pointer_cast<const SeriesOutcome>(reply.outcome.result);
}

TEST_F(SeriesTask, shows_the_values_as_they_were_archived)
{
    fill(40);
    const task::Reply reply = ask({{"characteristic", "zones.seat.mean_mm"}});
    ASSERT_TRUE(reply.errors.empty());
    const Json json = task::resultOf(seriesTask(), reply);
    EXPECT_EQ(json["task"], "compare");
    EXPECT_EQ(json["unit"], "mm");
    EXPECT_EQ(json["verdict"], "fail");
    EXPECT_EQ(json["count"], 40);
    EXPECT_EQ(json["out_of_tolerance"], 14);
    EXPECT_EQ(json["points"].size(), 40U);
    EXPECT_EQ(json["points"][7]["value"], 0.007);
    EXPECT_EQ(json["points"][7]["expanded_uncertainty"], 0.002);
    EXPECT_EQ(json["points"][7]["upper_limit"], 0.05);
    EXPECT_EQ(json["points"][7]["file"], "part_7.ply");
    EXPECT_NEAR(json["drift_per_100_parts"].get<double>(), 0.1, 1e-9);
    const SeriesOutcome& outcome = outcomeIn(reply);
    EXPECT_EQ(outcome.pictures.size(), mostPictures);
    EXPECT_EQ(outcome.pictures.back().file, "part_39.ply");
    EXPECT_EQ(outcome.worst, 39U);
    EXPECT_EQ(outcome.shown, 39U);
    EXPECT_EQ(outcome.part.entry.attestation.person, archive::inspector.person);
}

TEST_F(SeriesTask, begins_with_the_answer_of_the_latest_task)
{
    fill(3);
    const task::Reply reply = ask({});
    ASSERT_TRUE(reply.errors.empty());
    EXPECT_EQ(outcomeIn(reply).chosen.key, "answer");
    const report::Answer shown = answer(outcomeIn(reply));
    EXPECT_EQ(shown.verdict, Verdict::Fail);
    EXPECT_EQ(shown.upper_limit, 0.05);
    EXPECT_TRUE(reply.outcome.report({}).sections.size() > 1);
}

TEST_F(SeriesTask, value_and_verdict_are_those_of_one_part)
{
    fill(10);
    const SeriesOutcome outcome = outcomeIn(ask({{"characteristic", "zones.seat.mean_mm"}}));
    const report::Answer shown = answer(outcome);
    EXPECT_EQ(shown.value, outcome.points[outcome.worst].value);
    EXPECT_EQ(shown.expanded_uncertainty, outcome.points[outcome.worst].expanded_uncertainty);
    EXPECT_EQ(shown.verdict, outcome.points[outcome.worst].verdict);
    ASSERT_FALSE(shown.findings.empty());
    EXPECT_EQ(shown.findings.front().place.line, 10);
}

TEST_F(SeriesTask, the_latest_so_many_are_taken_and_it_is_said)
{
    fill(12);
    const task::Reply reply = ask({{"most", std::int64_t{5}}});
    EXPECT_EQ(outcomeIn(reply).points.size(), 5U);
    EXPECT_EQ(outcomeIn(reply).points.front().file, "part_7.ply");
    EXPECT_TRUE(contains(reply.notes, notes::seriesShortened));
}

TEST_F(SeriesTask, what_is_not_there_is_said)
{
    EXPECT_EQ(errorOf({}), "one_needed");
    EXPECT_EQ(errorOf({location_}, {{databaseKey, std::string("service=shop")}}), "one_only");
    EXPECT_EQ(errorOf({}, {{databaseKey, std::string("postgresql://a:secret@h/b")}}), "password_in_location");
    EXPECT_EQ(errorOf({location_}), "file_not_found");
    Archive::open(location_, Access::Create);
    EXPECT_EQ(errorOf({location_}), "archive_empty");
    const std::string text = scratch_ / "no.archive";
    std::ofstream(text) << "nothing of the kind";
    EXPECT_EQ(errorOf({text}), "no_archive");
}

TEST_F(SeriesTask, unknown_characteristic_is_named)
{
    fill(2);
    const task::Reply reply = ask({{"characteristic", "nothing_mm"}});
    ASSERT_FALSE(reply.errors.empty());
    EXPECT_EQ(reply.errors.front().code(), errors::seriesEmpty);
    EXPECT_EQ(*lathelier::find(reply.errors.front().values(), "characteristic"), Value(std::string("nothing_mm")));
}

TEST_F(SeriesTask, file_of_an_archive_is_known_by_its_head)
{
    fill(2);
    EXPECT_EQ(io::findKind({&archive::archiveFiles()}, location_).likeness, io::Likeness::Certain);
    const std::string text = scratch_ / "no.archive";
    std::ofstream(text) << "SQLite format 3";
    EXPECT_EQ(io::findKind({&archive::archiveFiles()}, text).kind, nullptr);
}

archive::Record recordOf(const std::string& copy, const std::string& reference)
{
    const std::string copy_sha256 = io::fileSha256(copy), reference_sha256 = io::fileSha256(reference);
    archive::Record record;
    record.evaluation.task = "compare";
    record.evaluation.inputs = {{"copy", {copy, 3, copy_sha256}}};
    record.evaluation.result = Json{{"inputs", {{{"path", reference}, {"sha256", reference_sha256}}}}}.dump();
    record.recipe = Json{{"inputs", {{"reference", {{"sha256", reference_sha256}, {"reading", {{"unit", "mm"}}}}}}},
                         {"reading", {{"unit", "inch"}}},
                         {"parameters", {{"tolerance_mm", 0.1}}}}
                        .dump();
    return record;
}

TEST(ArchivedState, is_what_was_asked_with_the_files_of_then)
{
    const ScratchFolder scratch;
    const std::string copy = scratch / "copy.ply", reference = scratch / "original.ply";
    std::ofstream(copy) << "abc";
    std::ofstream(reference) << "def";
    const archive::Record record = recordOf(copy, reference);
    const ArchivedState made = archivedState(record);
    EXPECT_TRUE(made.isWhole());
    EXPECT_EQ(made.state.inputs.at("copy").path, copy);
    EXPECT_EQ(made.state.inputs.at("copy").import, (Values{{"unit", std::string("inch")}}));
    EXPECT_EQ(made.state.inputs.at("reference").path, reference);
    EXPECT_EQ(made.state.inputs.at("reference").import, (Values{{"unit", std::string("mm")}}));
    EXPECT_EQ(made.state.parameters, (Values{{"tolerance_mm", 0.1}}));

    std::ofstream(copy) << "abd";
    EXPECT_FALSE(archivedState(record).isWhole());
    EXPECT_EQ(archivedState(record).files.front().state, FileState::Changed);
    std::filesystem::remove(copy);
    EXPECT_EQ(archivedState(record).files.front().state, FileState::Missing);
}

TEST(ArchivedState, record_without_a_recipe_has_no_question)
{
    archive::Record record;
    record.evaluation.result = "null";
    EXPECT_FALSE(archivedState(record).isWhole());
    record.recipe = "[1, 2]";
    record.evaluation.result = "{\"inputs\": 3}";
    EXPECT_TRUE(archivedState(record).files.empty());
}

}  // namespace
}  // namespace lathelier::series
