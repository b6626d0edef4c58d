// Roundness as Q-DAS characteristics: what a company's statistics read of it.
#include "engine/form/roundness/roundness_dfq.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>

namespace lathelier::form {
namespace {

RoundnessResult resultOf(const std::string& name, double lobe_mm, const RoundnessParameters& parameters)
{
    Profile profile;
    profile.name = name;
    for (int i = 0; i < 120; ++i) {
        const double angle = 2 * std::numbers::pi * i / 120, r = 25 + lobe_mm * std::cos(3 * angle);
        profile.points_mm.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return roundness(profile, parameters);
}

RoundnessParameters limited()
{
    RoundnessParameters parameters;
    parameters.tolerance_um = 8;
    parameters.cutoff_upr = 50;
    return parameters;
}

TEST(RoundnessDfq, severalProfilesAreValuesOfOneCharacteristic)
{
    const io::QdasFile file =
        qdasFile({resultOf("data/shaft_01.csv", 0.002, limited()), resultOf("data/shaft_02.csv", 0.003, limited()),
                  resultOf("data/shaft_03.csv", 0.004, limited())},
                 {"21.04.2015/12:00:00", "", "21.04.2015/12:10:00"});
    EXPECT_EQ(file.part_number, "shaft");
    ASSERT_EQ(file.characteristics.size(), 4U);
    for (const io::QdasCharacteristic& c : file.characteristics) {
        EXPECT_EQ(c.values.size(), 3U);
        EXPECT_LT(c.values[0], c.values[2]);
        ASSERT_EQ(c.measured.size(), 3U);
        EXPECT_EQ(c.measured[2], "21.04.2015/12:10:00");
        EXPECT_TRUE(std::regex_match(c.measured[1], std::regex(R"(\d\d\.\d\d\.\d{4}/\d\d:\d\d:\d\d)")));
        EXPECT_EQ(c.description.find("shaft"), std::string::npos) << c.description;
        EXPECT_LE(c.description.size(), 80U);
        EXPECT_EQ(c.nominal, 0.0);
        EXPECT_EQ(c.lower_limit, 0.0);
        EXPECT_TRUE(c.lower_is_natural);
        EXPECT_EQ(c.upper_limit.has_value(), c.description.starts_with("RONt(MZCI)"));
        EXPECT_FALSE(c.upper_is_natural);
        EXPECT_EQ(c.unit, "µm");
    }
    EXPECT_EQ(file.characteristics[1].number, "2");
}

TEST(RoundnessDfq, whatIsFilteredOtherwiseIsAnotherCharacteristic)
{
    RoundnessParameters other = limited();
    other.cutoff_upr = 15;
    const io::QdasFile file = qdasFile({resultOf("a", 0.002, limited()), resultOf("b", 0.002, other)});
    EXPECT_EQ(file.characteristics.size(), 8U);
    EXPECT_EQ(file.part_number, "a");
}

TEST(RoundnessDfq, thePartIsNamedInThirtyCharacters)
{
    EXPECT_EQ(qdasFile({resultOf("wałek.csv", 0.002, limited())}).part_number, "wałek");
    EXPECT_LE(qdasFile({resultOf(std::string(100, 'a') + ".csv", 0.002, limited())}).part_number.size(), 30U);
    EXPECT_FALSE(qdasFile({resultOf("", 0.002, limited())}).part_number.empty());
}

}  // namespace
}  // namespace lathelier::form
