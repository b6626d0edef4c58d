// JSON inputs: wrong types, missing keys, values out of range and unknown keys, each with its place.
#include "engine/io/json/json_fields.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/io/io_codes.h"
#include "engine/shaft/shaft.h"

namespace lathelier {
namespace {

constexpr const char* shaftText = R"({
  "schema": "lathelier-shaft",
  "name": "table 1",
  "segments": [
    {"length_mm": 98, "start_diameter_mm": 30, "end_diameter_mm": 30},
    {"length_mm": 10, "start_diameter_mm": 37, "end_diameter_mm": 37, "bore_diameter_mm": 12}
  ],
  "material": {"name": "brass", "elastic_modulus_MPa": 100000}
})";

Shaft readShaft(const std::string& text, Notes& notes)
{
    const io::JsonDocument document{text};
    return io::readFields<Shaft>(document.root(), notes, {"schema"});
}

/// The text of `text` with `from` replaced, read; what is wrong with it.
Error problemOf(std::string text, const std::string& from, const std::string& to)
{
    text.replace(text.find(from), from.size(), to);
    Notes notes;
    try {
        readShaft(text, notes);
    } catch (const Error& error) {
        return error;
    }
    throw std::logic_error("nothing was wrong");
}

TEST(JsonFields, ReadsGroupsAndRows)
{
    Notes notes;
    const Shaft shaft = readShaft(shaftText, notes);
    EXPECT_TRUE(notes.empty());
    ASSERT_EQ(shaft.segments.size(), 2U);
    EXPECT_EQ(shaft.segments[1].bore_diameter_mm, 12);
    ASSERT_TRUE(shaft.material);
    EXPECT_EQ(shaft.material->elastic_modulus_MPa, 100000);
    EXPECT_EQ(shaft.material->poisson_ratio, 0.3);  // what is not given keeps its default
}

TEST(JsonFields, WritesWhatItReads)
{
    Notes notes;
    Shaft shaft = readShaft(shaftText, notes);
    EXPECT_EQ(readShaft(io::objectOf(infos<Shaft>(), toValues(shaft)).dump(), notes), shaft);
    shaft.material.reset();
    EXPECT_EQ(readShaft(io::objectOf(infos<Shaft>(), toValues(shaft)).dump(), notes), shaft);
    EXPECT_TRUE(notes.empty());
}

TEST(JsonFields, AnUnknownKeyIsNotedWithItsPlace)
{
    std::string text = shaftText;
    text.replace(text.find("\"bore_diameter_mm\""), 18, "\"bohrung_mm\"");
    Notes notes;
    EXPECT_EQ(readShaft(text, notes).segments[1].bore_diameter_mm, 0);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, notes::unknownKey);
    EXPECT_EQ(*find(notes[0].values, "line"), Value(std::int64_t{6}));
    EXPECT_EQ(*find(notes[0].values, "column"), Value(std::int64_t{85}));
}

TEST(JsonFields, SaysWhereAValueHasTheWrongType)
{
    const Error error = problemOf(shaftText, "98", "\"long\"");
    EXPECT_EQ(error.code(), errors::malformed);
    EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{5}));
    EXPECT_EQ(*find(error.values(), "column"), Value(std::int64_t{19}));
    EXPECT_EQ(problemOf(shaftText, "{\"name\": \"brass\", \"elastic_modulus_MPa\": 100000}", "7").code(),
              errors::malformed);
}

TEST(JsonFields, SaysWhichKeyIsMissingWhere)
{
    const Error error = problemOf(shaftText, "\"length_mm\": 10,", "");
    EXPECT_EQ(error.code(), errors::keyMissing);
    EXPECT_EQ(*find(error.values(), "key"), Value("length_mm"));
    EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{6}));
}

TEST(JsonFields, NamesTheKeyFoundInPlaceOfTheOneExpected)
{
    for (const char* found : {"length", "length_in", "lengthMm", "Length_mm"}) {
        const Error error = problemOf(shaftText, "\"length_mm\": 10", std::string("\"").append(found).append("\": 10"));
        EXPECT_EQ(error.code(), errors::keyMisnamed) << found;
        EXPECT_EQ(*find(error.values(), "found"), Value(std::string(found)));
        EXPECT_EQ(*find(error.values(), "key"), Value("length_mm"));
        EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{6}));
    }
    EXPECT_EQ(problemOf(shaftText, "\"length_mm\": 10", "\"width_mm\": 10").code(), errors::keyMissing);
}

TEST(JsonFields, UnknownKeysOfManyRowsAreNotedUpToAHundred)
{
    std::string text = "{\"segments\": [";
    for (int i = 0; i < 2000; ++i)
        text += std::string(i > 0 ? "," : "") +
                "{\"length_mm\": 1, \"start_diameter_mm\": 9, \"end_diameter_mm\": 9, \"x\": 1}";
    Notes notes;
    readShaft(text + "]}", notes);
    EXPECT_EQ(notes.size(), 100U);
}

TEST(JsonFields, SaysWhichValueIsOutOfRangeWhere)
{
    const Error error = problemOf(shaftText, "\"start_diameter_mm\": 37", "\"start_diameter_mm\": -37");
    EXPECT_EQ(error.code(), errors::keyOutOfRange);
    EXPECT_EQ(*find(error.values(), "key"), Value("start_diameter_mm"));
    EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{6}));
}

TEST(JsonFields, RefusesNumbersThatDoNotExist)
{
    EXPECT_EQ(problemOf(shaftText, "98", "1e999").code(), errors::malformed);
}

}  // namespace
}  // namespace lathelier
