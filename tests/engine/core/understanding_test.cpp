// What was not understood settles verdict, notes and whether anything is written.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/understanding.h"
#include "engine/io/io_codes.h"

namespace lathelier {
namespace {

Understanding withGap(GapEffect effect)
{
    Understanding understanding;
    understanding.not_modelled = {{"a.nc", 3, 1, "M400", "nc_word_unknown", GapEffect::None},
                                  {"a.nc", 7, 5, "G160", "nc_word_unknown", effect}};
    return understanding;
}

TEST(UnderstandingRule, AGapThatCountsLeavesTheVerdictUndecided)
{
    for (const GapEffect effect : {GapEffect::Measures, GapEffect::Shifts, GapEffect::Moves}) {
        std::optional<Verdict> verdict = Verdict::Pass;
        Notes remarks;
        settle(withGap(effect), verdict, remarks);
        EXPECT_EQ(verdict, Verdict::Undecided);
        ASSERT_TRUE(contains(remarks, notes::notModelled));
        EXPECT_EQ(*find(remarks.front().values, "place"), Value(std::string("a.nc:7")));
        try {
            requireUnderstood(withGap(effect));
            ADD_FAILURE() << "not refused";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::notModelled);
            EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{7}));
        }
    }
    std::optional<Verdict> verdict = Verdict::Pass;
    Notes remarks;
    settle(withGap(GapEffect::None), verdict, remarks);
    EXPECT_EQ(verdict, Verdict::Pass);
    EXPECT_TRUE(remarks.empty());
    EXPECT_NO_THROW(requireUnderstood(withGap(GapEffect::None)));
    EXPECT_EQ(toJson(withGap(GapEffect::None))["not_modelled"].size(), 2u);
}

TEST(UnderstandingRule, AKeyThatIsNearlyAnotherOneIsAGap)
{
    const Values place{{"key", std::string("nose_radius_in")}, {"line", std::int64_t{2}}};
    Values meant = place;
    meant.emplace_back("meant", std::string("nose_radius_mm"));
    EXPECT_TRUE(understandingOf({{notes::unknownKey, place}}).isWhole());
    EXPECT_EQ(understandingOf({{notes::unknownKey, place}}).not_modelled.size(), 1u);
    EXPECT_FALSE(understandingOf({{notes::unknownKey, meant}}).isWhole());
}

}  // namespace
}  // namespace lathelier
