// Window and command line give one answer: the object that a panel writes beside its report is that of the task asked
// by operands and options, for the same inputs and parameters. Every panel over a task, with the data of the sample.
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/gui/panels.h"
#include "engine/cam/job_file.h"
#include "engine/cam/task/turn_task.h"
#include "engine/deflection/deflection_task.h"
#include "engine/io/file.h"
#include "engine/project/project_file.h"
#include "engine/sample/sample_files.h"
#include "engine/task/reply.h"
#include "tests/engine/cam/plan_data.h"
#include "tests/widgets/deflection/slender_files.h"

namespace lathelier {

class TaskAnswersTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    project::Project sample_;

    static const PanelFacts& factsOf(const std::string& id)
    {
        const std::vector<PanelFacts>& all = panelTable();
        return *std::find_if(all.begin(), all.end(), [&](const PanelFacts& facts) { return facts.id == id; });
    }

    /// The object of the panel's report.
    static Json ofPanel(const PanelFacts& facts, const project::PanelState& state)
    {
        Stores stores;
        return Json::parse(facts.report(state, stores, {}, {}).results.front());
    }

    /// Of the sample: what the command line can be given.
    project::PanelState stateOf(const PanelFacts& facts) const
    {
        project::PanelState state = project::resolved(sample_, facts.stateKey());
        for (const task::Input& input : facts.task->inputs)
            for (const std::string& key : project::keysOf(state, input.role))
                if (!state.inputs.at(key).item.empty()) state.inputs.erase(key);
        state.items.clear();
        return state;
    }

    static task::Reply ofVerb(const task::Task& task, const project::PanelState& state, const Values& begins_with = {},
                              std::map<std::string, std::string> exports = {})
    {
        task::Request request;
        request.parameters = begins_with;
        for (const auto& [key, value] : state.parameters) set(request.parameters, key, value);
        request.exports = std::move(exports);
        for (const task::Input& input : task.inputs)
            for (const std::string& key : project::keysOf(state, input.role)) {
                const project::Source& source = state.inputs.at(key);
                for (const auto& [name, value] : source.import) set(request.parameters, name, value);
                if (input.option.empty())
                    request.operands.push_back(source.path);
                else
                    set(request.parameters, input.option, source.path);
            }
        return task::reply(task, request, {});
    }

    static void areEqual(const Json& panel, const Json& verb)
    {
        QVERIFY(panel.contains("parameters") && panel.contains("inputs"));
        for (const auto& [key, value] : verb.items())
            if (!panel.contains(key) || panel[key] != value)
                QFAIL((key + ": " + value.dump().substr(0, 400) +
                       "\npanel: " + (panel.contains(key) ? panel[key].dump().substr(0, 400) : std::string("nothing")))
                          .c_str());
        QCOMPARE(panel.size(), verb.size());
    }

    std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }

private slots:
    void initTestCase()
    {
        const std::vector<std::string> files = sample::writeSample(folder_.path().toStdString());
        sample_ = project::readProject(files.back()).project;
    }

    void everyPanelOverATask_data()
    {
        QTest::addColumn<QString>("id");
        int count = 0;
        for (const PanelFacts& facts : panelTable()) {
            if (!facts.task) continue;
            if (facts.missing && !facts.missing(stateOf(facts)).empty()) continue;  // the sample gives it items only
            QTest::newRow(facts.id.c_str()) << QString::fromStdString(facts.id);
            ++count;
        }
        QVERIFY(count >= 15);
    }

    void everyPanelOverATask()
    {
        QFETCH(QString, id);
        const PanelFacts& facts = factsOf(id.toStdString());
        const task::Task& task = *facts.task;
        const project::PanelState state = stateOf(facts);
        areEqual(ofPanel(facts, state), task::resultOf(task, ofVerb(task, state, facts.begins_with)));
    }

    void deflectionWithASpindleAndAnInsertOfTheLibrary()
    {
        project::PanelState state;
        deflection_common::giveSlenderFiles(folder_, state);
        io::writeFile(path("stiff.json"), R"({"springs": {"radial_N_mm": 50000, "tilt_N_mm_rad": 1e9,
                                                          "loss_factor": 0.02}})");
        state.inputs[deflection::spindleRole].path = path("stiff.json");
        state.parameters = {{"tolerance_um", 30.0}, {"changed_insert", std::string("dnmg_150608")}, {"band", true}};
        const task::Task& task = deflection::deflectionTask();
        const Json panel = ofPanel(factsOf("deflection"), state);
        areEqual(panel, task::resultOf(task, ofVerb(task, state)));
        QCOMPARE(panel["parameters"]["spindle"].get<std::string>(), path("stiff.json"));
        state.inputs.erase(deflection::spindleRole);
        QVERIFY(task::resultOf(task, ofVerb(task, state))["max_um"] != panel["max_um"]);  // the chuck is that spindle
        areEqual(ofPanel(factsOf("correction"), state),
                 task::resultOf(task, ofVerb(task, state, {}, {{"compensate", path("corrected.nc")}})));
    }

    /// Of the command line the operand may be the job.
    void turningProgramOfAJobAlone()
    {
        io::writeFile(path("job.json"), cam::jobText(cam::paperJob({cam::roughC80(), cam::finishC80()})));
        project::PanelState state;
        state.inputs[cam::jobRole].path = path("job.json");
        const Json panel = ofPanel(factsOf("turning"), state);
        project::PanelState of_verb = state;
        of_verb.inputs[cam::partRole] = of_verb.inputs[cam::jobRole];
        of_verb.inputs.erase(cam::jobRole);
        Json verb = task::resultOf(cam::turnTask(), ofVerb(cam::turnTask(), of_verb));
        QCOMPARE(verb["parameters"]["job"].get<std::string>(), std::string());
        verb["parameters"]["job"] = panel["parameters"]["job"];
        areEqual(panel, verb);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::TaskAnswersTest)
#include "task_answers_test.moc"
