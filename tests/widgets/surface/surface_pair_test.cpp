// Two pictures in the panel "Surface": each with what is its own, and both brought together.
#include <QCheckBox>
#include <QLocale>
#include <QToolButton>

#include "tests/widgets/surface/surface_fixture.h"
#include "widgets/core/resources.h"

namespace lathelier::surface_panel {

class SurfacePairTest : public QObject, SurfaceFixture {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        writePictures();
    }
    void init() { begin(); }
    void cleanup() { end(); }

    void theSliderPartsBeforeFromAfter()
    {
        openBoth();
        views().primaryViews()->setPrimary("comparison");
        ComparisonView* comparison = views().comparison();
        QVERIFY(comparison->after()->isVisible());
        QCOMPARE(comparison->before()->image().size(), comparison->after()->image().size());
        panel_->findChild<QToolButton*>("underSlider")->click();
        QVERIFY(!comparison->after()->isVisible());
        comparison->slider()->setValue(0);
        const QColor after = comparison->before()->grab().toImage().pixelColor(comparison->before()->rect().center());
        comparison->slider()->setValue(comparison->slider()->maximum());
        const QColor before = comparison->before()->grab().toImage().pixelColor(comparison->before()->rect().center());
        QVERIFY(after != before);
        panel_->findChild<QToolButton*>("sideBySide")->click();
        // What is zoomed in one is zoomed in the other.
        QTest::keyClick(comparison->before(), Qt::Key_Plus);
        QCOMPARE(comparison->after()->zoom(), comparison->before()->zoom());
        QVERIFY(comparison->after()->pixelAt({0, 0}).y() > 0);
    }

    void theSpeedAfterIsNotThatBefore()
    {
        openBoth();
        session_->edit("Set", [&](project::Project& project) {
            lathelier::set(project.panels["surface"].parameters, "speed_before_rpm", Value());
        });
        settle();
        QVERIFY(!found().images[0].speed_rpm && !found().images[0].chatter_marks->frequency_hz);
        QCOMPARE(*found().images[1].speed_rpm, 2154.0);
    }

    void theSecondPictureHasItsOwnScale()
    {
        openBoth();
        auto* alike = panel_->findChild<QCheckBox*>("surfaceAlike");
        views().primaryViews()->setPrimary("photograph");
        QVERIFY(alike && alike->isVisible() && alike->isChecked());
        alike->click();
        panel_->findChild<QToolButton*>("showAfter")->click();
        emit views().photograph()->scaleRequested(1000, 32);
        emit views().photograph()->directionRequested(4.26);
        settle();
        QCOMPARE(*found().images[0].mm_per_px, 0.03);
        QCOMPARE(*found().images[1].mm_per_px, 0.032);
        QCOMPARE(*found().images[1].feed_direction_deg, 4.3);
        QCOMPARE(*found().images[0].feed_direction_deg, 0.0);
        alike->click();
        settle();
        QCOMPARE(*found().images[1].mm_per_px, 0.03);
    }

    void thePicturesAreLaidOverEachOther()
    {
        openBoth();
        views().primaryViews()->setPrimary("comparison");
        ComparisonView* both = views().comparison();
        panel_->findChild<QToolButton*>("surfaceLay")->click();
        QTest::mouseClick(both->before(), Qt::LeftButton, {}, both->before()->placeOf({100, 300}).toPoint());
        QTest::mouseClick(both->after(), Qt::LeftButton, {}, both->after()->placeOf({130, 260}).toPoint());
        settle();
        QVERIFY(std::abs(panel_->result()->laid.x - 30) < 3 && std::abs(panel_->result()->laid.y + 40) < 3);
        QCOMPARE(both->before()->tool(), PictureView::Tool::None);
        session_->undoStack().undo();
        settle();
        QCOMPARE(panel_->result()->laid.x, 0.0);
    }

    void theMagnifierShowsOnePlaceInBoth()
    {
        openBoth();
        views().primaryViews()->setPrimary("comparison");
        ComparisonView* both = views().comparison();
        const QImage plain = both->after()->grab().toImage();
        panel_->findChild<QToolButton*>("surfaceMagnifier")->click();
        QTest::mouseMove(both->before(), both->before()->placeOf({120, 400}).toPoint());
        QTRY_VERIFY(both->before()->lens() && both->after()->lens());
        QCOMPARE(*both->after()->lens(), *both->before()->lens());
        QVERIFY(both->after()->grab().toImage() != plain);
        panel_->findChild<QToolButton*>("surfaceMagnifier")->click();
        QVERIFY(!both->after()->lens());
    }
};

}  // namespace lathelier::surface_panel

QTEST_MAIN(lathelier::surface_panel::SurfacePairTest)
#include "surface_pair_test.moc"
