// The panel "Drawing", used as a technologist does: a shaft opened, a cell changed, a wrong cell, files written.
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>

#include "engine/core/shaft_item.h"
#include "engine/io/shaft/shaft_file.h"
#include "tests/widgets/core/drop_files.h"
#include "tests/widgets/core/panel_fixture.h"
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
            lathelier::set(state.parameters, segmentsKey, rows);
            lathelier::set(state.parameters, segmentsOfKey, identity(state));
        });
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
        const std::vector<PanelExport> exports = panel_->offeredExports();
        for (std::size_t i = 0; i < exports.size(); ++i) {
            const QString path = folder_.filePath(QString("export%1.%2").arg(i).arg(exports[i].suffix));
            exports[i].write(path);
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            written[exports[i].label] = file.readAll();
            QVERIFY(!written[exports[i].label].isEmpty());
        }
        QVERIFY(written["Drawing (PDF)…"].startsWith("%PDF"));
        QVERIFY(written["Drawing (SVG)…"].contains("<svg"));
        QVERIFY(written["Drawing (DXF)…"].contains("DIMENSIONS"));
        QVERIFY(written["Contour (DXF)…"].contains("CONTOUR"));
        QVERIFY(written["Solid (STEP AP214)…"].contains("AUTOMOTIVE_DESIGN"));
        QVERIFY(written["Solid (STEP AP242)…"].contains("AP242_MANAGED"));
        QVERIFY(written["FreeCAD macro…"].contains("FreeCAD"));
        QVERIFY(written["SolidWorks macro…"].contains("Sub main"));
        QVERIFY(written["Table of rows (CSV)…"].count('\n') > 3);
        QVERIFY(!written["Stock text…"].isEmpty());
        Notes notes;
        QVERIFY(io::readShaft(written["Shaft (SHAFT.json)…"].toStdString(), notes) == panel_->result()->shaft);
        const QString step = write("again.step", written["Solid (STEP AP242)…"].toStdString());
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

    void itFollowsTheLanguage()
    {
        setDiameter(2, 48.5);
        settle();
        Languages languages;
        languages.use("pl");
        QTRY_COMPARE(panel_->views().heroes()->title("sheet"), QString("Rysunek"));
        QVERIFY(says("48,5") && says("Podziałka"));
        languages.use("en");
        QLocale::setDefault(QLocale::c());
        QTRY_VERIFY(says("Scale"));
    }
};

}  // namespace lathelier::drawing_panel

QTEST_MAIN(lathelier::drawing_panel::DrawingPanelTest)
#include "drawing_panel_test.moc"
