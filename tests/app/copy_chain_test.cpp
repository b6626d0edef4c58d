// The chain in the window, from files that are dropped to the dossier: asked, run, cancelled, gone on with after a
// change, undone, and its fit taken to the machine.
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QToolBar>
#include <QUndoStack>

#include "app/gui/panels.h"
#include "engine/chain/dossier.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/report/title_block.h"
#include "engine/sample/chain_sample.h"
#include "tests/app/window_fixture.h"
#include "tests/widgets/core/drop_files.h"
#include "widgets/chain/chain_panel.h"
#include "widgets/chain/chain_run_row.h"
#include "widgets/chain/chain_steps.h"
#include "widgets/chain/chain_views.h"
#include "widgets/core/report/report_pdf.h"
#include "widgets/deflection/deflection_panel.h"
#include "widgets/drawing/drawing_panel.h"
#include "widgets/turning/turning_panel.h"

namespace lathelier {

using chain::StepState;
using chain_panel::ChainRunRow;

class CopyChainTest : public QObject, private WindowFixture {
    Q_OBJECT

    std::string setup_text_;

    QString file(const char* name) const { return folder_.filePath(name); }
    std::string out() const { return folder_.filePath("chain").toStdString(); }
    ChainRunRow& row() const { return panel().runRow(); }
    CopyTable& stepTable() const { return *panel().views().steps(); }
    const chain_panel::ChainPanel& panel() const
    {
        return static_cast<const chain_panel::ChainPanel&>(dock("chain")->panel());
    }
    StepState state(const char* step) const { return row().looked()->step(step)->state; }
    /// The row of a step in the panel's table.
    int rowOf(const char* step) const
    {
        const auto& all = row().looked()->steps;
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.id == step; });
        return static_cast<int>(found - all.begin());
    }
    void settle() const
    {
        QTest::qWait(1);
        QTRY_VERIFY_WITH_TIMEOUT(row().looked() && !row().isLooking() && !row().isRunning(), 120000);
    }
    void dropFiles(const QStringList& names)
    {
        QStringList paths;
        for (const QString& name : names) paths << folder_.filePath(name);
        drop(&dock("chain")->panel(), paths);
        QTRY_VERIFY(!window_->isOpening());
        QTRY_VERIFY_WITH_TIMEOUT(!session_->panel("chain").inputs.empty() && !panel().isBusy(), 60000);
        settle();
    }
    void dropAll()
    {
        dropFiles({"chain_worn.ply"});
        dropFiles({"chain_drawing.json", "spindle.json", "chain_job.json", "chain_setup.json", "chain_copy.ply"});
    }
    /// Presses Run, and in the question its folder and Run.
    void startRun()
    {
        settle();
        QTest::mouseClick(row().findChild<QPushButton*>("runChainWanted"), Qt::LeftButton);
        auto* dialog = window_->findChild<QDialog*>("runChain");
        QVERIFY(dialog && dialog->isVisible());
        dialog->findChild<QLineEdit*>("chainFolder")->setText(QString::fromStdString(out()));
        QTest::mouseClick(dialog->findChild<QPushButton*>("runChainNow"), Qt::LeftButton);
        QVERIFY(row().isRunning());
    }
    void runAll()
    {
        startRun();
        settle();
    }

