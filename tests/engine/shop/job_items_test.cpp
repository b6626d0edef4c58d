// Jobs and set-ups as items of the project: the answer is that of the file with the same content, to the bit.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/cam/check/check_report.h"
#include "engine/cam/job_file.h"
#include "engine/cam/job_item.h"
#include "engine/cam/plan_report.h"
#include "engine/cam/task/check_task.h"
#include "engine/cam/task/turn_task.h"
#include "engine/deflection/deflection_task.h"
#include "engine/deflection/setup_file.h"
#include "engine/gcode/program_input.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "engine/project/project_json.h"
#include "tests/scratch_folder.h"

namespace lathelier::shop {
namespace {

const std::string data = LATHELIER_SOURCE_DIR "/tests/data/";

cam::Job jobNamed(const std::string& name)
{
    const io::FileBytes bytes(data + "turning/" + name + "_job.json");
    Notes notes;
    return cam::readJob(std::string(bytes.view()), notes);
}

/// The item as a project file gives it back.
project::Item throughProject(const char* kind, Values values)
{
    const ScratchFolder folder;
    project::Project project;
    project.items["kept"] = {kind, std::move(values), {}};
    const std::string path = (folder / "p.json").string();
    project::writeProject(path, project);
    return project::readProject(path).project.items.at("kept");
}

project::PanelState withItem(const char* role, const char* kind, Values values)
{
    project::PanelState state;
    state.inputs[role].item = "kept";
    state.items[role] = throughProject(kind, std::move(values));
    return state;
}

project::PanelState withFile(const char* role, const std::string& path)
{
    project::PanelState state;
    state.inputs[role].path = path;
    return state;
}

TEST(JobItem, HasEveryValueOfTheJob)
{
    for (const char* name : {"contour", "neck_all", "tailstock", "bore", "small"}) {
        const cam::Job job = jobNamed(name);
        const auto read = cam::jobOf(throughProject(cam::jobItem, cam::valuesOf(job)).values);
        ASSERT_TRUE(read) << name;
        EXPECT_TRUE(*read == job) << name;
    }
}

TEST(JobItem, WhatIsNoJobIsNone)
{
    EXPECT_FALSE(cam::jobOf({}));
    Values values = cam::valuesOf(jobNamed("contour"));
    set(values, "stock.diameter_mm", -5.0);
    EXPECT_FALSE(cam::jobOf(values));
    values = cam::valuesOf(jobNamed("contour"));
    set(values, "shaft", std::string("round"));
    EXPECT_FALSE(cam::jobOf(values));
    values = cam::valuesOf(jobNamed("contour"));
    std::erase_if(values, [](const auto& value) { return value.first == "tools"; });
    EXPECT_FALSE(cam::jobOf(values));
}

TEST(JobItem, TurnsAsItsFileDoes)
{
    const ScratchFolder folder;
    const cam::Job job = jobNamed("contour");
    const std::string path = (folder / "job.json").string();
    io::writeFile(path, cam::jobText(job));
    const auto turned = [](const project::PanelState& state) {
        Stores stores;
        task::Sources sources;
        return cam::answerTurn(state, false, stores, sources, {});
    };
    const cam::TurnOutcome of_file = turned(withFile(cam::jobRole, path));
    const cam::TurnOutcome of_item = turned(withItem(cam::jobRole, cam::jobItem, cam::valuesOf(job)));
    ASSERT_EQ(of_file.plan->setups.size(), 1U);
    ASSERT_EQ(of_item.plan->setups.size(), 1U);
    ASSERT_FALSE(of_file.plan->setups.front().text.empty());
    EXPECT_EQ(of_item.plan->setups.front().text, of_file.plan->setups.front().text);  // digest in its head included
    EXPECT_EQ(cam::toJson(*of_item.plan).dump(), cam::toJson(*of_file.plan).dump());
    ASSERT_EQ(of_item.sources.inputs.size(), 1U);
    EXPECT_EQ(of_item.sources.inputs.front().path, "kept");
    EXPECT_EQ(of_item.sources.inputs.front().sha256, of_file.sources.inputs.front().sha256);
}

TEST(JobItem, ChecksAsItsFileDoes)
{
    const auto checked = [](project::PanelState state) {
        state.inputs[gcode::programRole].path = data + "turning/contour_fanuc_a.nc";
        Stores stores;
        task::Sources sources;
        return cam::toJson(*cam::answerCheck(state, stores, sources, {}).result).dump();
    };
    EXPECT_EQ(checked(withItem(cam::jobRole, cam::jobItem, cam::valuesOf(jobNamed("contour")))),
              checked(withFile(cam::jobRole, data + "turning/contour_job.json")));
}

TEST(JobItem, WithoutItsShaftItIsNamed)
{
    cam::Job job = jobNamed("contour");
    job.shaft.reset();
    Stores stores;
    task::Sources sources;
    try {
        cam::answerTurn(withItem(cam::jobRole, cam::jobItem, cam::valuesOf(job)), false, stores, sources, {});
        ADD_FAILURE() << "no part";
    } catch (const Error& error) {
        EXPECT_STREQ(error.code().key, "job_without_shaft");
        EXPECT_EQ(*find(error.values(), "path"), Value(std::string("kept")));
    }
}

TEST(JobItem, OfAnotherKindIsRefused)
{
    Stores stores;
    task::Sources sources;
    try {
        cam::answerTurn(withItem(cam::jobRole, "shaft", cam::valuesOf(jobNamed("contour"))), false, stores, sources,
                        {});
        ADD_FAILURE() << "a job of another kind";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::itemNotThere);
    }
}

/// Where a form has tools that were changed from no file, a job that is given as an item still counts.
TEST(JobItem, AFormOfAnotherJobDoesNotRule)
{
    cam::TurningQuestion question;
    question.job = jobNamed("small");
    const project::PanelState state = withItem(cam::jobRole, cam::jobItem, cam::valuesOf(jobNamed("contour")));
    EXPECT_FALSE(cam::formRules(question, state));
    question.job_of = cam::identity(state);
    EXPECT_TRUE(cam::formRules(question, state));
}

deflection::SetupFile caseA()
{
    const std::string path = data + "deflection/case_a_setup.json";
    io::InputFiles inputs;
    const Values reading;
    const Progress progress;
    return deflection::loadSetup({path, inputs.open(path), reading, inputs, progress});
}

TEST(SetupItem, HasEveryValueOfTheSetUpAndItsStock)
{
    const deflection::SetupFile file = caseA();
    ASSERT_TRUE(file.stock);
    const auto read = deflection::setupOf(throughProject(deflection::setupItem, deflection::valuesOf(file)).values);
    ASSERT_TRUE(read);
    deflection::TurningSetup expected = file.setup;
    expected.stock.clear();  // an item has no place from which a path counts
    EXPECT_TRUE(read->setup == expected);
    ASSERT_TRUE(read->stock);
    EXPECT_TRUE(*read->stock == *file.stock);
    EXPECT_FALSE(deflection::setupOf({}));
    Values values = deflection::valuesOf(file);
    set(values, "stock_shaft", 5.0);
    EXPECT_FALSE(deflection::setupOf(values));
}

TEST(SetupItem, DeflectsAsItsFileDoes)
{
    const auto predicted = [](project::PanelState state, deflection::StudyKind kind) {
        state.inputs[gcode::programRole].path = data + "deflection/three_passes.nc";
        Stores stores;
        task::Sources sources;
        const deflection::DeflectionOutcome outcome = deflection::answerDeflection(state, kind, stores, sources, {});
        std::string all = deflection::toJson(*outcome.study).dump();
        if (outcome.study->corrected) all += outcome.study->corrected->text;
        for (const Note& note : outcome.notes) all += note.code.key;
        return all;
    };
    for (const auto kind : {deflection::StudyKind::Prediction, deflection::StudyKind::Correction})
        EXPECT_EQ(
            predicted(withItem(deflection::setupRole, deflection::setupItem, deflection::valuesOf(caseA())), kind),
            predicted(withFile(deflection::setupRole, data + "deflection/case_a_setup.json"), kind));
}

TEST(SetupItem, WithoutAStockItIsNamed)
{
    deflection::HeldSetup held = caseA();
    held.stock.reset();
    project::PanelState state = withItem(deflection::setupRole, deflection::setupItem, deflection::valuesOf(held));
    state.inputs[gcode::programRole].path = data + "deflection/three_passes.nc";
    Stores stores;
    task::Sources sources;
    try {
        deflection::answerDeflection(state, deflection::StudyKind::Prediction, stores, sources, {});
        ADD_FAILURE() << "no stock";
    } catch (const Error& error) {
        EXPECT_STREQ(error.code().key, "stock_missing");
        EXPECT_EQ(*find(error.values(), "path"), Value(std::string("kept")));
    }
}

}  // namespace
}  // namespace lathelier::shop
