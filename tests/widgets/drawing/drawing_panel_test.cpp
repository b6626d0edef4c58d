// The panel "Drawing", used as a technologist does: a shaft opened, a cell changed, a wrong cell, files written.
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>

#include "engine/io/shaft/shaft_file.h"
#include "engine/shaft/shaft_item.h"
#include "tests/widgets/core/drop_files.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"
#include "widgets/drawing/drawing_panel.h"
#include "widgets/drawing/drawing_views.h"

namespace lathelier::drawing_panel {

/// A stepped shaft with a chamfer and a bore from the chuck.
Shaft samplePart()
{
    Shaft shaft;
    shaft.name = "pin";
    shaft.segments = {{2, 26, 30, 0, {}, "chamfer"}, {60, 30, 30, 0, {}, ""}, {40, 45, 45, 0, {}, ""}};
    shaft.material = Material{};
    shaft.bores = {{ShaftEnd::Chuck, {{25, 20, 20, {}, ""}}}};
    return shaft;
}

class DrawingPanelTest : public QObject, PanelFixture<DrawingPanel> {
    Q_OBJECT

    QTemporaryDir folder_;
    QString file_;

    QString write(const QString& name, const std::string& text) const
    {
        const QString path = folder_.filePath(name);
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) file.write(QByteArray::fromStdString(text));
        return path;
    }
    template <class W>
    W* child(const char* name) const
    {
        return panel_->findChild<W*>(name);
    }
    bool says(const std::string& text) const
    {
        for (const drawing::Label& label : panel_->views().drawing().labels)
            if (label.text.find(text) != std::string::npos) return true;
        return false;
    }
    /// The table with another start and end diameter of a row, as the form sets it.
    void setDiameter(std::size_t row, double diameter_mm)
    {
        Rows rows;
        std::size_t at = 0;
        for (ShaftSegment segment : panel_->result()->shaft.segments) {
            if (at++ == row) segment.start_diameter_mm = segment.end_diameter_mm = diameter_mm;
            rows.rows.push_back({toValues(segment)});
        }
        session_->edit("Set", [&](project::Project& project) {
            project::PanelState& state = project.panels["drawing"];
            lathelier::set(state.parameters, task::segmentsKey, rows);
            lathelier::set(state.parameters, task::segmentsOfKey, task::identity(state, cad::shaftRole));
        });
    }

