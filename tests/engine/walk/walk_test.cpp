// The walk from a scan to program and deflection, over six shapes of our own scanner; what must stop stops with its
// reason at the right place.
#include "engine/walk/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/cam/job_file.h"
#include "engine/cam/task/turn_task.h"
#include "engine/deflection/setup_item.h"
#include "engine/shaft/shaft_item.h"
#include "engine/shop/shop_codes.h"
#include "engine/shop/shop_job.h"
#include "engine/shop/shop_library.h"
#include "engine/walk/part_places.h"
#include "engine/walk/shop_supply.h"
#include "tests/engine/features/made_scan.h"
#include "tests/scratch_folder.h"

namespace lathelier::walk {
namespace {

using features::piece;

/// Six parts: stepped, with a cone, grooved, stub, slender, and one that is too long for the lathe.
sample::ShaftModel shapeNamed(const std::string& name)
{
    if (name == "stepped") return {piece(0, 20, 20, 20), piece(20, 50, 30, 30), piece(50, 90, 40, 40)};
    if (name == "cone") return {piece(0, 20, 24, 24), piece(20, 50, 24, 30), piece(50, 80, 36, 36)};
    if (name == "grooved")
        return {piece(0, 25, 25, 25), piece(25, 29, 22, 22), piece(29, 60, 32, 32), piece(60, 80, 45, 45)};
    if (name == "stub") return {piece(0, 12, 40, 40), piece(12, 30, 60, 60)};
    if (name == "slender") return {piece(0, 60, 16, 16), piece(60, 140, 20, 20), piece(140, 180, 24, 24)};
    return {piece(0, 400, 40, 40), piece(400, 1100, 50, 50)};  // "long"
}

class WalkTest : public testing::Test {
protected:
    std::string scanOf(const std::string& shape)
    {
        const std::string path = (folder_ / (shape + ".xyz")).string();
        std::ofstream file(path);
        file.precision(9);
        sample::ScannerModel scanner = features::askew(7, 0.01);
        if (shape == "long") scanner.row_pitch_mm = 0.25;
        for (const auto& point : sample::scanShaft(shapeNamed(shape), scanner).points_mm)
            file << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
        return path;
    }
    Walk walkOf(const project::Project& project, int generation = 0) const
    {
        return {project, partPlaces(), supplyOf({}), stores_, generation};
    }
    static project::Project withScan(const std::string& path)
    {
        project::Project project;
        project.panels["recognise"].inputs["scan"].path = path;
        return project;
    }

