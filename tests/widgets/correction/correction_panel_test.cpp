// The panel "Correction": every changed word with its reason, blocks kept, the written program.
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include "engine/deflection/deflection_codes.h"
#include "tests/widgets/core/panel_fixture.h"
#include "tests/widgets/deflection/slender_files.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/core/resources.h"
#include "widgets/correction/correction_panel.h"
#include "widgets/correction/correction_views.h"

namespace lathelier::correction_panel {

class CorrectionPanelTest : public QObject, PanelFixture<CorrectionPanel> {
    Q_OBJECT

    QTemporaryDir folder_;

    void open(const std::string& program = deflection_common::slenderProgram)
    {
        session_->edit("Open", [&](project::Project& project) {
            deflection_common::giveSlenderFiles(folder_, project.panels["deflection"], program);
        });
    }
    const deflection::CorrectedProgram& corrected() const { return *panel_->result()->study->corrected; }
    DiffModel& model() const { return *panel_->views().model(); }
    QString cell(int row, DiffModel::Column column) const { return model().index(row, column).data().toString(); }

private slots:
    void initTestCase() { useResources(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void bothProgramsStandSideBySide()
    {
        open();
        settle();
        QVERIFY(corrected().compensation.residual.max_um <= 0.6);
        QCOMPARE(model().rowCount(), 15 + static_cast<int>(corrected().compensation.blocks_added));
        const int row = model().firstChange();
        QCOMPARE(cell(row, DiffModel::Line), QString("8"));
        QCOMPARE(cell(row, DiffModel::Program), QString("G1 Z-200. F0.2"));
        QVERIFY(cell(row, DiffModel::Corrected).startsWith("G1 X29.9"));
        QVERIFY(cell(row, DiffModel::Reason).contains("F_t"));
        QCOMPARE(cell(row + 1, DiffModel::Line), QString("+"));
        QCOMPARE(cell(row + 1, DiffModel::Program), QString());
        QCOMPARE(panel_->views().lines()->currentIndex().row(), row);
        QCOMPARE(panel_->views().findChild<QLabel*>("correctionReason")->text(), cell(row, DiffModel::Reason));
        model().setOnlyChanges(true);
        QCOMPARE(model().firstChange(), 0);
        QVERIFY(panel_->reportDocument().has_value());
    }

    void aBlockIsKeptAsItWasAndTakenAgain()
    {
        open();
        settle();
        const auto blocks = corrected().compensation.blocks_changed;
        const int row = model().firstChange();
        const int steps = session_->undoStack().count();
        QVERIFY(model().setData(model().index(row, DiffModel::Take), Qt::Unchecked, Qt::CheckStateRole));
        settle();
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QVERIFY(corrected().compensation.blocks_changed < blocks);
        QVERIFY(corrected().compensation.residual.max_um > 5);
        QVERIFY(contains(panel_->result()->notes, notes::residualAboveTolerance));
        const int kept = row;  // the same line
        QCOMPARE(model().index(kept, DiffModel::Take).data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
        QCOMPARE(cell(kept, DiffModel::Corrected), cell(kept, DiffModel::Program));
        QVERIFY(model().setData(model().index(kept, DiffModel::Take), Qt::Checked, Qt::CheckStateRole));
        settle();
        QCOMPARE(corrected().compensation.blocks_changed, blocks);
    }

    void aClickInTheChartFindsTheBlock()
    {
        open();
        settle();
        emit panel_->views().correction()->clicked(190, 0);
        const int row = panel_->views().lines()->currentIndex().row();
        QVERIFY(std::abs(*model().placeOf(row) - 200) < 1e-9);
        QCOMPARE(*panel_->views().residual()->marker(), 200.0);
    }

    void whatMayNotBeChangedIsRefusedWithItsLine()
    {
        open(
            "%\nO1\nG21 G40 G99\nG97 S1000 M3\nG0 X40. Z2.\nM98 P2\nG0 Z2.\nM98 P2\nM30\nO2\nG0 X30.\nG1 Z-200. "
            "F0.2\nX40.\nM99\n%\n");
        QTRY_VERIFY(!panel_->isBusy() && panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("block_not_rewritable"));
        const Value* const line = lathelier::find(panel_->error()->values(), "line");
        QVERIFY(line && *line == Value(std::int64_t{12}));
    }
};

}  // namespace lathelier::correction_panel

QTEST_MAIN(lathelier::correction_panel::CorrectionPanelTest)
#include "correction_panel_test.moc"
