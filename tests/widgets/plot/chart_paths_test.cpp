#include "widgets/plot/chart_view.h"

#include <QMouseEvent>
#include <QTest>
#include <cmath>
#include <numbers>

using namespace lathelier;

/// Sent straight to the widget: QTest::mouseMove is silent when the pointer is there already.
static void hover(QWidget* widget, QPoint place)
{
    QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(widget, &move);
}

class ChartPathsTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<plot::ChartView> view_;

    static report::Plot circle()
    {
        report::Plot data;
        data.title = "Path";
        data.x = {"X", Text{"µm"}};
        data.y = {"Y", Text{"µm"}};
        data.along = {"angle", Text{"°"}};
        data.equal_scales = true;
        report::Curve curve;
        curve.name = "axis";
        for (int i = 0; i < 360; ++i) {
            const double angle = i * std::numbers::pi / 180;
            curve.x.push_back(12 * std::cos(angle));
            curve.y.push_back(12 * std::sin(angle));
            curve.along.push_back(i);
        }
        data.curves.push_back(curve);
        return data;
    }

private slots:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        view_ = std::make_unique<plot::ChartView>();
        view_->resize(700, 320);
        view_->show();
        view_->setData(circle());
        QTest::qWait(60);
    }
    void cleanup() { view_.reset(); }

    void ticksAreThoseOfTheScalesThatAreDrawn()
    {
        view_ = std::make_unique<plot::ChartView>();
        view_->setData(circle());
        view_->resize(320, 600);
        view_->show();
        QTest::qWait(120);
        const QImage first = view_->grab().toImage();
        view_->resetView();  // draws once more
        QTest::qWait(120);
        QVERIFY(view_->grab().toImage() == first);
    }

    void aCircleLooksLikeOne()
    {
        for (const QSize& size : {QSize(700, 320), QSize(320, 600)}) {
            view_->resize(size);
            QTest::qWait(80);
            const double wide = view_->pixelAt(12, 0).x() - view_->pixelAt(-12, 0).x();
            const double high = view_->pixelAt(0, -12).y() - view_->pixelAt(0, 12).y();
            QVERIFY2(std::abs(wide / high - 1) < 0.02, qPrintable(QString("%1 %2").arg(wide).arg(high)));
            const QRectF seen = view_->visibleRange();
            QVERIFY(seen.contains(QPointF(12, 0)) && seen.contains(QPointF(0, -12)));
        }
    }

    void pointerReadsCoordinatesAndRadiusVector()
    {
        hover(view_->findChild<QWidget*>(), view_->pixelAt(0, 11).toPoint());
        const QString text = view_->readout();
        QVERIFY2(text.contains("radius vector 12") && text.contains(QStringLiteral(" · 90.0°")), qPrintable(text));
    }

    void dataAreWritten()
    {
        const QString csv = view_->csv();
        QVERIFY(csv.startsWith("curve,angle (°),x,y\n\"axis\",0,12,0\n"));
        QCOMPARE(csv.count('\n'), 361);
    }

    void markerAndEmptyDataAreDrawn()
    {
        view_->setMarker(45.0);
        view_->setMarker({});
        view_->setData({});
        QVERIFY(!view_->grab().isNull());
    }

    /// Every side of a closed outline is drawn, also where only a part of it is shown and no corner lies in it.
    void anOutlineIsDrawnWhereItGoesBack()
    {
        report::Plot data;
        data.title = "Outline";
        data.x = {"z", Text{"mm"}};
        data.y = {"radius", Text{"mm"}};
        data.x.range = Interval{45, 55};
        data.y.range = Interval{-5, 15};
        report::Curve curve;
        curve.x = {0, 0, 100, 100, 0};
        curve.y = {1, 10, 10, 1, 1};
        data.curves.push_back(curve);
        view_->setData(data);
        const auto isDrawn = [this](double y) {
            const QImage drawn = view_->grab().toImage();
            const QPoint place = view_->pixelAt(50, y).toPoint();
            for (int dy = -2; dy <= 2; ++dy)
                if (drawn.pixelColor(place + QPoint(7, dy)).saturation() > 80) return true;
            return false;
        };
        QTRY_VERIFY(isDrawn(1));
        QTRY_VERIFY(isDrawn(10));
    }

    void whatIsPointedOutIsDrawnAndTakenAway()
    {
        const QPoint place = view_->pixelAt(0, 0).toPoint();
        const auto colour = [&] { return view_->grab().toImage().pixelColor(place + QPoint(4, 0)); };
        const QColor before = colour();
        plot::PointedOut out;
        out.lines.push_back(QPolygonF() << QPointF(-6, 0) << QPointF(6, 0));
        out.place = QPointF(6, 0);
        view_->pointOut(out);
        QTRY_VERIFY(colour() != before);
        view_->pointOut({});
        QTRY_COMPARE(colour(), before);
    }
};

QTEST_MAIN(ChartPathsTest)
#include "chart_paths_test.moc"
