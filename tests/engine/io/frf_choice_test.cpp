// One of several responses in a file.
#include "engine/io/frf/frf_choice.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_input.h"
#include "engine/io/frf/frf_writer.h"
#include "tests/engine/io/frf_files.h"

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

TEST(FrfChoice, OfTheDrivingPointsTheMostFlexibleIsTaken)
{
    std::vector<MeasuredFrf> all(3, testing::modeFrf(FrfQuantity::Accelerance));
    for (std::size_t k = 0; k < all.size(); ++k) {
        all[k].response_node = all[k].reference_node = static_cast<int>(k) + 1;
        for (auto& value : all[k].frf.value) value *= k == 1 ? 3.0 : 1.0 + 0.1 * static_cast<double>(k);
    }
    EXPECT_EQ(&preferredResponse(all), &all[1]);
    EXPECT_EQ(&chosenResponse(all, FrfOptions{}), &all[1]);
    FrfOptions options;
    options.response = "3/3";
    EXPECT_EQ(&chosenResponse(all, options), &all[2]);
    all[1].reference_node = 9;  // a cross response is none
    EXPECT_EQ(&preferredResponse(all), &all[2]);
    all[0].frf.value[60] += 1e6;  // one bad line does not make a soft point
    EXPECT_EQ(&preferredResponse(all), &all[2]);
    all[0].frf.value[61] = all[0].frf.value[62] = all[0].frf.value[60];
    EXPECT_EQ(&preferredResponse(all), &all[0]);
    all[0].frf.coherence.assign(all[0].frf.value.size(), 1);
    for (const std::size_t i : {60U, 61U, 62U}) all[0].frf.coherence[i] = 0.3;
    EXPECT_EQ(&preferredResponse(all), &all[2]);
}

TEST(FrfChoice, FlexibilityIsThatOfTheMode)
{
    // min Re of one mode is -1/(4 k ζ (1 + ζ)), near r = √(1 + 2ζ).
    const double expected = 1 / (4 * 1e4 * 0.02 * 1.02);
    for (const FrfQuantity quantity : {FrfQuantity::Receptance, FrfQuantity::Mobility, FrfQuantity::Accelerance})
        EXPECT_NEAR(largestFlexibility(testing::modeFrf(quantity, 4000, 0, 0.1).frf) / expected, 1, 1e-3);
    EXPECT_EQ(largestFlexibility({}), 0);
}

TEST(FrfInput, TheChoiceIsAReadingOption)
{
    std::vector<MeasuredFrf> two(2, testing::modeFrf(FrfQuantity::Receptance));
    two[0].reference_node = 1;
    const std::string bytes = toUff(two);
    InputFiles inputs;
    const auto read = [&](const std::string& choice) {
        return FrfInput::read({"two.uff", bytes, Values{{"response", choice}}, inputs, {}});
    };
    EXPECT_EQ(read("").used, 1U);
    EXPECT_TRUE(contains(read("").notes_of_choice, notes::severalResponses));
    EXPECT_EQ(read("7/1").used, 0U);
    EXPECT_TRUE(read("7/1").notes_of_choice.empty());
    EXPECT_EQ(FrfInput::valueOf(read("1")).value.size(), two[0].frf.value.size());
    EXPECT_THROW(read("9/9"), Error);
}

}  // namespace lathelier::io
