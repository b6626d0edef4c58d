// The panel "Program": text and path point at each other, remarks in place, drafts, saving.
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include "engine/deflection/deflection_task.h"
#include "engine/gcode/program_item_codes.h"
#include "tests/widgets/core/panel_fixture.h"
#include "tests/widgets/deflection/slender_files.h"
#include "widgets/core/resources.h"
#include "widgets/program/program_panel.h"
#include "widgets/program/program_views.h"
#include "widgets/program_common/program_editor.h"

namespace lathelier::program_panel {

class ProgramPanelTest : public QObject, PanelFixture<ProgramPanel> {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;

    /// Program, set-up and stock.
    void open(const std::string& program = deflection_common::slenderProgram)
    {
        session_->edit("Open", [&](project::Project& project) {
            deflection_common::giveSlenderFiles(*folder_, project.panels["deflection"], program);
        });
        settle();
    }
    /// The program alone.
    void openAlone(const std::string& program)
    {
        session_->edit("Open", [&](project::Project& project) {
            project::PanelState& state = project.panels["deflection"];
            deflection_common::giveSlenderFiles(*folder_, state, program);
            state.inputs.erase(deflection::setupRole);
        });
        settle();
    }
    ProgramEditor& editor() const { return *panel_->views().editor(); }
    const stock::ProgramCheck& check() const { return *panel_->result()->check; }
    QByteArray written(const QString& path) const
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Types at the end of a line.
    void type(int line, const QString& text)
    {
        editor().insertAt(text, line - 1, editor().text(line - 1).trimmed().size());
        editor().takeOver();
    }

private slots:
    void initTestCase() { useResources(); }
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        begin();
    }
    void cleanup() { end(); }

    void aProgramAloneIsRead()
    {
        openAlone(deflection_common::slenderProgram);
        QCOMPARE(editor().program().toStdString(), std::string(deflection_common::slenderProgram));
        QVERIFY(!check().stock);
        QVERIFY(!check().path.moves.empty());
        // 202 mm at F0.2 and 1200 1/min are 50.5 s; 102 mm behind it 25.5 s, 6 mm across 1.5 s.
        QVERIFY(std::abs(check().times.all.feed_time_s - 77.5) < 1e-9);
        QVERIFY(panel_->reportDocument().has_value());
    }

    void textAndPathPointAtEachOther()
    {
        open();
        panel_->views().goToLine(8);  // G1 Z-200. F0.2
        const plot::PointedOut& out = panel_->views().path()->pointedOut();
        QCOMPARE(int(out.lines.size()), 1);
        QVERIFY(std::abs(out.place->x() - 200) < 1e-9 && std::abs(out.place->y() - 15) < 1e-9);
        QVERIFY(!out.shapes.empty());
        const auto* where = panel_->views().findChild<QLabel*>("programWhere");
        QVERIFY2(where->text().contains("8") && where->text().contains("30.000"), qPrintable(where->text()));
        emit panel_->views().path()->clicked(60, 14.01);  // on the second pass
        QCOMPARE(editor().line(), std::int64_t{11});
        editor().setCursorPosition(7, 0);  // as a person does
        QTRY_VERIFY(std::abs(panel_->views().path()->pointedOut().place->y() - 15) < 1e-9);
    }

    void aPassShowsItsStock()
    {
        open();
        QCOMPARE(int(check().stock->passes.size()), 2);
        QCOMPARE(panel_->views().passes()->rowCount(), 2);
        panel_->views().passes()->setCurrentCell(0, 0);
        QVERIFY(panel_->views().pass() == std::optional<std::size_t>(0));
        QCOMPARE(editor().line(), check().stock->passes[0].line);
        const auto& regions = panel_->views().path()->data().regions;
        const double lowest = *std::min_element(regions[1].y.begin(), regions[1].y.end(), [](double a, double b) {
            return (a > 1 ? a : 1e9) < (b > 1 ? b : 1e9);  // on the axis it closes
        });
        QVERIFY(std::abs(lowest - 15) < 0.01);  // not yet 14
    }

    void remarksStandInPlaceAndLeadToTheirLine()
    {
        openAlone("%\nO1\nG21 G99\nG97 S1000 M3\nG0 X40. Z2.\nG1 X3$0. F0.2\nG777 Z1.\nM30\n%\n");
        QVERIFY(check().path.has_errors);
        QCOMPARE(panel_->views().remarks()->rowCount(), int(editor().remarks().size()));
        QCOMPARE(editor().remarks().front().line, std::int64_t{6});
        QVERIFY(editor().remarks().front().is_error);
        panel_->views().remarks()->setCurrentCell(0, 0);
        QCOMPARE(editor().line(), std::int64_t{6});
        QVERIFY(editor().markersAtLine(5) != 0);
        QVERIFY(editor().markersAtLine(4) == 0);
    }

    void wordsHaveColours()
    {
        openAlone("%\nO1 (SHAFT)\nG21 G99\nN10 G0 X40. Z2. M8\nF0.2 T0101\nM30\n%\n");
        editor().goToLine(1);
        QCOMPARE(editor().styleAt(2, 4), int(ProgramEditor::Comment));
        QCOMPARE(editor().styleAt(4, 1), int(ProgramEditor::Number));
        QCOMPARE(editor().styleAt(4, 5), int(ProgramEditor::Preparatory));
        QCOMPARE(editor().styleAt(4, 8), int(ProgramEditor::Coordinate));
        QCOMPARE(editor().styleAt(4, 17), int(ProgramEditor::Miscellaneous));
        QCOMPARE(editor().styleAt(5, 6), int(ProgramEditor::Technology));
    }

