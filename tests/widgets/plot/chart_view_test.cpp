#include "tests/widgets/plot/chart_fixture.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QMenu>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <QWindow>
#include <cmath>

#include "widgets/core/language.h"

using namespace lathelier;

class ChartViewTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<plot::ChartView> view_;

private slots:
    void init() { view_ = shownParabola(); }
    void cleanup() { view_.reset(); }

    void showsTheWholeCurveAndTheLimit()
    {
        const QRectF range = view_->visibleRange();
        QVERIFY(range.left() < 0 && range.right() > 100);
        QVERIFY(range.top() < 0 && range.bottom() > 100);
    }

    void crosshairSaysTheValueOfTheCurve()
    {
        hover(surface(*view_), at(*view_, 50, 60));
        QVERIFY2(QRegularExpression("z (49\\.9|50\\.[01])").match(view_->readout()).hasMatch(),
                 qPrintable(view_->readout()));
        QVERIFY2(view_->readout().contains("copy 25.0"), qPrintable(view_->readout()));
        QVERIFY(view_->readout().contains("mm"));
    }

    void crosshairSpeaksTheUsersLocale()
    {
        view_->setLocale(QLocale(QLocale::Polish));
        hover(surface(*view_), at(*view_, 50, 60));
        QVERIFY2(view_->readout().contains("copy 25,0"), qPrintable(view_->readout()));
    }

    void speaksAndTicksInTheUnitOfTheUser()
    {
        setScreenUnits({ScreenUnits::Length::Inch, ScreenUnits::Form::Micrometre});
        view_->setData(parabola());
        hover(surface(*view_), at(*view_, 50.8, 60));
        const QString read = view_->readout();
        setScreenUnits({});
        QVERIFY2(QRegularExpression("z (1\\.99|2\\.00)\\d* in").match(read).hasMatch(), qPrintable(read));
        QVERIFY2(read.contains("copy 1.0"), qPrintable(read));  // 26 mm
        QVERIFY2(!read.contains("mm"), qPrintable(read));
        QVERIFY2(view_->csv().startsWith("z (mm)"), qPrintable(view_->csv().left(20)));  // files keep the engine's
    }

    void wheelZoomsAboutThePointerAndDoubleClickResets()
    {
        const QRectF before = view_->visibleRange();
        const QPoint place = at(*view_, 25, 50);
        QWheelEvent wheel(place, surface(*view_)->mapToGlobal(place), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(surface(*view_), &wheel);
        const QRectF after = view_->visibleRange();
        QVERIFY(after.width() < 0.8 * before.width());
        QVERIFY(after.height() < 0.8 * before.height());
        const auto share = [](const QRectF& range) { return (25 - range.left()) / range.width(); };
        QVERIFY(std::abs(share(after) - share(before)) < 0.005);  // what is under the pointer stays there
        view_->setData(parabola());  // new numbers under the same title keep the user's view
        QCOMPARE(view_->visibleRange().width(), after.width());
        QTest::mouseDClick(surface(*view_), Qt::LeftButton, {}, place);
        QCOMPARE(view_->visibleRange().width(), before.width());
    }

    void theTagSaysTheValueUnderThePointerFirst()
    {
        hover(surface(*view_), at(*view_, 50, 60));
        QVERIFY(view_->tag().isVisible());
        QVERIFY2(view_->tag().words().value.startsWith("25.0"), qPrintable(view_->tag().words().value));
        QVERIFY2(view_->tag().words().place.contains("copy"), qPrintable(view_->tag().words().place));
        QVERIFY(view_->rect().contains(view_->tag().geometry()));
        hover(surface(*view_), at(*view_, 100, 100));  // at the corner the tag stays whole within
        QVERIFY(view_->rect().contains(view_->tag().geometry()));
        hover(surface(*view_), QPoint(1, 1));
        QVERIFY(!view_->tag().isVisible());
    }

    void aStretchIsDrawnWhereItIsWanted()
    {
        QSignalSpy drawn(view_.get(), &plot::PlotCanvas::stretchDrawn);
        QSignalSpy clicks(view_.get(), &plot::PlotCanvas::clicked);
        const QRectF before = view_->visibleRange();
        view_->setDrawsStretch(true);
        drag(surface(*view_), at(*view_, 60, 50), at(*view_, 20, 70));
        QCOMPARE(drawn.count(), 1);
        QVERIFY(std::abs(drawn[0][0].toDouble() - 20) < 0.5 && std::abs(drawn[0][1].toDouble() - 60) < 0.5);
        QCOMPARE(view_->visibleRange(), before);  // nothing was moved
        QTest::mouseClick(surface(*view_), Qt::LeftButton, {}, at(*view_, 30, 50));
        QCOMPARE(drawn.count(), 1);  // a click draws nothing
        QCOMPARE(clicks.count(), 0);
        view_->setDrawsStretch(false);
        drag(surface(*view_), at(*view_, 20, 50), at(*view_, 40, 50));
        QCOMPARE(drawn.count(), 1);
        QVERIFY(view_->visibleRange() != before);
    }

    void aSmallViewLeavesTheRoomToTheData()
    {
        view_->resize(220, 140);
        QTest::qWait(50);  // laid out
        const auto height = [&] { return std::abs(view_->pixelAt(0, 0).y() - view_->pixelAt(0, 100).y()); };
        const double before = height();
        view_->setProperty("smallView", true);
        QTest::qWait(50);
        QVERIFY2(height() > before + 15, qPrintable(QString("%1 %2").arg(before).arg(height())));
    }

    void dragPansAndAClickPoints()
    {
        QSignalSpy clicks(view_.get(), &plot::PlotCanvas::clicked);
        const QRectF before = view_->visibleRange();
        const QPoint from = at(*view_, 20, 50), to = at(*view_, 40, 50);
        drag(surface(*view_), from, to);
        QVERIFY(std::abs(view_->visibleRange().left() - (before.left() - 20)) < 0.5);
        QCOMPARE(view_->visibleRange().width(), before.width());
        QCOMPARE(clicks.count(), 0);
        QTest::mouseClick(surface(*view_), Qt::LeftButton, {}, at(*view_, 30, 50));
        QCOMPARE(clicks.count(), 1);
        QVERIFY(std::abs(clicks[0][0].toDouble() - 30) < 0.5);
    }

    void keyboardZoomsAndPans()
    {
        const QRectF before = view_->visibleRange();
        QTest::keyClick(view_.get(), Qt::Key_Plus);
        QVERIFY(view_->visibleRange().width() < before.width());
        QTest::keyClick(view_.get(), Qt::Key_Right);
        QVERIFY(view_->visibleRange().center().x() > before.center().x());
        QTest::keyClick(view_.get(), Qt::Key_Home);
        QCOMPARE(view_->visibleRange(), before);
    }

    void contextMenuOffersPictureAndData()
    {
        QStringList offered;
        QPoint shownAt;
        const auto look = [&] {
            QTimer::singleShot(50, this, [&] {
                auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
                if (!menu) return;
                for (const QAction* action : menu->actions()) offered << action->text();
                shownAt = menu->pos();
                menu->close();
            });
        };
        look();
        QContextMenuEvent key(QContextMenuEvent::Keyboard, {100, 100}, view_->mapToGlobal({100, 100}));
        QApplication::sendEvent(view_.get(), &key);
        QVERIFY(offered.join('|').contains("Copy picture"));
        QVERIFY(offered.join('|').contains("CSV"));
        offered.clear();
        look();
        // Through the window, as the system does it: a right click anywhere on the plot, at the place of the pointer.
        QTest::mouseClick(view_->windowHandle(), Qt::RightButton, {}, {120, 90});
        QTest::qWait(100);
        QVERIFY2(offered.join('|').contains("CSV"), "no menu by right click");
        QCOMPARE(shownAt, view_->mapToGlobal({120, 90}));
    }

    void picturesAndDataAreWritten()
    {
        const QTemporaryDir folder;
        for (const QString name : {"a.svg", "a.pdf", "a.png"}) {
            QVERIFY2(view_->savePicture(folder.filePath(name)), qPrintable(name));
            QVERIFY2(QFileInfo(folder.filePath(name)).size() > 1000, qPrintable(name));
        }
        QFile svg(folder.filePath("a.svg"));
        QVERIFY(svg.open(QIODevice::ReadOnly));
        QVERIFY2(svg.readAll().contains("radius (mm)"), "text stays text");
        QVERIFY(view_->saveData(folder.filePath("a.csv")));
        QVERIFY(!view_->saveData(folder.filePath("missing/a.csv")));
        QVERIFY(!view_->savePicture(folder.filePath("missing/a.png")));
    }

    void csvHasADecimalPointInEveryLocale()
    {
        QLocale::setDefault(QLocale(QLocale::Polish));
        report::Plot data = parabola();
        data.curves[0].y[1] = 0.1 + 0.2;
        data.curves[0].y[2] = std::nan("");
        view_->setData(data);
        const QStringList lines = view_->csv().split('\n');
        QCOMPARE(lines[0], QString("z (mm),copy (mm)"));
        QCOMPARE(lines[2], QString("1,0.30000000000000004"));
        QCOMPARE(lines[3], QString("2,"));
        QCOMPARE(lines.size(), 103);  // head, 101 rows, the end
    }

    void markerIsShownAndTakenAway()
    {
        view_->setMarker(40);
        QCOMPARE(*view_->marker(), 40.0);
        QCoreApplication::processEvents();
        const QImage marked = view_->grab().toImage();
        view_->setMarker({});
        QCoreApplication::processEvents();
        QVERIFY(marked != view_->grab().toImage());
    }

    void aMillionPointsAreDrawn()
    {
        report::Plot data;
        data.title = "Noise";
        data.x = {"t", Text{"s"}};
        data.y = {"a", Text{"m/s²"}};
        report::Curve curve;
        unsigned state = 1;
        for (int i = 0; i < 1'000'000; ++i) {
            state = state * 1664525U + 1013904223U;
            curve.x.push_back(i * 1e-4);
            curve.y.push_back(state / 4294967296.0 - 0.5);
        }
        data.curves.push_back(curve);
        view_->setData(data);
        QCoreApplication::processEvents();
        const QImage image = view_->grab().toImage();
        const QRgb ink = image.pixel(at(*view_, 50, 0));
        QVERIFY(qBlue(ink) > qRed(ink));  // the curve's blue fills the middle
        hover(surface(*view_), at(*view_, 50, 0.2));
        QVERIFY(view_->readout().contains("m/s²"));
    }

    void barsAreReadByTheirWholeNumber()
    {
        report::Plot data;
        data.title = "Spectrum";
        data.x = {"Undulations", Text{"UPR"}};
        data.y = {"Amplitude", Text{"µm"}};
        report::Curve bars;
        bars.style = report::Curve::Style::Bars;
        for (int upr = 2; upr <= 60; ++upr) {
            bars.x.push_back(upr - 0.5);
            bars.y.push_back(10.0 / upr);
        }
        bars.x.push_back(60.5);
        data.curves.push_back(bars);
        view_->setData(data);
        QCoreApplication::processEvents();
        for (const double x : {4.7, 5.3}) {
            hover(surface(*view_), at(*view_, x, 4));
            QVERIFY2(view_->readout().startsWith("5 UPR"), qPrintable(view_->readout()));
            QVERIFY2(view_->readout().contains("Amplitude 2.0"), qPrintable(view_->readout()));
        }
        hover(surface(*view_), at(*view_, 1.7, 4));  // the left half of the first bar
        QVERIFY2(view_->readout().contains("Amplitude 5.0"), qPrintable(view_->readout()));
    }

    void doubleClickTakesItsFirstClickBack()
    {
        QSignalSpy clicked(view_.get(), &plot::PlotCanvas::clicked),
            back(view_.get(), &plot::PlotCanvas::clickTakenBack);
        const QPoint place = at(*view_, 30, 50);
        QTest::mouseClick(surface(*view_), Qt::LeftButton, {}, place);
        QTest::mouseDClick(surface(*view_), Qt::LeftButton, {}, place);
        QCOMPARE(clicked.count(), 1);
        QCOMPARE(back.count(), 1);
    }

    void theRemarkStaysBesideTheReadout()
    {
        report::Plot data = parabola();
        data.remark = "error × 200";
        view_->setData(data);
        const auto inkAtTheRight = [&] {
            QCoreApplication::processEvents();
            const QImage image = view_->grab(QRect(450, 0, 150, view_->fontMetrics().height())).toImage();
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (qGray(image.pixel(x, y)) < 128) return true;
            return false;
        };
        QVERIFY(!inkAtTheRight());
        hover(surface(*view_), at(*view_, 50, 60));
        QVERIFY2(inkAtTheRight(), "the magnification is gone while the pointer is over the plot");
    }

    void emptyDataDrawEmptyAxes()
    {
        view_->setData({});
        QVERIFY(view_->visibleRange().width() > 0);
        hover(surface(*view_), {300, 200});
        QCOMPARE(view_->csv(), QString("\n"));
    }
};

QTEST_MAIN(ChartViewTest)
#include "chart_view_test.moc"
