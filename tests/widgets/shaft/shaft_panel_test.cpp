// The panel "Shaft", used as a technologist does: a file opened, a row changed, an end dragged, the response handed on.
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "engine/core/frf_item.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/shaft/shaft_item.h"
#include "engine/task/task_codes.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/resources.h"
#include "widgets/shaft/shaft_panel.h"
#include "widgets/shaft/shaft_views.h"

namespace lathelier::shaft_panel {

class ShaftPanelTest : public QObject, PanelFixture<ShaftPanel> {
    Q_OBJECT

    QTemporaryDir folder_;
    QString file_, spindle_;

    static Shaft rod(double length_mm, double diameter_mm)
    {
        Shaft shaft;
        shaft.name = "rod";
        shaft.segments = {{length_mm, diameter_mm, diameter_mm, 0, {}, {}}};
        shaft.material = Material{};
        return shaft;
    }
    void open(const QString& path)
    {
        const int steps = session_->undoStack().count();
        panel_->openFiles({path});
        QTRY_COMPARE(session_->undoStack().count(), steps + 1);
        settle();
    }
    QTableWidget* table() const { return panel_->findChild<QWidget*>("segments")->findChild<QTableWidget*>(); }
    double first_hz() const { return panel_->result()->study.modes.front().frequency_hz; }

private slots:
    void initTestCase()
    {
        useResources();
        Shaft two = rod(200, 40);
        two.segments.push_back({50, 30, 30, 0, {}, {}});
        file_ = folder_.filePath("shaft.json");
        io::writeFile(file_.toStdString(), io::shaftText(two));
        spindle_ = folder_.filePath("spindle.json");
        receptance::SpindleReceptance springs;
        springs.source = receptance::SpindleSprings{15000, 1.974e8, 0.06};
        io::writeFile(spindle_.toStdString(), receptance::spindleText(springs));
    }
    void init() { begin(); }
    void cleanup() { end(); }

    void aFileFillsTheTable()
    {
        QVERIFY(!panel_->hasResult());
        open(file_);
        QCOMPARE(panel_->result()->shaft.segments.size(), std::size_t{2});
        QVERIFY(!panel_->result()->table_rules);
        QCOMPARE(table()->rowCount(), 2);
        QVERIFY(!panel_->result()->study.static_mm_N);  // nothing holds it
        const auto document = panel_->reportDocument();
        QVERIFY(document.has_value());
        QCOMPARE(document->inputs.size(), std::size_t{1});
        QCOMPARE(document->results.size(), std::size_t{1});
    }

    void aChangedRowRulesInOneStep()
    {
        open(file_);
        const double before_hz = first_hz();
        const int steps = session_->undoStack().count();
        table()->item(1, 0)->setText("100");
        QTRY_VERIFY(panel_->isCurrent() && panel_->result()->shaft.length_mm() == 300);
        QVERIFY(panel_->result()->table_rules);
        QVERIFY(contains(panel_->result()->notes, notes::shaftChanged));
        QVERIFY(first_hz() < before_hz);
        QCOMPARE(session_->undoStack().count(), steps + 1);
        session_->undoStack().undo();
        settle();
        QCOMPARE(panel_->result()->shaft.length_mm(), 250.0);
        QVERIFY(!panel_->result()->table_rules);
        QCOMPARE(table()->rowCount(), 2);
        QCOMPARE(table()->item(1, 0)->text(), QString("50"));
    }

    void anotherFileTakesThePlaceOfTheTable()
    {
        open(file_);
        table()->item(1, 0)->setText("100");
        QTRY_VERIFY(panel_->isCurrent() && panel_->result()->table_rules);
        const QString other = folder_.filePath("stock.txt");
        io::writeFile(other.toStdString(), std::string("20 0 20 0 250\n"));
        open(other);
        QTRY_VERIFY(panel_->isCurrent() && panel_->result()->shaft.segments.size() == 1);
        QVERIFY(!panel_->result()->table_rules);
        QVERIFY(contains(panel_->result()->notes, notes::materialAssumed));
        // Chosen at the input, too, where the table stays in the project.
        open(file_);
        table()->item(1, 0)->setText("100");
        QTRY_VERIFY(panel_->isCurrent() && panel_->result()->table_rules);
        session_->edit("Choose", [&](project::Project& project) {
            project.panels["shaft"].inputs[receptance::shaftRole].path = other.toStdString();
        });
        QTRY_VERIFY(panel_->isCurrent() && !panel_->result()->table_rules);
        QCOMPARE(panel_->result()->shaft.segments.size(), std::size_t{1});
        QCOMPARE(table()->rowCount(), 1);
    }

