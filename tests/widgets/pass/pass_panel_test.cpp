// The panel "Pass", used as a technologist does: a shaft on its spindle, a pass that chatters, the best speed taken.
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <cmath>

#include "engine/io/file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/resources.h"
#include "widgets/pass/pass_panel.h"
#include "widgets/pass/pass_views.h"

namespace lathelier::pass_panel {

class PassPanelTest : public QObject, PanelFixture<PassPanel> {
    Q_OBJECT

    QTemporaryDir folder_;

    void giveFiles()
    {
        receptance::SpindleReceptance spindle;
        spindle.source = receptance::SpindleSprings{14850, 198.3e6, 0.06};
        const std::string spindle_path = folder_.filePath("spindle.json").toStdString();
        const std::string shaft_path = folder_.filePath("shaft.json").toStdString();
        io::writeFile(spindle_path, receptance::spindleText(spindle));
        io::writeFile(shaft_path,
                      R"({"segments": [{"length_mm": 180, "start_diameter_mm": 40, "end_diameter_mm": 40}]})");
        session_->edit("Open", [&](project::Project& project) {
            project.panels["pass"].inputs[stability::spindleRole].path = spindle_path;
            project.panels["pass"].inputs[stability::shaftRole].path = shaft_path;
        });
    }
    void askForAPass()
    {
        giveFiles();
        set("pass_z_mm", std::vector<Interval>{{0, 120}});
        set("pass_depth_mm", 2.0);
        set("speed_rpm", std::vector<Interval>{{1500, 5000}});
        set("pass_stations", std::int64_t{5});
        set("cutting_coefficient_N_mm2", 1000.0);
        settle();
    }

private slots:
    void initTestCase() { useResources(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void itAsksForWhatIsMissing()
    {
        giveFiles();
        QVERIFY(!panel_->hasResult());
        set("pass_z_mm", std::vector<Interval>{{0, 120}});
        set("cutting_coefficient_N_mm2", 1000.0);
        QTest::qWait(50);
        QVERIFY(!panel_->hasResult());
        set("pass_depth_mm", 0.5);
        settle();
        QVERIFY(panel_->result()->pass != nullptr);
    }

    void theLeastLimitIsThatOfTheWorstStation()
    {
        askForAPass();
        const stability::PassResult& pass = *panel_->result()->pass;
        QCOMPARE(pass.stations.size(), std::size_t{5});
        QCOMPARE(pass.stations.back().z_mm, 120.0);
        QCOMPARE(pass.stations.front().diameter_mm, 36.0);
        for (std::size_t i = 0; i < pass.speed_rpm.size(); i += 37) {
            double least = HUGE_VAL;
            for (std::size_t row = 0; row < 5; ++row)
                if (!std::isnan(pass.at(row, i))) least = std::min(least, pass.at(row, i));
            QCOMPARE(std::isinf(least), pass.worst.k[i] < 0);
            if (std::isfinite(least)) QCOMPARE(pass.worst.depth_mm[i], least);
        }
        QCOMPARE(panel_->views().map()->data().rows, 5);
        QCOMPARE(panel_->views().limit()->data().handles.size(), std::size_t{1});
        QVERIFY(panel_->reportDocument().has_value());
    }

    void withoutASpeedTheBestIsJudged()
    {
        askForAPass();
        const auto outcome = panel_->result();
        QCOMPARE(outcome->point.speed_rpm, outcome->safe.best.speed_rpm);
        // No other speed bears more all over ±2 %.
        const std::vector<double>& speeds = outcome->pass->speed_rpm;
        const auto leastAbout = [&](double speed_rpm) {
            double least = HUGE_VAL;
            for (std::size_t i = 0; i < speeds.size(); ++i)
                if (std::abs(speeds[i] - speed_rpm) <= 0.02 * speed_rpm && outcome->pass->worst.k[i] >= 0)
                    least = std::min(least, outcome->pass->worst.depth_mm[i]);
            return least;
        };
        const double best = leastAbout(outcome->safe.best.speed_rpm);
        for (const double speed_rpm : speeds) QVERIFY(leastAbout(speed_rpm) <= best);
    }

    void theBestSpeedIsTakenByAClickAndThePassStays()
    {
        askForAPass();
        const auto pass = panel_->result()->pass;
        std::size_t worst = 0;  // the deepest foot of the lobes
        for (std::size_t i = 1; i < pass->speed_rpm.size(); ++i)
            if (pass->worst.depth_mm[i] < pass->worst.depth_mm[worst]) worst = i;
        QVERIFY(pass->worst.depth_mm[worst] < 2);
        set(stability::operatingSpeedKey, std::round(pass->speed_rpm[worst]));
        settle();
        QVERIFY(panel_->findChild<QLabel*>("verdict")->text().contains("chatter"));
        auto* finding = panel_->findChild<FindingLink*>("finding1");
        QVERIFY(finding != nullptr);
        emit finding->clicked();
        settle();
        QCOMPARE(panel_->result()->point.speed_rpm, std::round(panel_->result()->safe.best.speed_rpm));
        QVERIFY(panel_->result()->pass == pass);  // nothing of it was computed anew
    }

    void theOperatingPointIsDraggedInOneStep()
    {
        askForAPass();
        const int steps = session_->undoStack().count();
        emit panel_->views().pointMoved(3000, 1.5, false);
        emit panel_->views().pointMoved(3100.4, 1.2004, false);
        emit panel_->views().pointMoved(3100.4, 1.0004, true);
        settle();
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QCOMPARE(panel_->result()->point.speed_rpm, 3100.0);
        QCOMPARE(*panel_->result()->question.pass.pass_depth_mm, 1.0);
        QCOMPARE(panel_->result()->pass->stations.front().diameter_mm, 38.0);
        session_->undoStack().undo();
        settle();
        QCOMPARE(*panel_->result()->question.pass.pass_depth_mm, 2.0);
    }

    void aSpeedThatIsNotLookedThroughIsRefused()
    {
        askForAPass();
        set(stability::operatingSpeedKey, 9000.0);
        QTRY_VERIFY(!panel_->isBusy() && panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("value_out_of_range"));
        set(stability::operatingSpeedKey, 3000.0);
        settle();
        QCOMPARE(panel_->result()->point.speed_rpm, 3000.0);
    }

    void aPassBeyondTheShaftIsRefused()
    {
        askForAPass();
        set("pass_z_mm", std::vector<Interval>{{0, 400}});
        QTRY_VERIFY(!panel_->isBusy() && panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("place_outside_shaft"));
    }
};

}  // namespace lathelier::pass_panel

QTEST_MAIN(lathelier::pass_panel::PassPanelTest)
#include "pass_panel_test.moc"
