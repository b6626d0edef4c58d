// The panel "Recognise", used as a technologist does: a scan dropped, a parameter changed, sizes accepted, the shaft
// kept for other panels, files written.
#include <QFile>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "engine/features/report/recognition_report.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/sample/sample.h"
#include "engine/shaft/shaft_item.h"
#include "tests/widgets/core/drop_files.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"
#include "widgets/recognise/recognise_panel.h"
#include "widgets/recognise/recognise_views.h"

namespace lathelier::recognise_panel {

class RecognisePanelTest : public QObject, PanelFixture<RecognisePanel> {
    Q_OBJECT

    QTemporaryDir folder_;
    QString scan_, part_;

    /// Half a row's density of the published shaft, tilted a little.
    QString write(const QString& name, sample::ScannerModel scanner) const
    {
        scanner.row_pitch_mm = 0.2;
        scanner.angle_step_deg = 1.8;
        scanner.scan_T_part = Eigen::Isometry3d(Eigen::AngleAxisd(0.007, Eigen::Vector3d::UnitX()));
        QString path = folder_.filePath(name);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) return {};
        for (const Eigen::Vector3d& point : scanShaft(sample::nominalShaft(), scanner).points_mm)
            file.write(QString("%1 %2 %3\n")
                           .arg(point.x(), 0, 'f', 5)
                           .arg(point.y(), 0, 'f', 5)
                           .arg(point.z(), 0, 'f', 5)
                           .toLatin1());
        return path;
    }
    const features::Recognition& recognised() const { return *panel_->result()->result; }
    template <class W>
    W* child(const char* name) const
    {
        return panel_->findChild<W*>(name);
    }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        scan_ = write("shaft.xyz", {});
        sample::ScannerModel window;
        window.scan_z_from_mm = 40;
        window.scan_z_to_mm = 150;
        part_ = write("window.xyz", window);
    }
    void init()
    {
        begin();
        drop(panel_.get(), {scan_});
        settle();
    }
    void cleanup() { end(); }

    void thePublishedShaftIsRecognised()
    {
        QCOMPARE(recognised().segments.size(), std::size_t{4});
        QVERIFY(recognised().length_mm && std::abs(*recognised().length_mm - 183) < 0.1);
        auto* rows = child<QTableWidget>("rows");
        QCOMPARE(rows->rowCount(), 4);
        QVERIFY(rows->item(0, 2)->text().startsWith("30.0") && rows->item(0, 2)->text().contains("±"));
        auto* steps = child<QTableWidget>("steps");
        QCOMPARE(steps->rowCount(), 3);
        QVERIFY(std::abs(steps->item(2, 6)->text().toDouble() - 5) < 0.1);  // its chamfer
    }

    void chartsStandAligned()
    {
        auto* meridian = child<plot::ChartView>("meridian");
        auto* residuals = child<plot::ChartView>("residuals");
        QTRY_COMPARE(residuals->visibleRange().left(), meridian->visibleRange().left());
        QCOMPARE(residuals->visibleRange().right(), meridian->visibleRange().right());
        QTRY_VERIFY(std::abs(residuals->pixelAt(100, 0).x() - meridian->pixelAt(100, 0).x()) < 2);
        QTest::mouseMove(residuals, residuals->rect().center());
        QTest::keyClick(residuals, Qt::Key_Plus);
        QTRY_VERIFY(std::abs(residuals->visibleRange().width() - meridian->visibleRange().width()) < 1e-6);
        residuals->resetView();
        QTRY_COMPARE(residuals->visibleRange().left(), meridian->visibleRange().left());
        QVERIFY(meridian->visibleRange().width() > 183);
    }

    void aRowIsMarkedInAllViews()
    {
        auto* meridian = child<plot::ChartView>("meridian");
        auto* residuals = child<plot::ChartView>("residuals");
        emit meridian->clicked(103, 0);
        QVERIFY(panel_->views().row() == std::size_t{1});
        QCOMPARE(child<QTableWidget>("rows")->currentRow(), 1);
        QCOMPARE(meridian->pointedOut().lines.size(), std::size_t{2});
        const QRectF marked = residuals->pointedOut().shapes.front().boundingRect();
        QVERIFY(std::abs(marked.left() - 98) < 0.2 && std::abs(marked.right() - 108) < 0.2);
        QVERIFY(child<scene::SceneView>("scene")->marker());
        child<QTableWidget>("rows")->setCurrentCell(3, 0);
        QVERIFY(panel_->views().row() == std::size_t{3});
        emit meridian->clicked(-50, 0);
        QVERIFY(!panel_->views().row() && meridian->pointedOut().lines.empty());
    }

    void theScanIsColouredByKind()
    {
        std::size_t points = 0;
        for (const ScanPtr& part : panel_->result()->by_kind) points += part->points_mm.size();
        QCOMPARE(points, panel_->result()->points->file.scan.points_mm.size());
        QVERIFY(panel_->result()->by_kind[0]->points_mm.size() > 100000);
        QVERIFY(panel_->result()->by_kind[1]->points_mm.size() > 1000);
        QVERIFY(panel_->result()->by_kind[2]->points_mm.empty());
    }

    void aParameterIsChangedAndTakenBack()
    {
        set("free_end", std::string("last"));
        settle();
        QVERIFY(recognised().segments.front().kind == features::RowKind::Cone);
        session_->undoStack().undo();
        settle();
        QVERIFY(recognised().segments.back().kind == features::RowKind::Cone);
    }

    void sizesAreAccepted()
    {
        const auto before = panel_->result();
        const auto chip = [this] {
            const QWidget* cell = child<QTableWidget>("rows")->cellWidget(0, features::nominalColumn);
            return cell ? cell->findChild<QToolButton*>() : nullptr;
        };
        QVERIFY(chip() && !chip()->isChecked());
        QCOMPARE(chip()->text(), QString("⌀ 30"));
        chip()->click();
        settle();
        QVERIFY(panel_->result()->result == before->result);  // nothing is recognised again
        QVERIFY(chip()->isChecked());
        const ShaftSegment& first = panel_->result()->shaft.segments.front();
        QCOMPARE(first.start_diameter_mm, 30.0);
        QCOMPARE(*first.measured->start_diameter_mm, recognised().segments.front().start_diameter_mm);
        chip()->click();
        settle();
        QVERIFY(panel_->result()->accepted.empty() && panel_->result()->shaft == before->shaft);

        child<QTableWidget>("rows")->setCurrentCell(1, 0);
        child<QPushButton>("acceptSize")->click();
        settle();
        QCOMPARE(panel_->result()->accepted, (std::vector<features::AcceptedSize>{{2, "diameter_mm"}}));
    }

    void allSizesAreAcceptedAtOnce()
    {
        child<QPushButton>("acceptAll")->click();
        settle();
        QVERIFY(recognised().parameters.snap == features::Snap::Apply);
        QVERIFY(!child<QPushButton>("acceptAll")->isEnabled());
        const std::vector<ShaftStep>& steps = panel_->result()->steps;  // the published table, to its digits
        QCOMPARE(steps.size(), std::size_t{3});
        QCOMPARE(steps[0].radius_mm, 15.0);
        QCOMPARE(steps[1].radius_mm, 18.5);
        QVERIFY(std::abs(steps[2].radius_mm - 16.9) < 1e-9 && std::abs(steps[2].chamfer_end_mm - 5) < 1e-9);
        QVERIFY(std::abs(steps[2].z_end_mm - 183) < 1e-9);
        session_->undoStack().undo();
        settle();
        QVERIFY(recognised().parameters.snap == features::Snap::Suggest);
    }

    void thePublishedMethodShowsItsOwnSteps()
    {
        set("method", std::string("paper"));
        settle();
        QCOMPARE(recognised().method_used, std::string("paper"));
        QVERIFY(!panel_->result()->steps.empty());
        QCOMPARE(child<QTableWidget>("steps")->rowCount(), static_cast<int>(panel_->result()->steps.size()));
        QCOMPARE(recognised().segments.size(), std::size_t{4});  // beside the rows of the robust one
    }

    void theShaftIsKeptForOtherPanels()
    {
        child<QToolButton>("useShaft")->click();
        const auto kept = session_->project().items.find("shaft");
        QVERIFY(kept != session_->project().items.end());
        QCOMPARE(kept->second.kind, std::string(shaftItem));
        const auto shaft = shaftOf(kept->second.values);
        QVERIFY(shaft && shaft->segments.size() == 4 && std::abs(shaft->length_mm() - 183) < 0.1);
    }

    void aShaftThatIsNotCompleteIsRefused()
    {
        drop(panel_.get(), {part_});
        settle();
        QVERIFY(!recognised().complete && !recognised().length_mm);
        std::string errorCode;
        connect(panel_.get(), &PanelBase::messageRaised, this, [&](const Message& message) {
            if (const auto* error = std::get_if<Error>(&message.content)) errorCode = error->code().key;
        });
        child<QToolButton>("useShaft")->click();
        QCOMPARE(errorCode, std::string("shaft_incomplete"));
        QVERIFY(session_->project().items.empty());
    }

    void filesAreWritten()
    {
        const std::vector<PanelExport> exports = panel_->offeredExports();
        QVERIFY(exports.size() >= 6);
        std::map<QString, QByteArray> written;
        for (std::size_t i = 0; i < exports.size(); ++i) {
            const QString path = folder_.filePath(QString("export%1.%2").arg(i).arg(exports[i].suffix));
            exports[i].write(path);
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            written[exports[i].label] = file.readAll();
            QVERIFY(!written[exports[i].label].isEmpty());
        }
        Notes notes;
        const Shaft shaft = io::readShaft(written["Shaft (SHAFT.json)…"].toStdString(), notes);
        QVERIFY(shaft == panel_->result()->shaft);
        QCOMPARE(io::readStock(written["Stock text…"].toStdString()).segments.size(), std::size_t{4});
        QCOMPARE(written["Table of rows (CSV)…"].count('\n'), 5);
        QVERIFY(written["Meridian (SVG)…"].contains("<svg"));
        QVERIFY(written["Solid (STEP)…"].contains("AUTOMOTIVE_DESIGN"));
        QVERIFY(written["FreeCAD macro…"].contains("FreeCAD"));
        const QByteArray& drawing = written["Drawing (SVG)…"];  // as measured, with U and the scan
        QVERIFY(drawing.contains("±") && drawing.contains("shaft.xyz") && drawing.contains("robust"));
    }

    void whatIsInTheChuckIsNotInTheStock()
    {
        set("length_of_chucked_mm", 20.0);
        settle();
        const QString path = folder_.filePath("stock.txt");
        for (const PanelExport& offered : panel_->offeredExports())
            if (offered.label == "Stock text…") offered.write(path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(std::abs(io::readStock(file.readAll().toStdString()).length_mm() - 163) < 0.1);
    }

    void rowsAreChangedAndFittedAgain()
    {
        auto* rows = child<QTableWidget>("rows");
        QToolButton* found = child<QToolButton>("asFound");
        QVERIFY(!found->isVisible());
        rows->setCurrentCell(3, 0);
        QTest::keyClick(rows, Qt::Key_Delete);  // the chamfer
        settle();
        QCOMPARE(recognised().segments.size(), std::size_t{3});
        QVERIFY(std::abs(recognised().segments[2].z_end_mm - 183) < 0.1);
        QCOMPARE(session_->undoStack().undoText(), QString("Delete row 4"));
        QVERIFY(found->isVisible());
        panel_->views().verbsOf(0, 40.0).split();
        settle();
        QCOMPARE(recognised().segments.size(), std::size_t{4});
        QVERIFY(std::abs(recognised().segments[0].z_end_mm - 40) < 0.05);
        QVERIFY(recognised().segments[0].uncertainty.start_diameter_um);
        session_->undoStack().undo();
        settle();
        QCOMPARE(recognised().segments.size(), std::size_t{3});
        found->click();
        settle();
        QCOMPARE(recognised().segments.size(), std::size_t{4});
        QVERIFY(panel_->result()->result == panel_->result()->found);
    }

    void aChangeThatCannotBeFittedIsNoStep()
    {
        std::string errorCode;
        connect(panel_.get(), &PanelBase::messageRaised, this, [&](const Message& message) {
            if (const auto* error = std::get_if<Error>(&message.content)) errorCode = error->code().key;
        });
        const int steps = session_->undoStack().count();
        emit panel_->views().changeRequested("Split", {features::RowChange::What::Split, 1, 150});
        QCOMPARE(errorCode, std::string("row_not_changeable"));
        QCOMPARE(session_->undoStack().count(), steps);
    }

    void theItemKnowsItsScanAndItsUncertainty()
    {
        child<QToolButton>("useShaft")->click();
        const Values& values = session_->project().items.at("shaft").values;
        const auto shaft = shaftOf(values);
        QVERIFY(shaft->recovered.scan == "shaft.xyz" && shaft->recovered.scan_sha256.size() == 64);
        for (const ShaftSegment& row : shaft->segments) {
            QVERIFY(row.measured && row.measured->uncertainty.start_diameter_um);
            QCOMPARE(*row.measured->start_diameter_mm, row.start_diameter_mm);
        }
    }

    void theReportHasBothCharts()
    {
        const auto document = panel_->reportDocument();
        QVERIFY(document);
        int charts = 0;
        for (const report::Section& section : document->sections)
            for (const report::Block& block : section.blocks) charts += std::holds_alternative<report::Plot>(block);
        QCOMPARE(charts, 2);
        QVERIFY(document->results.front().find("\"segments\"") != std::string::npos);
    }

    void everythingFollowsTheLanguage()
    {
        Languages languages;
        languages.use("pl");
        QTRY_COMPARE(panel_->views().primaryViews()->title("meridian"), QString("Zarys osiowy"));
        auto* rows = child<QTableWidget>("rows");
        QTRY_COMPARE(rows->item(0, 1)->text(), QString("walec"));
        QVERIFY(rows->item(0, 2)->text().startsWith("30,0"));
        languages.use("en");
        QLocale::setDefault(QLocale::c());
        QTRY_COMPARE(rows->item(0, 1)->text(), QString("cylinder"));
    }
};

}  // namespace lathelier::recognise_panel

QTEST_MAIN(lathelier::recognise_panel::RecognisePanelTest)
#include "recognise_panel_test.moc"
