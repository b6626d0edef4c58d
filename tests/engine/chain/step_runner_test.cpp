// The runner of steps with test tasks: steps run, reused steps, result of a dry run.
#include "engine/chain/step_runner.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/chain/chain_codes.h"
#include "engine/chain/dossier_read.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/report/result_json.h"
#include "tests/scratch_folder.h"

namespace lathelier::chain {
namespace {

/// Test tasks and the files of a chain.
struct Workshop {
    ScratchFolder scratch;
    std::string folder = (scratch / "chain").string();
    std::string scan = (scratch / "scan.txt").string();
    std::vector<std::string> asked;
    std::map<std::string, task::Task> tasks;
    std::shared_ptr<const Dossier> earlier;

    Workshop() { io::writeFile(scan, "1 2 3\n"); }

    /// Copies its operands to its outputs; refuses marked operands.
    task::Outcome run(const task::Task& task, const project::PanelState& state, const task::Wanted& wanted,
                      task::Sources& sources)
    {
        asked.push_back(task.key);
        std::string text;
        for (const auto& [role, source] : state.inputs) {
            const io::FileBytes bytes(source.path);
            text += bytes.view();
            sources.inputs.push_back(
                {source.path, static_cast<std::int64_t>(bytes.view().size()), io::sha256(bytes.view())});
        }
        task::Outcome outcome;
        const bool is_soft = wanted.has("hard") && text.find("soft") != std::string::npos;
        if (text.find("refuse") != std::string::npos)
            outcome.errors.emplace_back(errors::fileEmpty, Values{{"path", state.inputs.begin()->second.path}});
        else if (is_soft)
            outcome.errors.emplace_back(errors::chainInputMissing, Values{{"what", std::string("steel")}});
        for (const std::string& option : wanted.exports)
            if (outcome.errors.empty())
                outcome.writers[option] = [text, key = task.key](const std::string& path, const Language&,
                                                                 const Progress&) {
                    if (text.find("stop") != std::string::npos) {
                        io::writeFile(path, "half of it");
                        throw Cancelled{};
                    }
                    io::writeFile(path, key + ": " + text);
                };
        outcome.notes = {{notes::unitGuessed, {{"unit", "mm"}}}};
        outcome.json = [text] { return Json{{"length_mm", static_cast<double>(text.size())}}; };
        return outcome;
    }

    const task::Task* taskNamed(const std::string& key)
    {
        task::Task& task = tasks[key];
        if (task.run) return &task;
        task.key = key;
        task.inputs = {{"file", "", "FILE", {}, {}}};
        FieldInfo wish;
        wish.key = "wish";
        wish.kind = FieldInfo::Kind::Word;
        task.fields = {wish};
        task.defaults = {{"wish", std::string()}};
        for (const char* option : {"out", "hard"}) task.exports.push_back({option, {}, {}, {}, {}});
        task.run = [this, &task](const project::PanelState& state, const task::Wanted& wanted, Stores&,
                                 task::Sources& sources, const Progress&) { return run(task, state, wanted, sources); };
        return &task;
    }

