#include "widgets/scene/scene_view.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "engine/core/skin.h"
#include "engine/sample/sample.h"
#include "widgets/scene/scene_canvas.h"
#include "widgets/scene/scene_flags.h"

using namespace lathelier;
using Eigen::Vector3d;

namespace {

const QColor blue(31, 119, 180), red(214, 39, 40);

scene::SceneObject shaft(const QColor& colour)
{
    static const auto scan = [] {
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.5;
        return std::make_shared<const Scan>(sample::scanShaft(sample::nominalShaft(), scanner));
    }();
    scene::SceneObject object;
    object.scan = scan;
    object.colour = colour;
    return object;
}

/// Number of pixels that look like `wanted`: clearly more of its strongest channel than of the others.
int count(const QImage& image, const std::function<bool(QColor)>& wanted)
{
    int found = 0;
    for (int y = 0; y < image.height(); y += 2)
        for (int x = 0; x < image.width(); x += 2) found += wanted(image.pixelColor(x, y));
    return found;
}

bool isBlue(QColor c)
{
    return c.blue() > c.red() + 50;
}
bool isRed(QColor c)
{
    return c.red() > c.blue() + 50 && c.red() > c.green() + 50;
}
bool isGreen(QColor c)
{
    return c.green() > c.red() + 40 && c.green() > c.blue() + 20;
}

}  // namespace

class SceneViewTest : public QObject {
    Q_OBJECT

private:
    scene::SceneView* view_ = nullptr;

    QWidget* canvas() const { return view_->findChild<scene::SceneCanvas*>(); }

private slots:
    void init()
    {
        view_ = new scene::SceneView;
        QVERIFY2(view_->canDraw(), "no OpenGL: run under xvfb with software rendering, as ./dev test does");
        view_->resize(800, 500);
        view_->show();
        QVERIFY(QTest::qWaitForWindowExposed(view_));
    }
    void cleanup() { delete view_; }

    void overlayShowsBothColours()
    {
        scene::SceneObject copy = shaft(red);
        copy.scene_T_scan.translation() = Vector3d(60, 0, 0);
        view_->setObjects({shaft(blue), copy});
        const QImage image = view_->picture();
        QVERIFY(count(image, isBlue) > 1000);
        QVERIFY(count(image, isRed) > 1000);
        copy.visible = false;
        view_->setObjects({shaft(blue), copy});
        QVERIFY(count(view_->picture(), isRed) < 100);  // the axis triad has some
    }

    void aPictureForPaperDoesNotDependOnTheWindow()
    {
        view_->setObjects({shaft(blue)});
        const QImage before = view_->picture();
        const QImage paper = view_->paperPicture(scene::SceneViewpoint::Side);
        QCOMPARE(paper.height(), 840);
        QVERIFY(paper.width() >= 1800);
        QVERIFY(count(paper, isBlue) > 20000);
        QCOMPARE(view_->picture().size(), before.size());
        view_->resize(300, 200);
        view_->hide();
        const QImage hidden = view_->paperPicture(scene::SceneViewpoint::Side);
        QCOMPARE(hidden.size(), paper.size());
        QVERIFY(std::abs(count(hidden, isBlue) - count(paper, isBlue)) < 1000);
    }

    void deviationRecoloursAtOnce()
    {
        scene::SceneObject object = shaft(blue);
        object.values = std::make_shared<const std::vector<float>>(object.scan->points_mm.size(), 0.04F);
        view_->setColours({0.05, {}});
        view_->setScale({LT_TEXT("Engine", "Deviation"), LT_TEXT("Engine", "mm")});
        view_->setObjects({object});
        QVERIFY(count(view_->picture({}, false), isRed) > 1000);
        view_->setColours({0.05, 0.045});
        const QImage image = view_->picture({}, false);
        QVERIFY(count(image, isGreen) > 1000);
        QVERIFY(count(image, isRed) < 100);
    }

