// Window and command line give one answer: the object that a panel writes beside its report is that of the verb, for
// the same inputs and parameters.
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/verb_answer.h"
#include "app/gui/panels.h"
#include "engine/cam/job_file.h"
#include "engine/cam/task/turn_task.h"
#include "engine/deflection/deflection_task.h"
#include "engine/deflection/toolpath_task.h"
#include "engine/gcode/program_input.h"
#include "engine/sample/sample_record.h"
#include "engine/trajectory/task/roundness_task.h"
#include "engine/trajectory/task/trajectory_task.h"
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
        for (const task::Input& input : task.inputs) {
            const auto source = state.inputs.find(input.role);
            if (source == state.inputs.end()) continue;
            if (input.option.empty())
                for (const std::string& key : project::keysOf(state, input.role))
                    question.operands.push_back(state.inputs.at(key).path);
            else
                set(question.given, input.option, source->second.path);
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

    /// Sections along a workpiece in one record; the path of its file.
    std::string makeRecord(const char* name, int sections) const
    {
        sample::SpindleModel model = sample::quietSpindle();
        model.sections = sections;
        model.revolutions = 6;
        io::writeFile(path(name), sample::toCsv(sample::makeProbeRecord(model)));
        return path(name);
    }

    /// Three lobes and an oval of `oval_um`; the path of its file.
    std::string makeProfile(const char* name, double oval_um) const
    {
        std::string text = "x_mm,y_mm\n";
        for (int i = 0; i < 360; ++i) {
            const double angle = i * std::numbers::pi / 180;
            const double r = 20 + 0.006 * std::cos(3 * angle) + oval_um / 1000 * std::cos(2 * angle);
            text += std::to_string(r * std::cos(angle)) + "," + std::to_string(r * std::sin(angle)) + "\n";
        }
        io::writeFile(path(name), text);
        return path(name);
    }

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

    void roundnessOfAProfileWithATraceLaidOver()
    {
        project::PanelState state;
        state.inputs[trajectory::profileRole].path = makeProfile("profile.csv", 1);
        state.parameters = {{"cutoff_upr", 50.0}, {"tolerance_um", 15.0}};
        areEqual(ofPanel("roundness", trajectory::roundnessTask(), state), ofVerb(trajectory::roundnessTask(), state));
        state.inputs[trajectory::traceRole].path = makeProfile("trace.csv", 2);
        const Json panel = ofPanel("roundness", trajectory::roundnessTask(), state);
        areEqual(panel, ofVerb(trajectory::roundnessTask(), state));
        QVERIFY(panel["superimposed"]["largest_difference_um"].get<double>() > 0.5);
    }

    void roundnessOfASectionOfARecord()
    {
        project::PanelState state;
        state.inputs[trajectory::recordRole].path = makeRecord("sections.csv", 3);
        const Json worst = ofPanel("roundness", trajectory::roundnessTask(), state);
        areEqual(worst, ofVerb(trajectory::roundnessTask(), state));
        const int other = worst["profiles"][0]["section"] == 2 ? 3 : 2;
        state.parameters = {{trajectory::sectionKey, std::int64_t{other}}, {"outliers", std::string("hampel")}};
        const Json chosen = ofPanel("roundness", trajectory::roundnessTask(), state);
        areEqual(chosen, ofVerb(trajectory::roundnessTask(), state));
        QCOMPARE(chosen["profiles"][0]["section"].get<int>(), other);
    }

    void sectionsAndMotionOfSeveralRecords()
    {
        project::PanelState state;
        state.inputs["record"].path = makeRecord("first.csv", 1);
        state.inputs["record.2"].path = makeRecord("second.csv", 1);
        state.parameters = {{"z_mm", std::string("5,10")}};
        const Json verb = ofVerb(trajectory::trajectoryTask(), state);
        QCOMPARE(verb["inputs"].size(), std::size_t{2});
        QCOMPARE(verb["sections"].size(), std::size_t{2});
        areEqual(ofPanel("longitudinal", trajectory::trajectoryTask(), state), verb);
        set(state.parameters, trajectory::sectionKey, std::int64_t{2});  // what a window shows changes no number
        areEqual(ofPanel("longitudinal", trajectory::trajectoryTask(), state), verb);
        areEqual(ofPanel("trajectory", trajectory::motionTask(), state), verb);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::TaskAnswersTest)
#include "task_answers_test.moc"
