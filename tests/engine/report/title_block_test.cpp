#include "engine/report/title_block.h"

#include <gtest/gtest.h>

#include "engine/report/html.h"

namespace lathelier::report {
namespace {

TEST(TitleBlock, ShowsWhatWasGivenAndAPlaceToSign)
{
    TitleBlock block;
    block.part = "Shaft <1>";
    block.inspector = "A. Nowak";
    Document document;
    document.title = std::string("Report");
    document.title_block = rowsOf(block);
    ASSERT_EQ(document.title_block.size(), 2u);
    const std::string html = toHtml(document);
    EXPECT_NE(html.find("<dd>Shaft &lt;1&gt;</dd>"), std::string::npos);
    EXPECT_NE(html.find("<dt>Inspector</dt>"), std::string::npos);
    EXPECT_NE(html.find("Date, signature"), std::string::npos);
    EXPECT_EQ(html.find("Customer"), std::string::npos);
    document.title_block = rowsOf(TitleBlock{});
    EXPECT_EQ(toHtml(document).find("Date, signature"), std::string::npos);
}

/// A report with a verdict is a certificate: what is not known is written in by hand.
TEST(TitleBlock, ACertificateHasLinesToFillIn)
{
    Answer answer;
    answer.value = 1;
    Document document;
    document.sections = {{std::string("Result"), {answer}}};
    TitleBlock block;
    block.part = "Shaft";
    setTitleBlock(document, block);
    EXPECT_EQ(document.title_block.size(), 1U);  // without a verdict only what is given
    answer.verdict = Verdict::Pass;
    document.sections.front().blocks.front() = answer;
    setTitleBlock(document, block);
    ASSERT_EQ(document.title_block.size(), 6U);
    EXPECT_EQ(document.title_block[1].value, Value("Shaft"));
    EXPECT_EQ(document.title_block[2].value, Value(""));
    EXPECT_NE(toHtml(document).find("Date, signature"), std::string::npos);
}

TEST(TitleBlock, NamesTheFileAfterPartAndDate)
{
    TitleBlock block;
    EXPECT_EQ(reportFileName(block, "project", "2026-11-22"), "project_2026-11-22");
    EXPECT_EQ(reportFileName(block, "", "2026-11-22"), "report_2026-11-22");
    const auto named = [](std::string part, std::string serial) {
        TitleBlock filled;
        filled.part = std::move(part);
        filled.serial = std::move(serial);
        return filled;
    };
    EXPECT_EQ(reportFileName(named("../Wał \"42\"/B", "7"), "project", "2026-11-22"), "_Wał _42__B_7_2026-11-22");
    EXPECT_LE(reportFileName(named(std::string(200, 'x'), {}), "", "2026-11-22").size(), 140u);
}

}  // namespace
}  // namespace lathelier::report
