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
        stability::LobesQuestion question;
        question.response.mode = {{223, 0.03, 1e4}};
        question.lobes.cutting_coefficient_N_mm2 = 2000;
        question.lobes.speed_rpm = {{2000, 6000}};
        question.point.operating_speed_rpm = 2885;
        question.point.operating_depth = 0.5;
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
        const stability::LobesOutcome& outcome = *panel_->result();
        QVERIFY(std::abs(*outcome.lobes->minimum_depth_mm - 0.309) < 1e-3);
        QVERIFY(!outcome.safe.selected.is_stable);  // a lobe's foot
        QVERIFY(panel_->findChild<QLabel*>("verdict")->text().contains("chatter"));
        QVERIFY(outcome.candidates.has_value());
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
        QVERIFY(panel_->result()->safe.selected.is_stable);
        QVERIFY(panel_->result()->lobes == lobes);  // nothing of them was computed anew
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->safe.selected.is_stable);
    }

    void theRecommendedSpeedIsStableAtTheDepthAndTakenByAClick()
    {
        askPaperA();
        const stability::SafeSpeed safe = panel_->result()->safe;
        QVERIFY(safe.best.is_stable && *safe.best.limit > 0.5);
        const double recommended = std::round(safe.best.speed_rpm);
        auto* finding = panel_->findChild<FindingLink*>("finding1");
        QVERIFY(finding && finding->text().contains(QString::number(recommended)));
        emit finding->clicked();
        settle();
        QCOMPARE(panel_->result()->point.speed_rpm, recommended);
        QVERIFY(panel_->findChild<QLabel*>("verdict")->text().contains("stable"));
        QVERIFY(panel_->result()->safe.selected.is_stable);
    }

    void wherePointIsNotStatedNothingIsJudged()
    {
        askPaperA();
        set("operating_speed_rpm", Value());
        set("operating_depth", Value());
        settle();
        QVERIFY(!panel_->result()->is_judged);
        QVERIFY(panel_->findChild<QLabel*>("verdict")->text().contains("computed"));
        set("operating_speed_rpm", 2885.0);  // the depth is assumed then, and said
        settle();
        QCOMPARE(panel_->result()->understanding.assumed.size(), std::size_t{1});
        QCOMPARE(panel_->result()->understanding.assumed.front().what, std::string("operating_depth"));
    }

    void aFileTakesThePlaceOfModes()
    {
        io::MeasuredFrf response;
        response.frf = stability::frfOf({{400, 0.02, 2e4}}, 6000);
        const std::string path = folder_.filePath("response.csv").toStdString();
        io::writeFrfCsv(path, response.frf);
        session_->edit(
            "Open", [&](project::Project& project) { project.panels["lobes"].inputs[stability::frfRole].path = path; });
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
        QVERIFY(!panel_->result()->candidates);
        QVERIFY(panel_->views().primaryViews()->keys().contains("candidates"));  // those by the depth
    }
};

}  // namespace lathelier::lobes_panel

QTEST_MAIN(lathelier::lobes_panel::LobesPanelTest)
#include "lobes_panel_test.moc"
