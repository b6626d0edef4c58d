// The panel "Correction": every changed word with its reason, blocks kept, the written program.
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <cmath>

#include "engine/deflection/deflection_codes.h"
#include "engine/gcode/program_item_codes.h"
#include "tests/widgets/core/panel_fixture.h"
#include "tests/widgets/deflection/slender_files.h"
#include "widgets/core/panel/primary_views.h"
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

    /// The way back to the panel that checks turning programs.
    void theCorrectedProgramIsOfferedWithItsCorrection()
    {
        open();
        settle();
        std::string name;
        project::Item item;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string& offered_name, const project::Item& offered, bool) {
                    name = offered_name;
                    item = offered;
                });
        panel_->views().findChild<QToolButton*>("correctionCheck")->click();
        QCOMPARE(name, std::string("program, corrected"));
        QCOMPARE(item.kind, std::string(gcode::correctedItem));
        const auto program = gcode::programOf(item.values);
        QVERIFY(program.has_value());
        QCOMPARE(program->text, corrected().text);
        QCOMPARE(program->clamping, 1);
        QVERIFY(!program->corrected_from.empty());
        // Where runs overlap the last one counts.
        int found = 0;
        for (const deflection::CorrectedNode& node : corrected().compensation.runs.back().nodes)
            for (std::size_t i = 0; i < program->correction.z_mm.size(); ++i)
                found += std::abs(program->correction.z_mm[i] + program->z_zero_mm - node.z_mm) < 1e-9 &&
                         std::abs(program->correction.radius_mm[i] - (node.x_mm - node.programmed_mm)) < 1e-9;
        QVERIFY(found >= static_cast<int>(corrected().compensation.runs.back().nodes.size()));
    }

    /// A program that the turning panel planned is an item, and knows its bar.
    void aPlannedProgramBringsItsBar()
    {
        session_->edit("Open", [&](project::Project& project) {
            project::PanelState& state = project.panels["deflection"];
            deflection_common::giveSlenderFiles(folder_, state);
            deflection::TurningSetup setup = deflection::caseASetup();
            setup.stock.clear();
            io::writeFile(folder_.filePath("bare.json").toStdString(), deflection::setupText(setup));
            state.inputs[deflection::setupRole].path = folder_.filePath("bare.json").toStdString();
            gcode::ProgramItem program;
            program.text = deflection_common::slenderProgram;
            program.z_zero_mm = 2;
            program.stock = Shaft{"bar", {{287.5, 34, 34, 0, {}, ""}}, std::nullopt};
            project.items["planned"] = {gcode::programItem, gcode::toValues(program), {}};
            state.inputs[gcode::programRole] = {};
            state.inputs[gcode::programRole].item = "planned";
        });
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::barOfProgram));
        QCOMPARE(panel_->result()->job->setup.z_zero_mm, 2.0);
        QCOMPARE(panel_->result()->job->stock.length_mm(), 287.5);
        project::Item item;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string&, const project::Item& offered, bool) { item = offered; });
        panel_->views().findChild<QToolButton*>("correctionCheck")->click();
        const auto program = gcode::programOf(item.values);
        QVERIFY(program.has_value());
        QCOMPARE(program->corrected_from, io::sha256(deflection_common::slenderProgram));
        // Places count from the finished face, not from the raw end.
        const deflection::CorrectedRun& run = corrected().compensation.runs.back();
        const auto& z_mm = program->correction.z_mm;
        QVERIFY(std::any_of(z_mm.begin(), z_mm.end(),
                            [&](double z) { return std::abs(z - (run.nodes.back().z_mm - 2)) < 1e-6; }));
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
