// Tasks with made inputs: files and items by role, what an error leaves behind, one object for every caller.
#include "engine/task/task.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "tests/scratch_folder.h"

namespace lathelier::task {
namespace {

/// A file that holds one line; "bad" is refused.
struct LineFile {
    std::string line;
    Notes notes;
};

struct LineInput {
    using File = LineFile;
    using Value = std::string;
    static constexpr const char* item = "line";

    static File read(const io::FileToRead& file)
    {
        if (file.bytes == "bad") throw Error(errors::malformed, {{"found", "bad"}});
        if (file.bytes.starts_with("see "))  // names a further file
            return {std::string(file.inputs.open(std::string(file.bytes.substr(4)))), {}};
        return {std::string(file.bytes), {{notes::syntheticData, {}}}};
    }
    static Value valueOf(const File& file) { return file.line; }
    static io::FileKinds kinds() { return {}; }
    static std::optional<Value> ofItem(const Values& values)
    {
        const lathelier::Value* text = find(values, "text");
        return text ? std::optional(std::get<std::string>(*text)) : std::nullopt;
    }
};

struct JoinQuestion {
    std::string between = "+";
    std::string draft;
};

const std::vector<Field<JoinQuestion>>& fieldsOf(const JoinQuestion*)
{
    static const auto all = [] {
        auto list = described<JoinQuestion>(
            field("between", &JoinQuestion::between, Label{{"Between"}, {"Stands between both."}}),
            field("draft", &JoinQuestion::draft, Label{{"Draft"}, {"In place of both."}}));
        list.back().info.is_kept = true;
        return list;
    }();
    return all;
}

const Task& joinTask()
{
    static const Task task = [] {
        Task made;
        made.key = "join";
        made.inputs = {input<LineInput>("first", "", {"First"}, {"The first line."}),
                       optionalInput<LineInput>("second", "second", {"Second"}, {"The second line."})};
        askFor<JoinQuestion>(made);
        made.run = [](const project::PanelState& state, const Wanted&, Stores& stores, Sources& sources,
                      const Progress& progress) {
            const auto question = fromValues<JoinQuestion>(state.parameters);
            std::string all = *take<LineInput>(state, "first", stores, progress, sources);
            if (auto second = take<LineInput>(state, "second", stores, progress, sources))
                all += question.between + *second;
            Outcome outcome;
            outcome.notes = sources.notes;
            outcome.json = [all] { return Json{{"joined", all}}; };
            outcome.report = [](const Language&) { return report::Document{}; };
            return outcome;
        };
        return made;
    }();
    return task;
}

class TaskTest : public ::testing::Test {
protected:
    std::string write(const char* name, const std::string& text)
    {
        const std::string path = (folder_.path() / name).string();
        io::writeFile(path, text);
        return path;
    }
    Outcome run() { return joinTask().run(state_, {}, stores_, sources_, {}); }

    ScratchFolder folder_;
    project::PanelState state_;
    Stores stores_;
    Sources sources_;
};

TEST_F(TaskTest, TakesFilesAndItems)
{
    state_.inputs["first"].path = write("a.txt", "one");
    state_.inputs["second"].item = "kept";
    state_.items["second"] = {"line", {{"text", std::string("two")}}, {}};
    set(state_.parameters, "between", std::string("-"));
    const Outcome outcome = run();
    EXPECT_EQ(outcome.json()["joined"], "one-two");
    ASSERT_EQ(sources_.inputs.size(), 2u);
    EXPECT_EQ(sources_.inputs[1].path, "kept");
    EXPECT_TRUE(sources_.synthetic);
    const Json whole = resultOf(joinTask(), state_, sources_, outcome);
    EXPECT_EQ(whole["command"], "join");
    EXPECT_EQ(whole["parameters"]["second"], "kept");
    EXPECT_EQ(whole["parameters"]["between"], "-");
    EXPECT_FALSE(whole["parameters"].contains("draft")) << "nothing is kept";
    set(state_.parameters, "draft", std::string("changed"));
    EXPECT_EQ(parametersOf(joinTask(), state_).size(), parametersOf(joinTask(), {}).size() + 1);
    EXPECT_EQ(documentOf(joinTask(), state_, sources_, outcome).inputs.size(), 2u);
}

TEST_F(TaskTest, AnErrorNamesItsSourceAndLeavesWhatWasRead)
{
    state_.inputs["first"].path = write("a.txt", "one");
    state_.inputs["second"].path = write("b.txt", "bad");
    try {
        run();
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::get<std::string>(*find(error.values(), "path")), state_.inputs["second"].path);
    }
    ASSERT_EQ(sources_.inputs.size(), 1u);
    EXPECT_EQ(sources_.notes.size(), 1u);
}

TEST_F(TaskTest, AnItemThatIsNotThereIsNamed)
{
    state_.inputs["first"].item = "gone";
    EXPECT_THROW(run(), Error);
    state_.items["first"] = {"another kind", {}, {}};
    try {
        run();
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(error.code() == errors::itemNotThere);
    }
    state_.items["first"] = {"line", {}, {}};  // of the kind, but without its values
    EXPECT_THROW(run(), Error);
}

TEST_F(TaskTest, FilesNamedInFilesAreInputs)
{
    const std::string inner = write("inner.txt", "deep");
    state_.inputs["first"].path = write("a.txt", "see " + inner);
    EXPECT_EQ(run().json()["joined"], "deep");
    ASSERT_EQ(sources_.inputs.size(), 2u);
    EXPECT_EQ(sources_.inputs[1].path, inner);
}

TEST_F(TaskTest, AFileIsReadOnce)
{
    state_.inputs["first"].path = write("a.txt", "one");
    EXPECT_EQ(run().json()["joined"], "one");
    write("a.txt", "other");
    EXPECT_EQ(run().json()["joined"], "one") << "as the user has seen it";
    EXPECT_TRUE(stores_.forgetChanged());
    EXPECT_EQ(run().json()["joined"], "other");
}

/// On the command line a file gives what a window edits: nothing, the table, or the name of the file is stated.
TEST_F(TaskTest, AFieldMayComeFromAFile)
{
    Task task = joinTask();
    task.inputs.push_back(optionalInput<LineInput>("line", "between", {"Between"}, {"From a file."}));
    ASSERT_EQ(task.fileOf(task.fields.front()), &task.inputs.back());
    EXPECT_EQ(task.fileOf(task.fields.back()), nullptr);
    const auto stated = [&] { return *find(parametersOf(task, state_), "between"); };
    EXPECT_EQ(stated(), Value());
    set(state_.parameters, "between", std::string("-"));
    EXPECT_EQ(stated(), Value(std::string("-")));
    state_.inputs["line"].path = "b.txt";
    EXPECT_EQ(stated(), Value(std::string("b.txt")));
    EXPECT_EQ(parametersOf(task, state_).size(), parametersOf(joinTask(), state_).size());
}

TEST_F(TaskTest, TheStateIsStatedAsTheCommandLineHasIt)
{
    state_.inputs["first"].path = write("a.txt", "one");
    Outcome outcome = run();
    outcome.stated = state_;
    set(outcome.stated->parameters, "between", std::string("*"));
    EXPECT_EQ(resultOf(joinTask(), state_, sources_, outcome)["parameters"]["between"], "*");
    outcome.json = {};
    EXPECT_TRUE(documentOf(joinTask(), state_, sources_, outcome).results.empty());
}

}  // namespace
}  // namespace lathelier::task
