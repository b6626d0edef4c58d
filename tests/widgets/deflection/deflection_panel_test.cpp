// The panel "Deflection", used as a technologist does: a program is judged, springs are tried, the tool is moved along
// the work, diameters are measured.
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include "engine/cutting/tool_library.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/deflection_plots.h"
#include "engine/receptance/library.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/shaft/shaft_item.h"
#include "slender_files.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/resources.h"
#include "widgets/deflection/deflection_panel.h"
#include "widgets/deflection/deflection_views.h"

namespace lathelier::deflection_panel {

class DeflectionPanelTest : public QObject, PanelFixture<DeflectionPanel> {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;

    void open(const std::string& program = deflection_common::slenderProgram)
    {
        folder_ = std::make_unique<QTemporaryDir>();  // files that were read are kept
        session_->edit("Open", [&](project::Project& project) {
            deflection_common::giveSlenderFiles(*folder_, project.panels["deflection"], program);
        });
    }
    const deflection::TurningStudy& study() const { return *panel_->result()->study; }
    DeflectionViews& views() const { return panel_->views(); }

private slots:
    void initTestCase() { useResources(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void aProgramIsJudgedAgainstTheTolerance()
    {
        open();
        settle();
        QCOMPARE(study().prediction.passes.size(), std::size_t{2});
        QVERIFY(!study().verdict.has_value());
        set("tolerance_um", 10.0);
        settle();
        QVERIFY(study().verdict == Verdict::Fail);
        set("tolerance_um", 500.0);
        settle();
        QVERIFY(study().verdict == Verdict::Pass);
        QCOMPARE(views().error()->data().limits.size(), std::size_t{2});
        QVERIFY(panel_->reportDocument().has_value());
        QCOMPARE(panel_->reportDocument()->inputs.size(), std::size_t{3});  // program, set-up, stock
    }

    void aShaftOfTheProjectBringsItsMaterial()
    {
        open();
        settle();
        const double before = study().prediction.summary.max_um;
        Shaft shaft;
        shaft.segments = {{287.5, 34, 34, 0, {}, {}}};
        shaft.material.emplace();
        shaft.material->elastic_modulus_MPa = 70000;
        session_->edit("Use", [&](project::Project& project) {
            project.items["bar"].kind = shaftItem;
            project.items["bar"].values = lathelier::toValues(shaft);
            project.panels["deflection"].inputs[deflection::stockRole].item = "bar";
        });
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::materialOfShaft));
        QVERIFY(!contains(panel_->result()->notes, notes::materialOfSetup));
        QCOMPARE(panel_->result()->job->setup.material.elastic.elastic_modulus_MPa, 70000.0);
        QVERIFY(study().prediction.summary.max_um > before + 1);
        set("changed_material", std::string("brass"));  // rules over the shaft, and only one of both is said
        settle();
        QCOMPARE(panel_->result()->job->setup.material.elastic.elastic_modulus_MPa, 97000.0);
        QVERIFY(contains(panel_->result()->notes, notes::materialOfLibrary));
        QVERIFY(!contains(panel_->result()->notes, notes::materialOfShaft));
    }

    void nothingIsWrittenOverWhatWasRead()
    {
        open();
        settle();
        const auto exports = panel_->offeredExports();
        const QString stock = folder_->filePath("stock.txt");  // named in the set-up
        for (const PanelExport& one : exports) QVERIFY_EXCEPTION_THROWN(panel_->writeExport(one, stock), Error);
        QVERIFY(QFile::link(stock, folder_->filePath("link.txt")));
        QVERIFY_EXCEPTION_THROWN(panel_->writeExport(exports.front(), folder_->filePath("link.txt")), Error);
        const QString free = folder_->filePath("free.csv");
        panel_->writeExport(exports.front(), free);
        QVERIFY(QFileInfo(free).size() > 0);
        QCOMPARE(QFileInfo(stock).size(), qint64(16));
    }

    void everyChoiceStandsForAnEntryOfItsLibrary()
    {
        for (const FieldChoice& choice : receptance::materialChoices({}))
            QVERIFY((choice.key == statedChoice) == !entryOf(receptance::materials(), choice.key));
        for (const FieldChoice& choice : receptance::machineChoices({}))
            QVERIFY((choice.key == statedChoice) == !entryOf(receptance::machines(), choice.key));
        for (const FieldChoice& choice : cutting::insertChoices({})) {  // the angle in the name is that of the entry
            if (choice.key == statedChoice) continue;
            const double entering_deg = *entryOf(cutting::toolLibrary().inserts, choice.key)->value.entering_angle_deg;
            QVERIFY(QString(choice.label.english).endsWith(QString(", %1°").arg(entering_deg)));
        }
    }

