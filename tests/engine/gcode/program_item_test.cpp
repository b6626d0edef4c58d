// A program as an item: round trip, and invalid values.
#include "engine/gcode/program_item.h"

#include <gtest/gtest.h>

namespace lathelier::gcode {
namespace {

TEST(ProgramItem, ComesBackAsItWas)
{
    ProgramItem program;
    program.text = "G0 X1\nM30\n";
    program.clamping = 2;
    program.z_zero_mm = 1.5;
    program.stock = Shaft{"bar", {{100, 40, 40, 0, {}, ""}}, std::nullopt};
    EXPECT_EQ(programOf(toValues(program)), program);
    program.stock.reset();
    program.corrected_from = std::string(64, 'a');
    program.correction.z_mm = {0, 1, 2.5};
    program.correction.radius_mm = {0, -0.01, 0.02};
    EXPECT_EQ(programOf(toValues(program)), program);
}

TEST(ProgramItem, WholeNumbersOfAProjectFileAreNumbers)
{
    ProgramItem program;
    program.text = "M30\n";
    program.z_zero_mm = 1;
    program.corrected_from = std::string(64, 'a');
    Values values = toValues(program);
    set(values, "z_zero_mm", std::int64_t{1});
    set(values, "correction_z_mm", std::vector<std::int64_t>{0, 10});
    set(values, "correction_radius_mm", std::vector<std::int64_t>{0, 0});
    program.correction.z_mm = {0, 10};
    program.correction.radius_mm = {0, 0};
    EXPECT_EQ(programOf(values), program);
}

TEST(ProgramItem, OtherValuesAreNone)
{
    EXPECT_FALSE(programOf({}));
    ProgramItem program;
    program.text = "M30\n";
    program.corrected_from = std::string(64, 'a');
    Values values = toValues(program);
    set(values, "correction_z_mm", std::vector<double>{1, 0});
    set(values, "correction_radius_mm", std::vector<double>{0, 0});
    EXPECT_FALSE(programOf(values));  // places do not ascend
    set(values, "correction_z_mm", std::vector<double>{0});
    EXPECT_FALSE(programOf(values));  // not as many
}

}  // namespace
}  // namespace lathelier::gcode
