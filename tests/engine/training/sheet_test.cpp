// The sheet of a class: graded again from kind and seed, the same for everyone, and right in its totals.
#include "engine/training/sheet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/texts.h"
#include "engine/report/html.h"
#include "engine/report/plain_text.h"

namespace lathelier::training {
namespace {

/// One pupil answers everything correctly, the other nothing.
std::vector<Answered> answersOf(const std::vector<Exercise>& test)
{
    std::vector<Answered> answers;
    for (const Exercise& exercise : test) {
        const Interval right = grade(exercise, 0).expected.front();
        answers.push_back({"Ada, \"the quick\"", exercise.kind, exercise.seed, (right.from + right.to) / 2, 30});
        answers.push_back({"Żaneta", exercise.kind, exercise.seed, std::nan(""), 10.5});
    }
    return answers;
}

TEST(Sheet, TheSameSeedIsTheSameTest)
{
    const std::vector<Exercise> a = makeTest(7, 11), b = makeTest(7, 11), other = makeTest(8, 11);
    ASSERT_EQ(a.size(), 11U);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].kind, b[i].kind);
        EXPECT_EQ(a[i].seed, b[i].seed);
        EXPECT_EQ(a[i].hidden.modes, b[i].hidden.modes);
        EXPECT_NE(a[i].seed, other[i].seed);
    }
    EXPECT_NE(a[0].seed, a[5].seed);
    EXPECT_EQ(a[0].kind, a[5].kind);
    EXPECT_TRUE(makeTest(1, -3).empty());
}

TEST(Sheet, TotalsAreThoseOfTheAnswers)
{
    const std::vector<Answered> answers = answersOf(makeTest(3, 10));
    const Sheet sheet = sheetOf(answers);
    ASSERT_EQ(sheet.rows.size(), 20U);
    ASSERT_EQ(sheet.totals.size(), 2U);
    EXPECT_EQ(sheet.totals[0].pupil, answers[0].pupil);
    EXPECT_EQ(sheet.totals[0].answers, 10);
    EXPECT_EQ(sheet.totals[0].correct, 10);
    EXPECT_GE(sheet.totals[0].points, 96);
    EXPECT_EQ(sheet.totals[0].most_points, 100);
    EXPECT_DOUBLE_EQ(sheet.totals[0].needed_s, 300);
    EXPECT_EQ(sheet.totals[1].correct, 0);
    EXPECT_EQ(sheet.totals[1].points, 0);
    EXPECT_EQ(sheet.whole.answers, 20);
    EXPECT_DOUBLE_EQ(sheet.whole.points, sheet.totals[0].points);
}

TEST(Sheet, IsTheSameTextEveryTime)
{
    const std::vector<Answered> answers = answersOf(makeTest(3, 5));
    const std::string csv = sheetCsv(sheetOf(answers));
    EXPECT_EQ(csv, sheetCsv(sheetOf(answers)));
    EXPECT_TRUE(csv.starts_with("pupil,exercise,seed,answer,expected,correct,points,needed_s\n")) << csv;
    EXPECT_NE(csv.find("\n\"Ada, \"\"the quick\"\"\",safe_speed,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\nŻaneta,prediction,"), std::string::npos) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 11);
    const report::Document document = sheetReport(sheetOf(answers));
    const std::string html = report::toHtml(document);
    EXPECT_EQ(html, report::toHtml(sheetReport(sheetOf(answers))));
    EXPECT_NE(html.find("Żaneta"), std::string::npos);
    const std::string answered = report::toPlainText(document.sections[1]);
    EXPECT_NE(answered.find("Damping from a decay"), std::string::npos) << answered;
}

TEST(Sheet, OfNobodyIsEmpty)
{
    const Sheet sheet = sheetOf({});
    EXPECT_TRUE(sheet.rows.empty() && sheet.totals.empty());
    EXPECT_EQ(sheetCsv(sheet), "pupil,exercise,seed,answer,expected,correct,points,needed_s\n");
    EXPECT_FALSE(report::toHtml(sheetReport(sheet)).empty());
}

}  // namespace
}  // namespace lathelier::training
