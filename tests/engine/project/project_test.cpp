#include "engine/project/project.h"
#include "engine/io/io_codes.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "engine/project/migration.h"
#include "engine/project/project_codes.h"
#include "engine/project/project_json.h"
#include "tests/scratch_folder.h"

namespace lathelier {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed afterwards.
class ProjectFiles : public testing::Test {
protected:
    ProjectFiles() { fs::create_directories(folder / "data"); }

    std::string write(const std::string& name, const std::string& content) const
    {
        std::ofstream(folder / name, std::ios::binary) << content;
        return (folder / name).string();
    }

    ScratchFolder scratch;
    fs::path folder = scratch.path();
};

project::Project sampleProject(const fs::path& folder)
{
    project::Project project;
    project.title = "Wał – kopia „2”";
    project::PanelState& panel = project.panels["compare"];
    panel.inputs["reference"] = {(folder / "data/original.ply").string(), {{"unit", "mm"}}, io::sha256("abc"), true};
    panel.inputs["copy"] = {(folder.parent_path() / "elsewhere/copy.ply").string(), {}, "", false};
    panel.parameters = {{"tolerance_mm", 0.1},        {"pass_percent", std::int64_t{95}},
                        {"max_distance_mm", Value()}, {"exclude_z_mm", std::vector<Interval>{{1, 2}, {3, 4.5}}},
                        {"method", "auto"},           {"of_another_version", true}};
    project.report = {"compare"};
    project.name = "Wał";
    project.shop = {{"machine", "small"}, {"overhang_mm", 0.1}};
    project.others.resize(2);
    project.others[0].name = "Pin";
    project.others[0].panels["roundness"].inputs["record"] = {(folder / "data/pin.csv").string(), {}, "", false};
    project.others[0].title_block = {{"serial", "17"}};
    project.others[1].items["bar"] = {"shaft", {{"bore_mm", 1.0 / 3}}, {"shaft", "1", "ab", {"cd"}}};
    project.others[1].views["compare"] = {{"hero", "map"}};
    project.others[1].report = {"shaft"};
    project.place = 1;
    return project;
}

TEST_F(ProjectFiles, RoundTrip)
{
    const project::Project project = sampleProject(folder);
    const std::string path = (folder / "shaft.lathelier").string();
    project::writeProject(path, project);
    EXPECT_EQ(project::readProject(path).project, project);
}

TEST_F(ProjectFiles, PathsAreRelativeOnDiskAndFollowTheFolder)
{
    const std::string path = (folder / "shaft.lathelier").string();
    project::writeProject(path, sampleProject(folder));
    const Json json = Json::parse(std::ifstream(path));
    EXPECT_EQ(json["version"], project::projectVersion);
    const Json& inputs = json["parts"][1]["panels"]["compare"]["inputs"];
    EXPECT_EQ(json["parts"][0]["panels"]["roundness"]["inputs"]["record"]["path"], "data/pin.csv");
    EXPECT_EQ(json["shown"], 1);
    EXPECT_EQ(inputs["reference"]["path"], "data/original.ply");
    EXPECT_EQ(inputs["copy"]["path"], "../elsewhere/copy.ply");

    fs::create_directories(folder / "moved");
    fs::rename(path, folder / "moved/shaft.lathelier");
    const project::Project moved = project::readProject((folder / "moved/shaft.lathelier").string()).project;
    EXPECT_EQ(moved.panels.at("compare").inputs.at("reference").path, (folder / "moved/data/original.ply").string());
}

TEST_F(ProjectFiles, SaysWhichSourcesChangedOrAreMissing)
{
    const std::string path = (folder / "shaft.lathelier").string();
    project::writeProject(path, sampleProject(folder));
    write("data/original.ply", "abc");
    Notes notes = project::checkSources(project::readProject(path).project);
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_EQ(notes[0].code, notes::sourceMissing);
    EXPECT_EQ(*find(notes[0].values, "path"), Value((folder / "data/pin.csv").string()));  // of a part not shown
    EXPECT_EQ(notes[1].code, notes::sourceMissing);
    EXPECT_EQ(*find(notes[1].values, "path"), Value((folder.parent_path() / "elsewhere/copy.ply").string()));

    write("data/original.ply", "abcd");
    notes = project::checkSources(project::readProject(path).project);
    EXPECT_TRUE(contains(notes, notes::sourceChanged));
}

TEST_F(ProjectFiles, AFailedSaveLeavesTheOldFileWhole)
{
    const std::string path = write("shaft.lathelier", "old");
    EXPECT_THROW(project::writeProject((folder / "no such folder/shaft.lathelier").string(), {}), Error);
    EXPECT_EQ(io::FileBytes(path).view(), "old");
}

TEST_F(ProjectFiles, AMissingOrEmptyFileIsLocated)
{
    try {
        project::readProject((folder / "none.lathelier").string());
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::fileNotFound);
        EXPECT_TRUE(find(error.values(), "path"));
    }
    EXPECT_THROW(project::readProject(write("empty.lathelier", "")), Error);
    EXPECT_THROW(project::readProject(folder.string()), Error);
}

struct Wrong {
    std::string text;
    ErrorCode code;
    std::int64_t line;
    std::int64_t column;
};