    const ShaftRows& rows() const { return panel_->result()->shaft.segments; }
    int labelOf(const QString& text) const
    {
        const auto& labels = panel_->views().drawing().labels;
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (labels[i].text == text.toStdString()) return static_cast<int>(i);
        return -1;
    }
    QPoint labelAt(const QString& text) const
    {
        const auto& label = panel_->views().drawing().labels[static_cast<std::size_t>(labelOf(text))];
        return panel_->views().sheet()->pixelsOf(label).center().toPoint();
    }
    /// A double click on a dimension, another size, Return.
    void type(const QString& dimension, const QString& size)
    {
        QVERIFY2(labelOf(dimension) >= 0, qPrintable(dimension));
        SheetView* sheet = panel_->views().sheet();
        QTest::mouseDClick(sheet, Qt::LeftButton, {}, labelAt(dimension));
        QVERIFY(sheet->field()->isVisible());
        sheet->field()->selectAll();
        QTest::keyClicks(sheet->field(), size);
        QTest::keyClick(sheet->field(), Qt::Key_Return);
        settle();
    }
    Value tableWith(std::size_t row, double diameter_mm) const
    {
        ShaftRows all = rows();
        all[row].start_diameter_mm = all[row].end_diameter_mm = diameter_mm;
        return task::rowsOf(all);
    }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        file_ = write("pin.json", io::shaftText(samplePart()));
    }
    void init()
    {
        begin();
        drop(panel_.get(), {file_});
        settle();
    }
    void cleanup() { end(); }

    void theDrawingAppears()
    {
        QVERIFY(says("30") && says("⌀45") && says("20") && says("102"));
        QVERIFY(says("pin"));
        QCOMPARE(panel_->result()->shaft.bores.size(), std::size_t{1});  // not laid into the rows
        QCOMPARE(child<QTableWidget>("rows")->rowCount(), 4);
        QVERIFY(panel_->result()->mass_kg && *panel_->result()->mass_kg > 0.5);
        const QImage shown = child<QWidget>("sheet")->grab().toImage();
        int dark = 0;
        for (int y = 0; y < shown.height(); ++y)
            for (int x = 0; x < shown.width(); ++x) dark += qGray(shown.pixel(x, y)) < 100;
        QVERIFY(dark > 500);
    }

    void theSheetIsEnlargedAndFitted()
    {
        SheetView* sheet = panel_->views().sheet();
        const QPoint at = sheet->rect().center();
        QWheelEvent wheel(at, sheet->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(sheet, &wheel);
        QVERIFY(sheet->zoom() > 1.5 && sheet->sheetRect().width() > sheet->width());
        child<QToolButton>("wholeSheet")->click();
        QCOMPARE(sheet->zoom(), 1.0);
        QVERIFY(sheet->rect().contains(sheet->sheetRect().toRect()));
    }

    void aCellIsChanged()
    {
        setDiameter(2, 48.5);
        settle();
        QVERIFY(says("48.5") && !says("⌀45"));
        QCOMPARE(panel_->result()->shaft.bores.size(), std::size_t{1});
        session_->undoStack().undo();
        settle();
        QVERIFY(says("⌀45"));
    }

    void aWrongCellIsNamedAndTheOldPictureStays()
    {
        const auto before = panel_->result();
        setDiameter(1, 0);
        QTRY_VERIFY(panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("shaft_row_wrong"));
        QVERIFY(screenText(*panel_->error()).contains("Row 2"));
        QVERIFY(panel_->result() == before && says("30"));
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->error());
    }

    void theSheetAndItsWordsAreChosen()
    {
        set("sheet", std::string("a3"));
        set("name", std::string("drive shaft"));
        set("material_name", std::string("C45"));
        set("date", std::string("2026-01-15"));
        settle();
        QVERIFY(panel_->views().drawing().sheet == drawing::Sheet::A3Landscape);
        QVERIFY(says("drive shaft") && says("C45") && says("2026-01-15"));
        QCOMPARE(panel_->result()->shaft.name, std::string("drive shaft"));
    }

    void filesAreWritten()
    {
        std::map<QString, QByteArray> written;
        const auto writeAll = [&] {
            const std::vector<PanelExport> exports = panel_->offeredExports();
            for (std::size_t i = 0; i < exports.size(); ++i) {
                const QString path = folder_.filePath(QString("export%1.%2").arg(i).arg(exports[i].suffix));
                exports[i].write(path);
                QFile file(path);
                QVERIFY(file.open(QIODevice::ReadOnly));
                written[exports[i].label] = file.readAll();
                QVERIFY(!written[exports[i].label].isEmpty());
            }
        };
        writeAll();
        QVERIFY(written["Drawing (PDF)…"].startsWith("%PDF"));
        QVERIFY(written["Drawing (SVG)…"].contains("<svg"));
        QVERIFY(written["Drawing or contour (DXF)…"].contains("DIMENSIONS"));
        QVERIFY(written["Solid (STEP)…"].contains("AUTOMOTIVE_DESIGN"));
        set("dxf_contour", true);
        set("step_schema", std::string("AP242"));
        settle();
        writeAll();
        QVERIFY(written["Drawing or contour (DXF)…"].contains("CONTOUR"));
        QVERIFY(written["Solid (STEP)…"].contains("AP242_MANAGED"));
        QVERIFY(written["FreeCAD macro…"].contains("FreeCAD"));
        QVERIFY(written["SolidWorks macro…"].contains("Sub main"));
        QVERIFY(written["Table of rows (CSV)…"].count('\n') > 3);
        QVERIFY(!written["Stock text…"].isEmpty());
        Notes notes;
        QVERIFY(io::readShaft(written["Shaft (SHAFT.json)…"].toStdString(), notes) == panel_->result()->shaft);
        const QString step = write("again.step", written["Solid (STEP)…"].toStdString());
        drop(panel_.get(), {step});
        settle();
        const Shaft& again = panel_->result()->shaft;
        QVERIFY(std::abs(again.length_mm() - 102) < 1e-6 && again.bores.size() == 1);
    }

    void theShaftIsKeptForOtherPanels()
    {
        setDiameter(2, 50);
        settle();
        child<QToolButton>("useShaft")->click();
        const auto kept = session_->project().items.find("pin");
        QVERIFY(kept != session_->project().items.end());
        const auto shaft = shaftOf(kept->second.values);
        QVERIFY(shaft && *shaft == panel_->result()->shaft);
        QCOMPARE(shaft->segments[2].end_diameter_mm, 50.0);
    }

    void aRowIsLitEverywhere()
    {
        SheetView* sheet = panel_->views().sheet();
        QTest::mouseClick(sheet, Qt::LeftButton, {}, sheet->pixelOf(80, 15).toPoint());
        QVERIFY(panel_->views().row() == std::size_t{2});
        QCOMPARE(child<QTableWidget>("rows")->currentRow(), 2);
        QCOMPARE(panel_->views().meridian()->pointedOut().lines.size(), std::size_t{2});
        child<QTableWidget>("rows")->setCurrentCell(0, 0);
        QVERIFY(panel_->views().row() == std::size_t{0});
        emit panel_->views().meridian()->clicked(30, 5);
        QVERIFY(panel_->views().row() == std::size_t{1});
        QTest::mouseClick(sheet, Qt::LeftButton, {}, labelAt("⌀45"));  // a dimension stands for its row
        QVERIFY(panel_->views().row() == std::size_t{2});
        QTest::mouseClick(sheet, Qt::LeftButton, {}, sheet->sheetRect().topLeft().toPoint() + QPoint(4, 4));
        QVERIFY(!panel_->views().row());
    }

    void aDimensionIsTypedInPlace()
    {
        type("⌀45", "48,5");
        QVERIFY(says("⌀48.5"));
        QCOMPARE(panel_->result()->shaft.segments[2].end_diameter_mm, 48.5);
        QCOMPARE(session_->undoStack().undoText(), QString("Change the diameter of row 3"));
        session_->undoStack().undo();
        settle();
        QVERIFY(says("⌀45"));
        type("2×45°", "3 x 30");
        QVERIFY(says("3×30°"));
        QCOMPARE(rows()[1].length_mm, 59.0);
        type("62", "70");  // from the free end: the other shoulder stays
        QCOMPARE(rows()[1].length_mm, 67.0);
        QCOMPARE(rows()[2].length_mm, 32.0);
    }

    void aSizeThatCannotBeIsRefused()
    {
        std::string errorCode;
        connect(panel_.get(), &PanelBase::messageRaised, this, [&](const Message& message) {
            if (const auto* error = std::get_if<Error>(&message.content)) errorCode = error->code().key;
        });
        const int steps = session_->undoStack().count();
        type("⌀45", "0");
        QCOMPARE(errorCode, std::string("shaft_row_wrong"));
        type("⌀45", "wide");
        QCOMPARE(errorCode, std::string("value_not_understood"));
        type("⌀45", "18");  // narrower than the bore
        QCOMPARE(errorCode, std::string("shaft_crosses"));
        QCOMPARE(session_->undoStack().count(), steps);
        QVERIFY(says("⌀45"));
    }

    void keysEditTheLitRow()
    {
        panel_->views().markRow(1);
        QTest::keyClick(panel_->views().sheet(), Qt::Key_S);
        settle();
        QCOMPARE(rows().size(), std::size_t{4});
        QCOMPARE(session_->undoStack().undoText(), QString("Split row 2"));
        QTest::keyClick(child<QTableWidget>("rows"), Qt::Key_M);
        settle();
        QCOMPARE(rows().size(), std::size_t{3});
        QCOMPARE(rows()[1].length_mm, 60.0);
        panel_->views().markRow(0);
        QTest::keyClick(panel_->views().sheet(), Qt::Key_Delete);
        settle();
        QCOMPARE(rows().size(), std::size_t{2});
        QCOMPARE(panel_->result()->shaft.length_mm(), 102.0);
        for (int i = 0; i < 3; ++i) session_->undoStack().undo();
        settle();
        QCOMPARE(rows().size(), std::size_t{3});
    }

    void theMenuChangesKindsAndTies()
    {
        part_common::RowVerbs verbs = panel_->views().verbsOf(2);
        verbs.change(RowForm::Groove);
        settle();
        QCOMPARE(rows()[2].role, std::string("groove"));
        session_->undoStack().undo();
        settle();
        verbs = panel_->views().verbsOf(2);
        QCOMPARE(verbs.ties.size(), std::size_t{1});  // the other cylinder
        verbs.ties.front().second();
        settle();
        QCOMPARE(rows()[2].end_diameter_mm, 30.0);
        QCOMPARE(child<QTableWidget>("rows")->item(2, 9)->text(), QString("2"));
        setDiameter(1, 35);  // in the table: as the form does it, and then the follower
        settle();
        emit panel_->findChild<InputColumn*>()->parameterEdited(task::segmentsKey, tableWith(1, 36), 7, "Set");
        settle();
        QCOMPARE(rows()[1].end_diameter_mm, 36.0);
        QCOMPARE(rows()[2].end_diameter_mm, 36.0);
        panel_->views().verbsOf(2).untie();
        settle();
        QVERIFY(rows()[1].tie.empty() && rows()[2].tie.empty());
        QMenu menu;
        part_common::addRowVerbs(menu, 3, panel_->views().verbsOf(2));
        QVERIFY(menu.actions().size() >= 5);
    }

    void aShoulderIsDragged()
    {
        const int steps = session_->undoStack().count();
        emit panel_->views().meridian()->handleMoved("shoulder/1", 65.04, 15, false);
        settle();
        QCOMPARE(rows()[1].length_mm, 63.0);
        emit panel_->views().meridian()->handleMoved("shoulder/1", 70, 15, false);
        emit panel_->views().meridian()->handleMoved("shoulder/1", 500, 15, true);  // not beyond the next one
        settle();
        QCOMPARE(rows()[1].length_mm, 68.0);
        QCOMPARE(panel_->result()->shaft.length_mm(), 102.0);
        QCOMPARE(session_->undoStack().count(), steps + 1);
        session_->undoStack().undo();
        settle();
        QCOMPARE(rows()[1].length_mm, 60.0);
    }

    void lengthsAsAChainAreAChoiceThatIsKept()
    {
        set("lengths", std::string("chain"));
        settle();
        QVERIFY(says("62") && says("40") && says("102"));
        type("62", "70");  // the other length stays, the part grows
        QCOMPARE(rows()[2].length_mm, 40.0);
        QCOMPARE(panel_->result()->shaft.length_mm(), 110.0);
        const Value* kept = find(session_->project().panels.at("drawing").parameters, "lengths");
        QVERIFY(kept && *kept == Value(std::string("chain")));
    }

    void whatWasMeasuredStandsBesideWhatWasSet()
    {
        QVERIFY(!panel_->views().primaryViews()->keys().contains("measured"));
        set("measured", true);
        settle();
        type("⌀45", "45,5");
        auto* table = child<QTableWidget>("measured");
        QVERIFY(panel_->views().primaryViews()->keys().contains("measured"));
        QCOMPARE(table->item(0, 2)->text(), QString("45.500"));
        QVERIFY(table->item(0, 4)->text().endsWith("0.5000") && !table->item(0, 4)->text().startsWith('0'));
        const auto document = panel_->reportDocument();
        QVERIFY(document);
        bool drawn = false;
        for (const report::Block& block : document->sections.front().blocks)
            if (const auto* outcome = std::get_if<report::Picture>(&block)) drawn = outcome->png.find("<svg") == 0;
        QVERIFY(drawn);
    }

    void itFollowsTheLanguage()
    {
        setDiameter(2, 48.5);
        settle();
        Languages languages;
        languages.use("pl");
        QTRY_COMPARE(panel_->views().primaryViews()->title("sheet"), QString("Rysunek"));
        QVERIFY(says("48,5") && says("Podziałka"));
        languages.use("en");
        QLocale::setDefault(QLocale::c());
        QTRY_VERIFY(says("Scale"));
    }
};

}  // namespace lathelier::drawing_panel

QTEST_MAIN(lathelier::drawing_panel::DrawingPanelTest)
#include "drawing_panel_test.moc"