    void theShaftLiesLevelInTheSideView()
    {
        view_->setLongAxis(scene::SceneAxis{Vector3d::Zero(), Vector3d::UnitZ()});
        view_->setObjects({shaft(blue)});
        view_->setViewpoint(scene::SceneViewpoint::Side);
        const auto a = view_->pixelAt({0, 0, 0}), b = view_->pixelAt({0, 0, 183});
        QVERIFY(a && b);
        QVERIFY(std::abs(a->y() - b->y()) < 1);
        QVERIFY(b->x() - a->x() > 500);  // of 800: the part fills the picture
        QVERIFY(a->x() > 0 && b->x() < 800);
    }

    void aClickPicksThePointUnderThePointer()
    {
        view_->setLongAxis(scene::SceneAxis{Vector3d::Zero(), Vector3d::UnitZ()});
        view_->setObjects({shaft(blue)});
        view_->setParallel(true);
        view_->setViewpoint(scene::SceneViewpoint::Side);
        QSignalSpy picks(view_, &scene::SceneView::pointPicked);
        const QPoint place = view_->pixelAt({0, 0, 60})->toPoint();
        QTest::mouseClick(canvas(), Qt::LeftButton, {}, canvas()->mapFrom(view_, place));
        QCOMPARE(picks.count(), 1);
        QCOMPARE(picks[0][0].toInt(), 0);
        const auto index = static_cast<std::size_t>(picks[0][1].toLongLong());
        const Vector3d point = view_->objects()[0].scan->points_mm[index];
        QVERIFY2(std::abs(point.z() - 60) < 2, qPrintable(QString::number(point.z())));
        // It is on the side toward the eye: nothing of the shaft is nearer.
        const auto there = view_->pixelAt(point);
        QVERIFY(QLineF(*there, place).length() < 6);
        view_->setMarker(point, "picked");
        bool labelled = false;
        for (const QLabel* label : view_->findChildren<QLabel*>())
            labelled = labelled || (label->isVisible() && label->text() == "picked");
        QVERIFY(labelled);
        QTest::mouseClick(canvas(), Qt::LeftButton, {}, {5, 40});  // beside the part: nothing
        QCOMPARE(picks.count(), 1);
    }

