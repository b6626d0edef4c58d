#include "widgets/plot/polar_view.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <numbers>

#include "widgets/core/resources.h"

using namespace lathelier;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Radius 25 mm, 5 µm of three lobes, with a reference circle 8 µm off the centre and two contacts.
PolarPlot lobes(int samples = 720)
{
    PolarPlot plot;
    plot.title = std::string("Roundness");
    plot.base_radius_mm = 25;
    PolarPlot::Trace trace;
    trace.name = std::string("profile");
    for (int i = 0; i < samples; ++i) {
        trace.angle_deg.push_back(i * 360.0 / samples);
        trace.deviation_um.push_back(5 * std::cos(3 * trace.angle_deg.back() * degree));
    }
    plot.traces.push_back(trace);
    PolarPlot::ReferenceLine circle;
    circle.name = std::string("MCCI");
    circle.x_um = 8;
    circle.deviation_um = 2;
    plot.circles.push_back(circle);
    plot.contacts = {{0, 5, true}, {60, -5, false}};
    return plot;
}

void turnWheel(QWidget* view, int clicks)
{
    QWheelEvent event(QPointF(50, 50), view->mapToGlobal(QPoint(50, 50)), {}, QPoint(0, 120 * clicks), Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view, &event);
}

}  // namespace

/// Sent straight to the widget: QTest::mouseMove is silent when the pointer is there already.
static void hover(QWidget* widget, QPoint place)
{
    QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(widget, &move);
}

class PolarViewTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<PolarView> view_;

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
    }
    void init()
    {
        view_ = std::make_unique<PolarView>();
        view_->resize(640, 560);
        view_->show();
        view_->setPicture(polarPicture(lobes()));
        QCoreApplication::processEvents();
    }
    void cleanup() { view_.reset(); }

    void offCentreCircleIsExact()
    {
        const auto& circle = view_->polar()->plot.circles.front();
        QCOMPARE(deviationAt(circle, 25, 0), 10.0);
        QVERIFY(std::abs(deviationAt(circle, 25, 180) + 6) < 1e-9);
        // Every point of it lies on the circle: (R0 + d) (cos, sin) is R away from (x, y).
        for (int angle = 0; angle < 360; angle += 7) {
            const double r_um = 25000 + deviationAt(circle, 25, angle);
            const double away = std::hypot(r_um * std::cos(angle * degree) - 8, r_um * std::sin(angle * degree));
            QVERIFY(std::abs(away - 25002) < 1e-6);
        }
        QVERIFY(std::isnan(deviationAt({std::string(), 3000, 0, -500}, 1, 90)));
    }

    void thinningKeepsExtremes()
    {
        PolarPlot plot = lobes(400000);
        plot.traces.front().deviation_um[12345] = 40;
        plot.traces.front().deviation_um[222222] = -40;
        const PolarPicturePtr picture = polarPicture(plot);
        QCOMPARE(picture->highest_um, 40.0);
        QCOMPARE(picture->lowest_um, -40.0);
        QVERIFY(picture->lines.front().angle_deg.size() <= 4 * 3600);
        QVERIFY(picture->lines.front().closed);
    }

    void gapsStayOpen()
    {
        PolarPlot plot = lobes();
        for (std::size_t i = 100; i < 180; ++i) plot.traces.front().deviation_um[i] = std::nan("");
        const PolarLine line = polarPicture(plot)->lines.front();
        QCOMPARE(std::count_if(line.angle_deg.begin(), line.angle_deg.end(), [](double a) { return std::isnan(a); }),
                 std::ptrdiff_t{1});
        plot.traces.front().angle_deg.resize(600);  // an arc of 300°
        plot.traces.front().deviation_um.resize(600);
        QVERIFY(!polarPicture(plot)->lines.front().closed);
    }

    void magnificationIsRoundAndTrue()
    {
        const double magnification = view_->magnification();
        const double lead = magnification / std::pow(10, std::floor(std::log10(magnification)));
        QVERIFY(std::abs(lead - 1) < 1e-9 || std::abs(lead - 2) < 1e-9 || std::abs(lead - 5) < 1e-9);
        // What is drawn is what is stated: (25 mm + M · 5 µm) : 25 mm.
        const QPointF centre = (view_->pixelAt(0, 0) + view_->pixelAt(180, 0)) / 2;
        const double base = view_->pixelAt(0, 0).x() - centre.x();
        const double out = view_->pixelAt(0, 5).x() - centre.x();
        QVERIFY(std::abs(out / base - (25 + magnification * 0.005) / 25) < 1e-9);
    }

    void wheelMagnifiesAndDoubleClickResets()
    {
        const double first = view_->magnification();
        QSignalSpy changed(view_.get(), &PolarView::magnificationChanged);
        turnWheel(view_.get(), 1);
        QVERIFY(view_->magnification() >= 2 * first);
        turnWheel(view_.get(), -2);
        QVERIFY(view_->magnification() < first);
        QCOMPARE(changed.count(), 2);
        QTest::mouseDClick(view_.get(), Qt::LeftButton);
        QCOMPARE(view_->magnification(), first);
    }

    void pointerReadsTheNearestPoint()
    {
        QVERIFY(view_->readout().isEmpty());
        QSignalSpy pointed(view_.get(), &PolarView::pointed);
        const QPoint place = view_->pixelAt(120.1, 3).toPoint();
        hover(view_.get(), place);
        QVERIFY(pointed.count() > 0);
        QVERIFY2(view_->readout().contains("120") && view_->readout().contains("+5.00 µm"),
                 qPrintable(view_->readout()));
    }

    void clickAndKeysMoveTheMarker()
    {
        QSignalSpy clicked(view_.get(), &PolarView::clicked);
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, view_->pixelAt(45, 0).toPoint());
        QCOMPARE(clicked.count(), 1);
        QVERIFY(std::abs(*view_->marker() - 45) < 0.5);
        view_->setMarker(90.0);
        QTest::keyClick(view_.get(), Qt::Key_Left);
        QCOMPARE(*view_->marker(), 90.5);
        QTest::keyClick(view_.get(), Qt::Key_Right);
        QTest::keyClick(view_.get(), Qt::Key_Right);
        QCOMPARE(*view_->marker(), 89.5);
        view_->setMarker(0.0);
        QTest::keyClick(view_.get(), Qt::Key_Right);
        QCOMPARE(*view_->marker(), 359.5);
    }

    void picturesAndDataAreWritten()
    {
        QTemporaryDir folder;
        for (const char* name : {"plot.svg", "plot.pdf", "plot.png"}) {
            QVERIFY(view_->savePicture(folder.filePath(name)));
            QVERIFY(QFileInfo(folder.filePath(name)).size() > 1000);
        }
        QFile svg(folder.filePath("plot.svg"));
        QVERIFY(svg.open(QIODevice::ReadOnly));
        QVERIFY(svg.readAll().contains("<polyline"));
        QVERIFY(view_->saveData(folder.filePath("plot.csv")));
        QVERIFY(view_->csv().startsWith("trace,angle_deg,deviation_um\n\"profile\",0,5\n"));
        QCOMPARE(view_->csv().count('\n'), 721);
        QVERIFY(!view_->savePicture(folder.filePath("no/such/folder/plot.svg")));
        QVERIFY(!view_->saveData(folder.filePath("no/such/folder/plot.csv")));
        view_->picture().save(qEnvironmentVariable("LATHELIER_LOOK", folder.path()) + "/polar.png");
    }

    void darkAndEmptyAreDrawn()
    {
        QPalette dark(QColor(220, 220, 220), QColor(40, 40, 40));
        dark.setColor(QPalette::Base, QColor(30, 30, 30));
        dark.setColor(QPalette::Text, QColor(230, 230, 230));
        view_->setPalette(dark);
        QVERIFY(qGray(view_->grab().toImage().pixel(2, 2)) < 64);
        view_->setPicture(polarPicture(PolarPlot{}));
        QVERIFY(!view_->grab().isNull());
        view_->setPicture(nullptr);
        QVERIFY(!view_->grab().isNull());
        QCOMPARE(view_->readout(), QString());
    }
};

QTEST_MAIN(PolarViewTest)
#include "polar_view_test.moc"
