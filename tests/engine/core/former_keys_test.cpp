// Values that older files state under other keys.
#include <gtest/gtest.h>

#include "code_of_error.h"
#include "engine/core/core_codes.h"
#include "engine/core/tool.h"

namespace lathelier {
namespace {

struct Spindle {
    std::vector<Tool> tools;
    Tool mounted;
    friend bool operator==(const Spindle&, const Spindle&) = default;
};

const std::vector<Field<Spindle>>& fieldsOf(const Spindle*)
{
    static const auto all = described<Spindle>(rows("tools", &Spindle::tools, {0, 5}, {Text{"Tools"}, Text{"All"}}),
                                               group("mounted", &Spindle::mounted, {Text{"Mounted"}, Text{"Now"}}));
    return all;
}

TEST(FormerKeys, GiveTheSameTool)
{
    const Tool tool{.corner_radius_mm = 0.8, .entering_angle_deg = 95, .reach_mm = 18};
    EXPECT_EQ(fromValues<Tool>({{"nose_radius_mm", 0.8}, {"lead_angle_deg", std::int64_t{-5}}, {"max_depth_mm", 18.0}}),
              tool);
    EXPECT_EQ(fromValues<Tool>(toValues(tool)), tool);
    for (const auto& [key, value] : toValues(tool)) EXPECT_NE(key, "lead_angle_deg");
}

TEST(FormerKeys, CountWithinRowsAndGroups)
{
    const Values former{{"nose_radius_mm", 0.4}, {"lead_angle_deg", 15.0}};
    const Spindle made = fromValues<Spindle>(
        {{"tools", Rows{{Row{former}}}}, {"mounted.lead_angle_deg", -3.0}, {"mounted.number", std::int64_t{2}}});
    ASSERT_EQ(made.tools.size(), 1U);
    EXPECT_EQ(made.tools[0].corner_radius_mm, 0.4);
    EXPECT_EQ(made.tools[0].entering_angle_deg, 75);
    EXPECT_EQ(made.mounted.entering_angle_deg, 93);
    EXPECT_EQ(made.mounted.number, 2);
}

TEST(FormerKeys, StatedTwiceIsAnError)
{
    try {
        fromValues<Tool>({{"lead_angle_deg", -5.0}, {"entering_angle_deg", 95.0}});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::valueStatedTwice);
        EXPECT_EQ(*find(error.values(), "former"), Value(std::string("lead_angle_deg")));
        EXPECT_EQ(*find(error.values(), "key"), Value(std::string("entering_angle_deg")));
    }
    // "Not given" states nothing.
    EXPECT_EQ(fromValues<Tool>({{"lead_angle_deg", Value()}, {"entering_angle_deg", 95.0}}).entering_angle_deg, 95);
    EXPECT_EQ(fromValues<Tool>({{"lead_angle_deg", -5.0}, {"entering_angle_deg", Value()}}).entering_angle_deg, 95);
}

TEST(FormerKeys, HaveTheRangeOfTodays)
{
    EXPECT_EQ(codeOfError([] { fromValues<Tool>({{"lead_angle_deg", 89.5}}); }), errors::valueOutOfRange);
    EXPECT_EQ(fromValues<Tool>({{"lead_angle_deg", 89.0}}).entering_angle_deg, 1);
}

TEST(FormerKeys, ABlankOfOlderWritersIsNotStated)
{
    // They put the corner of a blade, 0, beside the nose of an insert.
    EXPECT_EQ(fromValues<Tool>({{"nose_radius_mm", 0.8}, {"corner_radius_mm", 0.0}}).corner_radius_mm, 0.8);
    EXPECT_FALSE(fromValues<Tool>({{"nose_radius_mm", Value()}, {"corner_radius_mm", 0.0}}).corner_radius_mm);
    EXPECT_EQ(fromValues<Tool>({{"nose_radius_mm", Value()}, {"corner_radius_mm", 0.2}}).corner_radius_mm, 0.2);
    EXPECT_EQ(fromValues<Tool>({{"corner_radius_mm", 0.0}}).corner_radius_mm, 0);
    EXPECT_EQ(codeOfError([] {
                  fromValues<Tool>({{"nose_radius_mm", 0.8}, {"corner_radius_mm", 0.4}});
              }),
              errors::valueStatedTwice);
}

TEST(Tool, AnInsertIsReadFromItsCode)
{
    const std::optional<Tool> insert = toolOfCode("DCMT 11T3 02");
    ASSERT_TRUE(insert);
    EXPECT_EQ(insert->tip_angle_deg, 55);
    EXPECT_EQ(insert->edge_length_mm, 11);
    EXPECT_EQ(insert->corner_radius_mm, 0.2);
    for (const char* code : {"", "CNMG", "CNMG 12", "XNMG 120408", "PCLNL 2525M12"})
        EXPECT_FALSE(toolOfCode(code)) << code;
}

}  // namespace
}  // namespace lathelier
