#include "widgets/plot/polar_view.h"

#include <QDir>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <numbers>

#include "engine/report/svg.h"
#include "widgets/core/resources.h"
#include "widgets/plot/plot_style.h"

using namespace lathelier;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Radius 25 mm, 5 µm of three lobes, with a reference circle 8 µm off the centre and two contacts.
report::PolarPlot lobes(int samples = 720)
{
    report::PolarPlot plot;
    plot.title = std::string("Roundness");
    plot.base_radius_mm = 25;
    report::PolarPlot::Trace trace;
    trace.name = std::string("profile");
    for (int i = 0; i < samples; ++i) {
        trace.angle_deg.push_back(i * 360.0 / samples);
        trace.deviation_um.push_back(5 * std::cos(3 * trace.angle_deg.back() * degree));
    }
    plot.traces.push_back(trace);
    report::PolarPlot::ReferenceLine circle;
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
    std::unique_ptr<plot::PolarView> view_;

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
    }
    void init()
    {
        view_ = std::make_unique<plot::PolarView>();
        view_->resize(640, 560);
        view_->show();
        view_->setPicture(plot::polarPicture(lobes()));
        QCoreApplication::processEvents();
    }
    void cleanup() { view_.reset(); }

    void offCentreCircleIsExact()
    {
        const auto& circle = view_->polar()->plot.circles.front();
        QCOMPARE(plot::deviationAt(circle, 25, 0), 10.0);
        QVERIFY(std::abs(plot::deviationAt(circle, 25, 180) + 6) < 1e-9);
        // Every point of it lies on the circle: (R0 + d) (cos, sin) is R away from (x, y).
        for (int angle = 0; angle < 360; angle += 7) {
            const double r_um = 25000 + plot::deviationAt(circle, 25, angle);
            const double away = std::hypot(r_um * std::cos(angle * degree) - 8, r_um * std::sin(angle * degree));
            QVERIFY(std::abs(away - 25002) < 1e-6);
        }
        QVERIFY(std::isnan(plot::deviationAt({std::string(), 3000, 0, -500}, 1, 90)));
    }

    void thinningKeepsExtremes()
    {
        report::PolarPlot plot = lobes(400000);
        plot.traces.front().deviation_um[12345] = 40;
        plot.traces.front().deviation_um[222222] = -40;
        const plot::PolarPicturePtr picture = plot::polarPicture(plot);
        QCOMPARE(picture->highest_um, 40.0);
        QCOMPARE(picture->lowest_um, -40.0);
        QVERIFY(picture->lines.front().angle_deg.size() <= 4 * 3600);
        QVERIFY(picture->lines.front().closed);
    }

    void gapsStayOpen()
    {
        report::PolarPlot plot = lobes();
        for (std::size_t i = 100; i < 180; ++i) plot.traces.front().deviation_um[i] = std::nan("");
        const plot::PolarLine line = plot::polarPicture(plot)->lines.front();
        QCOMPARE(std::count_if(line.angle_deg.begin(), line.angle_deg.end(), [](double a) { return std::isnan(a); }),
                 std::ptrdiff_t{1});
        plot.traces.front().angle_deg.resize(600);  // an arc of 300°
        plot.traces.front().deviation_um.resize(600);
        QVERIFY(!plot::polarPicture(plot)->lines.front().closed);
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
        QSignalSpy changed(view_.get(), &plot::PolarView::magnificationChanged);
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
        QSignalSpy pointed(view_.get(), &plot::PolarView::pointed);
        const QPoint place = view_->pixelAt(120.1, 3).toPoint();
        hover(view_.get(), place);
        QVERIFY(pointed.count() > 0);
        QVERIFY2(view_->readout().contains("120") && view_->readout().contains("+5.00 µm"),
                 qPrintable(view_->readout()));
    }

    void theOtherCircleOfAZoneHasANameInTheTable()
    {
        report::PolarPlot plot = lobes();
        plot.circles.push_back({std::string(), 8, 0, -6});
        QVERIFY(plot::toCsv(plot).contains("\n\"MCCI, inner circle\",0,2\n"));
    }

    void aCircleIsDrawnWhenItIsAskedFor()
    {
        report::PolarPlot plot = lobes();
        plot.circles[0].asked = "MCCI";
        view_->setPicture(plot::polarPicture(plot));
        const QImage without = view_->grab().toImage();
        view_->setAsked("LSCI");
        QCOMPARE(view_->grab().toImage(), without);
        view_->setAsked("MCCI");
        QVERIFY(view_->grab().toImage() != without);
        QVERIFY(view_->csv().contains("MCCI"));  // the data are whole
        view_->setAsked({});
        QCOMPARE(view_->grab().toImage(), without);
    }

    void theZoneBetweenTwoCirclesIsShaded()
    {
        report::PolarPlot plot = lobes();
        plot.circles.clear();
        plot.contacts.clear();
        plot.rings = {{std::string("zone"), 0, 0, -5, 5, report::ColourRole::Limit}};
        view_->setPicture(plot::polarPicture(plot));
        const QImage shown = view_->grab().toImage();
        const auto at = [&](double deviation_um) {
            return shown.pixelColor(view_->pixelAt(45, deviation_um).toPoint());  // no spoke, no curve, no number
        };
        const QColor inside = at(1.3), outside = at(-8);
        QVERIFY2(inside.blue() < outside.blue() - 10, qPrintable(inside.name() + " " + outside.name()));
    }

    void theTagAtThePointerSaysTheValueFirst()
    {
        hover(view_.get(), view_->pixelAt(120, 0).toPoint());
        QCOMPARE(view_->tag().words().value, QString("+5.00 µm"));
        QCOMPARE(view_->tag().words().place, QString("120.0°"));
        QVERIFY(view_->tag().isVisible());
        hover(view_.get(), QPoint(1, 1));
        QVERIFY(!view_->tag().isVisible());
    }

    void titleAndMagnificationStayBesideTheReadout()
    {
        const auto top = [&] { return view_->grab(QRect(0, 0, 640, view_->fontMetrics().height() + 4)).toImage(); };
        const QImage before = top();
        view_->setMarker(45.0);
        QVERIFY(!view_->readout().isEmpty());
        QCOMPARE(top(), before);
        hover(view_.get(), view_->pixelAt(120, 3).toPoint());
        QCOMPARE(top(), before);
        // A low plot has no line for it: it covers the title, never the magnification at the right.
        const auto right = [&] { return view_->grab(QRect(220, 0, 100, view_->fontMetrics().height())).toImage(); };
        view_->resize(320, 12 * view_->fontMetrics().height());
        view_->setMarker({});
        hover(view_.get(), {1, 1});
        const QImage stated = right();
        view_->setMarker(45.0);
        QCOMPARE(right(), stated);
    }

    void doubleClickLeavesTheMarker()
    {
        view_->setMarker(90.0);
        QSignalSpy clicked(view_.get(), &plot::PolarView::clicked), unmarked(view_.get(), &plot::PolarView::unmarked);
        const QPoint place = view_->pixelAt(45, 0).toPoint();
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, place);
        QCOMPARE(*view_->marker(), 90.0);
        QCOMPARE(clicked.last()[0].toDouble(), 90.0);  // and the linked views go back
        view_->setMarker({});
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, place);
        QVERIFY(!view_->marker());
        QCOMPARE(unmarked.count(), 1);
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, place);
        QTest::keyClick(view_.get(), Qt::Key_Escape);
        QVERIFY(!view_->marker());
        QCOMPARE(unmarked.count(), 2);
    }

    void scaleNeverHidesTheData()
    {
        // A profile so dense that there is no free place for the numbers: it must be drawn unbroken all the same.
        report::PolarPlot plot = lobes();
        plot.circles.clear();
        plot.contacts.clear();
        plot.title = std::string();
        for (int k = 0; k < 40; ++k) {
            report::PolarPlot::Trace ring = plot.traces.front();
            ring.colour = 0;
            for (double& value : ring.deviation_um) value = -5 + k * 0.25;
            plot.traces.push_back(ring);
        }
        view_->setPicture(plot::polarPicture(plot));
        const QImage image = view_->grab().toImage();
        const QColor ink = plot::PlotStyle(view_->palette(), view_->font()).colour(0);
        for (const report::PolarPlot::Trace& trace : plot.traces)
            for (std::size_t i = 0; i < trace.angle_deg.size(); ++i) {
                const QPoint place = view_->pixelAt(trace.angle_deg[i], trace.deviation_um[i]).toPoint();
                int away = 500;
                for (const QPoint& step : {QPoint(0, 0), QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)}) {
                    const QColor seen = image.pixelColor(place + step);
                    away = std::min(away, std::abs(seen.red() - ink.red()) + std::abs(seen.green() - ink.green()));
                }
                QVERIFY2(away < 200, qPrintable(QString("%1° %2").arg(trace.angle_deg[i]).arg(away)));
            }
    }

    void theDiscComesBeforeTheLegend()
    {
        report::PolarPlot plot = lobes();
        plot.circles.clear();
        for (const char* name :
             {"LSCI  RONt 10.77 µm", "MZCI  RONt 9.49 µm", "MICI  RONt 13.62 µm", "MCCI  RONt 11.29 µm"})
            plot.circles.push_back({std::string(name), 1, 1, 2});
        view_->setPicture(plot::polarPicture(plot));
        QFont large = view_->font();
        large.setPixelSize(21);
        view_->setFont(large);
        view_->resize(533, 483);  // presenter mode at 1280x800
        view_->grab().save(qEnvironmentVariable("LATHELIER_LOOK", QDir::tempPath()) + "/polar_presenter.png");
        QVERIFY2(view_->discRect().width() > 260, qPrintable(QString::number(view_->discRect().width())));
        view_->resize(250, 200);
        QVERIFY2(view_->discRect().width() > 120, qPrintable(QString::number(view_->discRect().width())));
        for (const QSize& size : {QSize(180, 180), QSize(533, 483), QSize(900, 300), QSize(300, 900)}) {
            view_->resize(size);
            QVERIFY(QRectF(view_->rect()).contains(view_->discRect()));
        }
    }

    void oneSidedDeviationsAreDrawnAsLarge()
    {
        for (const double side : {5.0, -5.0}) {
            report::PolarPlot plot = lobes();
            plot.circles.clear();
            plot.contacts.clear();
            const double both = plot::fittingMagnification(*plot::polarPicture(plot));
            for (double& value : plot.traces.front().deviation_um) value += side;  // from an inscribed circle, say
            QVERIFY(plot::fittingMagnification(*plot::polarPicture(plot)) >= both / 2);
        }
    }

    void screenAndReportShareTheirColours()
    {
        const plot::PlotStyle paper(plot::paperPalette(), view_->font());
        for (int i = 0; i < 8; ++i) QCOMPARE(paper.colour(i).name().toStdString(), report::hex(report::colourOf(i)));
    }

    void clickAndKeysMoveTheMarker()
    {
        QSignalSpy clicked(view_.get(), &plot::PolarView::clicked);
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
        // 720 samples; the circle, degree by degree; two contacts.
        QCOMPARE(view_->csv().count('\n'), 1 + 720 + 360 + 2);
        QVERIFY(view_->csv().contains("\n\"MCCI\",0,10\n"));
        QVERIFY(view_->csv().contains("\n\"outer contact\",0,5\n\"inner contact\",60,-5\n"));
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
        view_->setPicture(plot::polarPicture(report::PolarPlot{}));
        QVERIFY(!view_->grab().isNull());
        view_->setPicture(nullptr);
        QVERIFY(!view_->grab().isNull());
        QCOMPARE(view_->readout(), QString());
    }
};

QTEST_MAIN(PolarViewTest)
#include "polar_view_test.moc"