    void aStifferTailstockLeavesASmallerError()
    {
        open();
        settle();
        const double before = study().prediction.summary.max_um;
        set("changed_tailstock_N_mm", 20000.0);
        settle();
        QVERIFY(study().prediction.summary.max_um < 0.8 * before);
        set("changed_tailstock_N_mm", 0.0);  // none
        settle();
        QVERIFY(!panel_->result()->job->setup.tailstock.has_value());
        QVERIFY(study().prediction.summary.max_um > 2 * before);
    }

    void insertMachineAndMaterialComeFromTheLibraries()
    {
        open();
        settle();
        const double before = study().prediction.summary.max_um;
        set("changed_material", std::string("aluminium"));
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::materialOfLibrary));
        QCOMPARE(panel_->result()->job->setup.material.elastic.elastic_modulus_MPa, 70000.0);
        QVERIFY(study().prediction.summary.max_um > before + 1);
        set("changed_material", std::string("stated"));
        set("changed_machine", std::string("stiff"));
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::machineOfLibrary));
        QCOMPARE(panel_->result()->job->setup.chuck.radial_N_mm, 60000.0);
        set("changed_chuck_N_mm", 30000.0);  // a number rules over the library
        settle();
        QCOMPARE(panel_->result()->job->setup.chuck.radial_N_mm, 30000.0);
        set("changed_machine", std::string("stated"));
        set("changed_chuck_N_mm", std::monostate());
        settle();
        QCOMPARE(study().prediction.summary.max_um, before);
        set("changed_insert", std::string("snmg_120408"));  // enters at 75°: more of the force is radial
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::insertOfLibrary));
        QVERIFY(study().prediction.summary.max_um > before + 1);
        QCOMPARE(*deflection::stockParameters(panel_->result()->job->setup).tools.front().tip_angle_deg, 90.0);
        set("changed_corner_radius_mm", 0.4);
        settle();
        QCOMPARE(panel_->result()->job->setup.tool.corner_radius_mm, std::optional<double>(0.4));
        QCOMPARE(panel_->result()->job->setup.tool.entering_angle_deg, std::optional<double>(75));
    }

    void restsAndToolPostAreTriedOnTheSetUp()
    {
        open();
        settle();
        const double before = study().prediction.summary.max_um;
        set("changed_follower_offset_mm", 5.0);  // of no rest
        settle();
        QCOMPARE(study().prediction.summary.max_um, before);
        set("changed_follower_N_mm", 50000.0);
        settle();
        QVERIFY(study().prediction.summary.max_um < 0.5 * before);
        set("changed_follower_N_mm", 0.0);
        settle();
        QCOMPARE(study().prediction.summary.max_um, before);
        set("changed_post_radial_N_mm", 20000.0);  // the other direction is rigid
        settle();
        QVERIFY(study().prediction.summary.max_um > before);
        set("changed_post_radial_N_mm", 0.0);
        settle();
        QCOMPARE(study().prediction.summary.max_um, before);
        Rows rests;
        rests.rows.push_back({{{"z_mm", 150.0}, {"radial_N_mm", 100000.0}}});
        set("changed_steady_rests", rests);
        settle();
        QCOMPARE(panel_->result()->job->setup.steady_rests.size(), std::size_t{1});
        QVERIFY(study().prediction.summary.max_um < before);
    }

    void theToolIsDraggedAlongTheWork()
    {
        open();
        settle();
        QCOMPARE(views().toolPlace_mm(), 0.0);  // where the error is largest
        emit views().shape()->handleMoved(deflection::toolKey, 150, 0, false);
        QCOMPARE(views().toolPlace_mm(), 150.0);
        QCOMPARE(*views().error()->marker(), 150.0);
        QCOMPARE(views().shape()->data().handles.front().x, 150.0);
        const auto firstPass = views().forces()->data().curves.front().y.front();
        emit views().error()->clicked(50, 0);
        QCOMPARE(views().toolPlace_mm(), 50.0);
        QVERIFY(views().forces()->data().curves.front().y.front() != firstPass);  // those of the second pass
        set("tolerance_um", 30.0);
        settle();
        QCOMPARE(views().toolPlace_mm(), 50.0);  // a recomputation leaves the tool where it is
    }

    void whatIsNotAskedTakesNoRoom()
    {
        open();
        settle();
        QVERIFY(views().primaryViews()->keys().contains("map"));
        QVERIFY(!views().primaryViews()->keys().contains("power"));
        QVERIFY(!views().primaryViews()->keys().contains("diameters"));
        QVERIFY(!views().primaryViews()->keys().contains("feed"));  // no tolerance
        set("map", false);
        set("tolerance_um", 50.0);
        set("cutting_speed_m_min", 150.0);
        settle();
        QVERIFY(!views().primaryViews()->keys().contains("map"));
        QVERIFY(views().primaryViews()->keys().contains("power"));
        QVERIFY(views().primaryViews()->keys().contains("feed"));
        QVERIFY(study().feed->max_um <= 50.5);
    }

    void springsAreFoundFromMeasuredDiameters()
    {
        open();
        settle();
        // What a tailstock of 8000 N/mm would leave.
        set("changed_tailstock_N_mm", 8000.0);
        settle();
        std::vector<deflection::MeasuredDiameter> measured;
        Rows rows;
        const deflection::FinalContour truth = study().prediction.final;
        for (const std::size_t i : {std::size_t{5}, std::size_t{100}, std::size_t{300}}) {
            rows.rows.push_back(
                {{{"z_mm", truth.z_mm[i]}, {"diameter_mm", 2 * truth.radius_mm[i]}, {"uncertainty_um", 1.0}}});
        }
        set("changed_tailstock_N_mm", Value());
        set("measured", rows);
        settle();
        QVERIFY(study().identified.has_value());
        QVERIFY(std::abs(study().identified->factors.front().value - 8000) < 10);
        QVERIFY(study().triage.has_value());
        QVERIFY(views().primaryViews()->keys().contains("diameters"));
    }

    void theSpindleOfChatterStandsInForTheChuck()
    {
        open();
        settle();
        QVERIFY(study().compliance.largest_difference < 1e-6);  // as the receptance at 0 Hz
        const double before = study().prediction.summary.max_um;
        receptance::SpindleReceptance spindle;
        spindle.source = receptance::SpindleSprings{330000, 6.87e8, 0.06};
        const std::string path = folder_->filePath("spindle.json").toStdString();
        io::writeFile(path, receptance::spindleText(spindle));
        session_->edit("Open",
                       [&](project::Project& project) { project.panels["deflection"].inputs["spindle"].path = path; });
        settle();
        QCOMPARE(panel_->result()->job->setup.chuck.radial_N_mm, 330000.0);
        QVERIFY(study().prediction.summary.max_um < before);
        QVERIFY(study().compliance.largest_difference < 1e-6);
    }

    void aRapidMoveThroughStockIsFound()
    {
        open();
        settle();
        QVERIFY(study().stock && study().stock->findings.empty());
        QCOMPARE(study().stock->passes.size(), std::size_t{2});
        QVERIFY(!views().primaryViews()->keys().contains("findings"));
        std::string program = deflection_common::slenderProgram;
        program.replace(program.find("X40.\nG0 X100."), 13, "G0 Z-150.\nX100.");
        open(program);
        settle();
        QVERIFY(study().stock->findings.size() >= 1);
        QCOMPARE(study().stock->findings.front().line, std::int64_t{12});
        QVERIFY(views().primaryViews()->keys().contains("findings"));
        QVERIFY(contains(panel_->result()->notes, notes::toolMeets));
        set("check_stock", false);
        settle();
        QVERIFY(!study().stock.has_value());
        QVERIFY(!views().primaryViews()->keys().contains("stock"));
    }

    void aProgramWithAnErrorSaysWhere()
    {
        open("%\nO1\nG21 G99\nG0 X40. Z2.\nG1 Z-5.\nM30\n%\n");
        QTRY_VERIFY(!panel_->isBusy() && panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("nc_feed_missing"));
        const Value* const line = lathelier::find(panel_->error()->values(), "line");
        QVERIFY(line && *line == Value(std::int64_t{5}));
    }
};

}  // namespace lathelier::deflection_panel

QTEST_MAIN(lathelier::deflection_panel::DeflectionPanelTest)
#include "deflection_panel_test.moc"
