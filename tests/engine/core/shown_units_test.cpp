// Lengths in the unit that people read: sentences, numbers, values of any kind.
#include <gtest/gtest.h>

#include "engine/core/texts.h"
#include "engine/core/units.h"

namespace lathelier {
namespace {

Language inches()
{
    Language language;
    language.lengths = {Text{"in"}, 1 / 25.4, 2};
    language.deviations_of_form = {Text{"µin"}, 1e3 / 25.4, -1};
    return language;
}

TEST(ShownUnits, ANumberHasTheDecimalsAndTheSignThatThePatternAsksFor)
{
    EXPECT_EQ(fill("{a:2} {a:+1} {b:+3} {b} {c:1}", {{"a", 1.25}, {"b", -0.5}, {"c", std::string("x")}}),
              "1.25 +1.2 -0.500 -0.5 x");
    EXPECT_EQ(fill("{gone:2}", {}), "{gone:2}");
    EXPECT_EQ(fill("{a:2", {{"a", 1.0}}), "{a:2");
}

TEST(ShownUnits, SmallValuesKeepThreeDigitsWhereAsked)
{
    const auto shown = [](double value) { return fill("{a:3+}", {{"a", value}}); };
    EXPECT_EQ(shown(12.5), "12.500");
    EXPECT_EQ(shown(0.0002697912), "0.000270");
    EXPECT_EQ(shown(-0.0421), "-0.0421");
    EXPECT_EQ(shown(0), "0.000");
    EXPECT_EQ(shown(1e-12), "0.000000000");
}

TEST(ShownUnits, ASentenceInInches)
{
    const Values values{{"value_mm", 0.0508}, {"uncertainty_mm", 0.0127}, {"from_mm", 25.4}, {"to_mm", 50.8}};
    const std::string pattern = "Step {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm";
    EXPECT_EQ(fill(pattern, values), "Step +0.051 ± 0.013 mm · z 25.4-50.8 mm");
    EXPECT_EQ(fill(pattern, values, inches()), "Step +0.00200 ± 0.00050 in · z 1.000-2.000 in");
    EXPECT_EQ(fill("up to {form_um:1} µm, {form_um} µm", {{"form_um", 2.54}}, inches()), "up to 100 µin, 100 µin");
}

TEST(ShownUnits, OnlyTheUnitOfALengthIsReplaced)
{
    // Units of something else, of a length squared, or inside a word stay.
    EXPECT_EQ(fill("{depth_mm} mm at {k} N/mm, {s} µm/V, 3 mm², 5 mm/N, hammm, mm",
                   {{"depth_mm", 25.4}, {"k", 2.0}, {"s", 50.0}}, inches()),
              "1 in at 2 N/mm, 50 µm/V, 3 mm², 5 mm/N, hammm, in");
    EXPECT_EQ(fill("{k} mm", {{"k", 25.4}}, inches()), "25.4 mm") << "not a length by its name";
    EXPECT_EQ(fill("{a_mm} mm, {b_mm} mm", {{"a_mm", 25.4}, {"b_mm", Text{"none"}}}, inches()), "25.4 mm, none mm")
        << "a phrase in place of a number: the engine's units";
}

TEST(ShownUnits, NumbersAndLists)
{
    EXPECT_EQ(shownUnit(unit::mm, inches()).unit, Text{"in"});
    EXPECT_EQ(shownUnit(Text{"N"}, inches()), (ShownUnit{Text{"N"}}));
    EXPECT_EQ(shownUnit(unit::mm, {}), (ShownUnit{unit::mm}));
    EXPECT_EQ(shownNumber(25.4, unit::mm, 3, inches()), "1.00000");
    EXPECT_EQ(shownNumber(2.54, unit::um, 2, inches()), "100.0");
    EXPECT_EQ(shownNumber(2.54, unit::um, 0, inches()), "100") << "no fewer than none";
    EXPECT_EQ(shownNumber(2.5, Text{"Hz"}, 1, inches()), "2.5");
    const Value list = shownValue(std::vector<double>{25.4, 50.8}, unit::mm, inches());
    EXPECT_EQ(text(list), "1, 2");
    const Value ranges = shownValue(std::vector<Interval>{{25.4, 50.8}}, unit::mm, inches());
    EXPECT_EQ(text(ranges), "1:2");
    EXPECT_EQ(shownValue(std::int64_t{3}, unit::mm, inches()), Value(std::int64_t{3}));
    EXPECT_EQ(fill("{a_mm} mm", {{"a_mm", 25.4}}, inEngineUnits(inches())), "25.4 mm");
}

}  // namespace
}  // namespace lathelier
