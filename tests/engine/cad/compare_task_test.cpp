// The task compare without a window: what is computed once, what a refusal notes, zones from a file, further copies.
#include "engine/cad/task/compare_task.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/cad/task/compare_copies.h"
#include "engine/core/core_codes.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/shaft/shaft_file.h"
#include "tests/scratch_folder.h"

namespace lathelier::cad {
namespace {

/// Two cylinders with a shoulder, as points; `excess_mm` on the radius of the second.
std::string pointsOf(double excess_mm, double scale = 1)
{
    std::string text;
    const auto add = [&](double radius_mm, double z_mm, int k) {
        const double angle = k * std::numbers::pi / 60 + 0.3 * z_mm;
        for (const double x : {radius_mm * std::cos(angle), radius_mm * std::sin(angle), z_mm})
            text += std::to_string(x * scale) + ' ';
        text += '\n';
    };
    for (int k = 0; k < 120; ++k) {
        for (int i = 0; i <= 100; ++i) add(15, 0.4 * i, k);
        for (int i = 1; i <= 100; ++i) add(20 + excess_mm, 40 + 0.3 * i, k);
        for (int i = 1; i < 12; ++i) add(15 + i * 5.0 / 12, 40, k);
    }
    return text;
}

class CompareTask : public ::testing::Test {
protected:
    CompareTask()
    {
        io::writeFile((folder_ / "original.xyz").string(), pointsOf(0));
        io::writeFile((folder_ / "copy.xyz").string(), pointsOf(0.05));
        state_.inputs[referenceRole].path = (folder_ / "original.xyz").string();
        state_.inputs[copyRole].path = (folder_ / "copy.xyz").string();
    }
    CompareOutcome answer()
    {
        task::Sources sources;
        return answerCompare(state_, registration::CompareDetail::Full, stores_, sources, {});
    }
    ScratchFolder folder_;
    project::PanelState state_;
    Stores stores_;
};

TEST_F(CompareTask, AnotherToleranceAlignsNothingAnew)
{
    CompareOutcome before = answer();
    EXPECT_FALSE(before.result->verdict);
    set(state_.parameters, "tolerance_mm", 0.2);
    CompareOutcome after = answer();
    EXPECT_EQ(after.result->windows, before.result->windows);  // the same object
    ASSERT_TRUE(after.result->verdict);
    Stores fresh;
    task::Sources sources;
    const CompareOutcome anew = answerCompare(state_, registration::CompareDetail::Full, fresh, sources, {});
    EXPECT_NE(anew.result->windows, before.result->windows);
    const auto json = [](const CompareOutcome& outcome) {
        return outcomeOf(std::make_shared<const CompareOutcome>(outcome)).json().dump();
    };
    EXPECT_EQ(json(after), json(anew));
    addViews(before, stores_, {});
    addViews(after, stores_, {});
    EXPECT_EQ(after.form.local_mean_mm, before.form.local_mean_mm);
    set(state_.parameters, "max_distance_mm", 2.0);
    EXPECT_NE(answer().result->windows, before.result->windows);
}

TEST_F(CompareTask, AFileOfZonesRulesOverTheTable)
{
    io::writeFile((folder_ / "zones.json").string(), R"([{"name": "second", "z_start_mm": 42, "z_end_mm": 68,
                                                          "lower_mm": -0.01, "upper_mm": 0.01}])");
    CompareQuestion question;
    question.compare.zones = {{"first", 1, 39, -1, 1}};
    state_.parameters = toValues(question);
    EXPECT_EQ(answer().result->zones.front().name, "first");
    state_.inputs[zonesRole].path = (folder_ / "zones.json").string();
    const CompareOutcome outcome = answer();
    ASSERT_EQ(outcome.result->zones.size(), 1u);
    EXPECT_EQ(outcome.result->zones.front().name, "second");
    EXPECT_EQ(outcome.result->verdict, Verdict::Fail);
    EXPECT_EQ(outcome.sources.inputs.front().path, state_.inputs[zonesRole].path);
}

