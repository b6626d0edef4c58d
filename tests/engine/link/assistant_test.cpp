#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "engine/link/link_codes.h"
#include "engine/link/program_bar.h"
#include "engine/stability/task/speed_entry.h"
#include "tests/engine/link/paper_case.h"

namespace lathelier::link {
namespace {

Reply answerTo(const ControlValues& values, const std::string& more = {})
{
    const LinkConfig config = readConfig(configText(more), ".");
    Assistant assistant = paperAssistant(config);
    return assistant.answer(values, std::nullopt, {});
}

ControlValues with(const char* name, double value)
{
    ControlValues values = paperValues();
    values[name] = value;
    return values;
}

std::string fileWith(const std::string& text)
{
    const std::string path = (std::filesystem::path(testing::TempDir()) / "bar.ngc").string();
    std::ofstream(path) << text;
    return path;
}

TEST(Assistant, answers_the_case_of_the_paper)
{
    const Reply reply = answerTo(paperValues());
    EXPECT_EQ(reply.state, State::Ok);
    EXPECT_NEAR(reply.selected_rpm.value(), paperSelected_rpm, 0.1);
    EXPECT_EQ(reply.n_cor_rpm.value(), paperCorrected_rpm);
}

TEST(Assistant, answers_2800_of_the_paper_with_the_same_speed)
{
    const Reply reply = answerTo(with(speedName, 2800 * M_PI * paperDiameter_mm / 1000));
    EXPECT_NEAR(reply.selected_rpm.value(), 2800, 1e-6);
    EXPECT_EQ(reply.n_cor_rpm.value(), paperCorrected_rpm);
}

TEST(Assistant, refuses_a_machine_that_runs_before_anything_else)
{
    ControlValues values = with(runningName, 1);
    values[speedName] = -4;
    EXPECT_EQ(answerTo(values).state, State::Running);
}

TEST(Assistant, refuses_what_is_out_of_range_and_gives_no_speed)
{
    for (const auto& [name, value] : {std::pair{diameterName, -32.0},
                                      {diameterName, 1e9},
                                      {speedName, 1e9},
                                      {speedName, -290.0},
                                      {depthName, -1.0},
                                      {lengthName, -1.0}}) {
        const Reply reply = answerTo(with(name, value));
        EXPECT_EQ(reply.state, State::OutOfRange) << name << value;
        EXPECT_FALSE(reply.n_cor_rpm);
    }
    ControlValues backwards = with(lowestName, 350);
    backwards[highestName] = 200;
    EXPECT_EQ(answerTo(backwards).state, State::OutOfRange);
}

TEST(Assistant, refuses_what_is_missing_or_no_number)
{
    EXPECT_EQ(answerTo(with(speedName, 0)).state, State::NotUnderstood);
    EXPECT_EQ(answerTo(with(diameterName, NAN)).state, State::NotUnderstood);
    EXPECT_EQ(answerTo(with(depthName, INFINITY)).state, State::NotUnderstood);
}

TEST(Assistant, needs_the_overhang_of_a_bar)
{
    const LinkConfig config = readConfig(barConfigText(R"("loop": {})"), ".");
    EXPECT_EQ(paperAssistant(config).answer(paperValues(), std::nullopt, {}).state, State::NotUnderstood);
}

TEST(Assistant, judges_by_the_depth_where_the_control_states_one)
{
    LinkConfig config = paperConfig(1);
    set(config.question.parameters, "cutting_coefficient_N_mm2", 600.0);
    EXPECT_EQ(paperAssistant(config).answer(paperValues(), std::nullopt, {}).n_cor_rpm, paperCorrected_rpm);
    const Reply deep = paperAssistant(config).answer(with(depthName, 1), std::nullopt, {});
    EXPECT_EQ(deep.state, State::Ok);
    EXPECT_NE(deep.n_cor_rpm, paperCorrected_rpm);
    set(config.question.parameters, depthName, 1.0);  // of the configuration: told
    const Reply assumed = paperAssistant(config).answer(paperValues(), std::nullopt, {});
    EXPECT_EQ(assumed.n_cor_rpm, deep.n_cor_rpm);
    ASSERT_FALSE(assumed.assumed.empty());
    EXPECT_EQ(assumed.assumed.back().what, depthName);
    EXPECT_EQ(assumed.assumed.back().value, "1");
}

TEST(Assistant, takes_no_value_of_the_operators_screen_from_the_configuration)
{
    LinkConfig config = paperConfig(1);
    stability::enterValue(config.question.parameters, highestName, 300.0);
    set(config.question.parameters, "speed_rpm", 1000.0);
    const Reply reply = paperAssistant(config).answer(paperValues(), std::nullopt, {});
    EXPECT_NEAR(reply.selected_rpm.value(), paperSelected_rpm, 0.1);
    EXPECT_EQ(reply.n_cor_rpm, paperCorrected_rpm);
}

TEST(Assistant, says_that_no_speed_of_the_range_is_stable)
{
    ControlValues values = with(lowestName, 287);
    values[highestName] = 292;
    const Reply reply = answerTo(values);
    EXPECT_EQ(reply.state, State::NoStableSpeed);
    EXPECT_FALSE(reply.n_cor_rpm);
}

TEST(Assistant, never_gives_a_speed_above_that_of_the_machine)
{
    const LinkConfig config = readConfig(configText(), ".");
    Limits limits = config.limits;
    limits.highest_rpm = paperCorrected_rpm;
    EXPECT_EQ(Assistant(config.question, limits).answer(paperValues(), {}, {}).state, State::Ok);
    limits.highest_rpm = paperCorrected_rpm - 1;
    const Reply reply = Assistant(config.question, limits).answer(paperValues(), {}, {});
    EXPECT_EQ(reply.state, State::AboveSpeedLimit);
    EXPECT_FALSE(reply.n_cor_rpm);
}

TEST(Assistant, keeps_the_limits_of_the_configuration)
{
    const LinkConfig config = readConfig(configText(), ".");
    Limits limits = config.limits;
    limits.highest_diameter_mm = paperDiameter_mm - 0.1;
    EXPECT_EQ(Assistant(config.question, limits).answer(paperValues(), {}, {}).state, State::OutOfRange);
}

TEST(Assistant, takes_diameter_and_length_of_the_program_where_the_control_states_none)
{
    const std::string path = fileWith("G18 G21 G90 G7\nG97 S1000 M3\nG0 X36 Z2\nG1 X32 Z2 F0.2\nG1 Z-60\nG1 X34\nM2\n");
    const LinkConfig config = readConfig(configText(R"("program": {"clearance_mm": 20})"), ".");
    Assistant assistant = paperAssistant(config);
    EXPECT_FALSE(assistant.needsProgram({{diameterName, 32}, {lengthName, 100}}));
    EXPECT_FALSE(assistant.needsProgram({{diameterName, 32}}));  // modes are stated: no bar is asked for
    const ControlValues values{{requestName, 1}, {speedName, paperSpeed_m_min}};
    ASSERT_TRUE(assistant.needsProgram(values));
    const Reply reply = assistant.answer(values, path, {});
    ASSERT_TRUE(reply.program);
    EXPECT_DOUBLE_EQ(reply.program->diameter_mm, 34);
    EXPECT_DOUBLE_EQ(reply.program->length_mm, 82);
    EXPECT_EQ(assistant.answer(values, std::nullopt, {}).state, State::ProgramNotUsable);
    EXPECT_EQ(assistant.answer(values, path + ".not", {}).state, State::ProgramNotUsable);
}

TEST(Assistant, takes_a_program_where_its_feed_moves_begin_too)
{
    const ProgramBar turned =
        barOfProgram(fileWith("G18 G21 G90 G7\nG97 S500 M3\nG0 X60 Z2\nG1 Z-50 F0.2\nM2\n"), {20}, {});
    EXPECT_DOUBLE_EQ(turned.diameter_mm, 60);
    EXPECT_DOUBLE_EQ(turned.length_mm, 72);
    const ProgramBar faced =
        barOfProgram(fileWith("G18 G21 G90 G7\nG97 S500 M3\nG0 X60 Z0\nG1 X10 F0.2\nM2\n"), {20}, {});
    EXPECT_DOUBLE_EQ(faced.diameter_mm, 60);
    EXPECT_DOUBLE_EQ(faced.length_mm, 20);
}

TEST(Assistant, takes_nothing_from_a_program_with_a_variable_that_it_does_not_set)
{
    const std::string head = "G18 G21 G90 G7\nG97 S500 M3\nG0 X60 Z2\n";
    for (const char* move : {"G1 Z[#100-50] F0.2", "G1 Z[#5-50] F0.2", "#1=1\nG1 Z[#1+#100-50] F0.2"}) try {
            barOfProgram(fileWith(head + move + "\nM2\n"), {20}, {});
            ADD_FAILURE() << move;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::linkProgramNotWhole) << move;
        }
    EXPECT_DOUBLE_EQ(barOfProgram(fileWith(head + "#100=3\nG1 Z[#100-53] F0.2\nM2\n"), {20}, {}).length_mm, 72);
}

TEST(Assistant, takes_nothing_from_a_program_that_was_not_understood)
{
    const std::string path = fileWith("G18 G21 G90 G7\nG1 X32 Z0 F0.2\nG888 Z-60\nM2\n");
    const LinkConfig config = readConfig(configText(R"("program": {"clearance_mm": 20})"), ".");
    Assistant assistant = paperAssistant(config);
    const Reply reply = assistant.answer({{speedName, paperSpeed_m_min}}, path, {});
    EXPECT_EQ(reply.state, State::ProgramNotUsable);
    ASSERT_TRUE(reply.error);
}

}  // namespace
}  // namespace lathelier::link