std::string manyMembers(int count)
{
    std::string result;
    for (int i = 0; i < count; ++i) result += (i ? ", \"" : "\"") + std::to_string(i) + "\": {}";
    return result;
}

std::string manyRanges(int count)
{
    std::string result;
    for (int i = 0; i < count; ++i) result += i ? ", [0, 1]" : "[0, 1]";
    return result;
}

TEST(ProjectText, HostileTextIsRefusedWithItsPlace)
{
    const std::string head = "{\"format\": \"lathelier-project\", \"version\": 1,\n";
    const std::string present = "{\"format\": \"lathelier-project\", \"version\": 7,\n";
    const Wrong cases[] = {
        {"{", errors::malformed, 1, 2},
        {"not json", errors::malformed, 1, 2},
        {"[]", errors::malformed, 1, 1},
        {"{}", errors::malformed, 1, 1},
        {"{\"format\": \"other\"}", errors::malformed, 1, 12},
        {"{\"format\": \"lathelier-project\", \"version\": 0}", errors::malformed, 1, 44},
        {"{\"format\": \"lathelier-project\", \"version\": \"1\"}", errors::malformed, 1, 44},
        {head + "\"title\": 7}", errors::malformed, 2, 10},
        {head + "\"tilte\": \"ł\"}", errors::malformed, 2, 10},
        {head + "\"title\": \"łłł\", \"report\": [\"a\",\n {\"b\": 1}]}", errors::malformed, 3, 2},
        {head + "\"panels\": {\"compare\": {\"parameters\": {\"x\": {\"y\": 1}}}}}", errors::malformed, 2, 44},
        {head + "\"panels\": {\"compare\": {\"parameters\": {\"x\": 18446744073709551615}}}}", errors::malformed, 2,
         44},
        {head + "\"panels\": {\"compare\": {\"inputs\": {\"copy\": \"c.ply\"}}}}", errors::malformed, 2, 43},
        {head + "\"title\": 1e999}", errors::malformed, 2, 14},
        {head + "\"panels\": {" + manyMembers(1001) + "}}", errors::malformed, 2, 11},
        {head + "\"panels\": {\"compare\": {\"inputs\": {" + manyMembers(1001) + "}}}}", errors::malformed, 2, 34},
        {head + "\"panels\": {\"compare\": {\"parameters\": {\"x\": [" + manyRanges(10001) + "]}}}}", errors::malformed,
         2, 44},
        {present + "\"panels\": {}}", errors::malformed, 2, 11},
        {present + "\"parts\": {}}", errors::malformed, 2, 10},
        {present + "\"parts\": [" + manyRanges(1001) + "]}", errors::malformed, 2, 10},
        {present + "\"parts\": [{}, {\"panels\": {" + manyMembers(1001) + "}}]}", errors::malformed, 2, 26},
        {present + "\"parts\": [{\"nmae\": \"\"}]}", errors::malformed, 2, 20},
        {present + "\"parts\": [{}],\n\"shown\": 1}", errors::malformed, 3, 10},
        {present + "\"shown\": -1}", errors::malformed, 2, 10},
        {present + "\"shop\": []}", errors::malformed, 2, 9},
        {head + "\"parts\": []}", errors::malformed, 2, 10},
        {std::string(40, '['), errors::malformed, 1, 33},
        {std::string(1000000, '['), errors::malformed, 1, 33},
    };
    for (const Wrong& wrong : cases) {
        SCOPED_TRACE(wrong.text.substr(0, 120));
        try {
            project::parseProject(wrong.text, "/");
            ADD_FAILURE() << "accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), wrong.code);
            EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "line")), wrong.line) << error.what();
            EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "column")), wrong.column) << error.what();
        }
    }
}

TEST(ProjectText, ANewerVersionIsRefusedByItsNumber)
{
    try {
        project::parseProject(R"({"format": "lathelier-project", "version": 8, "unheard_of": 1})", "/");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::versionTooNew);
        EXPECT_STREQ(error.what(), "The project has format version 8; this program reads up to version 7.");
    }
}

TEST(ProjectText, EverythingButFormatAndVersionMayBeMissing)
{
    EXPECT_EQ(project::parseProject(R"({"format": "lathelier-project", "version": 1})", "/"), project::Project{});
}

TEST(ProjectText, MigrationRunsTheStepsFromTheVersionOn)
{
    const std::vector<project::MigrationStep> steps{[](Json& json) { json["steps"] += "1"; },
                                                    [](Json& json) { json["steps"] += "2"; }};
    Json json{{"version", 2}, {"steps", Json::array()}};
    project::migrate(json, 2, steps);
    EXPECT_EQ(json, (Json{{"version", 3}, {"steps", {"2"}}}));
    EXPECT_EQ(static_cast<int>(project::migrationSteps().size()) + 1, project::projectVersion);
}

TEST(ProjectText, AnyChangedByteIsReadOrRefusedButNothingElse)
{
    const std::string text = project::toJsonText(sampleProject("/work"), "/work");
    rc::check([&] {
        std::string changed = text;
        changed[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::arbitrary<char>();
        try {
            project::parseProject(changed, "/work");
        } catch (const Error& error) {
            RC_ASSERT(error.code().kind == ErrorKind::InputRejected);
        }
    });
}

}  // namespace
}  // namespace lathelier