    void whatIsTypedIsTheProgramOfAllPanelsAndCanBeUndone()
    {
        open();
        const double before = check().times.all.feed_time_s;
        type(8, " S600");
        settle();
        QVERIFY(panel_->result()->isDraft());
        QVERIFY(check().times.all.feed_time_s > before);
        QVERIFY(contains(panel_->result()->notes, notes::programEdited));
        task::Sources sources;
        const deflection::DeflectionOutcome other = deflection::answerDeflection(
            session_->panel("deflection"), deflection::StudyKind::Prediction, session_->stores(), sources, Progress());
        QVERIFY(contains(other.notes, notes::programEdited));
        QCOMPARE(other.job->program.text, editor().program().toStdString());
        QVERIFY(session_->isModified());
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->isDraft());
        QCOMPARE(editor().program().toStdString(), std::string(deflection_common::slenderProgram));
        session_->undoStack().redo();
        settle();
        QVERIFY(editor().text(7).contains("S600"));
    }

    void typingIsNotOvertakenByAnOlderAnswer()
    {
        open();
        editor().insertAt("(A)", 7, 0);
        QVERIFY(editor().isTyping());
        panel_->recompute();  // an answer to the text before
        QTRY_VERIFY(!panel_->isBusy());
        QVERIFY(editor().text(7).startsWith("(A)"));
        takeOverTyping(panel_.get());
        settle();
        QVERIFY(panel_->result()->isDraft());
        panel_->views().findChild<QPushButton*>("programDiscard")->click();
        settle();
        QVERIFY(!editor().text(7).startsWith("(A)"));
    }

    void savedUnderANewNameItIsTheProgram()
    {
        open("%\r\nO1 (\xD8 30)\r\nG21 G99\r\nG97 S1000 M3\r\nG0 X40. Z2.\r\nX30.\r\nG1 Z-20. F0.2\r\nM30");
        QVERIFY(editor().text(1).contains(QChar(0xD8)));
        type(7, " (\xC3\x98)");
        settle();
        const QString path = folder_->filePath("new.nc");
        panel_->saveTo(path);
        settle();
        QCOMPARE(written(path), QByteArray("%\r\nO1 (\xD8 30)\r\nG21 G99\r\nG97 S1000 M3\r\nG0 X40. Z2.\r\nX30.\r\nG1 "
                                           "Z-20. F0.2 (\xD8)\r\nM30"));
        QCOMPARE(panel_->result()->file, path.toStdString());
        QVERIFY(!panel_->result()->isDraft());
        QVERIFY(written(folder_->filePath("program.nc")).contains("F0.2\r\n"));  // the original as it was
    }

    void savedOverItselfItIsReadAgain()
    {
        open();
        type(8, " (B)");
        settle();
        panel_->saveTo(folder_->filePath("program.nc"));
        settle();
        QVERIFY(!panel_->result()->isDraft());
        QVERIFY(panel_->result()->text.find("(B)") != std::string::npos);
    }

    void aDraftFollowsItsFileToAnotherFolder()
    {
        using gcode::isOf;
        const gcode::ProgramDraft draft{"/a/one.nc", "1234", "G0"};
        QVERIFY(isOf(draft, "/a/one.nc", "9999"));   // the same file, written by another program
        QVERIFY(isOf(draft, "/b/one.nc", "1234"));   // moved with its project
        QVERIFY(!isOf(draft, "/b/one.nc", "9999"));  // another program of that name
        QVERIFY(!isOf(draft, "/b/two.nc", "1234"));
        QVERIFY(!isOf({"/a/one.nc", "", "G0"}, "/b/one.nc", ""));
    }

    void textIsFound()
    {
        open();
        auto* search = panel_->views().findChild<QLineEdit*>("programSearch");
        search->setText("G1 ");
        emit search->returnPressed();
        QCOMPARE(editor().line(), std::int64_t{8});
        emit search->returnPressed();
        QCOMPARE(editor().line(), std::int64_t{11});
        QVERIFY(editor().find("G1 ", false));
        QCOMPARE(editor().line(), std::int64_t{8});
        QVERIFY(!editor().find("NOT THERE", true));
    }

    void aMillionLinesScroll()
    {
        QByteArray text("%\nO1\nG21 G99\nG97 S1000 M3\nG0 X40. Z2.\nG1 F0.2\n");
        for (int i = 0; i < 1000000; ++i) text += "X30.5 Z-" + QByteArray::number(i % 200) + ".\n";
        ProgramEditor alone;
        alone.resize(600, 400);
        alone.show();
        QVERIFY(QTest::qWaitForWindowExposed(&alone));
        alone.setProgram(text, "big.nc", gcode::controlNamed("fanuc"));
        QCOMPARE(alone.program(), text);
        alone.goToLine(900000);
        QCOMPARE(alone.line(), std::int64_t{900000});
        QCOMPARE(alone.styleAt(900000, 1), int(ProgramEditor::Coordinate));
        QCOMPARE(alone.styleAt(500000, 1), int(ProgramEditor::Plain));  // was never seen
    }
};

}  // namespace lathelier::program_panel

QTEST_MAIN(lathelier::program_panel::ProgramPanelTest)
#include "program_panel_test.moc"
