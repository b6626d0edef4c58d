// What mouse and keyboard do with the handles of a chart, on linear and logarithmic axes, and the regions behind them.
#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <limits>

#include "tests/widgets/plot/chart_fixture.h"

using namespace lathelier;

namespace {

/// A curve with a tolerance to drag.
/// A limit over speed with the regions beside it and an operating point.
report::Plot lobes()
{
    report::Plot plot;
    plot.title = "Lobes";
    plot.x = {"Speed", Text{"1/min"}, report::Axis::Scale::Logarithmic, Interval{100, 10000}};
    plot.y = {"Depth", Text{"mm"}, report::Axis::Scale::Logarithmic, Interval{0.1, 10}};
    report::Curve curve;
    curve.name = "limit";
    curve.x = {100, 1000, 10000};
    curve.y = {2, 2, 2};
    const std::vector<double> end(3, std::numeric_limits<double>::infinity());
    plot.regions = {report::between("stable", report::ColourRole::Stable, curve.x, {0, 0, 0}, curve.y),
                    report::between("unstable", report::ColourRole::Unstable, curve.x, curve.y, end)};
    plot.curves = {curve};
    plot.handles = {{"operating", report::Handle::Kind::Point, 1000, 1, "operating point", Interval{200, 5000}, {}}};
    return plot;
}

}  // namespace

class ChartHandlesTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<plot::ChartView> view_;

private slots:
    void init() { view_ = shownParabola(); }
    void cleanup() { view_.reset(); }

    void aHandleIsDraggedWithoutPanning()
    {
        QSignalSpy moved(view_.get(), &plot::ChartView::handleMoved);
        const QRectF before = view_->visibleRange();
        drag(surface(*view_), at(*view_, 80, 40), at(*view_, 60, 40));
        QCOMPARE(view_->visibleRange(), before);
        QVERIFY(moved.count() >= 4);
        for (int i = 0; i < moved.count(); ++i) QCOMPARE(moved[i][3].toBool(), i + 1 == moved.count());
        QCOMPARE(moved.last()[0].toString(), QString("limit"));
        QVERIFY(std::abs(moved.last()[1].toDouble() - 60) < 0.5);
        QVERIFY(std::abs(view_->data().handles[0].x - 60) < 0.5);
    }

    void newDataLeaveTheHandleWithThePointer()
    {
        const QPoint from = at(*view_, 80, 40), to = at(*view_, 50, 40);
        QTest::mousePress(surface(*view_), Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(surface(*view_), &move);
        view_->setData(parabola());
        QVERIFY(std::abs(view_->data().handles[0].x - 50) < 0.5);
        report::Plot without = parabola();
        without.handles.clear();
        view_->setData(without);
        QSignalSpy moved(view_.get(), &plot::ChartView::handleMoved);
        QTest::mouseRelease(surface(*view_), Qt::LeftButton, {}, to);
        QCOMPARE(moved.count(), 0);  // it is gone
    }

    void aPointIsDraggedOnLogarithmicAxes()
    {
        view_->setData(lobes());
        QCoreApplication::processEvents();
        const double middle = (view_->pixelAt(100, 1).x() + view_->pixelAt(10000, 1).x()) / 2;
        QVERIFY(std::abs(view_->pixelAt(1000, 1).x() - middle) < 1);
        QSignalSpy moved(view_.get(), &plot::ChartView::handleMoved);
        drag(surface(*view_), at(*view_, 1000, 1), at(*view_, 3000, 0.3));
        QCOMPARE(moved.last()[0].toString(), QString("operating"));
        QVERIFY2(std::abs(moved.last()[1].toDouble() / 3000 - 1) < 0.01, qPrintable(moved.last()[1].toString()));
        QVERIFY2(std::abs(moved.last()[2].toDouble() / 0.3 - 1) < 0.01, qPrintable(moved.last()[2].toString()));
        QVERIFY(moved.last()[3].toBool());
        QVERIFY(view_->readout().contains("operating point"));
        drag(surface(*view_), at(*view_, 3000, 0.3), at(*view_, 9000, 0.3));
        QCOMPARE(view_->data().handles[0].x, 5000.0);  // as far as it may go
        view_->setHandle("operating", 150, 2);
        QCOMPARE(view_->data().handles[0].x, 200.0);
        QCOMPARE(view_->data().handles[0].y, 2.0);
    }

    void aHandleIsMovedByKeys()
    {
        view_->setData(lobes());
        view_->setFocus();
        QSignalSpy moved(view_.get(), &plot::ChartView::handleMoved);
        const QRectF before = view_->visibleRange();
        QTest::keyClick(view_.get(), Qt::Key_Tab);  // to the handle, not out of the chart
        QTest::keyClick(view_.get(), Qt::Key_Right);
        QCOMPARE(moved.count(), 2);
        QVERIFY(!moved[0][3].toBool() && moved[1][3].toBool());
        QVERIFY(std::abs(moved[1][1].toDouble() / (1000 * std::pow(100, 0.01)) - 1) < 1e-9);  // 1 % of two decades
        QTest::keyClick(view_.get(), Qt::Key_Down, Qt::ShiftModifier);
        QVERIFY(std::abs(moved.last()[2].toDouble() / std::pow(100, -0.001) - 1) < 1e-9);
        QCOMPARE(view_->visibleRange(), before);
        QTest::keyClick(view_.get(), Qt::Key_Escape);
        QTest::keyClick(view_.get(), Qt::Key_Right);  // pans again, by a factor
        QVERIFY(std::abs(view_->visibleRange().left() / (before.left() * std::pow(100, 0.1)) - 1) < 1e-9);
        QVERIFY(std::abs(view_->visibleRange().right() / (before.right() * std::pow(100, 0.1)) - 1) < 1e-9);
    }

    void regionsAreShadedToTheEdge()
    {
        view_->setData(lobes());
        QCoreApplication::processEvents();
        const QImage image = view_->grab().toImage();
        const auto differs = [&](double x, double y) {
            return image.pixelColor(at(*view_, x, y)) != image.pixelColor(at(*view_, x, 1.3 * y));
        };
        QVERIFY(image.pixelColor(at(*view_, 150, 0.13)) != image.pixelColor(at(*view_, 150, 8.5)));
        QVERIFY(!differs(150, 0.13));
        QVERIFY(!differs(150, 6.7));
    }
};

QTEST_MAIN(ChartHandlesTest)
#include "chart_handles_test.moc"
