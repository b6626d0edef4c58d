// The views of the comparison: a place, a zone, a finding, a limit in one is marked in all; each can be the large one.
#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "tests/widgets/compare/compare_fixture.h"
#include "widgets/compare/compare_tables.h"
#include "widgets/compare/compare_views.h"
#include "widgets/compare/zone_dialog.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/scene/scene_view.h"

using namespace lathelier;

class CompareViewsTest : public QObject, CompareFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void coloursShowTheFormOrPassAndFail()
    {
        dropBoth();
        auto* passFail = part<QToolButton>("passFail");
        QVERIFY(!passFail->isEnabled());  // without a tolerance there is nothing to pass
        setTolerance(0.1);
        QVERIFY(passFail->isEnabled());
        const auto isGreen = [](const QColor& colour) {
            return colour.green() > colour.red() && colour.green() > colour.blue();
        };
        const auto* map = part<plot::MapView>("map");
        QVERIFY(map->colourAt(60, 100).isValid() && !isGreen(map->colourAt(60, 100)));
        passFail->click();
        QVERIFY(isGreen(map->colourAt(60, 100)));
        setTolerance(0.2);  // stays as the user chose it
        QVERIFY(isGreen(map->colourAt(60, 100)));
        part<QToolButton>("form")->click();
        QVERIFY(!isGreen(map->colourAt(60, 100)));
    }

    void whatIsShownComesBackWithTheProject()
    {
        dropBoth();
        setTolerance(0.1);
        part<QToolButton>("passFail")->click();
        part<QDoubleSpinBox>("magnification")->setValue(77);
        part<scene::SceneView>("scene")->turn(30, 20);
        const std::vector<double> camera = part<scene::SceneView>("scene")->view();
        QCOMPARE(camera.size(), std::size_t{15});
        const QString path = folder_.filePath("views.lathelier");
        session_->save(path);

        end();
        begin();
        session_->open(path);
        settle();
        QVERIFY(part<QToolButton>("passFail")->isChecked());
        QCOMPARE(part<QDoubleSpinBox>("magnification")->value(), 77.0);
        const std::vector<double> again = part<scene::SceneView>("scene")->view();
        QCOMPARE(again.size(), camera.size());
        for (std::size_t i = 0; i < camera.size(); ++i) QVERIFY(std::abs(again[i] - camera[i]) < 1e-3);

        session_->reset();  // the next project begins as all do
        QVERIFY(part<QToolButton>("form")->isChecked());
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

    void aZoneIsDrawnOverTheDeviation()
    {
        dropBoth();
        setTolerance(0.1);
        part<QToolButton>("drawZone")->setChecked(true);
        auto* along = part<plot::ChartView>("along");
        QWidget* surface = along->findChild<QWidget*>();
        const double middle = along->visibleRange().center().y();
        const QPoint from = along->pixelAt(30, middle).toPoint(), to = along->pixelAt(60, middle).toPoint();
        const auto dialogSays = [](const char* button) {
            QTimer::singleShot(200, [button] {
                auto* dialog = qobject_cast<compare_panel::ZoneDialog*>(QApplication::activeModalWidget());
                QVERIFY(dialog);
                if (button)
                    dialog->findChild<QPushButton*>(button)->click();
                else
                    dialog->accept();
            });
        };
        const auto drag = [&] {
            QTest::mousePress(surface, Qt::LeftButton, {}, from);
            QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(surface, &move);
            QTest::mouseRelease(surface, Qt::LeftButton, {}, to);
        };
        dialogSays(nullptr);
        drag();
        settle();
        const auto zones = [&] {
            return fromValues<registration::CompareParameters>(session_->panel("compare").parameters).zones;
        };
        QCOMPARE(zones().size(), std::size_t{1});
        QVERIFY(std::abs(zones()[0].z_start_mm - 30) < 1 && std::abs(zones()[0].z_end_mm - 60) < 1);
        QCOMPARE(*zones()[0].upper_mm, 0.1);
        QVERIFY(!part<QToolButton>("drawZone")->isChecked());
        QCOMPARE(along->data().regions.size(), std::size_t{1});
        QCOMPARE(panel_->result()->result->zones.size(), std::size_t{1});

        part<QToolButton>("drawZone")->setChecked(true);  // on a zone that is there: it is edited
        dialogSays("remove");
        drag();
        settle();
        QVERIFY(zones().empty());
        session_->undoStack().undo();
        settle();
        QCOMPARE(zones().size(), std::size_t{1});
    }

    void aDrawnZoneTakesNothingFromOthers()
    {
        const std::vector<registration::ZoneLimits> zones{{"a", 10, 20, {}, {}}, {"b", 40, 50, {}, {}}};
        const auto drawn = compare_panel::zoneAt(zones, 45, 15);
        QVERIFY(drawn && !drawn->existing);
        QCOMPARE(drawn->zone.z_start_mm, 20.0);
        QCOMPARE(drawn->zone.z_end_mm, 40.0);
        QCOMPARE(*compare_panel::zoneAt(zones, 40, 52)->existing, std::size_t{1});
        QVERIFY(!compare_panel::zoneAt(zones, 30, 30.01));
    }

    void thePartSaysWhatLiesUnderThePointer()
    {
        dropBoth();
        auto* scene = part<scene::SceneView>("scene");
        QVERIFY(scene->canDraw());
        scene->setViewpoint(scene::SceneViewpoint::Side);
        QTest::qWait(400);
        auto* canvas = scene->focusProxy();
        QMouseEvent move(QEvent::MouseMove, canvas->rect().center(), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(canvas, &move);
        auto* tag = scene->findChild<plot::PointerTag*>("pointerTag");
        QTRY_VERIFY(!tag->words().value.isEmpty());
        QVERIFY2(tag->words().value.endsWith(" mm"), qPrintable(tag->words().value));
        QVERIFY2(tag->words().place.startsWith("z "), qPrintable(tag->words().place));
        QVERIFY(canvas->rect().contains(tag->geometry()));
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
        panel_->findChild<PrimaryViews*>()->setPrimary("tables");
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
        setTolerance(0.04);
        const auto text = [&] { return part<compare_panel::ZoneTable>("zones")->text(false); };
        QVERIFY2(text().contains("✗ out"), qPrintable(text()));  // the collar of the sample copy is 50 µm too large
        QVERIFY2(text().contains("? undecided"), qPrintable(text()));  // 70 points do not show a plateau of 40 µm
        setTolerance(0.08);
        QVERIFY2(text().contains("✓ within") && !text().contains("✗ out"), qPrintable(text()));
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
        auto* primaryViews = panel_->findChild<PrimaryViews*>();
        QCOMPARE(primaryViews->primary(), QString("part"));
        QVERIFY(part<QWidget>("scene")->isVisible() && part<QWidget>("along")->isVisible());
        const std::pair<const char*, const char*> views[] = {
            {"map", "map"}, {"meridian", "meridian"}, {"distribution", "histogram"}, {"tables", "statistics"}};
        for (const auto& [key, view] : views) {
            if (QString(view) == "statistics") panel_->findChild<QTabWidget*>()->setCurrentIndex(1);
            QTest::mouseClick(part<QWidget>((std::string("cover_") + key).c_str()), Qt::LeftButton);
            QCOMPARE(primaryViews->primary(), QString(key));
            QTRY_VERIFY2(part<QWidget>(view)->isVisible(), view);
            QTRY_VERIFY2(part<QWidget>(view)->height() > 400, view);
            QVERIFY(part<QWidget>("scene")->isVisible());  // small, beside it
        }
        QCOMPARE(session_->view("compare", "hero"), Value(std::string("tables")));
        panel_->recompute();
        settle();
        QCOMPARE(primaryViews->primary(), QString("tables"));  // a new answer leaves the view as it is
        QTest::keyClick(primaryViews, Qt::Key_1);
        QCOMPARE(primaryViews->primary(), QString("part"));
        primaryViews->setShowsAll(true);
        QTRY_VERIFY(part<QWidget>("map")->isVisible() && part<QWidget>("meridian")->isVisible());
        QVERIFY(std::abs(part<QWidget>("map")->height() - part<QWidget>("meridian")->height()) < 4);
    }

    void aFindingLeadsToItsPlaceInAllViews()
    {
        dropBoth();
        setTolerance(0.04);
        auto* finding = panel_->findChild<FindingLink*>("finding1");
        QVERIFY2(finding->text().startsWith(QStringLiteral("✗ Step +0.0")), qPrintable(finding->text()));
        QTest::mouseClick(finding, Qt::LeftButton);
        for (const char* chart : {"along", "meridian"})  // the middle of the collar, z 98-108
            QVERIFY2(std::abs(part<plot::ChartView>(chart)->marker().value_or(-1) - 103) < 0.5,
                     qPrintable(QString("%1: %2, %3")
                                    .arg(chart)
                                    .arg(part<plot::ChartView>(chart)->marker().value_or(-1))
                                    .arg(finding->text())));
        QVERIFY(std::abs(part<plot::MapView>("map")->marker()->x() - 103) < 0.5);
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    CompareViewsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "compare_views_test.moc"
