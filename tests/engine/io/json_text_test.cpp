// JSON that would exhaust time or stack is refused with its place, before it is parsed.
#include "engine/io/json/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

std::string objectOf(int names)
{
    std::string text = R"({"list": [{"a": 1}, {"b": ":"}], "k0": 0)";
    for (int i = 1; i < names - 1; ++i) text += ",\n\"k" + std::to_string(i) + "\": " + std::to_string(i);
    return text + "}";
}

TEST(JsonText, HasAtMostTenThousandNamesInAnObject)
{
    EXPECT_EQ(parseJson(objectOf(10000)).size(), 10000U);
    try {
        parseJson(objectOf(10001));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::malformed);
        EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{10000}));
    }
}

TEST(JsonText, ClosedBracketsWithoutOpenOnesAreNoNesting)
{
    EXPECT_THROW(parseJson("]]]]{\"a\": 1}"), Error);
    EXPECT_THROW(parseJson(std::string(40, '[')), Error);
}

}  // namespace
}  // namespace lathelier::io
