// Window and command line give one answer: the object that a panel writes beside its report is that of the task asked
// by operands and options, for the same inputs and parameters. Every panel over a task, with the data of the sample.
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/gui/panels.h"
#include "engine/batch/recipe_file.h"
#include "engine/cad/task/compare_task.h"
#include "engine/cam/job_file.h"
#include "engine/cam/task/turn_task.h"
#include "engine/deflection/deflection_task.h"
#include "engine/gcode/program_item.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/sample/sample.h"
#include "engine/sample/sample_files.h"
#include "engine/sample/sample_record.h"
#include "engine/shaft/shaft_item.h"
#include "engine/surface/synthetic.h"
#include "engine/surface/task/surface_task.h"
#include "engine/task/reply.h"
#include "engine/trajectory/task/roundness_task.h"
#include "engine/trajectory/task/trajectory_task.h"
#include "engine/walk/shop_supply.h"
#include "engine/walk/walk.h"
#include "tests/engine/cam/plan_data.h"
#include "tests/widgets/deflection/slender_files.h"

namespace lathelier {

class TaskAnswersTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    project::Project sample_;
    std::unique_ptr<walk::Walk> walk_;

    static const PanelFacts& factsOf(const std::string& id)
    {
        const std::vector<PanelFacts>& all = panelTable();
        return *std::find_if(all.begin(), all.end(), [&](const PanelFacts& facts) { return facts.id == id; });
    }

    /// The object of the panel's report.
    static Json ofPanel(const PanelFacts& facts, const project::PanelState& state)
    {
        Stores stores;
        task::Sources sources;
        return Json::parse(facts.report(state, stores, sources, {}, {}).results.front());
    }

    /// An item as the file that the command line is given.
    static std::string textOf(const project::Item& item)
    {
        if (item.kind == shaftItem) return io::shaftText(*shaftOf(item.values));
        if (item.kind == receptance::spindleItem) return receptance::spindleText(*receptance::spindleOf(item.values));
        if (item.kind == gcode::programItem) return gcode::programOf(item.values)->text;
        return {};
    }

    /// Of the sample, with what the walk through its part fills in, as the command line can be given it.
    project::PanelState stateOf(const PanelFacts& facts) const
    {
        Notes notes;
        project::PanelState state = walk_->place(facts.id) && walk_->canAnswer(facts.id)
                                        ? walk_->complete(facts.id, notes, {})
                                        : project::resolved(sample_, facts.stateKey());
        for (const task::Input& input : facts.task->inputs)
            for (const std::string& key : project::keysOf(state, input.role)) {
                project::Source& source = state.inputs.at(key);
                if (source.item.empty()) continue;
                const std::string text = textOf(state.items.at(key));
                // An item brings the bar of its program, which a file does not.
                const bool is_bent = state.items.at(key).kind == gcode::programItem && facts.id != "program";
                if (text.empty() || is_bent) {
                    state.inputs.erase(key);
                    continue;
                }
                source.path = folder_.filePath(QString::fromStdString(facts.id + "_" + key)).toStdString();
                source.item.clear();
                io::writeFile(source.path, text);
            }
        state.items.clear();
        return state;
    }

    /// As it is typed.
    static task::Request requestOf(const task::Task& task, const project::PanelState& state,
                                   const Values& begins_with = {})
    {
        task::Request request;
        request.parameters = begins_with;
        for (const auto& [key, value] : state.parameters) {  // a state that panels share has those of other tasks too
            const auto is_field = [&key = key](const FieldInfo& field) { return field.key == key; };
            if (std::any_of(task.fields.begin(), task.fields.end(), is_field)) set(request.parameters, key, value);
        }
        for (const task::Input& input : task.inputs)
            for (const std::string& key : project::keysOf(state, input.role)) {
                const project::Source& source = state.inputs.at(key);
                for (const auto& [name, value] : source.import) set(request.parameters, name, value);
                if (input.option.empty())
                    request.operands.push_back(source.path);
                else
                    set(request.parameters, input.option, source.path);
            }
        return request;
    }

    static Json ofVerb(const task::Task& task, const project::PanelState& state, const Values& begins_with = {},
                       std::map<std::string, std::string> exports = {})
    {
        task::Request request = requestOf(task, state, begins_with);
        request.exports = std::move(exports);
        return task::resultOf(task, task::reply(task, request, {}));
    }

