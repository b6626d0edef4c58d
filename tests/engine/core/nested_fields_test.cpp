// Parameters within parameters: groups, optional groups and lists of structs.
#include <gtest/gtest.h>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/shaft/shaft.h"

namespace lathelier {
namespace {

struct Support {
    double stiffness_N_mm = 1e5;
    bool rotates = false;
    friend bool operator==(const Support&, const Support&) = default;
};

struct Rod {
    double length_mm = 100;
    std::optional<double> diameter_mm;
    std::string material = "steel";
    friend bool operator==(const Rod&, const Rod&) = default;
};

struct MachineSetup {
    Support chuck;
    std::optional<Support> tailstock;
    std::vector<Rod> rods{{}};
    double speed_rpm = 1000;
    friend bool operator==(const MachineSetup&, const MachineSetup&) = default;
};

const std::vector<Field<Support>>& fieldsOf(const Support*)
{
    static const std::vector<Field<Support>> all{
        field("stiffness_N_mm", &Support::stiffness_N_mm, {0, 1e9}, {Text{"Stiffness"}, Text{"Radial"}, Text{"N/mm"}}),
        field("rotates", &Support::rotates, {Text{"Rotates"}, Text{"Does it?"}})};
    return all;
}

const std::vector<Field<Rod>>& fieldsOf(const Rod*)
{
    static const std::vector<Field<Rod>> all{
        field("length_mm", &Rod::length_mm, {1, 1000}, {Text{"Length"}, Text{"Whole"}, Text{"mm"}, false, true}),
        field("diameter_mm", &Rod::diameter_mm, {1, 500}, {Text{"Diameter"}, Text{"Outer"}, Text{"mm"}}),
        field("material", &Rod::material, {Text{"Material"}, Text{"Name"}})};
    return all;
}

const std::vector<Field<MachineSetup>>& fieldsOf(const MachineSetup*)
{
    static const auto all = described<MachineSetup>(
        group("chuck", &MachineSetup::chuck, {Text{"Chuck"}, Text{"At the spindle"}}),
        group("tailstock", &MachineSetup::tailstock, {Text{"Tailstock"}, Text{"At the free end"}}),
        rows("rods", &MachineSetup::rods, {1, 5}, {Text{"Rods"}, Text{"Measured"}}),
        field("speed_rpm", &MachineSetup::speed_rpm, {1, 1e5}, {Text{"Speed"}, Text{"Of the spindle"}, Text{"rpm"}}));
    return all;
}

TEST(NestedFields, KeysOfAGroupBeginWithItsOwn)
{
    std::vector<std::string> keys;
    for (const FieldInfo& info : infos<MachineSetup>()) keys.push_back(info.key);
    EXPECT_EQ(keys, (std::vector<std::string>{"chuck.stiffness_N_mm", "chuck.rotates", "tailstock",
                                              "tailstock.stiffness_N_mm", "tailstock.rotates", "rods", "speed_rpm"}));
    EXPECT_EQ(infos<MachineSetup>()[3].group_key, "tailstock");
    EXPECT_EQ(infos<MachineSetup>()[3].group, Text{"Tailstock"});
    EXPECT_EQ(infos<MachineSetup>()[5].columns.size(), 3U);
}

TEST(NestedFields, ValuesComeBackAsTheyWere)
{
    MachineSetup setup;
    setup.chuck.stiffness_N_mm = 5;
    setup.rods = {{20, 8.0, "brass"}, {30, {}, "steel"}};
    EXPECT_EQ(fromValues<MachineSetup>(toValues(setup)), setup);
    setup.tailstock = Support{7, true};
    EXPECT_EQ(fromValues<MachineSetup>(toValues(setup)), setup);
    EXPECT_EQ(fromValues<MachineSetup>(toValues(MachineSetup{}), setup), MachineSetup{});
}

TEST(NestedFields, AValueOfAGroupBringsItUnlessItIsSaidToBeAbsent)
{
    const MachineSetup given = fromValues<MachineSetup>({{"tailstock.stiffness_N_mm", 9.0}});
    ASSERT_TRUE(given.tailstock);
    EXPECT_EQ(given.tailstock->stiffness_N_mm, 9);
    EXPECT_FALSE(fromValues<MachineSetup>({{"tailstock", false}, {"tailstock.stiffness_N_mm", 9.0}}).tailstock);
}

TEST(NestedFields, ACellOutOfRangeIsNamedByRowAndColumn)
{
    const Rows rows{{Row{{{"length_mm", 10.0}}}, Row{{{"length_mm", 0.5}}}}};
    try {
        fromValues<MachineSetup>({{"rods", rows}});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::valueOutOfRange);
        EXPECT_EQ(*find(error.values(), "parameter"), Value("rods[2].length_mm"));
    }
    EXPECT_THROW(fromValues<MachineSetup>({{"rods", Rows{}}}), Error);  // at least one
    EXPECT_THROW(fromValues<MachineSetup>({{"rods", Rows{std::vector<Row>(6)}}}), Error);
    EXPECT_THROW(fromValues<MachineSetup>({{"rods", 3.0}}), Error);
}

TEST(NestedFields, RowsAreTypedCellByCell)
{
    const FieldInfo rods = infos<MachineSetup>()[5];
    const Rows expected{
        {Row{{{"length_mm", 20.0}, {"diameter_mm", 8.0}, {"material", "brass"}}}, Row{{{"length_mm", 30.0}}}}};
    EXPECT_EQ(parse(rods, "20,8,brass;30"), Value(expected));
    EXPECT_THROW(parse(rods, "20,8,brass,4"), Error);
    EXPECT_THROW(parse(rods, "x"), Error);
}

TEST(Shaft, IsDescribedLikeANumberIs)
{
    Shaft shaft;
    shaft.name = "spindle nose";
    shaft.segments = {{20, 30, 30, 10, {}, ""}, {50, 40, 35, 0, 12.5, "saddle"}};
    shaft.material = Material{"brass", 100000, 0.34, 8400, 0.003};
    EXPECT_EQ(fromValues<Shaft>(toValues(shaft)), shaft);
    EXPECT_DOUBLE_EQ(shaft.length_mm(), 70);
    shaft.material.reset();
    EXPECT_EQ(fromValues<Shaft>(toValues(shaft)), shaft);
}

}  // namespace
}  // namespace lathelier
