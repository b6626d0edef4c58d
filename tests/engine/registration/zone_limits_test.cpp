#include "engine/registration/verdict/zone_limits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"
#include "tests/engine/core/code_of_error.h"

namespace lathelier::registration {
namespace {

TEST(ZoneLimits, AreReadInOrderOfTheAxis)
{
    Notes notes;
    const auto zones =
        readZones(R"([{"name": "b", "z_start_mm": 50, "z_end_mm": 60, "lower_mm": null, "upper_mm": null},
        {"name": "a", "z_start_mm": 1, "z_end_mm": 9, "lower_mm": -0.1, "upper_mm": 0.2, "colour": "red"}])",
                  notes);
    ASSERT_EQ(zones.size(), 2u);
    EXPECT_EQ(zones[0], (ZoneLimits{"a", 1, 9, -0.1, 0.2}));
    EXPECT_FALSE(zones[1].lower_mm);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].code, notes::unknownKey);
}

TEST(ZoneLimits, RefuseWhatDoesNotFitAndSayWhere)
{
    const auto codeOf = [](const std::string& json) {
        Notes notes;
        return codeOfError([&] { readZones(json, notes); });
    };
    const auto zone = [](const char* from, const char* to, const char* lower, const char* upper) {
        return fmt::format(R"({{"name": "a", "z_start_mm": {}, "z_end_mm": {}, "lower_mm": {}, "upper_mm": {}}})", from,
                           to, lower, upper);
    };
    const auto list = [](const std::string& items) { return fmt::format("[\n{}]", items); };
    EXPECT_EQ(codeOf("{}"), errors::malformed);
    EXPECT_EQ(codeOf("[1]"), errors::malformed);
    EXPECT_EQ(codeOf(list(zone("9", "9", "0", "1"))), errors::malformed);
    EXPECT_EQ(codeOf(list(zone("1", "9", "1", "0"))), errors::malformed);
    EXPECT_EQ(codeOf(list(zone("1", "9", "null", "0"))), errors::malformed);
    EXPECT_EQ(codeOf(list(zone("1", "\"9\"", "0", "1"))), errors::malformed);
    EXPECT_EQ(codeOf(list(zone("1", "9e9", "0", "1"))), errors::keyOutOfRange);
    EXPECT_EQ(codeOf(list(fmt::format("{},{}", zone("1", "9", "0", "1"), zone("8", "12", "0", "1")))),
              errors::malformed);
    EXPECT_EQ(codeOf(R"([{"name": "a", "z_start_mm": 1, "z_end_mm": 2, "lower_mm": 0}])"), errors::keyMissing);
    Notes notes;
    try {
        readZones(list(zone("9", "7", "0", "1")), notes);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{2}));
    }
    EXPECT_EQ(codeOfError([] { checkZones({{"a", 5, 1, {}, {}}}); }), errors::valueNotUnderstood);
}

}  // namespace
}  // namespace lathelier::registration