    void aDragTurnsThePartAndIsNoPick()
    {
        view_->setObjects({shaft(blue)});
        QSignalSpy picks(view_, &scene::SceneView::pointPicked);
        const auto before = view_->pixelAt({0, 0, 0});
        const QPoint from(400, 250);
        QTest::mousePress(canvas(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= 6; ++i) {
            QMouseEvent move(QEvent::MouseMove, from + QPoint(15 * i, 5 * i), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(canvas(), &move);
        }
        QTest::mouseRelease(canvas(), Qt::LeftButton, {}, from + QPoint(90, 30));
        QVERIFY(QLineF(*before, *view_->pixelAt({0, 0, 0})).length() > 20);
        QCOMPARE(picks.count(), 0);
    }

    void movingIsThinnedAndRestIsFull()
    {
        view_->setObjects({shaft(blue)});
        view_->turn(5, 0);
        const scene::SceneView::Speed speed = view_->speed();
        QVERIFY(speed.moving_points > 0);
        QVERIFY(speed.moving_points <= view_->objects()[0].scan->points_mm.size());
        QTRY_VERIFY(view_->speed().moving_s > 0);
        const double rested = speed.resting_s;
        QTRY_VERIFY(view_->speed().resting_s != rested);  // a full picture follows by itself
    }

    void sectionCutsAway()
    {
        view_->setLongAxis(scene::SceneAxis{Vector3d::Zero(), Vector3d::UnitZ()});
        view_->setObjects({shaft(blue)});
        view_->setViewpoint(scene::SceneViewpoint::Side);
        const int whole = count(view_->picture(scene::SceneViewpoint::Side, false), isBlue);
        view_->findChild<QComboBox*>()->setCurrentIndex(3);  // along z
        view_->findChild<QSlider*>()->setValue(500);
        const int cut = count(view_->picture(scene::SceneViewpoint::Side, false), isBlue);
        QVERIFY2(cut > 0.3 * whole && cut < 0.7 * whole, qPrintable(QString("%1 of %2").arg(cut).arg(whole)));
        view_->findChild<QComboBox*>()->setCurrentIndex(0);
        QVERIFY(count(view_->picture(scene::SceneViewpoint::Side, false), isBlue) > 0.95 * whole);
    }

    void buttonsChangeTheView()
    {
        view_->setLongAxis(scene::SceneAxis{Vector3d::Zero(), Vector3d::UnitZ()});
        view_->setObjects({shaft(blue)});
        for (QToolButton* button : view_->findChildren<QToolButton*>()) {
            if (button->text() == "End") {
                button->click();
                QVERIFY(QLineF(*view_->pixelAt({0, 0, 0}), *view_->pixelAt({0, 0, 183})).length() < 5);
            }
            if (button->text() == "Parallel") {
                button->click();
                QVERIFY(view_->isParallel());
            }
        }
    }

    void meshesAreDrawn()
    {
        scene::SceneObject mesh;
        mesh.scan = std::make_shared<const Scan>(sample::shaftMesh(sample::nominalShaft()));
        mesh.colour = blue;
        view_->setObjects({mesh});
        QVERIFY(count(view_->picture(), isBlue) > 3000);
    }

    /// Sharp steps of colour between the corners, grey where nothing is known; the view point stays for a part of about
    /// the same size.
    void aMeshIsColouredBetweenItsCorners()
    {
        Skin skin;
        skin.stations = stationsAlong({{0, 0}, {0, 20}, {100, 20}, {100, 0}}, 50);
        skin.angle_count = 60;
        for (const SkinStation& station : skin.stations)
            skin.values.insert(skin.values.end(), 60,
                               station.isFace() ? NAN : static_cast<float>(0.002 * (station.z_mm - 50)));
        const auto object = [&skin](double factor) {
            scene::SceneObject part;
            skin.shift_mm.assign(skin.vertexCount(), Eigen::Vector3f(0.1F, 0, 0));
            part.scan = std::make_shared<const Scan>(meshOf(skin, factor, Eigen::Isometry3d::Identity()));
            part.values = std::make_shared<const std::vector<float>>(skin.values);
            return part;
        };
        report::DeviationColours colours{0.1};
        colours.steps = 2;
        view_->setLongAxis(scene::SceneAxis{Vector3d::Zero(), Vector3d::UnitZ()});
        view_->setColours(colours);
        view_->setObjects({object(0)});
        const QImage image = view_->picture(scene::SceneViewpoint::Side, false);
        QVERIFY(count(image, isBlue) > 3000);
        QVERIFY(count(image, isRed) > 3000);
        view_->setViewpoint(scene::SceneViewpoint::Top);
        const std::vector<double> before = view_->view();
        view_->setObjects({object(10)});
        QCOMPARE(view_->view(), before);
        QVERIFY(count(view_->picture({}, false), isRed) > 3000);  // drawn anew
    }

    void flagsStandBesideEachOther()
    {
        view_->setLongAxis(scene::SceneAxis{Vector3d::Zero(), Vector3d::UnitZ()});
        view_->setObjects({shaft(blue)});
        view_->setViewpoint(scene::SceneViewpoint::Side);
        view_->setFlags({{{0, 0, 90}, "+0.050 mm (limit 0.040)", red},
                         {{0, 0, 91}, "-0.020 mm (limit 0.040)", red},
                         {{0, 0, 95}, "+0.031 mm (limit 0.040)", red}});
        QVERIFY(!view_->picture().isNull());  // which places them
        auto* flags = view_->findChild<scene::SceneFlags*>();
        QVERIFY(flags);
        const std::vector<QRectF> labels = flags->labels();
        QCOMPARE(labels.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(QRectF(flags->rect()).contains(labels[i]));
            for (std::size_t k = 0; k < i; ++k) QVERIFY(!labels[i].intersects(labels[k]));
        }
    }

    void emptyAndSinglePointScenesAreFine()
    {
        view_->setObjects({});
        QVERIFY(!view_->picture().isNull());
        scene::SceneObject dot;
        auto scan = std::make_shared<Scan>();
        scan->points_mm.push_back({1e6, 2e6, 3e6});
        dot.scan = scan;
        view_->setObjects({dot});
        QVERIFY(!view_->picture().isNull());
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    SceneViewTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "scene_view_test.moc"
