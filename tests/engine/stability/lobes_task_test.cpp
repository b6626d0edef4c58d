// The task lobes asked again with other reading options, as a window does it.
#include "engine/stability/task/lobes_task.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/stability/modes.h"
#include "engine/task/stores.h"
#include "tests/engine/stability/machines.h"
#include "tests/scratch_folder.h"

namespace lathelier::stability {
namespace {

double leastDepth_mm(const project::PanelState& state, Stores& stores)
{
    task::Sources sources;
    return *answerLobes(state, stores, sources, {}).lobes->minimum_depth_mm;
}

TEST(LobesTask, AnotherUnitOfTheFileIsAnotherLimit)
{
    const ScratchFolder folder;
    std::string text = "frequency_hz,real,imag\n";
    for (double f = 100; f <= 400; f += 0.5) {
        const std::complex<double> g = receptanceOf(paperA, f);
        text += std::to_string(f) + "," + std::to_string(1e6 * g.real()) + "," + std::to_string(1e6 * g.imag()) + "\n";
    }
    const std::string path = (folder / "response.csv").string();
    io::writeFile(path, text);
    project::PanelState state;
    state.inputs[frfRole].path = path;
    state.parameters = {{"cutting_coefficient_N_mm2", coefficient_N_mm2}};
    Stores stores;
    set(state.inputs[frfRole].import, "frf_unit", std::string("mm/N"));
    // 2 ζ (1 + ζ) k / K_r of one mode, with the values of the file 1e6 times the receptance.
    const double expected_mm = 2 * 0.03 * 1.03 * 1e4 / coefficient_N_mm2 / 1e6;
    EXPECT_NEAR(leastDepth_mm(state, stores), expected_mm, 1e-3 * expected_mm);
    set(state.inputs[frfRole].import, "frf_unit", std::string("m/N"));
    EXPECT_NEAR(leastDepth_mm(state, stores), expected_mm / 1000, 1e-6 * expected_mm);
}

/// The answer is the depth that is stable; the one that was asked is its limit.
TEST(LobesTask, AnswersWithTheStableDepth)
{
    const ScratchFolder folder;
    const std::string path = (folder / "response.csv").string();
    std::ostringstream text;
    text << "frequency_hz,real,imag\n";
    for (double f = 100; f <= 400; f += 0.5) {
        const std::complex<double> g = receptanceOf(paperA, f);
        text << f << ',' << g.real() << ',' << g.imag() << '\n';
    }
    io::writeFile(path, text.str());
    project::PanelState state;
    state.parameters = {
        {"cutting_coefficient_N_mm2", coefficient_N_mm2}, {"operating_speed_rpm", 2885.0}, {"operating_depth", 0.6}};
    state.inputs[frfRole].path = path;
    set(state.inputs[frfRole].import, "frf_unit", std::string("mm/N"));
    Stores stores;
    task::Sources sources;
    const LobesOutcome outcome = answerLobes(state, stores, sources, {});
    const report::Answer told = answer(outcome);
    EXPECT_EQ(told.verdict, Verdict::Fail);
    EXPECT_EQ(told.lower_limit, 0.6);
    ASSERT_TRUE(told.value);
    EXPECT_LT(*told.value, 0.6);
    EXPECT_NEAR(*told.value, pointStabilityAt(*outcome.lobes, 2885, 0.6).limit_mm, 1e-3);
}

/// Of a shaft, it swings at the frequency of its chatter, as its response says at the tool.
TEST(LobesTask, AShaftSwingsAsItChatters)
{
    const ScratchFolder folder;
    const std::string path = (folder / "shaft.json").string();
    Shaft shaft;
    shaft.segments = {{150, 30, 30, 0, {}, {}}, {50, 50, 50, 0, {}, {}}};
    shaft.material = Material{};
    io::writeFile(path, io::shaftText(shaft));
    project::PanelState state;
    state.inputs[shaftRole].path = path;
    state.parameters = {{"cutting_coefficient_N_mm2", coefficient_N_mm2}};
    const auto answered = [&] {
        Stores stores;
        task::Sources sources;
        return answerLobes(state, stores, sources, {});
    };
    const LobesOutcome outcome = answered();
    ASSERT_TRUE(outcome.swing);
    EXPECT_EQ(outcome.swing->force_z_mm, 0);
    const PointStability work = pointStabilityAt(*outcome.lobes, outcome.point.speed_rpm, outcome.point.depth_mm);
    EXPECT_EQ(outcome.swing->frequency_hz,
              std::isfinite(work.frequency_hz) ? work.frequency_hz : *outcome.lobes->frequency_of_minimum_hz);
    state.inputs.clear();
    state.parameters.push_back(
        {modeKey, Rows{{Row{Values{{"frequency_hz", 250.0}, {"damping_ratio", 0.03}, {"stiffness_N_mm", 1e4}}}}}});
    EXPECT_FALSE(answered().swing);  // of modes alone nobody knows the shape
}

}  // namespace
}  // namespace lathelier::stability
