// A refused plan says which operation, tool and place, and its text stands beside, stopped.
#include "engine/cam/plan_refusal.h"

#include <gtest/gtest.h>

#include "engine/cam/plan_codes.h"
#include "engine/cam/plan_files.h"
#include "engine/cam/plan_programs.h"
#include "engine/core/texts.h"
#include "engine/io/file.h"
#include "tests/engine/cam/plan_checks.h"
#include "tests/scratch_folder.h"

namespace lathelier::cam {
namespace {

/// A plan whose finish was changed: before it leaves the work it feeds 2 mm into the part, up to z 45.
TurningPlan refusedPlan(const char* post)
{
    TurningInputs inputs;
    inputs.post = postNamed(post);
    const Job job = jobWith({row(30, 20, 20), row(30, 30, 30)}, 34, 80, {roughC80(), finishC80()});
    const TurningPlan plan = planned(job, post);
    std::string text = plan.setups[0].text;
    const std::size_t retract = text.rfind("G0 X", text.rfind("M9"));
    EXPECT_NE(retract, std::string::npos) << text;
    text.insert(text.rfind('\n', retract) + 1, "G1 X26. Z-45. F0.1\n");
    return withPrograms(plan, {{0, text, {}, true, true}}, inputs);
}

TEST(RefusedPlan, NamesOperationToolAndPlace)
{
    const TurningPlan plan = refusedPlan("linuxcnc");
    ASSERT_TRUE(plan.is_refused);
    try {
        throwIfRefused(plan);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::programRefused);
        EXPECT_EQ(std::get<Text>(*find(error.values(), "operation")), nameOf(OperationKind::Finish));
        EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "tool")), 2);
        EXPECT_NEAR(std::get<double>(*find(error.values(), "z_mm")), 52, 8.5);
        const std::string sentence = text(error);
        EXPECT_NE(sentence.find("finish, tool 2"), std::string::npos) << sentence;
        EXPECT_NE(sentence.find("insert below the drawing at z = "), std::string::npos) << sentence;
        const Row& first = std::get<Rows>(*find(error.values(), "findings")).rows.at(0);
        EXPECT_EQ(std::get<std::string>(*find(first.cells, "operation")), "finish");
        EXPECT_EQ(std::get<std::int64_t>(*find(first.cells, "tool")), 2);
    }
}

TEST(RefusedPlan, StandsBesideWithAStopInItsFirstLine)
{
    const ScratchFolder folder;
    const std::string path = folder / "p.nc";
    for (const char* post : {"linuxcnc", "fanuc_a", "fanuc_b"}) {
        const TurningPlan plan = refusedPlan(post);
        io::writeFile(refusedPath(path), "before");
        writeRefused(plan, {path});
        EXPECT_FALSE(std::filesystem::exists(path)) << post;
        const std::string written(io::FileBytes(refusedPath(path)).view());
        EXPECT_EQ(written.substr(0, 7), "M0 M30\n");
        // The lines that findings name are those of this file.
        EXPECT_EQ(std::count(written.begin(), written.end(), '\n'),
                  std::count(plan.setups[0].text.begin(), plan.setups[0].text.end(), '\n'));
    }
    EXPECT_EQ(stoppedText("%\r\nO100 (T)\r\nG0 X1\r\n"), "M0 M30\r\nM0 M30\r\nG0 X1\r\n");
    EXPECT_EQ(stoppedText("(TITLE)\nG0 X1\n"), "M0 M30\nG0 X1\n");
    EXPECT_EQ(stoppedText(""), "M0 M30");
}

}  // namespace
}  // namespace lathelier::cam
