// The library of inserts and holders.
#include "engine/cutting/tool_library.h"

#include <gtest/gtest.h>

#include "../core/code_of_error.h"
#include "engine/io/io_codes.h"

namespace lathelier::cutting {
namespace {

TEST(ToolLibrary, EveryInsertIsAChoice)
{
    const std::vector<FieldChoice> choices = insertChoices(Text{"as stated"});
    ASSERT_EQ(choices.size(), toolLibrary().inserts.size() + 1);
    EXPECT_EQ(choices.front().key, statedChoice);
    EXPECT_EQ(choices.front().label, Text{"as stated"});
    EXPECT_EQ(choices[1].key, "cnmg_120404");
    EXPECT_EQ(choices[1].label, Text{"CNMG 120404, 95°"});
}

TEST(ToolLibrary, FormerKeysAreRead)
{
    const ToolLibrary library = readToolLibrary(R"({"inserts": [{"key": "rcmx_100300", "lead_angle_deg": 45,
        "nose_radius_mm": 5, "tip_angle_deg": 90, "source": "ours"}]})",
                                                R"({"holders": []})");
    EXPECT_EQ(library.inserts[0].value.entering_angle_deg, 45);
    EXPECT_EQ(library.inserts[0].value.corner_radius_mm, 5);
    EXPECT_EQ(insertChoices({}, library)[1].label, Text{"RCMX 100300, 45°"});
}

TEST(ToolLibrary, WhatAnEntryLacksIsNamed)
{
    EXPECT_EQ(codeOfError([] {
                  readToolLibrary(
                      R"({"inserts": [{"key": "a", "corner_radius_mm": 1, "tip_angle_deg": 80, "source": ""}]})",
                      R"({"holders": []})");
              }),
              errors::keyMissing);
    EXPECT_EQ(codeOfError([] {
                  readToolLibrary(R"({"inserts": []})", R"({"holders": [{"key": "a", "name": "A", "source": ""}]})");
              }),
              errors::keyMissing);
}

}  // namespace
}  // namespace lathelier::cutting
