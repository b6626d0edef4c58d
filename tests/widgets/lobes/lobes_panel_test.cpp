// The panel "Lobes", used as a technologist does: modes or a file, the operating point dragged, a better speed taken.
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include "engine/io/file.h"
#include "engine/io/frf/frf_writer.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/resources.h"
#include "widgets/lobes/lobes_panel.h"
#include "widgets/lobes/lobes_views.h"

namespace lathelier::lobes_panel {

class LobesPanelTest : public QObject, PanelFixture<LobesPanel> {
    Q_OBJECT

    QTemporaryDir folder_;

    void askPaperA()
    {
        LobesQuestion question;
        question.modes = {{223, 0.03, 1e4}};
        question.lobes.cutting_coefficient_N_mm2 = 2000;
        question.lobes.speed_rpm = {{2000, 6000}};
        question.operating_speed_rpm = 2885;
        question.operating_depth = 0.5;
        session_->edit("Ask",
                       [&](project::Project& project) { project.panels["lobes"].parameters = toValues(question); });
        settle();
    }

private slots:
    void initTestCase() { useResources(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void modesAreEnough()
    {
        QVERIFY(!panel_->hasResult());
        askPaperA();
        const LobesOutcome& outcome = *panel_->result();
        QVERIFY(std::abs(*outcome.lobes->minimum_depth_mm - 0.309) < 1e-3);
        QVERIFY(!outcome.work.stable);  // a lobe's foot
        QVERIFY(panel_->findChild<QLabel*>("verdict")->text().contains("chatter"));
        QVERIFY(outcome.speed.has_value());
        const report::Plot& chart = panel_->views().chart()->data();
        QCOMPARE(chart.handles.size(), std::size_t{1});
        QCOMPARE(chart.handles[0].x, 2885.0);
        QVERIFY(chart.regions.size() >= 2);
        QCOMPARE(chart.marks.size(), std::size_t{3});
    }

    void processDampingLiftsSlowCuts()
    {
        askPaperA();
        const auto leastWith = [&](const Value& damping) {
            set("process_damping_N_mm", damping);
            settle();
            return *panel_->result()->lobes->minimum_depth_mm;
        };
        set("diameter_mm", 40.0);
        set("speed_rpm", std::vector<Interval>{{300, 500}});
        settle();
        const double without = *panel_->result()->lobes->minimum_depth_mm;
        QVERIFY(leastWith(400.0) > 1.2 * without);
        QVERIFY(std::abs(leastWith(Value()) - without) < 1e-9);
    }

    void theOperatingPointIsDraggedInOneStep()
    {
        askPaperA();
        const int steps = session_->undoStack().count();
        const auto lobes = panel_->result()->lobes;
        emit panel_->views().operatingPointMoved(3000, 0.4, false);
        emit panel_->views().operatingPointMoved(3237, 0.3, false);
        emit panel_->views().operatingPointMoved(3237, 0.25, true);
        settle();
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QVERIFY(panel_->result()->work.stable);
        QVERIFY(panel_->result()->lobes == lobes);  // nothing of them was computed anew
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->work.stable);
    }

    void theRecommendedSpeedIsTakenByAClick()
    {
        askPaperA();
        set("relation", std::string("published"));
        settle();
        const double recommended = panel_->result()->speed->recommended_rpm;
        QVERIFY(std::abs(recommended - 3237) < 1);
        auto* finding = panel_->findChild<FindingLink*>("finding1");
        QVERIFY(finding && finding->text().contains("3237"));
        emit finding->clicked();
        settle();
        QCOMPARE(panel_->result()->point.speed_rpm, 3237.0);
    }

    void aFileTakesThePlaceOfModes()
    {
        io::MeasuredFrf response;
        response.frf = stability::frfOf({{400, 0.02, 2e4}}, 6000);
        const std::string path = folder_.filePath("response.csv").toStdString();
        io::writeFrfCsv(path, response.frf);
        session_->edit("Open", [&](project::Project& project) { project.panels["lobes"].inputs[frfRole].path = path; });
        settle();
        QVERIFY(std::abs(*panel_->result()->lobes->frequency_of_minimum_hz - 400 * std::sqrt(1.04)) < 0.5);
        QVERIFY(panel_->result()->lobes->isRelative());
        const auto document = panel_->reportDocument();
        QVERIFY(document.has_value());
        QCOMPARE(document->inputs.size(), std::size_t{1});
    }

    void aSpeedAboveTheLastLobeSaysWhy()
    {
        askPaperA();
        set("speed_rpm", std::vector<Interval>{{2000, 20000}});
        set("operating_speed_rpm", 19000.0);
        settle();
        QVERIFY(!panel_->result()->speed);
        QVERIFY(!panel_->views().primaryViews()->keys().contains("candidates"));
    }
};

}  // namespace lathelier::lobes_panel

QTEST_MAIN(lathelier::lobes_panel::LobesPanelTest)
#include "lobes_panel_test.moc"