TEST_F(CompareTask, ARefusalNamesTheFileAndNotesUnits)
{
    task::Sources sources;
    const auto refusal = [&]() -> std::optional<Error> {
        try {
            answerCompare(state_, registration::CompareDetail::Summary, stores_, sources, {});
            return std::nullopt;
        } catch (const Error& error) {
            return error;
        }
    };
    io::writeFile((folder_ / "inch.xyz").string(), pointsOf(0, 1 / 25.4));
    state_.inputs[copyRole].path = (folder_ / "inch.xyz").string();
    set(state_.inputs[copyRole].import, "unit", std::string("mm"));
    ASSERT_TRUE(refusal());
    EXPECT_TRUE(contains(sources.notes, notes::unitsMayDiffer));
    set(state_.parameters, copyUnitKey, std::string("inch"));
    EXPECT_LT(answer().result->statistics.rmse_mm, 0.01);

    io::writeFile((folder_ / "few.xyz").string(), "1 2 3\n4 5 6\n7 8 10\n1 1 1\n");
    state_.inputs[copyRole].path = (folder_ / "few.xyz").string();
    const std::optional<Error> too_few = refusal();
    ASSERT_TRUE(too_few);
    const Value* const path = find(too_few->values(), "path");
    ASSERT_TRUE(path);
    EXPECT_EQ(*path, Value(state_.inputs[copyRole].path));
}

TEST_F(CompareTask, UnitsOfTheFilesAreStatedAsTheCommandLineHasThem)
{
    set(state_.inputs[referenceRole].import, "unit", std::string("mm"));
    set(state_.inputs[copyRole].import, "unit", std::string("mm"));
    EXPECT_EQ(withStatedUnits(state_).parameters, state_.parameters);
    set(state_.inputs[copyRole].import, "unit", std::string("inch"));
    const project::PanelState stated = withStatedUnits(state_);
    EXPECT_EQ(*find(stated.parameters, referenceUnitKey), Value(std::string("mm")));
    EXPECT_EQ(*find(stated.parameters, copyUnitKey), Value(std::string("inch")));
    const auto question = fromValues<CompareQuestion>(stated.parameters);
    EXPECT_EQ(withUnits(stated, question).inputs, state_.inputs);
}

TEST_F(CompareTask, ADrawingIsKnownByItsHeadAndAddsSizes)
{
    Shaft shaft;
    shaft.segments = {{40, 30, 30, 0, {}, ""}, {30, 40, 40, 0, {}, ""}};
    io::writeFile((folder_ / "drawing.json").string(), io::shaftText(shaft));
    state_.inputs[referenceRole].path = (folder_ / "drawing.json").string();
    EXPECT_TRUE(isDrawn(state_.inputs[referenceRole]));
    EXPECT_FALSE(isDrawn(state_.inputs[copyRole]));
    CompareOutcome outcome = answer();
    ASSERT_TRUE(outcome.reference.drawn && outcome.sizes);
    EXPECT_FALSE(outcome.original);
    addViews(outcome, stores_, {});
    ASSERT_TRUE(outcome.original);
    EXPECT_TRUE(outcome.original->file.scan.isMesh());
    EXPECT_TRUE(outcomeOf(std::make_shared<const CompareOutcome>(outcome)).json().contains("rows"));
}

TEST_F(CompareTask, FurtherCopiesAreJudgedByTheSameLimits)
{
    io::writeFile((folder_ / "broken.xyz").string(), "1 2 no number\n");
    state_.inputs[copiesRole].path = (folder_ / "original.xyz").string();
    state_.inputs[project::keyOf(copiesRole, 2)].path = (folder_ / "broken.xyz").string();
    set(state_.parameters, "tolerance_mm", 0.02);
    task::Sources sources;
    const task::Outcome outcome = compareTask().run(state_, {}, stores_, sources, {});
    const Json copies = outcome.json()["copies"];
    ASSERT_EQ(copies.size(), 3u);
    EXPECT_EQ(copies[0]["verdict"], "fail");
    EXPECT_EQ(copies[1]["verdict"], "pass");
    EXPECT_TRUE(copies[2].contains("error"));
    ASSERT_EQ(sources.inputs.size(), 3u);  // the broken one was not read
    EXPECT_EQ(sources.inputs.back().path, state_.inputs[copiesRole].path);
}

}  // namespace
}  // namespace lathelier::cad
