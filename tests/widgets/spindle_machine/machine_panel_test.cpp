// The panel "Spindle", used as a technologist does: tap tests opened, a rod held out, a machine of the library taken.
#include <QFileInfo>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/sample/chatter_sample.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/resources.h"
#include "widgets/spindle_machine/machine_panel.h"
#include "widgets/spindle_machine/machine_views.h"

namespace lathelier::machine_panel {

class MachinePanelTest : public QObject, PanelFixture<MachinePanel> {
    Q_OBJECT

    QTemporaryDir folder_;
    QString tests_;

    void open()
    {
        panel_->openFiles({tests_});
        settle();
    }

private slots:
    void initTestCase()
    {
        useResources();
        const SamplePart& part = sample::chatterSample();
        const SampleContent content = part.make(1, {});
        for (std::size_t i = 0; i < part.files.size(); ++i)
            io::writeFile((folder_.path() + "/").toStdString() + part.files[i], content.texts[i]);
        tests_ = folder_.filePath("tap_tests.json");
    }
    void init() { begin(); }
    void cleanup() { end(); }

    void tapTestsFindTheSpindle()
    {
        QVERIFY(!panel_->hasResult());
        open();
        const receptance::SpindleOutcome& outcome = *panel_->result();
        QVERIFY(outcome.identified != nullptr);
        QCOMPARE(outcome.identified->frfs, std::size_t{18});
        QVERIFY(outcome.identified->residual_rms_percent < 2);    // noise of 1 %
        QCOMPARE(outcome.sources.inputs.size(), std::size_t{2});  // the responses too
        const receptance::Complex H = outcome.spindle.at(500)(0, 0);
        QVERIFY(std::abs(H - 1.0 / (14850.0 * receptance::Complex(1, 0.06))) < 0.05 / 14850);
        QCOMPARE(panel_->views().magnitude()->data().curves.size(), std::size_t{3});
        QVERIFY(panel_->views().primaryViews()->keys().contains("condition"));
        QVERIFY(!panel_->views().primaryViews()->keys().contains("heldOut"));
        QVERIFY(panel_->reportDocument()->sections.size() >= 4);
    }

    void aRodHeldOutIsPredictedAndJudged()
    {
        open();
        set("hold_out", std::int64_t{2});
        set("limit_percent", 10.0);
        settle();
        QVERIFY(panel_->result()->identified->hold_out_rms_percent.has_value());
        QCOMPARE(panel_->views().heldOut()->data().curves.size(), std::size_t{12});
        QCOMPARE(answer(*panel_->result()).verdict, std::optional(Verdict::Pass));
        QCOMPARE(answer(*panel_->result()).value, panel_->result()->identified->hold_out_rms_percent);
        const auto before = panel_->result()->identified;
        set("limit_percent", 0.1);
        settle();
        QVERIFY(panel_->result()->identified == before);  // nothing of it was computed anew
        QCOMPARE(answer(*panel_->result()).verdict, std::optional(Verdict::Fail));
        set("hold_out", std::int64_t{7});
        QTRY_VERIFY(panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("hold_out_unknown"));
        session_->undoStack().undo();
        settle();
    }

    void aMistakeLeavesItUndecidedAndIsNamed()
    {
        QFile stated(tests_), swapped(folder_.filePath("swapped.json"));
        QVERIFY(stated.open(QIODevice::ReadOnly) && swapped.open(QIODevice::WriteOnly));
        Json json = Json::parse(stated.readAll().toStdString());
        Json& points = json["rods"][0]["points"];
        std::swap(points[0]["node"], points[1]["node"]);
        swapped.write(QByteArray::fromStdString(json.dump()));
        swapped.close();
        panel_->openFiles({swapped.fileName()});
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::spindlePointsSwapped));
        QVERIFY(contains(panel_->result()->notes, notes::spindleNotExplained));
        QCOMPARE(outcomeOf(panel_->result()).verdict, std::optional(Verdict::Undecided));
        QCOMPARE(panel_->findChild<QTableWidget*>("responses")->rowCount(), 18);
        QCOMPARE(panel_->findChild<plot::ChartView*>("residual")->data().curves.size(), std::size_t{19});
    }

    void springsAndMachinesNeedNoFile()
    {
        set(receptance::sourceKey, std::string("stiff"));
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::machineOfLibrary));
        QCOMPARE(panel_->result()->spindle.springs()->radial_N_mm, 60000.0);
        QCOMPARE(panel_->result()->used.front().origin, ValueOrigin::Assumed);
        QVERIFY(!panel_->views().primaryViews()->keys().contains("residual"));
        set(receptance::sourceKey, std::string("springs"));
        set("springs.radial_N_mm", 20000.0);
        settle();
        QCOMPARE(*answer(*panel_->result()).value, 50.0);
        QVERIFY(panel_->result()->notes.empty());
        open();  // tap tests that are opened are what is meant
        QVERIFY(panel_->result()->identified != nullptr);
        session_->undoStack().undo();
        settle();
        QVERIFY(panel_->result()->spindle.springs());
    }

    void theSpindleIsHandedOnAndWritten()
    {
        open();
        project::Item item;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string&, const project::Item& made, bool) { item = made; });
        QTest::mouseClick(panel_->findChild<QPushButton*>("useSpindle"), Qt::LeftButton);
        QCOMPARE(item.kind, std::string(receptance::spindleItem));
        QVERIFY(receptance::spindleOf(item.values) == panel_->result()->spindle);
        const auto exports = panel_->offeredExports();
        const QString path = folder_.filePath("found.json");
        exports.front().write(path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        Notes notes;
        QVERIFY(receptance::readSpindle(file.readAll().toStdString(), notes) == panel_->result()->spindle);
    }

    void isStoppedWhileItIdentifies()
    {
        panel_->openFiles({tests_});
        QTRY_VERIFY(panel_->isBusy());
        QTRY_VERIFY(!session_->panel("spindle").inputs.empty());
        panel_->cancel();
        QTRY_VERIFY(!panel_->isBusy());
        panel_->recompute();
        settle();
    }

    void aFileOfResponsesThatIsNotThereIsNamed()
    {
        QTemporaryDir alone;
        const QString copy = alone.filePath("tap_tests.json");
        QVERIFY(QFile::copy(tests_, copy));
        panel_->openFiles({copy});
        QTRY_VERIFY(panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("file_not_found"));
        QVERIFY(std::get<std::string>(*find(panel_->error()->values(), "path")).ends_with("tap_tests.uff"));
    }
};

}  // namespace lathelier::machine_panel

QTEST_MAIN(lathelier::machine_panel::MachinePanelTest)
#include "machine_panel_test.moc"