    static void areEqual(const Json& panel, const Json& verb)
    {
        QVERIFY(panel.contains("parameters") && panel.contains("inputs"));
        const Json difference = Json::diff(panel, verb);
        if (!difference.empty()) QFAIL(difference.dump(1).substr(0, 1500).c_str());
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
    void initTestCase()
    {
        const std::vector<std::string> files = sample::writeSample(folder_.path().toStdString());
        sample_ = project::readProject(files.back()).project;
        walk_ = std::make_unique<walk::Walk>(sample_, placesOf(panelTable()), walk::supplyOf({}),
                                             std::make_shared<Stores>());
    }

    void everyPanelOverATask_data()
    {
        QTest::addColumn<QString>("id");
        int count = 0;
        for (const PanelFacts& facts : panelTable()) {
            // Surface asks a window in other fields than the command line: surfaceBeforeAndAfter().
            if (!facts.task || facts.id == "surface") continue;
            const auto missing = facts.missing ? facts.missing : missingOf(facts.roles);
            if (!missing(stateOf(facts)).empty()) continue;
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
        std::map<std::string, std::string> exports;
        if (id == "correction") exports["compensate"] = path("corrected.nc");
        areEqual(ofPanel(facts, state), ofVerb(task, state, facts.begins_with, exports));
    }

    /// "Recipe for many parts" of the panel and --save-recipe of the verb are one recipe.
    void recipesAreOne_data() { everyPanelOverATask_data(); }
    void recipesAreOne()
    {
        QFETCH(QString, id);
        const PanelFacts& facts = factsOf(id.toStdString());
        const task::Task& task = *facts.task;
        const project::PanelState state = stateOf(facts);
        if (!batch::hasVaried(task, state)) return;
        const task::Request typed = requestOf(task, state);
        const batch::Recipe panel = batch::recipeOf(task, state);
        const batch::Recipe verb = batch::recipeOf(task, task::statedState(task, typed.operands, typed.parameters));
        const QString shown = QString::fromStdString(batch::contentOf(verb).dump());
        QCOMPARE(QString::fromStdString(batch::contentOf(panel).dump()), shown);
        QCOMPARE(batch::identityOf(panel), batch::identityOf(verb));
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
        const Values& usual = factsOf("deflection").begins_with;
        areEqual(panel, ofVerb(task, state, usual));
        QCOMPARE(panel["parameters"]["spindle"].get<std::string>(), path("stiff.json"));
        state.inputs.erase(deflection::spindleRole);
        QVERIFY(ofVerb(task, state, usual)["max_um"] != panel["max_um"]);  // the chuck is that spindle
        areEqual(ofPanel(factsOf("correction"), state),
                 ofVerb(task, state, factsOf("correction").begins_with, {{"compensate", path("corrected.nc")}}));
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
        areEqual(ofPanel(factsOf("compare"), state), ofVerb(cad::compareTask(), state));
        Shaft shaft;
        shaft.segments = {{98, 30, 30, 0, {}, ""}, {10, 37, 37, 0, {}, ""}, {75, 33.8, 33.8, 0, {}, ""}};
        shaft.segments[1].tolerance = SizeTolerance{{}, -10, 10};
        io::writeFile(path("drawing.json"), io::shaftText(shaft));
        state.inputs[cad::referenceRole].path = path("drawing.json");
        const Json panel = ofPanel(factsOf("compare"), state);
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
        areEqual(ofPanel(factsOf("surface"), state), ofVerb(surface::surfaceTask(), state));
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
        areEqual(ofPanel(factsOf("roundness"), state), ofVerb(trajectory::roundnessTask(), state));
        state.inputs[trajectory::traceRole].path = makeProfile("trace.csv", 2);
        const Json panel = ofPanel(factsOf("roundness"), state);
        areEqual(panel, ofVerb(trajectory::roundnessTask(), state));
        QVERIFY(panel["superimposed"]["largest_difference_um"].get<double>() > 0.5);
    }

    void roundnessOfASectionOfARecord()
    {
        project::PanelState state;
        state.inputs[trajectory::recordRole].path = makeRecord("sections.csv", 3);
        const Json worst = ofPanel(factsOf("roundness"), state);
        areEqual(worst, ofVerb(trajectory::roundnessTask(), state));
        const int other = worst["profiles"][0]["section"] == 2 ? 3 : 2;
        state.parameters = {{trajectory::sectionKey, std::int64_t{other}}, {"outliers", std::string("hampel")}};
        const Json chosen = ofPanel(factsOf("roundness"), state);
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
        areEqual(ofPanel(factsOf("longitudinal"), state), verb);
        set(state.parameters, trajectory::sectionKey, std::int64_t{2});  // what a window shows changes no number
        areEqual(ofPanel(factsOf("longitudinal"), state), verb);
        areEqual(ofPanel(factsOf("trajectory"), state), verb);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::TaskAnswersTest)
#include "task_answers_test.moc"
