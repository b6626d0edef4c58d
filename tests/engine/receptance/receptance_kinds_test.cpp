// Files of shafts, spindles and tap tests are distinguished from each other and from other kinds.
#include <gtest/gtest.h>

#include "engine/io/json/json_head.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle/spindle_kind.h"

namespace lathelier::receptance {
namespace {

using io::shaftFiles;

using io::Likeness;

const io::FileKinds& kinds()
{
    static const io::FileKinds all{&shaftFiles(),    &spindleFiles(), &measurementFiles(),    &io::profileFiles(),
                                   &io::scanFiles(), &io::frfFiles(), &io::probeRecordFiles()};
    return all;
}

std::string kindOf(const std::string& path, std::string_view head)
{
    const io::KindFound found = io::likeliestKind(kinds(), path, head, {});
    return found.kind ? found.kind->key : "none";
}

TEST(ReceptanceKinds, AreToldByTheirKeys)
{
    EXPECT_EQ(kindOf("a.json", R"( {"schema": "lathelier-shaft", "segments": [{"length_mm": 1}]})"), "shaft");
    EXPECT_EQ(kindOf("a.json", "\xEF\xBB\xBF{\"segments\": []}"), "shaft");
    EXPECT_EQ(kindOf("a.json", R"({"springs": {"radial_N_mm": 1}})"), "spindle");
    EXPECT_EQ(kindOf("a.json", R"({"frequency_hz": [1], "H_mm_N": [[1, 0]]})"), "spindle");
    EXPECT_EQ(kindOf("a.json", R"({"frequency_hz": [1, 2, 3)"), "spindle");
    EXPECT_EQ(kindOf("a.json", R"({"frf": "a.uff", "rods": [{"length_mm": 1}]})"), "measurements");
}

TEST(ReceptanceKinds, AreNoOtherJson)
{
    EXPECT_EQ(kindOf("a.json", R"({"title": "job", "shaft": {"segments": []}})"), "none");
    EXPECT_EQ(kindOf("a.json", R"({"command": "spindle", "frequency_hz": [1]})"), "none");
    EXPECT_EQ(kindOf("a.json", R"({"name": "a \"segments\": {\"segments\": 1}"})"), "none");
    EXPECT_EQ(kindOf("a.json", R"(["segments", {"segments": 1}])"), "none");
    EXPECT_EQ(kindOf("a.json", "{"), "none");
    EXPECT_EQ(kindOf("a.json", ""), "none");
}

TEST(ReceptanceKinds, KnowAStockByItsFiveColumns)
{
    EXPECT_EQ(kindOf("stock.txt", "# bar\n\n17 0 17 0 287.5\n"), "shaft");
    EXPECT_EQ(kindOf("stock", "20 0 20 0 250\n20 3 10 3 5\n10 0 10 0 0\n"), "shaft");
    EXPECT_EQ(kindOf("stock.xyz", "17 0 17 0 287.5\n"), "scan");         // a name that says what it is
    EXPECT_EQ(kindOf("a.txt", "17 0 17 287.5\n"), "scan");               // four columns
    EXPECT_EQ(kindOf("a.txt", "17 0 -17 0 287.5\n"), "scan");            // no radius
    EXPECT_EQ(kindOf("a.txt", "17 18 17 0 287.5\n"), "scan");            // a bore wider than the shaft
    EXPECT_EQ(kindOf("a.txt", "17 0 17 0 287.5\nx y z i j\n"), "scan");  // words
    std::string cloud;
    for (int i = 0; i < 1000; ++i) cloud += "17 0 17 0 2\n";
    EXPECT_EQ(kindOf("a.txt", cloud), "scan");
}

TEST(ReceptanceKinds, SayWhatTheyUnderstood)
{
    const auto facts = [](const io::FileKind& kind, const std::string& text, Notes& notes) {
        io::InputFiles inputs;
        const Values reading;
        return kind.facts({"there", text, reading, inputs, {}}, notes);
    };
    Notes notes;
    const io::FileFacts stock = facts(shaftFiles(), "17 0 17 0 287.5\n20 0 20 0 12.5\n", notes);
    EXPECT_EQ(stock.format, "stock");
    EXPECT_EQ(*find(stock.details, "segments"), Value(std::int64_t{2}));
    EXPECT_EQ(*find(stock.details, "length_mm"), Value(300.0));
    EXPECT_EQ(*find(stock.details, "largest_diameter_mm"), Value(40.0));
    EXPECT_EQ(find(stock.details, "material"), nullptr);
    const io::FileFacts table = facts(spindleFiles(),
                                      R"({"frequency_hz": [1, 2], "H_mm_N": [[1, 0], [1, 0]],)"
                                      R"( "L_mm_Nmm": [[0, 0], [0, 0]], "P_rad_Nmm": [[1, 0], [1, 0]]})",
                                      notes);
    EXPECT_EQ(table.format, "spindle_json");
    EXPECT_EQ(*find(table.details, "lines"), Value(std::int64_t{2}));
    EXPECT_EQ(*find(table.details, "to_hz"), Value(2.0));
    EXPECT_TRUE(notes.empty());
    facts(shaftFiles(),
          R"({"segments": [{"length_mm": 1, "start_diameter_mm": 1, "end_diameter_mm": 1}], "colour": 1})", notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(*find(notes[0].values, "path"), Value(std::string("there")));
}

TEST(JsonHead, GivesTheKeysAsFarAsItReaches)
{
    using Keys = std::vector<std::string>;
    EXPECT_EQ(io::keysOfHead(R"({"a": {"b": [1, "c"]}, "d" : 2, "e)"), (Keys{"a", "d"}));
    EXPECT_EQ(io::keysOfHead(R"({"a": "{\"", "b": 1})"), (Keys{"a", "b"}));
    EXPECT_EQ(io::keysOfHead("nothing"), Keys{});
    EXPECT_EQ(io::keysOfHead("{\"a"), Keys{});
    EXPECT_EQ(io::keysOfHead("{\"a\\"), Keys{});
}

}  // namespace
}  // namespace lathelier::receptance
