// The comparison panel driven as a user would: drop, click, drag, type, cancel, undo.
#include "widgets/compare/compare_panel.h"
#include "engine/io/io_codes.h"
#include "tests/widgets/core/drop_files.h"
#include "widgets/core/panel/hero_views.h"

#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "engine/project/project_codes.h"
#include "engine/sample/sample.h"
#include "widgets/compare/compare_tables.h"
#include "widgets/compare/compare_views.h"
#include "widgets/core/resources.h"
#include "widgets/core/session.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/scene/scene_view.h"

using namespace lathelier;

namespace {

void write(const QString& path, const Scan& scan)
{
    std::ofstream file(path.toStdString());
    file.precision(9);
    for (const Eigen::Vector3d& p : scan.points_mm) file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
}

}  // namespace

class ComparePanelTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    QString original_, copy_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<compare_panel::ComparePanel> panel_;

    template <class W>
    W* part(const char* name) const
    {
        return panel_->findChild<W*>(name);
    }
    void settle()
    {
        QTRY_VERIFY_WITH_TIMEOUT(panel_->isCurrent() || panel_->error(), 60000);
        QVERIFY2(!panel_->error(), panel_->error() ? panel_->error()->what() : "");
    }
    void dropBoth()
    {
        drop(panel_.get(), {original_, copy_});
        settle();
        QTest::qWait(100);  // laid out and drawn
    }
    std::optional<double> tolerance() const
    {
        return fromValues<registration::CompareParameters>(session_->panel("compare").parameters).tolerance_mm;
    }
    void setTolerance(double value_mm)
    {
        session_->edit("tolerance", [&](project::Project& project) {
            lathelier::set(project.panels["compare"].parameters, "tolerance_mm", value_mm);
        });
        settle();
    }
    QString headline() const { return part<QLabel>("headline")->text(); }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.2;
        scanner.angle_step_deg = 1.8;
        original_ = folder_.filePath("original.xyz");
        copy_ = folder_.filePath("copy.xyz");
        write(original_, sample::scanShaft(sample::nominalShaft(), scanner));
        scanner.seed = 2;
        write(copy_, sample::scanShaft(sample::copiedShaft(), scanner));
    }
    void init()
    {
        session_ = std::make_unique<Session>();
        panel_ = std::make_unique<compare_panel::ComparePanel>(*session_);
        panel_->resize(1280, 760);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
        QCoreApplication::processEvents();
    }
    void cleanup()
    {
        panel_.reset();
        session_.reset();
    }

    void aChangedFileIsToldAndTakenWhenWanted()
    {
        const QString copy = folder_.filePath("changing.xyz");
        QVERIFY(QFile::copy(copy_, copy));
        drop(panel_.get(), {original_, copy});
        settle();
        const double before_mm = panel_->result()->result->statistics.mean_mm;
        QVERIFY(QFile::remove(copy));
        QVERIFY(QFile::copy(original_, copy));
        session_->watch().look();
        const auto notes = [this] { return part<QLabel>("notes")->text(); };
        QTRY_VERIFY(notes().contains("changing.xyz was changed after it was read"));
        setTolerance(0.2);  // still of the file as it was
        QCOMPARE(panel_->result()->result->statistics.mean_mm, before_mm);
        QVERIFY(notes().contains("was changed after it was read"));
        const report::Document report = *panel_->reportDocument();
        QVERIFY(std::any_of(report.sections.front().blocks.begin(), report.sections.front().blocks.end(),
                            [](const report::Block& block) {
                                const auto* said = std::get_if<Notes>(&block);
                                return said && contains(*said, notes::sourceChangedSince);
                            }));

        panel_->recompute();
        settle();
        QVERIFY(std::abs(panel_->result()->result->statistics.mean_mm) < 1e-3);
        QVERIFY(!notes().contains("was changed after it was read"));
    }

    void twoDroppedFilesAreAnswered()
    {
        dropBoth();
        const project::PanelState& state = session_->panel("compare");
        QCOMPARE(QString::fromStdString(state.inputs.at("reference").path), original_);
        QCOMPARE(QString::fromStdString(state.inputs.at("copy").path), copy_);
        QVERIFY2(headline().contains("mm"), qPrintable(headline()));
        QVERIFY(!panel_->result()->result->verdict);
        QVERIFY(part<plot::MapView>("map")->isVisible());
        QVERIFY(!part<plot::MapView>("map")->data().empty());
        QCOMPARE(part<plot::ChartView>("histogram")->data().handles.size(), std::size_t{0});
        QVERIFY(part<compare_panel::ZoneTable>("zones")->rowCount() > 3);
        QVERIFY(part<compare_panel::StatisticsTable>("statistics")->rowCount() > 10);
    }

    void filesCanComeOneByOne()
    {
        drop(panel_.get(), {original_});
        QTRY_VERIFY(!panel_->isBusy());
        QVERIFY(!panel_->hasResult());
        drop(panel_.get(), {copy_});
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("copy").path), copy_);
    }

    void aThirdScanIsTheNextCopy()
    {
        dropBoth();
        setTolerance(0.2);
        const QString next = folder_.filePath("next.xyz");
        QVERIFY(QFile::copy(original_, next));
        drop(panel_.get(), {next});
        settle();
        const project::PanelState& state = session_->panel("compare");
        QCOMPARE(QString::fromStdString(state.inputs.at("reference").path), original_);
        QCOMPARE(QString::fromStdString(state.inputs.at("copy").path), next);
        QVERIFY(panel_->result()->result->verdict == Verdict::Pass);  // the limits are those of the part before
        session_->undoStack().undo();
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("copy").path), copy_);
    }

    void swapAndUndo()
    {
        dropBoth();
        const double mean = panel_->result()->result->statistics.mean_mm;
        part<QToolButton>("swap")->click();
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("reference").path), copy_);
        QVERIFY(std::abs(panel_->result()->result->statistics.mean_mm + mean) < 0.01);  // excess becomes lack
        session_->undoStack().undo();
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("reference").path), original_);
        QCOMPARE(panel_->result()->result->statistics.mean_mm, mean);
    }

    void toleranceIsJudgedWithoutRegisteringAgain()
    {
        dropBoth();
        const auto before = panel_->result();
        setTolerance(0.1);
        const auto after = panel_->result();
        QVERIFY(after->result->verdict.has_value());
        QVERIFY(after->local_mean_mm == before->local_mean_mm);  // the same object: taken over, not computed
        QCOMPARE(after->result->deviation_mm.size(), before->result->deviation_mm.size());
        QVERIFY(part<QLabel>("verdict")->isVisible());
        const QString word = part<QLabel>("verdict")->text();
        QVERIFY2(word.contains("tolerance") && (word.startsWith("✓") || word.startsWith("✗")), qPrintable(word));
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->result->verdict);
        QCOMPARE(part<QLabel>("verdict")->text(), QString("no limit given"));
    }

    void toleranceIsDraggedInTheHistogram()
    {
        dropBoth();
        setTolerance(0.1);
        auto* histogram = part<plot::ChartView>("histogram");
        QCOMPARE(histogram->data().handles.size(), std::size_t{2});
        QCoreApplication::processEvents();
        QWidget* surface = histogram->findChild<QWidget*>();
        const QPoint from = histogram->pixelAt(0.1, 0).toPoint() - QPoint(0, 40);
        const QPoint to = histogram->pixelAt(0.15, 0).toPoint() - QPoint(0, 40);
        const int steps = session_->undoStack().count();
        QTest::mousePress(surface, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 4; ++i) {
            QMouseEvent move(QEvent::MouseMove, from + (to - from) * i / 4, Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(surface, &move);
        }
        QVERIFY(std::abs(histogram->data().handles[0].x + 0.15) < 0.01);  // the other one follows
        // All views follow while the button is held.
        QTRY_VERIFY(std::abs(panel_->result()->result->parameters.tolerance_mm.value_or(0) - 0.15) < 0.01);
        QVERIFY(std::abs(histogram->data().handles[0].x + 0.15) < 0.01);
        QMouseEvent back(QEvent::MouseMove, (from + to) / 2, Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(surface, &back);
        QTRY_VERIFY(std::abs(panel_->result()->result->parameters.tolerance_mm.value_or(0) - 0.125) < 0.01);
        QMouseEvent again(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(surface, &again);
        QTest::mouseRelease(surface, Qt::LeftButton, {}, to);
        settle();
        QVERIFY2(std::abs(*tolerance() - 0.15) < 0.01, qPrintable(QString::number(*tolerance())));
        QCOMPARE(session_->undoStack().count(), steps + 1);  // one drag, one step
        session_->undoStack().undo();
        settle();
        QCOMPARE(*tolerance(), 0.1);
        QCOMPARE(histogram->data().handles[1].x, 0.1);
    }

    void aPlacePickedInTheMapIsMarkedEverywhere()
    {
        dropBoth();
        auto* map = part<plot::MapView>("map");
        QSignalSpy clicks(map, &plot::PlotCanvas::clicked);
        const QPoint pixel = map->pixelAt(60, 120).toPoint();
        QTest::mouseClick(map->findChild<QWidget*>(), Qt::LeftButton, {}, pixel);
        QCOMPARE(clicks.count(), 1);
        const double z_mm = clicks[0][0].toDouble();
        QVERIFY2(std::abs(z_mm - 60) < 2, qPrintable(QString::number(z_mm)));
        QVERIFY(panel_->views().place().has_value());
        QVERIFY(std::abs(*panel_->views().place()->z_mm - z_mm) < 1e-6);
        QVERIFY(std::abs(map->marker()->x() - z_mm) < 1e-6);
        QVERIFY(std::abs(map->marker()->y() - clicks[0][1].toDouble()) < 1e-6);
        QVERIFY(std::abs(*part<plot::ChartView>("meridian")->marker() - z_mm) < 1e-6);
        const auto* zones = part<compare_panel::ZoneTable>("zones");
        QCOMPARE(zones->selectionModel()->selectedRows().size(), 1);
        const int row = zones->selectionModel()->selectedRows()[0].row();
        QVERIFY(zones->item(row, 0)->text().toDouble() <= z_mm + 5 &&
                zones->item(row, 1)->text().toDouble() >= z_mm - 5);
        auto* scene = part<scene::SceneView>("scene");
        if (scene->canDraw()) {
            const Eigen::Vector3d place = *scene->marker();
            const auto& axis = *panel_->result()->result->axis_T_reference;
            const Eigen::Vector3d local = axis * place;
            QVERIFY(std::abs(std::hypot(local.x(), local.y()) - 15) < 0.2);  // on the surface of the thin end
        }
    }

    void aPointPickedInSpaceIsMarkedInTheMap()
    {
        dropBoth();
        const auto& result = *panel_->result()->result;
        std::size_t point = result.used.size() / 2;
        while (!result.used[point]) ++point;
        emit part<scene::SceneView>("scene")->pointPicked(1, static_cast<qint64>(point));
        const auto& place = *panel_->views().place();
        QCOMPARE(*place.point, point);
        QCOMPARE(*place.deviation_mm, static_cast<double>(result.deviation_mm[point]));
        QVERIFY(std::abs(part<plot::MapView>("map")->marker()->x() - *place.z_mm) < 1e-9);
        QCOMPARE(*part<plot::ChartView>("histogram")->marker(), *place.deviation_mm);
    }

    void aZoneClickedInTheTableIsMarked()
    {
        dropBoth();
        panel_->findChild<HeroViews*>()->setHero("tables");
        auto* zones = part<compare_panel::ZoneTable>("zones");
        QTRY_VERIFY(zones->isVisible());
        QTest::mouseClick(zones->viewport(), Qt::LeftButton, {}, zones->visualItemRect(zones->item(1, 2)).center());
        const double middle = (zones->item(1, 0)->text().toDouble() + zones->item(1, 1)->text().toDouble()) / 2;
        QVERIFY(std::abs(*part<plot::ChartView>("meridian")->marker() - middle) < 0.2);
        zones->setFocus();
        QTest::keyClick(zones, Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->text().count('\t') >= 10);
    }

    void zonesOutOfToleranceHaveAWord()
    {
        dropBoth();
        setTolerance(0.03);
        const QString text = part<compare_panel::ZoneTable>("zones")->text(false);
        QVERIFY2(text.contains("✗ out"), qPrintable(text));  // the collar of the sample copy is 50 µm too large
        QVERIFY(text.contains("✓ within"));
    }

    void scaleAndMagnificationAreEdited()
    {
        dropBoth();
        auto* map = part<plot::MapView>("map");
        auto* box = map->findChild<QDoubleSpinBox*>();
        box->setValue(0.5);
        QCOMPARE(panel_->views().limit_mm(), 0.5);
        auto* factor = part<QDoubleSpinBox>("magnification");
        factor->setValue(77);
        QVERIFY(report::captionText(part<plot::ChartView>("meridian")->data().remark).find("77") != std::string::npos);
        const auto& curves = part<plot::ChartView>("meridian")->data().curves;
        const auto& meridian = *panel_->result()->result->meridian;
        for (std::size_t i = 0; i < meridian.z_mm.size(); ++i)
            if (std::isfinite(meridian.deviation_mm[i]) && std::isfinite(meridian.reference_radius_mm[i]))
                QVERIFY(std::abs(curves[3].y[i] - meridian.reference_radius_mm[i] - 77 * meridian.deviation_mm[i]) <
                        1e-9);
    }

    void everyViewCanStandAlone()
    {
        dropBoth();
        auto* heroes = panel_->findChild<HeroViews*>();
        QCOMPARE(heroes->hero(), QString("part"));
        QVERIFY(part<QWidget>("scene")->isVisible() && part<QWidget>("along")->isVisible());
        const std::pair<const char*, const char*> views[] = {
            {"map", "map"}, {"meridian", "meridian"}, {"distribution", "histogram"}, {"tables", "statistics"}};
        for (const auto& [key, view] : views) {
            if (QString(view) == "statistics") panel_->findChild<QTabWidget*>()->setCurrentIndex(1);
            QTest::mouseClick(part<QWidget>((std::string("cover_") + key).c_str()), Qt::LeftButton);
            QCOMPARE(heroes->hero(), QString(key));
            QTRY_VERIFY2(part<QWidget>(view)->isVisible(), view);
            QTRY_VERIFY2(part<QWidget>(view)->height() > 400, view);
            QVERIFY(part<QWidget>("scene")->isVisible());  // small, beside it
        }
        QCOMPARE(session_->view("compare", "hero"), Value(std::string("tables")));
        panel_->recompute();
        settle();
        QCOMPARE(heroes->hero(), QString("tables"));  // a new answer leaves the view as it is
        QTest::keyClick(heroes, Qt::Key_1);
        QCOMPARE(heroes->hero(), QString("part"));
        heroes->setShowsAll(true);
        QTRY_VERIFY(part<QWidget>("map")->isVisible() && part<QWidget>("meridian")->isVisible());
        QVERIFY(std::abs(part<QWidget>("map")->height() - part<QWidget>("meridian")->height()) < 4);
    }

    void cancelStopsAndKeepsTheOldPicture()
    {
        dropBoth();
        const auto before = panel_->result();
        session_->edit("method", [](project::Project& project) {
            lathelier::set(project.panels["compare"].parameters, "max_distance_mm", 2.5);
        });
        QVERIFY(panel_->isBusy());
        panel_->cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!panel_->isBusy(), 2000);
        QVERIFY(panel_->result() == before);
        panel_->recompute();
        settle();
        QVERIFY(panel_->result() != before);
    }

    void aMissingFileIsToldAndTheNextOneHelps()
    {
        drop(panel_.get(), {original_, folder_.filePath("nowhere.ply")});
        QTRY_VERIFY(panel_->error().has_value());
        QCOMPARE(panel_->error()->code(), errors::fileNotFound);
        session_->undoStack().undo();
        dropBoth();
    }

    void deviationsAreExportedAndReported()
    {
        dropBoth();
        const auto document = panel_->reportDocument();
        QVERIFY(document && document->inputs.size() == 2);
        int pictures = 0;
        for (const report::Section& section : document->sections)
            for (const report::Block& block : section.blocks)
                pictures += std::holds_alternative<report::Picture>(block);
        QCOMPARE(pictures, part<scene::SceneView>("scene")->canDraw() ? 4 : 0);
        QVERIFY(!document->synthetic);
    }

    void syntheticDataAreMarked()
    {
        session_->edit("open", [&](project::Project& project) {
            auto& inputs = project.panels["compare"].inputs;
            inputs["reference"].path = original_.toStdString();
            inputs["reference"].synthetic = true;
            inputs["copy"].path = copy_.toStdString();
        });
        settle();
        QVERIFY(part<QLabel>("synthetic")->isVisible());
        QVERIFY(panel_->reportDocument()->synthetic);
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    ComparePanelTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "compare_panel_test.moc"