    ScratchFolder folder_;
    std::shared_ptr<Stores> stores_ = std::make_shared<Stores>();
};

TEST_F(WalkTest, NothingIsPromisedWithoutAPart)
{
    const Walk walk = walkOf({});
    for (const Place& place : walk.places()) {
        EXPECT_TRUE(walk.taken(place.id).empty()) << place.id;
        if (place.id == "spindle") continue;  // it answers stated springs
        EXPECT_FALSE(walk.canAnswer(place.id)) << place.id;
    }
}

TEST_F(WalkTest, PromisesNameTheQuestionOrTheShop)
{
    const Walk walk = walkOf(withScan(scanOf("stub")));
    EXPECT_EQ(walk.promised("drawing").inputs.at("shaft").item, "recognise:shaft");
    EXPECT_EQ(walk.promised("turning").inputs.at("shaft").item, "drawing:shaft");
    EXPECT_EQ(walk.promised("turning").inputs.at("job").item, "shop:job");
    EXPECT_EQ(walk.promised("deflection").inputs.at("program").item, "turning:program");
    EXPECT_EQ(walk.promised("lobes").inputs.at("spindle").item, "shop:spindle");
    EXPECT_FALSE(walk.canAnswer("compare"));  // no copy
    const std::vector<Taken> expected{{"shaft", walk.place("drawing")->title, false}, {"job", {}, true}};
    for (const Taken& taken : expected)
        EXPECT_NE(std::find(walk.taken("turning").begin(), walk.taken("turning").end(), taken),
                  walk.taken("turning").end());
}

class ShapesTest : public WalkTest, public testing::WithParamInterface<const char*> {};

TEST_P(ShapesTest, GoesFromTheScanToProgramAndDeflection)
{
    const Walk walk = walkOf(withScan(scanOf(GetParam())));
    const auto planned = walk.answer("turning", {});
    const auto& turned = *std::static_pointer_cast<const cam::TurnOutcome>(planned->value);
    EXPECT_FALSE(turned.plan->setups.empty());
    EXPECT_TRUE(planned->outcome.errors.empty());
    // The bar, the chuck, the tools and the material were assumed, and are listed.
    EXPECT_TRUE(contains(planned->outcome.notes, notes::ofShop));
    EXPECT_GE(planned->outcome.understanding.assumed.size(), 4U);
    const auto bent = walk.answer("deflection", {});
    EXPECT_TRUE(contains(bent->outcome.notes, notes::ofShop));
    ASSERT_TRUE(bent->outcome.json);
    EXPECT_GT(bent->outcome.json().size(), 0U);
    for (const char* id : {"drawing", "shaft", "lobes"}) EXPECT_NO_THROW((void)walk.answer(id, {})) << id;
}

INSTANTIATE_TEST_SUITE_P(Parts, ShapesTest, testing::Values("stepped", "cone", "grooved", "stub", "slender"));

/// The drawing stands; the lathe takes 1000 mm.
TEST_F(WalkTest, StopsWhereTheShopCannotTurnThePart)
{
    const Walk walk = walkOf(withScan(scanOf("long")));
    EXPECT_NO_THROW((void)walk.answer("drawing", {}));
    try {
        (void)walk.answer("turning", {});
        FAIL() << "turned";
    } catch (const Error& error) {
        EXPECT_STREQ(error.code().key, "part_larger_than_lathe");
    }
}

/// What is given in a place is not replaced, and what rests on it follows.
TEST_F(WalkTest, GivenInputsRuleAndLaterPlacesFollow)
{
    project::Project project = withScan(scanOf("stub"));
    const std::string before = walkOf(project).promised("deflection").items.at("program").origin.state_sha256;
    Shaft drawn;
    drawn.segments = {{30, 50, 50, 0, {}, ""}};
    project.items["mine"] = {shaftItem, toValues(drawn), {}};
    project.panels["drawing"].inputs["shaft"].item = "mine";
    const Walk walk = walkOf(project);
    EXPECT_EQ(walk.promised("drawing").inputs.at("shaft").item, "mine");
    EXPECT_NE(walk.promised("deflection").items.at("program").origin.state_sha256, before);
    const auto planned = walk.answer("turning", {});
    const auto& turned = *std::static_pointer_cast<const cam::TurnOutcome>(planned->value);
    EXPECT_NEAR(turned.plan->part.length_mm(), 30, 1e-9);
    EXPECT_NEAR(turned.plan->job.stock.diameter_mm, 52, 1e-9);  // the bar with 2 mm of allowance
}

/// A job that is given clamps the part for machine and deflection too, and a change of it is a change of theirs.
TEST_F(WalkTest, AGivenJobIsFollowed)
{
    project::Project project = withScan(scanOf("stub"));
    const std::string free_shaft = walkOf(project).promised("shaft").items.at("shaft").origin.state_sha256;
    const std::string free_setup = walkOf(project).promised("deflection").items.at("setup").origin.state_sha256;
    Shaft stub;
    stub.segments = {{12, 40, 40, 0, {}, ""}, {18, 60, 60, 0, {}, ""}};
    cam::Job job = shop::jobOf(shop::shopOf({}), stub);
    ASSERT_FALSE(job.setup.tailstock);
    job.stock.diameter_mm = 77;
    job.part_off = false;
    job.setup.tailstock.emplace();
    project.panels["turning"].inputs["job"].path = (folder_ / "job.json").string();
    std::ofstream(folder_ / "job.json") << cam::jobText(job);
    const Walk walk = walkOf(project);
    EXPECT_NE(walk.promised("shaft").items.at("shaft").origin.state_sha256, free_shaft);
    EXPECT_NE(walk.promised("deflection").items.at("setup").origin.state_sha256, free_setup);
    Notes notes;
    const auto held = shaftOf(walk.complete("shaft", notes, {}).items.at("shaft").values);
    ASSERT_TRUE(held);
    EXPECT_EQ(held->segments.back().end_diameter_mm, 77);
    const auto setup = deflection::setupOf(walk.complete("deflection", notes, {}).items.at("setup").values);
    ASSERT_TRUE(setup);
    EXPECT_TRUE(setup->setup.tailstock);
}

/// Equal questions are computed once; another generation of files is another question.
TEST_F(WalkTest, AnswersAreShared)
{
    const project::Project project = withScan(scanOf("stub"));
    const auto first = walkOf(project).answer("recognise", {});
    EXPECT_EQ(walkOf(project).answer("recognise", {}), first);
    EXPECT_NE(walkOf(project, 1).answer("recognise", {}), first);
}

TEST_F(WalkTest, AnErrorNamesTheQuestionItIsOf)
{
    const std::string path = (folder_ / "empty.xyz").string();
    std::ofstream(path) << "";
    const Walk walk = walkOf(withScan(path));
    try {
        (void)walk.answer("turning", {});
        FAIL() << "answered";
    } catch (const Error& error) {
        EXPECT_STREQ(error.code().key, "file_empty");
        EXPECT_EQ(*find(error.values(), "of_place"), Value(walk.place("recognise")->title));
    }
}

TEST_F(WalkTest, IsCancelled)
{
    std::stop_source stop;
    stop.request_stop();
    const Progress stopped(stop.get_token(), [](double, Text) {});
    const Walk walk = walkOf(withScan(scanOf("stub")));
    EXPECT_THROW((void)walk.answer("turning", stopped), Cancelled);
    EXPECT_NO_THROW((void)walk.answer("recognise", {}));
}

}  // namespace
}  // namespace lathelier::walk
