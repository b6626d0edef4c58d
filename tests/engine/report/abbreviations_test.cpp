// Abbreviations are distinguished from words and units around them.
#include "engine/report/abbreviations.h"

#include <gtest/gtest.h>

namespace lathelier {
namespace {

TEST(Abbreviations, OfAHeadline)
{
    EXPECT_EQ(report::expansion("RONt(MZCI) 5.3\u00A0µm · G 1-50\u00A0UPR · within 8\u00A0µm"),
              "RONt: peak-to-valley roundness deviation\n"
              "MZCI: minimum zone reference circles\n"
              "UPR: undulations per revolution\n"
              "G: Gaussian filter");
}

TEST(Abbreviations, WholeWordsOnly)
{
    EXPECT_EQ(report::expansion("RMS 0.05 mm"), "RMS: root mean square");
    EXPECT_EQ(report::expansion("RMSE 0.05 mm"), "RMSE: root mean square error");
    EXPECT_EQ(report::expansion("Gap, ALARMS, UPRIGHT, Gd"), "");
    EXPECT_EQ(report::expansion(""), "");
}

TEST(Abbreviations, InTheLanguageOfTheReader)
{
    Language language;
    language.translate = [](const char* english) { return std::string(english).append("!"); };
    EXPECT_EQ(report::expansion("UPR", language), "UPR: undulations per revolution!");
}

}  // namespace
}  // namespace lathelier
