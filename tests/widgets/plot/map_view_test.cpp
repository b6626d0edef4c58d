#include "widgets/plot/map_view.h"

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

using namespace lathelier;

namespace {

/// Four columns (z 0…40) by three rows (0…360°); the last cell has no data.
report::ColourMap small()
{
    report::ColourMap map;
    map.title = "Unrolled";
    map.x = {"z", Text{"mm"}};
    map.y = {"angle", Text{"°"}};
    map.value = {"Deviation", Text{"mm"}};
    map.x_to = 40;
    map.y_to = 360;
    map.columns = 4;
    map.rows = 3;
    map.values = {0.00F, 0.02F, 0.06F, 0.2F, -0.02F, -0.06F, -0.2F, 0.F, 0.F, 0.F, 0.F, std::nanf("")};
    return map;
}

void hover(QWidget* widget, QPoint place)
{
    QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(widget, &move);
}

bool near(QColor a, report::Rgb b)
{
    return std::abs(a.red() - b.red) + std::abs(a.green() - b.green) + std::abs(a.blue() - b.blue) <= 6;
}

}  // namespace

class MapViewTest : public QObject {
    Q_OBJECT

private:
    plot::MapView* view_ = nullptr;

    QColor pixel(double x, double y)
    {
        QCoreApplication::processEvents();
        return view_->grab().toImage().pixelColor(view_->pixelAt(x, y).toPoint());
    }

private slots:
    void init()
    {
        view_ = new plot::MapView;
        view_->setColours({0.2, {}});
        view_->setData(small());
        view_->resize(640, 400);
        view_->show();
        QVERIFY(QTest::qWaitForWindowExposed(view_));
        QCoreApplication::processEvents();
    }
    void cleanup() { delete view_; }

    void cellsHaveTheColourOfTheirValue()
    {
        const report::DeviationColours rule{0.2, {}};
        QVERIFY(near(pixel(5, 60), rule(0)));
        QVERIFY(near(pixel(35, 60), rule(0.2)));
        QVERIFY(near(pixel(25, 180), rule(-0.2)));
        QVERIFY2(near(pixel(35, 300), {255, 255, 255}), "blank where no data are");
        QVERIFY(!view_->colourAt(35, 300).isValid());
    }

    void greenComesWithTheTolerance()
    {
        const auto isGreen = [](QColor c) { return c.green() > c.red() + 20 && c.green() >= c.blue(); };
        QVERIFY(!isGreen(pixel(15, 60)));
        view_->setColours({0.2, 0.05});
        QVERIFY(isGreen(pixel(15, 60)));
        QVERIFY(!isGreen(pixel(25, 60)));
        view_->setColours({0.2, 0.07});
        QVERIFY(isGreen(pixel(25, 60)));
    }

    void crosshairSaysPlaceAndValue()
    {
        view_->setLocale(QLocale::c());
        QWidget* surface = view_->findChild<QWidget*>();
        hover(surface, view_->pixelAt(25, 60).toPoint());
        QVERIFY2(view_->readout().contains("0.060"), qPrintable(view_->readout()));
        QVERIFY(view_->readout().contains("°"));
        hover(surface, view_->pixelAt(35, 300).toPoint());
        QVERIFY(view_->readout().contains("no data"));
    }

    void clickPicksAndMarkerIsKept()
    {
        QSignalSpy clicks(view_, &plot::PlotCanvas::clicked);
        QTest::mouseClick(view_->findChild<QWidget*>(), Qt::LeftButton, {}, view_->pixelAt(12, 100).toPoint());
        QCOMPARE(clicks.count(), 1);
        QVERIFY(std::abs(clicks[0][0].toDouble() - 12) < 0.2);
        QVERIFY(std::abs(clicks[0][1].toDouble() - 100) < 2);
        view_->setMarker(QPointF(12, 100));
        QCOMPARE(*view_->marker(), QPointF(12, 100));
    }

    void scaleIsEdited()
    {
        QSignalSpy edits(view_, &plot::MapView::limitEdited);
        auto* box = view_->findChild<QDoubleSpinBox*>();
        QVERIFY(box && box->isVisible());
        QCOMPARE(box->value(), 0.2);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, box->locale().toString(0.5));
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(edits.count(), 1);
        QCOMPARE(edits[0][0].toDouble(), 0.5);
        view_->setColours({0.3, {}});  // set from outside: no echo
        QCOMPARE(box->value(), 0.3);
        QCOMPARE(edits.count(), 1);
    }

    void eachSideOfTheScaleByItself()
    {
        QSignalSpy edits(view_, &plot::MapView::limitEdited);
        auto* lower = view_->findChild<QDoubleSpinBox*>("scaleLower");
        QVERIFY(lower && !lower->isVisible());
        view_->findChild<QAction*>("scaleApart")->trigger();
        QVERIFY(lower->isVisible());
        lower->setValue(0.05);
        QCOMPARE(edits.back()[1].toDouble(), 0.05);
        report::DeviationColours colours{0.2};
        colours.lower = 0.05;
        QCOMPARE(colours.least(), -0.05);
        QVERIFY(colours(-0.05) == report::divergingColour(-1));
        QVERIFY(colours(0.05) == report::divergingColour(0.25));
        view_->setColours(colours);
        QCOMPARE(lower->value(), 0.05);
        view_->setColours({0.2, {}});
        QVERIFY(!lower->isVisible());
    }

    void csvListsCellsWithData()
    {
        const QStringList lines = view_->csv().split('\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 12);  // head and 11 cells
        QCOMPARE(lines[0], QString("z (mm),angle (°),Deviation (mm)"));
        QCOMPARE(lines[1], QString("5,60,0"));
    }
};

QTEST_MAIN(MapViewTest)
#include "map_view_test.moc"
