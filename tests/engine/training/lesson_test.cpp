// The reader of lessons: valid lessons, and every error with its line and column.
#include "engine/training/lesson.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/random.h"
#include "engine/core/texts.h"
#include "engine/io/io_codes.h"
#include "tests/engine/core/code_of_error.h"

namespace lathelier::training {
namespace {

const std::string goodLesson =
    "# A lesson\n"
    "\n"
    "Its introduction.\n"
    "\n"
    "## First *step*\n"
    "\n"
    "A paragraph: with a colon.\n"
    "\n"
    "    N = 60 f / k\n"
    "\n"
    "```\n"
    "# no title\n"
    "check: no directive\n"
    "```\n"
    "### A smaller heading\n"
    "https://example.org is a text\n"
    "set: scenario = tailstock, speed_rpm=2800 , depth_mm = 0.25, relation = published\n"
    "show: waves, lobes\n"
    "task: Do this,\n"
    "and that.\n"
    "\n"
    "More text.\n"
    "hint: Like so.\n"
    "check: depth_mm > 1.5 * minimum_depth_mm\n"
    "check: speed_rpm>=limit_mm\n"
    "check: growth <= -1.25e-1\n"
    "check: verdict != chatter\n"
    "## Second\n"
    "set: exercise = damping, seed = 4294967295\n"
    "task: Answer.\n"
    "check: score >= 5\n";

TEST(Lesson, IsReadAsItIsWritten)
{
    const Lesson lesson = readLesson(goodLesson, "good.md");
    EXPECT_EQ(lesson.title, "A lesson");
    EXPECT_EQ(lesson.introduction, "Its introduction.");
    ASSERT_EQ(lesson.steps.size(), 2U);
    const Step& first = lesson.steps[0];
    EXPECT_EQ(first.heading, "First *step*");
    EXPECT_EQ(
        first.body,
        "A paragraph: with a colon.\n\n    N = 60 f / k\n\n```\n# no title\ncheck: no directive\n```\n### A smaller "
        "heading\nhttps://example.org is a text\n\nMore text.");
    EXPECT_EQ(first.task, "Do this, and that.");
    EXPECT_EQ(first.hint, "Like so.");
    EXPECT_EQ(first.set, (Setting{"tailstock", 2800, 0.25, stability::SpeedRelation::Published, {}, {}}));
    EXPECT_EQ(first.show, (std::vector<View>{View::Waves, View::Lobes}));
    ASSERT_EQ(first.checks.size(), 4U);
    EXPECT_EQ(first.checks[0], (Check{"depth_mm", Comparison::Greater, "", 1.5, "minimum_depth_mm"}));
    EXPECT_EQ(first.checks[1], (Check{"speed_rpm", Comparison::AtLeast, "", 1, "limit_mm"}));
    EXPECT_EQ(first.checks[2], (Check{"growth", Comparison::AtMost, "", -0.125, ""}));
    EXPECT_EQ(first.checks[3], (Check{"verdict", Comparison::Different, "chatter", 1, ""}));
    EXPECT_EQ(lesson.steps[1].set.exercise, ExerciseKind::Damping);
    EXPECT_EQ(lesson.steps[1].set.seed, 4294967295U);
}

TEST(Lesson, LineEndsAndByteOrderMarksDoNotMatter)
{
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : goodLesson) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(readLesson(windows, "w.md").steps[0].body, readLesson(goodLesson, "g.md").steps[0].body);
}

struct Slip {
    std::string text;
    ErrorCode code;
    std::int64_t line, column;
    std::string found;  ///< expected part of the sentence
};

TEST(Lesson, EverySlipHasItsPlace)
{
    const std::string head = "# T\n## S\n";
    const std::vector<Slip> slips{
        {"text\n# T\n## S\n", errors::malformed, 1, 1, "“text”"},
        {"## S\n", errors::malformed, 1, 1, "a title"},
        {"# \n", errors::malformed, 1, 3, "a heading"},
        {"#\n", errors::malformed, 1, 2, "a heading"},
        {"# T\n##  \n", errors::malformed, 2, 5, "a heading"},
        {"# T\ntext\n", errors::malformed, 2, 5, "a step"},
        {"# T\n# U\n## S\n", errors::malformed, 2, 1, "one title only"},
        {"# T\nset: scenario = rigid\n## S\n", errors::malformed, 2, 1, "a step"},
        {"# T\n## S\n```\ntext", errors::malformed, 4, 5, "```"},
        {head + "chek: growth > 1\n", errors::malformed, 3, 1, "“chek”, expected set, show, task, hint, check"},
        {head + "task: a\ntask: b\n", errors::malformed, 4, 1, "only one"},
        {head + "task:\n", errors::malformed, 3, 6, "a text"},
        {head + "show: lobes, wave\n", errors::malformed, 3, 14, "“wave”, expected lobes, growth, waveform"},
        {head + "show: lobes, lobes\n", errors::malformed, 3, 14, "only once"},
        {head + "show:\n", errors::malformed, 3, 6, "the end of the line"},
        {head + "show: lobes,\n", errors::malformed, 3, 13, "the end of the line"},
        {head + "set: scenario\n", errors::malformed, 3, 6, "key = value"},
        {head + "set: scenario = stiff\n", errors::malformed, 3, 17, "“stiff”, expected rigid, slender, tailstock"},
        {head + "set: speed = 5\n", errors::malformed, 3, 6, "“speed”, expected scenario, speed_rpm"},
        {head + "set: depth_mm = 0,2\n", errors::keyOutOfRange, 3, 17, "depth_mm is 0"},
        {head + "set: depth_mm = 1, 2\n", errors::malformed, 3, 20, "key = value"},
        {head + "set: depth_mm = deep\n", errors::malformed, 3, 17, "“deep”"},
        {head + "set: speed_rpm = 1e6\n", errors::keyOutOfRange, 3, 18, "speed_rpm"},
        {head + "set: speed_rpm = 100, speed_rpm = 200\n", errors::malformed, 3, 23, "only once"},
        {head + "set: seed = 5\n", errors::malformed, 3, 13, "an exercise"},
        {head + "set: exercise = damping, seed = 1.5\n", errors::malformed, 3, 33, "a whole number"},
        {head + "set: exercise = damping, seed = 4294967296\n", errors::keyOutOfRange, 3, 33, "seed"},
        {head + "set: exercise = guess\n", errors::malformed, 3, 17, "safe_speed, lobe_number"},
        {head + "task: t\ncheck: growht > 1\n", errors::malformed, 4, 8, "“growht”, expected scenario, speed_rpm"},
        {head + "task: t\ncheck: growth 1\n", errors::malformed, 4, 15, "< <= > >= = !="},
        {head + "task: t\ncheck: growth =< 1\n", errors::malformed, 4, 15, "< <= > >= = !="},
        {head + "task: t\ncheck: growth >\n", errors::malformed, 4, 16, "a number"},
        {head + "task: t\ncheck: growth > 1,5\n", errors::malformed, 4, 17, "“1,5”"},
        {head + "task: t\ncheck: growth > 2 * \n", errors::malformed, 4, 20, "a quantity"},
        {head + "task: t\ncheck: growth > 2 * verdict\n", errors::malformed, 4, 21, "“verdict”"},
        {head + "task: t\ncheck: growth > deep\n", errors::malformed, 4, 17, "“deep”"},
        {head + "task: t\ncheck: growth > 1e300\n", errors::keyOutOfRange, 4, 17, "growth"},
        {head + "task: t\ncheck: verdict > chatter\n", errors::malformed, 4, 16, "= !="},
        {head + "task: t\ncheck: verdict = silent\n", errors::malformed, 4, 18, "stable, chatter, undecided"},
        {head + "check: growth > 1\n## Next\n", errors::malformed, 3, 1, "a task"},
        {head + "check: growth > 1\n", errors::malformed, 3, 1, "a task"},
        {"# Ł\n## Ś\ntask: ż\ncheck: ąę\n", errors::malformed, 4, 8, "“ąę”"},
    };
    for (const Slip& slip : slips) {
        SCOPED_TRACE(slip.text);
        try {
            readLesson(slip.text, "slip.md");
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), slip.code);
            EXPECT_EQ(std::get<std::string>(*find(error.values(), "path")), "slip.md");
            EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "line")), slip.line);
            EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "column")), slip.column);
            EXPECT_NE(text(error).find(slip.found), std::string::npos) << text(error);
        }
    }
}

