// Window and command line give one answer: the object that a panel writes beside its report is that of the verb, for
// the same inputs and parameters.
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/verb_answer.h"
#include "app/gui/panels.h"
#include "engine/cad/task/compare_task.h"
#include "engine/cam/job_file.h"
#include "engine/cam/task/turn_task.h"
#include "engine/deflection/deflection_task.h"
#include "engine/deflection/toolpath_task.h"
#include "engine/gcode/program_input.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/sample/sample.h"
#include "engine/surface/synthetic.h"
#include "engine/surface/task/surface_task.h"
#include "tests/engine/cam/plan_data.h"
#include "tests/widgets/deflection/slender_files.h"

namespace lathelier {

class TaskAnswersTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static const PanelFacts& factsOf(const std::string& id)
    {
        const std::vector<PanelFacts>& all = panelTable();
        return *std::find_if(all.begin(), all.end(), [&](const PanelFacts& facts) { return facts.id == id; });
    }

    /// The object of the panel's report, with the command line's defaults.
    static Json ofPanel(const std::string& id, const task::Task& task, project::PanelState state)
    {
        for (const auto& [key, value] : task.defaults)
            if (!find(state.parameters, key)) set(state.parameters, key, value);
        Stores stores;
        return Json::parse(factsOf(id).report(state, stores, {}, {}).results.front());
    }

    static Json ofVerb(const task::Task& task, const project::PanelState& state,
                       std::map<std::string, std::string> outputs = {})
    {
        chain::VerbQuestion question;
        question.verb = task.key;
        question.given = state.parameters;
        question.outputs = std::move(outputs);
        for (const task::Input& input : task.inputs)
            for (const std::string& key : project::keysOf(state, input.role)) {
                const std::string& path = state.inputs.at(key).path;
                if (input.option.empty())
                    question.operands.push_back(path);
                else
                    set(question.given, input.option, path);
            }
        const chain::VerbReply reply = cli::runVerbByName(question, {});
        return *reply.result;
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
    void program()
    {
        project::PanelState state;
        deflection_common::giveSlenderFiles(folder_, state);
        areEqual(ofPanel("program", deflection::toolpathTask(), state), ofVerb(deflection::toolpathTask(), state));
        state.inputs.erase(deflection::setupRole);
        areEqual(ofPanel("program", deflection::toolpathTask(), state), ofVerb(deflection::toolpathTask(), state));
    }

    void deflectionWithASpindleAndAnInsertOfTheLibrary()
    {
        project::PanelState state;
        deflection_common::giveSlenderFiles(folder_, state);
        io::writeFile(path("spindle.json"), R"({"springs": {"radial_N_mm": 50000, "tilt_N_mm_rad": 1e9,
                                                            "loss_factor": 0.02}})");
        state.inputs[deflection::spindleRole].path = path("spindle.json");
        state.parameters = {{"tolerance_um", 30.0}, {"changed_insert", std::string("dnmg_150608")}, {"band", true}};
        const Json panel = ofPanel("deflection", deflection::deflectionTask(), state);
        areEqual(panel, ofVerb(deflection::deflectionTask(), state));
        QCOMPARE(panel["parameters"]["spindle"].get<std::string>(), path("spindle.json"));
        state.inputs.erase(deflection::spindleRole);
        QVERIFY(ofVerb(deflection::deflectionTask(), state)["max_um"] != panel["max_um"]);  // the chuck is that spindle
    }

    void correction()
    {
        project::PanelState state;
        deflection_common::giveSlenderFiles(folder_, state);
        areEqual(ofPanel("correction", deflection::deflectionTask(), state),
                 ofVerb(deflection::deflectionTask(), state, {{"--compensate", path("corrected.nc")}}));
    }

    void compare()
    {
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.3;
        scanner.angle_step_deg = 2.4;
        const auto writeScan = [&](const char* name, const sample::ShaftModel& shaft) {
            std::string text;
            for (const Eigen::Vector3d& p : sample::scanShaft(shaft, scanner).points_mm)
                for (int i = 0; i < 3; ++i) text += std::to_string(p[i]) + (i < 2 ? ' ' : '\n');
            io::writeFile(path(name), text);
            scanner.seed = 2;
        };
        writeScan("original.xyz", sample::nominalShaft());
        writeScan("copy.xyz", sample::copiedShaft());
        project::PanelState state;
        state.inputs[cad::referenceRole].path = path("original.xyz");
        state.inputs[cad::copyRole].path = path("copy.xyz");
        state.parameters = {{"tolerance_mm", 0.04}, {"exclude_z_mm", std::vector<Interval>{{0, 20}}}};
        areEqual(ofPanel("compare", cad::compareTask(), state), ofVerb(cad::compareTask(), state));
        Shaft shaft;
        shaft.segments = {{98, 30, 30, 0, {}, ""}, {10, 37, 37, 0, {}, ""}, {75, 33.8, 33.8, 0, {}, ""}};
        shaft.segments[1].tolerance = SizeTolerance{{}, -10, 10};
        io::writeFile(path("drawing.json"), io::shaftText(shaft));
        state.inputs[cad::referenceRole].path = path("drawing.json");
        const Json panel = ofPanel("compare", cad::compareTask(), state);
        areEqual(panel, ofVerb(cad::compareTask(), state));
        QVERIFY(panel.contains("rows") && panel["verdict"] == "fail");
    }

    void surfaceBeforeAndAfter()
    {
        surface::SyntheticParameters picture;
        picture.width = 420;
        picture.height = 300;
        io::writeFile(path("before.png"), surface::syntheticPng(surface::syntheticPicture(picture)));
        picture.seed = 2;
        io::writeFile(path("after.png"), surface::syntheticPng(surface::syntheticPicture(picture)));
        project::PanelState state;
        state.inputs[surface::beforeRole].path = path("before.png");
        state.inputs[surface::afterRole].path = path("after.png");
        state.parameters = {{"feed_mm_rev", 0.1}, {"diameter_mm", 30.0}, {"mm_per_px", 0.006}};
        areEqual(ofPanel("surface", surface::surfaceTask(), state), ofVerb(surface::surfaceTask(), state));
    }

    void turningProgram()
    {
        io::writeFile(path("job.json"), cam::jobText(cam::paperJob({cam::roughC80(), cam::finishC80()})));
        project::PanelState state;
        state.inputs[cam::jobRole].path = path("job.json");
        const Json panel = ofPanel("turning", cam::turnTask(), state);
        project::PanelState of_verb = state;  // the operand is the job
        of_verb.inputs[cam::partRole] = of_verb.inputs[cam::jobRole];
        of_verb.inputs.erase(cam::jobRole);
        Json verb = ofVerb(cam::turnTask(), of_verb);
        QCOMPARE(verb["parameters"]["job"].get<std::string>(), std::string());
        verb["parameters"]["job"] = panel["parameters"]["job"];
        areEqual(panel, verb);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::TaskAnswersTest)
#include "task_answers_test.moc"