    void segmentsAreEnough()
    {
        set(task::segmentsKey, Rows{{{toValues(ShaftSegment{250, 40, 40, 0, {}, {}})}}});
        settle();
        QVERIFY(std::abs(first_hz() - 2771) < 10);
        set("hold", std::string("clamped"));
        settle();
        QVERIFY(panel_->result()->study.static_mm_N.has_value());
        QVERIFY(first_hz() < 800);
        set("library_material", std::string("aluminium"));
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::materialOfLibrary));
        QCOMPARE(panel_->result()->study.response.used.front().origin, ValueOrigin::Assumed);
        QVERIFY(panel_->result()->study.mass_kg < 0.9);
        set("own_material", true);
        settle();
        QVERIFY(!contains(panel_->result()->notes, notes::materialOfLibrary));
        QCOMPARE(panel_->result()->study.response.used.front().origin, ValueOrigin::Given);
    }

    void anEndIsDraggedInOneStep()
    {
        open(file_);
        const int steps = session_->undoStack().count();
        QCOMPARE(panel_->views().drawing()->data().handles.size(), std::size_t{2});
        emit panel_->views().endMoved(0, 210, 20, false);
        emit panel_->views().endMoved(0, 220, 21, false);
        emit panel_->views().endMoved(0, 220, 22, true);
        QTRY_VERIFY(panel_->isCurrent() && panel_->result()->shaft.segments[0].length_mm == 220);
        QCOMPARE(panel_->result()->shaft.segments[1].length_mm, 30.0);
        QCOMPARE(panel_->result()->shaft.segments[0].start_diameter_mm, 44.0);
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QCOMPARE(table()->item(0, 0)->text(), QString("220"));
        session_->undoStack().undo();
        settle();
        QCOMPARE(panel_->result()->shaft.segments[0].length_mm, 200.0);
    }

    void aSpindleHoldsItAndATailstockToo()
    {
        open(file_);
        const double free_hz = first_hz();
        open(spindle_);
        QVERIFY(panel_->result()->holding.spindle.has_value());
        QVERIFY(first_hz() < free_hz / 3);
        const double compliance = *panel_->result()->study.static_mm_N;
        set("tailstock", Rows{{{toValues(receptance::Tailstock{})}}});
        settle();
        QVERIFY(*panel_->result()->study.static_mm_N < compliance);
        set("hold", std::string("free"));
        settle();
        QVERIFY(!panel_->result()->holding.spindle);
    }

    void aSpindleThatIsATableSaysWhereItIsKnown()
    {
        open(file_);
        receptance::SpindleTable table;
        for (double f = 100; f <= 400; f += 10) {
            table.frequency_hz.push_back(f);
            table.H_mm_N.emplace_back(1e-5, -1e-6);
            table.L_mm_Nmm.emplace_back(0, 0);
            table.P_rad_Nmm.emplace_back(5e-9, -1e-10);
        }
        session_->edit("Use", [&](project::Project& project) {
            project.items["machine"].kind = receptance::spindleItem;
            project.items["machine"].values = receptance::toValues(receptance::SpindleReceptance{table});
            project.panels["shaft"].inputs[receptance::spindleRole].item = "machine";
        });
        settle();
        QCOMPARE(panel_->result()->study.response.frf.frequency_hz.back(), 400.0);
        QVERIFY(!panel_->views().primaryViews()->keys().contains("shapes"));
        QVERIFY(!panel_->reportDocument()->sections.empty());
    }

    void shaftAndResponseAreHandedOn()
    {
        open(file_);
        open(spindle_);
        project::Item item;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string&, const project::Item& made, bool) { item = made; });
        QTest::mouseClick(panel_->findChild<QPushButton*>("useResponse"), Qt::LeftButton);
        QCOMPARE(item.kind, std::string(frfItem));
        QCOMPARE(item.origin.panel, std::string("shaft"));
        const auto frf = frfOf(item.values);
        QVERIFY(frf.has_value());
        QCOMPARE(frf->value, panel_->result()->study.response.frf.value);
        QTest::mouseClick(panel_->findChild<QPushButton*>("useShaft"), Qt::LeftButton);
        const auto kept = session_->project().items.find("rod");
        QVERIFY(kept != session_->project().items.end());
        QCOMPARE(shaftOf(kept->second.values)->segments, panel_->result()->shaft.segments);
        session_->undoStack().undo();
        QVERIFY(session_->project().items.empty());
        panel_->disconnect(this);
    }

    void exportsComeBack()
    {
        open(file_);
        open(spindle_);
        int written = 0;
        for (const PanelExport& item : panel_->offeredExports()) {
            const QString path = folder_.filePath(QString("export%1.%2").arg(written++).arg(item.suffix));
            item.write(path);
            QVERIFY2(QFileInfo(path).size() > 0, qPrintable(item.label));
        }
        QCOMPARE(written, 6);  // all numbers and the recipe among them
        QFile file(folder_.filePath("export0.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        Notes notes;
        QCOMPARE(io::readShaft(file.readAll().toStdString(), notes).segments, panel_->result()->shaft.segments);
    }

    void shapesSwingAndComeToRest()
    {
        open(file_);
        panel_->views().primaryViews()->setPrimary("shapes");
        auto* play = panel_->findChild<QToolButton*>("playShapes");
        const double rest = panel_->views().shapes()->data().curves.front().y.front();
        QTest::mouseClick(play, Qt::LeftButton);
        QTRY_VERIFY(panel_->views().shapes()->data().curves.front().y.front() < 0.5 * rest);
        QTest::mouseClick(play, Qt::LeftButton);
        QCOMPARE(panel_->views().shapes()->data().curves.front().y.front(), rest);
    }

    void aShaftThatCannotBeSaysWhy()
    {
        open(file_);
        table()->item(0, 3)->setText("45");  // a bore wider than the shaft
        QTRY_VERIFY(panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("shaft_segment_unusable"));
        session_->undoStack().undo();
        settle();
        const QString broken = folder_.filePath("broken.json");
        io::writeFile(broken.toStdString(), std::string(R"({"segments": [{"length_mm": 1}]})"));
        panel_->openFiles({broken});  // the former shaft comes back
        QTRY_VERIFY(panel_->findChild<QLabel*>("message")->text().contains("broken.json"));
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("shaft").inputs.at("shaft").path), file_);
    }

    void isStoppedAndComputedAgain()
    {
        open(file_);
        set("step_hz", 0.005);  // a million lines
        panel_->cancel();
        QTRY_VERIFY(!panel_->isBusy());
        QVERIFY(!panel_->isCurrent());
        set("step_hz", 1.0);
        settle();
    }
};

}  // namespace lathelier::shaft_panel

QTEST_MAIN(lathelier::shaft_panel::ShaftPanelTest)
#include "shaft_panel_test.moc"