TEST(Lesson, FilesThatAreNoLessonAreRefused)
{
    EXPECT_EQ(codeOfError([] { readLesson("", "a"); }), errors::fileEmpty);
    EXPECT_EQ(codeOfError([] { readLesson(std::string("a\0b\x01", 4), "a"); }), errors::formatUnknown);
    EXPECT_EQ(codeOfError([] { readLesson("%PDF-1.7\n", "a"); }), errors::formatUnknown);
    EXPECT_EQ(codeOfError([] { readLesson("\n \n", "a"); }), errors::malformed);
    EXPECT_EQ(codeOfError([] { readLesson("# T\n" + std::string(largestLesson_bytes, 'x'), "a"); }), errors::malformed);
    std::string many = "# T\n";
    for (std::size_t i = 0; i <= mostSteps; ++i) many += "## S\n";
    EXPECT_EQ(codeOfError([&] { readLesson(many, "a"); }), errors::malformed);
    std::string checks = "# T\n## S\ntask: t\n";
    for (std::size_t i = 0; i <= mostChecks; ++i) checks += "check: growth > 1\n";
    EXPECT_EQ(codeOfError([&] { readLesson(checks, "a"); }), errors::malformed);
}

TEST(Lesson, ChecksSpeakOfTheState)
{
    LessonState state;
    state.scenario = "slender";
    state.depth_mm = 0.5;
    state.limit_mm = 0.4;
    state.k = 4;
    state.published_limit_mm = HUGE_VAL;
    state.verdict = stability::CutVerdict::Chatter;
    const auto met = [&](const std::string& check) {
        return isDone(readLesson("# T\n## S\ntask: t\ncheck: " + check + "\n", "c").steps[0], state);
    };
    for (const char* check :
         {"depth_mm > 0.4", "depth_mm >= 0.5", "depth_mm = 0.5", "depth_mm = 0.5004", "depth_mm > limit_mm",
          "depth_mm <= 1.3 * limit_mm", "depth_mm < published_limit_mm", "verdict = chatter", "verdict != stable",
          "scenario = slender", "scenario != rigid", "view = lobes", "relation = exact", "k = 4", "heard_s = 0"})
        EXPECT_TRUE(met(check)) << check;
    for (const char* check :
         {"depth_mm < 0.4", "depth_mm > 0.5", "depth_mm != 0.5", "depth_mm = 0.51", "depth_mm < limit_mm",
          "depth_mm > 1.3 * limit_mm", "verdict = stable", "scenario = rigid", "view = frf", "k = 5", "k != 4",
          "score > 0", "score <= 0", "score != 3", "growth < speed_rpm", "amplitude_mm = amplitude_mm"})
        EXPECT_FALSE(met(check)) << check;
}

