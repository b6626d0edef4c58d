// What "Verify installation" says, by itself and quoted.
#include "engine/form/verify_report.h"

#include <gtest/gtest.h>

#include "engine/report/plain_text.h"

namespace lathelier::form {
namespace {

VerifyResult made(bool pass)
{
    VerifyResult result;
    result.kinds.push_back({"least_squares_circle", Text{"Least-squares circle"}, 19, 6.8e-13, Text{"mm"}, 2e-9, true});
    result.kinds.push_back({"harmonics", Text{"Harmonics"}, 15, 3e-11, Text{}, 1e-12, pass});
    result.pass = pass;
    return result;
}

TEST(VerifyReport, CountsWhatMisses)
{
    EXPECT_EQ(headline(made(true)).text, "2 kinds of reference data refitted: all answers agree");
    EXPECT_EQ(headline(made(false)).text, "1 of 2 kinds of reference data miss their answers");
    EXPECT_NE(toPlainText(verifySummary(made(false))).find("3.0e-11"), std::string::npos);
}

TEST(VerifyReport, IsQuotedOnceAsTheLastSection)
{
    Document document;
    document.sections.push_back({Text{"Result"}, {}});
    quoteVerification(document, made(true));
    quoteVerification(document, made(true));
    ASSERT_EQ(document.sections.size(), 2u);
    EXPECT_NE(toPlainText(document.sections.back()).find("all answers agree"), std::string::npos);
    EXPECT_NE(toPlainText(document.sections.back()).find("6.8e-13"), std::string::npos);
    Document itself = verifyReport(made(true));
    const std::size_t sections = itself.sections.size();
    quoteVerification(itself, made(true));
    EXPECT_EQ(itself.sections.size(), sections);
}

}  // namespace
}  // namespace lathelier::form
