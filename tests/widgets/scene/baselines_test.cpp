// Five views as pictures beside what they looked like when someone last approved them: tests/data/baselines. Drawing
// differs a little between versions of fonts and of Mesa, so that means over blocks are compared, with a tolerance.
// LATHELIER_WRITE_BASELINES=1 writes them anew; look at them before they are committed.
#include <QDir>
#include <QLocale>
#include <QTest>
#include <cmath>
#include <numbers>

#include "engine/sample/sample.h"
#include "tests/widgets/core/picture_difference.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/plot/polar_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier {
namespace {

constexpr double largestMean = 4;    // of all blocks, in levels of 255
constexpr double largestBlock = 90;  // a word moved by one pixel changes its blocks by less

/// A lobe chart: logarithmic frequency, a stable region, a limit, the operating point.
report::Plot chart(double sign = 1)
{
    report::Plot plot;
    plot.title = std::string("Limiting depth");
    plot.x = {std::string("Spindle speed"), Text{"rpm"}};
    plot.x.scale = report::Axis::Scale::Logarithmic;
    plot.y = {std::string("Depth"), Text{"mm"}};
    report::Curve curve;
    curve.name = std::string("lobes");
    for (int i = 0; i <= 400; ++i) {
        const double rpm = 200 * std::pow(10, i / 200.0);
        curve.x.push_back(rpm);
        curve.y.push_back(1 + sign * 0.6 * std::cos(20 * std::numbers::pi * std::log10(rpm / 200)));
    }
    plot.curves.push_back(curve);
    plot.handles.push_back({"point", report::Handle::Kind::Vertical, 2000, 0, "n"});
    return plot;
}

report::ColourMap map(double sign = 1)
{
    report::ColourMap map;
    map.title = std::string("Unrolled");
    map.x = {std::string("z"), Text{"mm"}};
    map.y = {std::string("angle"), Text{"°"}};
    map.value = {std::string("Deviation"), Text{"mm"}};
    map.x_to = 180;
    map.y_to = 360;
    map.columns = 60;
    map.rows = 36;
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column)
            map.values.push_back(
                static_cast<float>(sign * 0.08 * std::sin(column * 0.2) + 0.02 * std::cos(row * 0.35)));
    return map;
}

report::PolarPlot polar(double sign = 1)
{
    report::PolarPlot plot;
    plot.title = std::string("Roundness");
    plot.base_radius_mm = 25;
    report::PolarPlot::Trace trace;
    trace.name = std::string("profile");
    for (int i = 0; i < 720; ++i) {
        trace.angle_deg.push_back(i / 2.0);
        trace.deviation_um.push_back(sign * 5 * std::cos(3 * trace.angle_deg.back() * std::numbers::pi / 180));
    }
    plot.traces.push_back(trace);
    report::PolarPlot::ReferenceLine circle;
    circle.name = std::string("MCCI");
    circle.deviation_um = 5;
    plot.circles.push_back(circle);
    plot.contacts = {{0, 5, true}, {60, -5, false}};
    return plot;
}

report::Answer answer(Verdict verdict = Verdict::Fail)
{
    report::Answer answer;
    answer.quantity = std::string("RONt(MZCI)");
    answer.value = 15.3;
    answer.expanded_uncertainty = 0.4;
    answer.unit = Text{"µm"};
    answer.decimals = 1;
    answer.upper_limit = 15;
    answer.verdict = verdict;
    answer.sentence = Text{"G 1-50 UPR, within by 21 of 24 methods: look at the filter"};
    answer.findings = {{Text{"3 UPR, 4.9 µm: three jaws"}, {}, {}, {}}};
    return answer;
}

}  // namespace

class BaselinesTest : public QObject {
    Q_OBJECT

    /// `picture` equals the stored baseline; `other`, of other data, does not: the tolerance separates them.
    static void compare(const QString& name, const QImage& picture, const QImage& other)
    {
        const QString path = QStringLiteral(LATHELIER_SOURCE_DIR "/tests/data/baselines/") + name + ".png";
        if (qEnvironmentVariableIsSet("LATHELIER_WRITE_BASELINES")) {
            QDir().mkpath(QStringLiteral(LATHELIER_SOURCE_DIR "/tests/data/baselines"));
            QVERIFY(picture.save(path));
        }
        const QImage approved(path);
        QVERIFY2(!approved.isNull(), qPrintable(path));
        QCOMPARE(picture.size(), approved.size());
        const PictureDifference found = differenceOfShrunk(shrunk(picture), shrunk(approved));
        const bool same = found.mean <= largestMean && found.largest <= largestBlock;
        if (!same) picture.save(QDir::tempPath() + "/lathelier_baseline_" + name + ".png");
        QVERIFY2(same, qPrintable(QString("%1: mean %2, largest %3").arg(name).arg(found.mean).arg(found.largest)));
        const PictureDifference planted = differenceOfShrunk(shrunk(other), shrunk(approved));
        QVERIFY2(
            planted.mean > largestMean || planted.largest > largestBlock,
            qPrintable(
                QString("%1 hides other data: mean %2, largest %3").arg(name).arg(planted.mean).arg(planted.largest)));
    }

    template <class View>
    static QImage shown(View& view, const QSize& size)
    {
        view.resize(size);
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) QTest::qFail("not shown", __FILE__, __LINE__);
        QTest::qWait(100);
        return view.grab().toImage();
    }

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        QFont font("DejaVu Sans");
        font.setPointSizeF(10);
        QApplication::setFont(font);
        QApplication::setPalette(QPalette(QColor("#efefef")));
    }
    void theChart()
    {
        plot::ChartView view, other;
        view.setData(chart());
        other.setData(chart(-1));
        compare("chart", shown(view, {480, 320}), shown(other, {480, 320}));
    }
    void theMap()
    {
        plot::MapView view, other;
        for (plot::MapView* each : {&view, &other}) each->setColours({0.1, 0.05});
        view.setData(map());
        other.setData(map(-1));
        compare("map", shown(view, {560, 320}), shown(other, {560, 320}));
    }
    void thePolarPlot()
    {
        plot::PolarView view, other;
        view.setPicture(plot::polarPicture(polar()));
        other.setPicture(plot::polarPicture(polar(-1)));
        compare("polar", shown(view, {400, 400}), shown(other, {400, 400}));
    }
    void theAnswer()
    {
        AnswerStrip strip, other;
        strip.setAnswer(answer());
        other.setAnswer(answer(Verdict::Pass));
        const QSize size(1000, strip.height());
        compare("answer", shown(strip, size), shown(other, size));
    }
    void theScene()
    {
        const auto mesh = std::make_shared<const Scan>(sample::shaftMesh(sample::nominalShaft(), 90));
        const auto coloured = [&](double sign) {
            scene::SceneObject object;
            object.scan = mesh;
            auto values = std::make_shared<std::vector<float>>();
            for (const Eigen::Vector3d& p : mesh->points_mm)
                values->push_back(static_cast<float>(sign * (p.head<2>().norm() > 17 ? 0.08 : -0.03)));
            object.values = values;
            scene::SceneView view;
            if (!view.canDraw()) QTest::qFail("no OpenGL: run under xvfb with software rendering", __FILE__, __LINE__);
            view.setColours({0.1, 0.05});
            view.setObjects({object});
            view.resize(600, 400);
            view.show();
            if (!QTest::qWaitForWindowExposed(&view)) QTest::qFail("not shown", __FILE__, __LINE__);
            return view.picture();
        };
        compare("scene", coloured(1), coloured(-1));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::BaselinesTest)
#include "baselines_test.moc"