TEST(Lesson, ChecksAreWrittenAsTheyAreRead)
{
    for (const std::string check : {"depth_mm > 1.5 * minimum_depth_mm", "growth <= -0.125", "verdict != chatter",
                                    "waves = 3.75", "phase_deg < 1 * frequency_hz"})
        EXPECT_EQ(written(readLesson("# T\n## S\ntask: t\ncheck: " + check, "c").steps[0].checks[0]), check);
}

/// Random changes of a good lesson: a lesson or a located error, nothing else.
TEST(Lesson, RandomBytesAreRefusedWithAPlace)
{
    for (std::uint64_t round = 0; round < 3000; ++round) {
        std::string bytes = goodLesson;
        const int changes = 1 + static_cast<int>(8 * randomUniform(round, 1, 0));
        for (std::uint64_t i = 1; i <= static_cast<std::uint64_t>(changes); ++i) {
            const auto at = static_cast<std::size_t>(static_cast<double>(bytes.size()) * randomUniform(round, 2, i));
            const char byte = static_cast<char>(randomBits(round, 3, i) & (i % 2 == 0 ? 0x7FU : 0xFFU));
            if (randomUniform(round, 4, i) < 0.3)
                bytes.erase(at, 3);
            else
                bytes[at] = byte;
        }
        try {
            EXPECT_FALSE(readLesson(bytes, "r").steps.empty());
        } catch (const Error& error) {
            EXPECT_EQ(error.code().kind, ErrorKind::InputRejected) << text(error);
            EXPECT_TRUE(find(error.values(), "line") || find(error.values(), "byte")) << text(error);
        }
    }
}

}  // namespace
}  // namespace lathelier::training