    /// Two steps in a row and one beside them.
    Dossier run(RunMode mode, const std::string& wish = "as it is")
    {
        asked.clear();
        StepRunner runner(folder, mode, earlier);
        runner.run({"recognise", taskNamed("read"), {scan}, {}, {{"out", "a.txt"}}}, {});
        runner.run({"draw", taskNamed("draw"), {runner.path("a.txt")}, {{"wish", wish}}, {{"out", "b.txt"}}}, {});
        runner.run({"copy", taskNamed("look"), {scan}, {}, {{"out", "c.txt"}}}, {});
        Dossier dossier = std::move(runner.dossier());
        if (mode != RunMode::DryRun) {
            io::writeFile(folder + "/" + dossierFile, report::toText(wholeDossier(dossier, {}, {})));
            earlier = std::make_shared<const Dossier>(dossier);
        }
        return dossier;
    }
    static std::vector<StepState> statesOf(const Dossier& dossier)
    {
        std::vector<StepState> states;
        for (const ChainStep& step : dossier.steps) states.push_back(step.state);
        return states;
    }
};

using enum StepState;
using States = std::vector<StepState>;
using Names = std::vector<std::string>;

TEST(StepRunner, ALookMakesNothing)
{
    Workshop shop;
    EXPECT_EQ(Workshop::statesOf(shop.run(RunMode::DryRun)), (States{NotReached, NotReached, NotReached}));
    EXPECT_TRUE(shop.asked.empty());
    EXPECT_FALSE(std::filesystem::exists(shop.folder));
}

TEST(StepRunner, WhatIsAsItWasIsTakenOver)
{
    Workshop shop;
    const Dossier first = shop.run(RunMode::Everything);
    EXPECT_EQ(shop.asked, (Names{"read", "draw", "look"}));
    EXPECT_TRUE(checkDossier(shop.folder + "/" + dossierFile).faults.empty());
    const Dossier second = shop.run(RunMode::OutOfDate);
    EXPECT_TRUE(shop.asked.empty());
    EXPECT_EQ(Workshop::statesOf(second), (States{Done, Done, Done}));
    EXPECT_EQ(second.numbers.size(), first.numbers.size());
    EXPECT_EQ(second.notes.size(), first.notes.size());
    shop.run(RunMode::Everything);
    EXPECT_EQ(shop.asked.size(), 3u);
}

TEST(StepRunner, ADossierFromTheDiskIsTakenOverToo)
{
    Workshop shop;
    shop.run(RunMode::Everything);
    auto read = dossierIn(shop.folder);
    ASSERT_TRUE(read);
    shop.earlier = std::make_shared<const Dossier>(*std::move(read));
    const Dossier again = shop.run(RunMode::OutOfDate);
    EXPECT_TRUE(shop.asked.empty());
    const Json json = wholeDossier(again, {}, {});
    ASSERT_EQ(json["notes"].size(), 3u);  // as written, although this process has not run the steps
    EXPECT_EQ(json["assumed"].size(), 3u);
    EXPECT_EQ(json["steps"][0]["remarks"].size(), 1u);
}

TEST(StepRunner, AChangedQuestionRunsTheStepAndWhatFollowsFromIt)
{
    Workshop shop;
    shop.run(RunMode::Everything);
    EXPECT_EQ(Workshop::statesOf(shop.run(RunMode::DryRun, "otherwise")), (States{Done, OutOfDate, Done}));
    EXPECT_TRUE(shop.asked.empty());
    shop.run(RunMode::OutOfDate, "otherwise");
    EXPECT_EQ(shop.asked, Names{"draw"});
}

TEST(StepRunner, AChangedFileRunsAllThatTookIt)
{
    Workshop shop;
    shop.run(RunMode::Everything);
    io::writeFile(shop.scan, "4 5 6 7\n");
    EXPECT_EQ(Workshop::statesOf(shop.run(RunMode::DryRun)), (States{OutOfDate, OutOfDate, OutOfDate}));
    shop.run(RunMode::OutOfDate);
    EXPECT_EQ(shop.asked, (Names{"read", "draw", "look"}));
}

TEST(StepRunner, AFileOfTheChainThatWasChangedIsMadeAnew)
{
    Workshop shop;
    shop.run(RunMode::Everything);
    io::writeFile(shop.folder + "/b.txt", "by hand");
    EXPECT_EQ(Workshop::statesOf(shop.run(RunMode::DryRun)), (States{Done, OutOfDate, Done}));
    shop.run(RunMode::OutOfDate);
    EXPECT_EQ(shop.asked, Names{"draw"});
    EXPECT_NE(io::fileSha256(shop.folder + "/b.txt"), io::sha256("by hand"));
}

TEST(StepRunner, ARefusalStopsTheChainAndWhatWasMadeStays)
{
    Workshop shop;
    shop.run(RunMode::Everything);
    const std::string made = io::fileSha256(shop.folder + "/c.txt");
    io::writeFile(shop.scan, "refuse\n");
    const Dossier dossier = shop.run(RunMode::OutOfDate);
    EXPECT_EQ(Workshop::statesOf(dossier), (States{Failed, NotReached, NotReached}));
    ASSERT_TRUE(dossier.error());
    EXPECT_EQ(std::string(dossier.error()->code().key), "file_empty");
    EXPECT_EQ(io::fileSha256(shop.folder + "/c.txt"), made);
    // A dry run gives the same without running verbs; a run tries again.
    EXPECT_EQ(Workshop::statesOf(shop.run(RunMode::DryRun)), (States{Failed, NotReached, NotReached}));
    EXPECT_TRUE(shop.asked.empty());
    shop.run(RunMode::OutOfDate);
    EXPECT_EQ(shop.asked, Names{"read"});
}

TEST(StepRunner, AStopBringsBackWhatTheStepHadMade)
{
    Workshop shop;
    shop.run(RunMode::Everything);
    const std::string made = io::fileSha256(shop.folder + "/a.txt"),
                      digest_before = io::fileSha256(shop.folder + "/recognise.json");
    io::writeFile(shop.scan, "stop\n");
    EXPECT_THROW(shop.run(RunMode::OutOfDate), Cancelled);
    EXPECT_EQ(io::fileSha256(shop.folder + "/a.txt"), made);
    EXPECT_EQ(io::fileSha256(shop.folder + "/recognise.json"), digest_before);
    EXPECT_FALSE(std::filesystem::exists(shop.folder + "/.earlier"));
}

TEST(StepRunner, FilesBelowTheFolderAreNamedFromThere)
{
    Workshop shop;
    const std::string given = shop.folder + "/given/job.txt";
    std::filesystem::create_directories(shop.folder + "/given");
    io::writeFile(given, "job\n");
    StepRunner runner(shop.folder, RunMode::Everything, nullptr);
    runner.run({"recognise", shop.taskNamed("read"), {given}, {}, {{"out", "a.txt"}}}, {});
    EXPECT_EQ(runner.dossier().steps.front().inputs.front().path, "given/job.txt");
    const std::string path = shop.folder + "/" + dossierFile;
    io::writeFile(path, report::toText(wholeDossier(runner.dossier(), {}, {})));
    EXPECT_TRUE(checkDossier(path).faults.empty());
    // The folder may be moved.
    const std::string elsewhere = (shop.scratch / "elsewhere").string();
    std::filesystem::rename(shop.folder, elsewhere);
    EXPECT_TRUE(checkDossier(elsewhere + "/" + dossierFile).faults.empty());
}

TEST(StepRunner, TheSameFilesAreTheSameQuestionFromWhereverTheyAreNamed)
{
    namespace fs = std::filesystem;
    Workshop shop;
    const auto requests = [&shop](const std::string& scan) {
        StepRunner runner(shop.folder, RunMode::Everything, nullptr);
        runner.run({"recognise", shop.taskNamed("read"), {scan}, {{"job", scan}}, {{"out", "a.txt"}}}, {});
        runner.make("proof", {"a.txt"},
                    [] {
                        return MadeStep{std::make_shared<const Json>(Json::object()), {}, {}};
                    },
                    {});
        std::vector<std::string> all;
        for (const ChainStep& step : runner.dossier().steps) all.push_back(step.request);
        return all;
    };
    const std::vector<std::string> absolute = requests(shop.scan);
    const fs::path here = fs::current_path();
    fs::current_path(fs::path(shop.scan).parent_path());
    const std::vector<std::string> relative = requests("scan.txt");
    fs::current_path(here);
    EXPECT_EQ(relative, absolute);
}

TEST(StepRunner, AnOutputThatIsRefusedIsLeftOut)
{
    Workshop shop;
    io::writeFile(shop.scan, "soft\n");
    StepRunner runner(shop.folder, RunMode::Everything, nullptr);
    StepRequest step{"recognise", shop.taskNamed("read"), {shop.scan}, {}, {{"out", "a.txt"}}};
    step.outputs_if_possible = {{"hard", "hard.txt"}};
    runner.run(step, {});
    EXPECT_EQ(shop.asked.size(), 2u);
    ASSERT_TRUE(runner.refusal());
    EXPECT_TRUE(runner.isDone("recognise"));
    EXPECT_TRUE(runner.canRead("a.txt"));
    EXPECT_FALSE(runner.canRead("hard.txt"));
}

TEST(StepRunner, AStepThatIsNoTaskFollowsItsFiles)
{
    Workshop shop;
    int made = 0;
    const auto go = [&](RunMode mode) {
        StepRunner runner(shop.folder, mode, shop.earlier);
        runner.write("in.txt", mode == RunMode::DryRun ? "new" : "old");
        runner.make("proof", {"in.txt"},
                    [&] {
                        ++made;
                        return MadeStep{std::make_shared<const Json>(Json{{"largest_normalized_error", 0.5}}), {}, {}};
                    },
                    {});
        Dossier dossier = std::move(runner.dossier());
        if (mode != RunMode::DryRun) shop.earlier = std::make_shared<const Dossier>(dossier);
        return dossier.steps.front().state;
    };
    EXPECT_EQ(go(RunMode::Everything), Done);
    EXPECT_EQ(go(RunMode::OutOfDate), Done);
    EXPECT_EQ(made, 1);
    EXPECT_EQ(go(RunMode::DryRun), OutOfDate);  // its file would be rewritten
    EXPECT_EQ(shop.earlier->numbers.size(), 1u);
}

TEST(StepRunner, AFolderThatCannotBeMadeIsRefused)
{
    Workshop shop;
    EXPECT_THROW(StepRunner(shop.scan + "/chain", RunMode::Everything, nullptr), Error);
}

}  // namespace
}  // namespace lathelier::chain
