// One of several responses in a file.
#include "engine/io/frf/frf_choice.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/io/frf/frf_codes.h"

namespace lathelier::io {
namespace {

std::vector<MeasuredFrf> responses()
{
    std::vector<MeasuredFrf> all(3);
    all[0].response_node = all[0].reference_node = 101;
    all[1].response_node = 102;
    all[1].reference_node = 101;
    return all;
}

}  // namespace

TEST(FrfChoice, IsByNumberOrNodes)
{
    const std::vector<MeasuredFrf> all = responses();
    EXPECT_EQ(&chosenResponse(all, ""), &all[0]);
    EXPECT_EQ(&chosenResponse(all, " 3 "), &all[2]);
    EXPECT_EQ(&chosenResponse(all, "102/101"), &all[1]);
    EXPECT_EQ(nodePair(all[2]), "");
}

TEST(FrfChoice, SaysWhatThereIs)
{
    const std::vector<MeasuredFrf> all = responses();
    for (const char* word : {"0", "4", "-1", "101", "101/102", "first"}) {
        try {
            chosenResponse(all, word);
            ADD_FAILURE() << word;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("102/101"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(chosenResponse({}, ""), Error);
}

TEST(FrfChoice, ADrivingPointIsPreferred)
{
    std::vector<MeasuredFrf> all(3);
    for (std::size_t k = 0; k < all.size(); ++k) {
        all[k].response_node = static_cast<int>(k == 0 ? 2 : k);
        all[k].reference_node = 1;
        all[k].response_direction = all[k].reference_direction = 3;
    }
    EXPECT_EQ(&preferredResponse(all), &all[1]);
    const Notes notes = notesOfChoice(all, all[1], "f.uff");
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, notes::severalResponses);
    EXPECT_EQ(std::get<std::string>(*find(notes[0].values, "used")), "1z/1z");
    EXPECT_EQ(std::get<std::string>(*find(notes[0].values, "others")), "2z/1z, 2z/1z");
    all[1].response_node = 5;
    EXPECT_EQ(&preferredResponse(all), &all[0]);
    EXPECT_TRUE(contains(notesOfChoice(all, all[0], "f.uff"), notes::noDrivingPoint));
    EXPECT_TRUE(notesOfChoice({all.data(), 1}, all[0], "f.uff").empty());
}

}  // namespace lathelier::io