private slots:
    void initTestCase()
    {
        prepareSettings();
        const SamplePart& part = sample::chainSample();
        const SampleContent content = part.make(1, {});
        for (std::size_t i = 0; i < part.files.size(); ++i)
            io::writeFile((folder_.path() + "/").toStdString() + part.files[i], content.texts[i]);
        receptance::SpindleSprings springs;
        io::writeFile(file("spindle.json").toStdString(), receptance::spindleText({springs}));
        Notes notes;
        setup_text_ = content.texts.at(3);
        deflection::readSetup(setup_text_, notes);  // it is the set-up
    }
    void init()
    {
        io::writeFile(file("chain_setup.json").toStdString(), setup_text_);
        QDir(QString::fromStdString(out())).removeRecursively();
        QSettings().clear();
        session_ = std::make_unique<Session>();
        session_->setWorkspace("proof");
        window_ = std::make_unique<MainWindow>(
            *session_, languages_,
            std::vector<PanelFacts>{drawing_panel::drawingPanelFacts(), turning_panel::turningPanelFacts(),
                                    deflection_panel::deflectionPanelFacts(), chain_panel::chainPanelFacts()});
        window_->resize(1280, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        window_->enterQuestion("proof");
        settle();
    }
    void cleanup() { end(); }

    void theRowStandsOverTheEmptyPanel()
    {
        QVERIFY(row().isVisible());
        const int height = row().height();
        QVERIFY(height < 44);
        for (const char* step : {"recognise", "draw", "machine", "speeds", "program", "deflection", "copy", "proof"})
            QCOMPARE(state(step), StepState::Missing);
        window_->enterQuestion("deflection");
        QVERIFY(!row().isVisible());
        window_->enterQuestion("proof");
        QVERIFY(row().isVisible());
        QCOMPARE(row().height(), height);
        window_->setPresenting(true);
        QVERIFY(!row().isVisible());
        window_->setPresenting(false);
        QVERIFY(row().isVisible());
    }

    void goesFromDropToDossier()
    {
        dropAll();
        for (const char* key : {"recognise", "draw", "machine", "speeds", "program", "deflection", "copy", "proof"})
            QCOMPARE(state(key), StepState::NotReached);
        QVERIFY(!QFile::exists(QString::fromStdString(out())));  // looking makes nothing
        const int steps = session_->undoStack().count();
        runAll();
        QCOMPARE(session_->undoStack().count(), steps + 1);
        for (const char* key : {"recognise", "draw", "machine", "speeds", "program", "deflection", "copy", "proof"})
            QCOMPARE(state(key), StepState::Done);
        // What its own answer says stands on the step: the sample's program leaves material on the drawing.
        QVERIFY(row().looked()->step("program")->verdict == Verdict::Fail);
        const chain::DossierCheck check = chain::checkDossier(out() + "/" + chain::dossierFile);
        QVERIFY(check.faults.empty() && check.numbers > 80);
        QVERIFY(QFile::exists(QString::fromStdString(out() + "/report.html")));
        // The proof follows by itself.
        QTRY_VERIFY_WITH_TIMEOUT(panel().isCurrent(), 60000);
        QVERIFY(panel().result()->proof && panel().result()->proof->places.size() >= 3);
        QVERIFY(panel().views().chart()->data().curves.size() >= 4);
        QCOMPARE(panel().views().rows()->rowCount(), static_cast<int>(panel().result()->proof->places.size()));
        // Two pages for the customer, with six pictures; the rest is in the annexes.
        std::optional<report::Document> dossier = panel().reportDocument();
        QVERIFY(dossier);
        report::setTitleBlock(*dossier, {});
        const std::string pdf = toPdf(*dossier);
        if (qEnvironmentVariableIsSet("LATHELIER_WRITE_BASELINES"))
            io::writeFile((QDir::tempPath() + "/lathelier_dossier.pdf").toStdString(), pdf);
        QCOMPARE(
            QString::fromLatin1(pdf.data(), static_cast<int>(pdf.size())).count(QRegularExpression("/Type /Page\\b")),
            2);
        int pictures = 0;
        for (const report::Section& section : dossier->sections)
            for (const report::Block& block : section.blocks)
                pictures += std::holds_alternative<report::Picture>(block);
        QCOMPARE(pictures, 6);
        QVERIFY(QFile::exists(QString::fromStdString(out() + "/annex_deflection.html")));
        QVERIFY(window_->questionBar().box("proof")->answer().state == QuestionAnswer::State::Answered);
        // Signs of the steps, and files and digests in the tooltips of their table.
        const chain::ChainStep& recognise = *row().looked()->step("recognise");
        const QString about = stepTable().item(rowOf("recognise"), 0)->toolTip();
        QVERIFY(about.contains("chain_worn.ply"));
        QVERIFY(about.contains(QString::fromStdString(recognise.inputs.front().sha256.substr(0, 12))));
        QVERIFY(stepTable().item(rowOf("program"), 1)->text().startsWith(QString::fromUtf8("✗ ")));
        QVERIFY(stepTable().item(rowOf("recognise"), 1)->text().startsWith(QString::fromUtf8("✓ ")));
        // Its files stand in the questions that had none; the others follow from them.
        const project::Project& project = session_->project();
        QVERIFY(project.items.empty());
        QVERIFY(project.panels.at("drawing").inputs.at("shaft").path.find("chain_drawing.json") != std::string::npos);
        QCOMPARE(session_->walk()->promised("turning").inputs.at("shaft").item, std::string("drawing:shaft"));
        QCOMPARE(session_->walk()->promised("deflection").inputs.at("program").item, std::string("turning:program"));
        // That is no new drawing for the chain: all stays done.
        QVERIFY(!row().findChild<QPushButton*>("runChainWanted")->isEnabled());
        session_->undoStack().undo();
        QVERIFY(session_->panel("drawing").inputs.empty());
        QVERIFY(session_->project().panels.at("chain").parameters.empty() ||
                !find(session_->panel("chain").parameters, "run") ||
                *find(session_->panel("chain").parameters, "run") == Value(std::string()));
        session_->undoStack().redo();
        settle();
        QCOMPARE(state("proof"), StepState::Done);
    }

    /// A click on a step shows the chain's own data; the chain's question stays as it was.
    void aStepOpensWithTheDataOfTheChain()
    {
        dropAll();
        session_->edit("Own work", [](project::Project& project) {
            project.panels["turning"].inputs["job"].path = "/somewhere/else/job.json";
            project.panels["deflection"].parameters = {{"tolerance_um", 5.0}};
        });
        settle();
        runAll();
        const int steps = session_->undoStack().count();
        QTRY_VERIFY_WITH_TIMEOUT(panel().isCurrent(), 60000);
        emit stepTable().cellActivated(rowOf("program"), 0);
        QVERIFY(window_->activeDock() == dock("turning"));
        QCOMPARE(session_->undoStack().count(), steps + 1);
        const project::PanelState turning = session_->project().panels.at("turning");
        QCOMPARE(turning.inputs.at("shaft").path, out() + "/drawing.json");
        QVERIFY(turning.inputs.at("job").path.find("chain_job.json") != std::string::npos);
        window_->enterQuestion("proof");
        settle();
        emit stepTable().cellActivated(rowOf("deflection"), 0);
        const project::PanelState deflection = session_->project().panels.at("deflection");
        QVERIFY(deflection.inputs.at("program").path.starts_with(out() + "/program"));
        QVERIFY(find(deflection.parameters, "band"));
        window_->enterQuestion("proof");
        settle();
        for (const char* key : {"recognise", "draw", "machine", "speeds", "program", "deflection", "copy", "proof"})
            QCOMPARE(state(key), StepState::Done);
        session_->undoStack().undo();
        session_->undoStack().undo();
        QCOMPARE(session_->project().panels.at("turning").inputs.at("job").path, "/somewhere/else/job.json");
    }

    void aChangedFileMakesWhatFollowsOutOfDate()
    {
        dropAll();
        runAll();
        QCOMPARE(state("proof"), StepState::Done);
        const std::string program = io::fileStamp(out() + "/program.json");
        const std::string before = io::fileSha256(out() + "/deflection.json");
        Notes notes;
        deflection::TurningSetup setup = deflection::readSetup(setup_text_, notes);
        setup.chuck.tilt_N_mm_rad /= 2;
        io::writeFile(file("chain_setup.json").toStdString(), deflection::setupText(setup));
        QTRY_COMPARE_WITH_TIMEOUT(state("deflection"), StepState::OutOfDate, 30000);  // noticed, not run
        QCOMPARE(io::fileSha256(out() + "/deflection.json"), before);
        QCOMPARE(state("proof"), StepState::OutOfDate);
        QCOMPARE(state("program"), StepState::Done);
        QCOMPARE(state("copy"), StepState::Done);
        runAll();
        QCOMPARE(state("deflection"), StepState::Done);
        QVERIFY(io::fileSha256(out() + "/deflection.json") != before);
        QCOMPARE(io::fileStamp(out() + "/program.json"), program);  // was not made anew
    }

    void aStepThatFailsSaysSoAndWhatWasMadeStays()
    {
        dropAll();
        runAll();
        const std::string drawn = io::fileSha256(out() + "/draw.json");
        io::writeFile(file("bad_job.json").toStdString(), R"({"stock": {"diameter_mm": 20, "face_allowance_mm": 1},
            "setup": {"chuck_face_z_mm": 200}, "tools": [{"number": 1, "use": "rough", "nose_radius_mm": 0.8,
            "entering_angle_deg": 93, "tip_angle_deg": 55, "edge_length_mm": 12}],
            "cutting": {"rough": {"depth_mm": 2, "feed_mm_rev": 0.2, "cutting_speed_m_min": 180},
            "finish": {"feed_mm_rev": 0.1, "cutting_speed_m_min": 180}}})");
        dropFiles({"bad_job.json"});  // no finishing tool, a bar that is too thin
        runAll();
        QCOMPARE(state("recognise"), StepState::Done);
        QVERIFY(state("program") == StepState::Failed || state("machine") == StepState::Failed);
        QCOMPARE(state("proof"), StepState::NotReached);
        QCOMPARE(io::fileSha256(out() + "/draw.json"), drawn);
        QVERIFY(QFile::exists(QString::fromStdString(out() + "/copy.json")));
        QVERIFY(row().findChild<QPushButton*>("runChainWanted")->isEnabled());
    }

    void isStoppedAndKeepsWhatWasMade()
    {
        dropAll();
        startRun();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(QString::fromStdString(out() + "/draw.json")), 60000);
        QTest::mouseClick(row().findChild<QPushButton*>("cancelChain"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!row().isRunning(), 5000);
        QVERIFY(session_->project().items.empty());
        // What was finished is taken over by the next run, also from here on.
        const std::string scan = io::fileStamp(out() + "/recognise.json");
        runAll();
        QCOMPARE(state("proof"), StepState::Done);
        QCOMPARE(io::fileStamp(out() + "/recognise.json"), scan);
    }

    void theFitGoesToTheMachine()
    {
        dropAll();
        runAll();
        QTRY_VERIFY_WITH_TIMEOUT(panel().isCurrent(), 60000);
        QVERIFY(panel().result()->fit.has_value());
        const int steps = session_->undoStack().count();
        QTest::mouseClick(panel().views().takeFit(), Qt::LeftButton);
        QCOMPARE(session_->undoStack().count(), steps + 1);
        const project::Project& project = session_->project();
        QCOMPARE(project.items.size(), std::size_t{1});
        const std::string item = project.panels.at("deflection").inputs.at("spindle").item;
        QCOMPARE(project.items.at(item).kind, std::string("spindle"));
        const auto machine = receptance::spindleOf(project.items.at(item).values);
        QVERIFY(machine && machine->springs());
        const deflection::TurningSetup& fitted = panel().result()->fit->found.setup;
        QCOMPARE(machine->springs()->radial_N_mm, fitted.chuck.radial_N_mm);
        QCOMPARE(machine->springs()->tilt_N_mm_rad, fitted.chuck.tilt_N_mm_rad);
        QCOMPARE(machine->springs()->loss_factor, panel().result()->fit->springs->loss_factor);
        QCOMPARE(project.panels.at("chain").inputs.at("spindle").item, item);
        settle();
        QCOMPARE(state("deflection"), StepState::OutOfDate);
        runAll();
        QCOMPARE(state("proof"), StepState::Done);
        QTRY_VERIFY_WITH_TIMEOUT(panel().isCurrent(), 60000);
        session_->undoStack().undo();
        session_->undoStack().undo();
        QVERIFY(session_->project().items.empty());
        QVERIFY(session_->project().panels.at("deflection").inputs.count("spindle") == 0);
    }

    /// A run takes its time: whoever looks elsewhere meanwhile is shown the proof when it is there.
    void afterARunProofIsShown()
    {
        dropAll();
        startRun();
        window_->enterQuestion("program");
        QTRY_VERIFY_WITH_TIMEOUT(!row().isRunning(), 120000);
        QTRY_COMPARE(window_->question(), std::string("proof"));
        QTRY_VERIFY_WITH_TIMEOUT(panel().isCurrent(), 60000);
    }

    void everyStepHasAPanelInTheTable()
    {
        for (const chain::ChainStep& step : row().looked()->steps) {
            const char* const id = chain_panel::panelOf(step.id);
            if (!id) continue;
            const auto& table = panelTable();
            QVERIFY2(std::any_of(table.begin(), table.end(), [&](const PanelFacts& facts) { return facts.id == id; }),
                     id);
        }
        for (const char* step : {"recognise", "draw", "machine", "speeds", "program", "deflection", "copy"})
            QVERIFY2(chain_panel::panelOf(step), step);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::CopyChainTest)
#include "copy_chain_test.moc"
