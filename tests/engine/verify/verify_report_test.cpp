// Report of "Verify installation", alone and quoted.
#include "engine/verify/verify_report.h"

#include <gtest/gtest.h>

#include "engine/report/plain_text.h"

namespace lathelier {
namespace {

verify::VerifyResult made(bool pass)
{
    verify::VerifyResult result;
    result.kinds.push_back({"least_squares_circle", Text{"Least-squares circle"}, 19, 6.8e-13, Text{"mm"}, 2e-9, true});
    result.kinds.push_back({"harmonics", Text{"Harmonics"}, 15, 3e-11, Text{}, 1e-12, pass});
    result.pass = pass;
    return result;
}

TEST(VerifyReport, CountsWhatMisses)
{
    EXPECT_EQ(report::sentenceText(answer(made(true))), "2 kinds of reference data refitted: all answers agree");
    EXPECT_EQ(report::sentenceText(answer(made(false))), "1 of 2 kinds of reference data miss their answers");
    EXPECT_NE(report::toPlainText(verify::verifySummary(made(false))).find("3.0e-11"), std::string::npos);
}

TEST(VerifyReport, IsQuotedOnceAsTheLastSection)
{
    const VerifyPart part{"made", {[](const Progress&) { return made(true).kinds.front(); }}};
    report::Document document;
    document.sections.push_back({Text{"Result"}, {}});
    verify::quoteVerification(document);
    EXPECT_EQ(document.sections.size(), 1U);  // nothing of it can be verified
    document.verification = {&part};
    verify::quoteVerification(document);
    verify::quoteVerification(document);
    ASSERT_EQ(document.sections.size(), 2U);
    const std::string quotedText = report::toPlainText(document.sections.back());
    EXPECT_NE(quotedText.find(made(true).kinds.front().name.english), std::string::npos);
    report::Document itself = verify::verifyReport(made(true));
    itself.verification = {&part};
    const std::size_t sections = itself.sections.size();
    verify::quoteVerification(itself);
    EXPECT_EQ(itself.sections.size(), sections);
}

}  // namespace
}  // namespace lathelier
