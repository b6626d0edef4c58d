#include "engine/batch/part_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/batch/number_task.h"

namespace lathelier::batch {
namespace {

using testing::ElementsAre;

std::vector<std::string> namesOf(const std::vector<Part>& parts)
{
    std::vector<std::string> names;
    for (const Part& part : parts) names.push_back(std::filesystem::path(part.name()).filename().string());
    return names;
}

Recipe pairRecipe()
{
    project::PanelState state;
    state.inputs["first"].path = "a";
    state.inputs["second"].path = "b";
    return recipeOf(pairTask(), state);
}

Error errorIn(const std::function<void()>& work)
{
    try {
        work();
    } catch (const Error& error) {
        return error;
    }
    return Error(ErrorCode{"none", ErrorKind::NoAnswer, {}}, {});
}

TEST(PartList, a_folder_gives_its_own_files_in_byte_order)
{
    const ScratchFolder folder;
    for (const char* name : {"b.txt", "B.txt", "a10.txt", "a9.txt", ".hidden", "sub/c.txt"})
        writeText(folder / "parts" / name, "1");
    const Recipe recipe = numberRecipe(folder);
    EXPECT_THAT(namesOf(partsOf({(folder / "parts").string()}, recipe)),
                ElementsAre("B.txt", "a10.txt", "a9.txt", "b.txt"));
}

TEST(PartList, a_record_in_two_files_is_one_part)
{
    const ScratchFolder folder;
    for (const char* name : {"a.dat", "a.par", "b.par", "c.txt"}) writeText(folder / "parts" / name, "1");
    EXPECT_THAT(namesOf(partsOf({(folder / "parts").string()}, numberRecipe(folder))),
                ElementsAre("a.dat", "b.par", "c.txt"));
}

TEST(PartList, a_list_names_files_beside_it)
{
    const ScratchFolder folder;
    const std::vector<std::string> paths = writeParts(folder, 3);
    writeText(folder / "list.txt", "\n  parts/p002.txt\r\n\nparts/none.txt\n" + paths[0] + "\n");
    const std::vector<Part> parts = partsOf({(folder / "list.txt").string()}, numberRecipe(folder));
    EXPECT_THAT(namesOf(parts), ElementsAre("p002.txt", "none.txt", "p000.txt"));
    EXPECT_EQ(parts[0].name(), (folder / "parts" / "p002.txt").string());
}

TEST(PartList, a_file_that_names_no_file_is_a_part)
{
    const ScratchFolder folder;
    writeText(folder / "scan.txt", "1 2 3\n");
    writeText(folder / "blank.txt", " \n\n");
    EXPECT_THAT(namesOf(partsOf({(folder / "scan.txt").string(), (folder / "blank.txt").string(), "missing.txt"},
                                numberRecipe(folder))),
                ElementsAre("scan.txt", "blank.txt", "missing.txt"));
}

TEST(PartList, groups_fill_the_roles)
{
    const ScratchFolder folder;
    writeParts(folder, 3);
    writeText(folder / "pairs.jsonl",
              "{\"inputs\": {\"second\": \"parts/p001.txt\", \"first\": \"parts/p000.txt\"}}\n"
              "{\"inputs\": {\"first\": \"parts/p002.txt\", \"second\": \"parts/none.txt\"}}\n");
    const std::vector<Part> pairs = partsOf({(folder / "pairs.jsonl").string()}, pairRecipe());
    ASSERT_EQ(pairs.size(), 2U);
    EXPECT_EQ(pairs[0].files[0].first, "first");
    EXPECT_EQ(std::filesystem::path(pairs[0].files[1].second).filename(), "p001.txt");
    writeText(folder / "several.jsonl", "{\"inputs\": {\"part\": [\"parts/p000.txt\", \"parts/p001.txt\"]}}\n");
    const std::vector<Part> several = partsOf({(folder / "several.jsonl").string()}, numberRecipe(folder));
    ASSERT_EQ(several.size(), 1U);
    EXPECT_EQ(several[0].files[1].first, "part.2");
}

TEST(PartList, wrong_groups_are_refused_by_their_line)
{
    const ScratchFolder folder;
    writeParts(folder, 1);
    const std::string good = "{\"inputs\": {\"first\": \"parts/p000.txt\", \"second\": \"parts/p000.txt\"}}\n";
    const auto codeOf = [&](const std::string& line) {
        writeText(folder / "pairs.jsonl", good + line);
        const Error error = errorIn([&] { partsOf({(folder / "pairs.jsonl").string()}, pairRecipe()); });
        EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{2})) << error.what();
        return std::string(error.code().key);
    };
    EXPECT_EQ(codeOf("{\"inputs\": {\"first\": \"a\"}}"), "key_missing");
    EXPECT_EQ(codeOf("{\"inputs\": {\"first\": \"a\", \"second\": \"b\", \"third\": \"c\"}}"), "recipe_member_unknown");
    EXPECT_EQ(codeOf("{\"inputs\": {\"first\": [\"a\"], \"second\": \"b\"}}"), "malformed");
    EXPECT_EQ(codeOf("{\"inputs\": "), "malformed");
    EXPECT_EQ(codeOf("parts/p000.txt"), "batch_needs_groups");
}

TEST(PartList, groups_are_asked_as_one_part)
{
    const ScratchFolder folder;
    writeParts(folder, 4);
    writeText(folder / "pairs.jsonl",
              "{\"inputs\": {\"first\": \"parts/p001.txt\", \"second\": \"parts/p002.txt\"}}\n"
              "{\"inputs\": {\"first\": \"parts/p002.txt\", \"second\": \"parts/p001.txt\"}}\n"
              "{\"inputs\": {\"first\": \"parts/p003.txt\", \"second\": \"parts/none.txt\"}}\n");
    const BatchResult result = runBatch({(folder / "pairs.jsonl").string()}, pairRecipe(), into(folder / "out"));
    EXPECT_EQ(result.computed, 2);  // the roles are part of what is asked
    EXPECT_EQ(result.failed(), 1);
}

}  // namespace
}  // namespace lathelier::batch
