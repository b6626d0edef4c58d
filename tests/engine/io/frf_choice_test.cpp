// One of several responses in a file.
#include "engine/io/frf/frf_choice.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"

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

}  // namespace lathelier::io
