// The panel "Training", used as a trainer does: the point dragged, the tour stepped in both languages, an exercise
// answered, the chart hidden, a demonstration written.
#include <QDir>
#include <QLabel>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <cmath>

#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"
#include "widgets/training/training_panel.h"

namespace lathelier::training_panel {

class TrainingPanelTest : public QObject, PanelFixture<TrainingPanel> {
    Q_OBJECT

    QTemporaryDir folder_;

    QString taskText() const { return panel_->tour().findChild<QLabel*>("tourTask")->text(); }

private slots:
    void initTestCase() { useResources(); }
    void init()
    {
        begin();
        settle();
    }
    void cleanup() { end(); }

    void aScenarioNeedsNoInput()
    {
        const training::TrainingOutcome& outcome = *panel_->result();
        QCOMPARE(outcome.scenario.key, std::string("slender"));
        QVERIFY(std::abs(*outcome.limits->exact.minimum_depth_mm - 0.309) < 1e-3);
        QVERIFY(outcome.cut->seconds() >= 0.99);
        QVERIFY(panel_->findChild<QLabel*>("verdict")->text().contains("stable"));
    }

    void theMapOfTheGrowthFillsWhileOneLooks()
    {
        const auto ground = [this] { return panel_->views().lobes()->data().ground; };
        QTRY_VERIFY_WITH_TIMEOUT(ground().has_value(), 30000);
        QTRY_VERIFY_WITH_TIMEOUT(!panel_->views().filler().isBusy(), 120000);
        QCOMPARE(ground()->columns, 200);
    }

    void allLooksFollowTheDraggedPoint()
    {
        const int steps = session_->undoStack().count();
        const auto limits = panel_->result()->limits;
        emit panel_->views().pointMoved(2890, 0.5, false);
        emit panel_->views().pointMoved(2885, 0.6, true);
        settle();
        const training::TrainingOutcome& outcome = *panel_->result();
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QVERIFY(outcome.limits == limits);  // not computed anew
        QVERIFY(outcome.cut->cut == stability::CutVerdict::Chatter);
        QVERIFY(outcome.cut->lost_contact_percent > 0);
        QVERIFY(panel_->findChild<QLabel*>("verdict")->text().contains("chatter"));
        const report::Plot& waves = panel_->views().waves()->data();
        QCOMPARE(waves.curves.back().x.size(), outcome.cut->waves.angle_deg.size());
        session_->undoStack().undo();
        settle();
        QVERIFY(panel_->result()->cut->cut == stability::CutVerdict::Stable);
    }

    void playStepAndPauseGoThroughTheCut()
    {
        TransportBar& bar = panel_->transport();
        bar.setTime(0);
        bar.step(1);
        const double revolution_s = 60 / panel_->result()->point.speed_rpm;
        QVERIFY(std::abs(bar.time_s() - revolution_s) < 0.05 * revolution_s);
        bar.setPlaying(true);
        const double before = bar.time_s();
        QTRY_VERIFY(bar.time_s() > before);
        bar.setPlaying(false);
        QVERIFY(!bar.isPlaying());
    }

    void theSoundIsOffUntilAskedForAndFollows()
    {
        SoundPlayer& player = panel_->player();
        QVERIFY(!player.isOn());
        QVERIFY(player.volume() <= SoundPlayer::loudest);
        player.setVolume(5);
        QVERIFY(player.volume() <= SoundPlayer::loudest);
        emit panel_->views().pointMoved(2885, 0.6, true);
        settle();
        player.setOn(true);
        QTRY_VERIFY_WITH_TIMEOUT(player.level() > 0.05, 10000);
        QVERIFY(player.heard_s() > 0);
        player.setOn(false);
    }

    /// As the window gives a file that was named on its command line.
    void aLessonOpensInTheTour()
    {
        const QString path = folder_.filePath("own.md");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("# Own\n\nWords.\n\n## One\n\nText.\n\n## Two\n\nText.\n");
        file.close();
        const int steps = session_->undoStack().count();
        panel_->openFound({{path.toStdString()}});
        QCOMPARE(panel_->tour().path(), path);
        QCOMPARE(panel_->tour().steps(), 2);
        QCOMPARE(session_->undoStack().count(), steps);
        QVERIFY(panel_->error() == std::nullopt);
        const io::FileKinds& kinds = trainingPanelFacts().kinds;
        QCOMPARE(io::findKind(kinds, path.toStdString()).kind->key, std::string("lesson"));
    }

    void theTourIsSteppedInEveryLanguage()
    {
        Languages languages;
        for (const QString& language : Languages::codes()) {
            languages.use(language);
            TourPane& tour = panel_->tour();
            tour.retranslate();
            QCOMPARE(tour.steps(), 12);
            tour.goTo(0);
            settle();
            QCOMPARE(panel_->result()->point.speed_rpm, 2885.0);
            QVERIFY(!tour.isDone());
            QVERIFY2(taskText().contains("☐"), qPrintable(taskText()));
            emit panel_->views().pointMoved(2885, 0.5, true);
            settle();
            QTRY_VERIFY(tour.isDone());
            QVERIFY(taskText().contains("✓"));
            for (int step = 0; step < tour.steps(); ++step) {
                tour.goTo(step);
                settle();
                QVERIFY2(!tour.isDone(), qPrintable(QString("step %1 is done before it begins").arg(step + 1)));
            }
        }
        languages.use("en");
    }

    void whatAStepSpeaksOfIsOnScreen_data()
    {
        QTest::addColumn<QString>("language");
        for (const QString& language : Languages::codes()) QTest::newRow(qPrintable(language)) << language;
    }
    /// The panel as the window gives it room at 1280 × 800. LATHELIER_WRITE_LESSONS=1 writes a picture of each step.
    void whatAStepSpeaksOfIsOnScreen()
    {
        QFETCH(QString, language);
        Languages languages;
        languages.use(language);
        const auto back = qScopeGuard([&] { languages.use("en"); });
        panel_->resize(1280, 650);
        TourPane& tour = panel_->tour();
        tour.retranslate();
        PrimaryViews& views = *panel_->views().primaryViews();
        for (int step = 0; step < tour.steps(); ++step) {
            tour.goTo(step);
            settle();
            const QString what = QString("step %1: %2").arg(step + 1).arg(views.primary());
            if (qEnvironmentVariableIsSet("LATHELIER_WRITE_LESSONS")) {
                QTest::qWait(300);
                panel_->grab().save(QDir::tempPath() + QString("/lesson_%1_%2.png").arg(language).arg(step + 1));
            }
            const bool has_chart = views.keys().contains(TrainingViews::alwaysShown());
            QVERIFY2(has_chart != panel_->views().isExercising(), qPrintable(what));
            QWidget* const primary = views.findChild<QWidget*>("training_" + views.primary());
            if (primary) QVERIFY2(primary->isVisible() && primary->height() >= 150, qPrintable(what));
            if (!has_chart) continue;
            const plot::ChartView& chart = *panel_->views().lobes();
            QVERIFY2(chart.isVisible() && chart.width() >= 250 && chart.height() >= 150, qPrintable(what));
            QVERIFY2(chart.glows(), qPrintable(what));
            const report::Plot& plot = chart.data();
            QCOMPARE(plot.handles.size(), std::size_t{1});
            const report::Handle& handle = plot.handles.front();
            QVERIFY2(plot.x.range->from <= handle.x && handle.x <= plot.x.range->to, qPrintable(what));
            QVERIFY2(plot.y.range->from <= handle.y && handle.y <= plot.y.range->to, qPrintable(what));
        }
        tour.goTo(-1);
        QVERIFY(!panel_->views().lobes()->glows());
    }

    void anExerciseIsSolvedAndFailed()
    {
        ExercisePane& pane = panel_->exercises();
        const auto shows = [this](const char* key) {
            return panel_->views().primaryViews()->keys().contains(QString(key));
        };
        pane.begin(training::ExerciseKind::SafeSpeed, 3);
        QCOMPARE(pane.cutsLeft(), 3);
        for (const char* key : {"lobes", "growth", "frf", "comparison", "why"}) QVERIFY(!shows(key));
        int heard = 0;
        connect(&pane, &ExercisePane::cutHeard, this, [&heard] { ++heard; });
        pane.listen(pane.exercise()->speed_rpm.from);
        QCOMPARE(pane.cutsLeft(), 2);
        QCOMPARE(heard, 1);
        QCOMPARE(panel_->views().primaryViews()->primary(), QString("exercise"));
        const Interval right = training::grade(*pane.exercise(), 0).expected.front();
        pane.submitAnswer((right.from + right.to) / 2);
        QVERIFY(pane.grade()->correct);
        QVERIFY(shows("lobes"));
        pane.begin(training::ExerciseKind::Damping, 7);
        QVERIFY(panel_->views().primaryViews()->keys().contains("exercise"));
        pane.submitAnswer(77);
        QVERIFY(!pane.grade()->correct);
        QCOMPARE(pane.answers().size(), std::size_t{2});
        pane.submitAnswer(3);  // the first answer counts
        QCOMPARE(pane.answers().size(), std::size_t{2});
        pane.begin(training::ExerciseKind::Prediction, 1);
        pane.submitAnswer(0);
        QVERIFY(pane.grade().has_value());
    }

    void theTeacherHidesWhatWouldTell()
    {
        set("hide_chart", true);
        settle();
        const QStringList keys = panel_->views().primaryViews()->keys();
        for (const char* key : {"lobes", "growth", "frf", "comparison", "why"}) QVERIFY(!keys.contains(key));
        QVERIFY(keys.contains("waveform"));
        QVERIFY(!panel_->findChild<QLabel*>("verdict")->text().contains("stable"));
        set("hide_chart", false);
        settle();
        QVERIFY(panel_->views().primaryViews()->keys().contains("lobes"));
    }

    void presentingLeavesTheViewsAlone()
    {
        panel_->setPresenting(true);
        QVERIFY(!panel_->findChild<QTabWidget*>("panes")->isVisible());
        panel_->setPresenting(false);
        QVERIFY(panel_->findChild<QTabWidget*>("panes")->isVisible());
    }

    void picturesOfADemonstrationAreWritten()
    {
        FrameWriter writer;
        QSignalSpy finished(&writer, &FrameWriter::finished);
        int prepared = 0;
        writer.begin(*panel_, folder_.filePath("frames"), 3, [&](int) { ++prepared; });
        QTRY_COMPARE(finished.count(), 1);
        QCOMPARE(prepared, 3);
        QVERIFY(QFile::exists(folder_.filePath("frames/frame_0003.png")));
    }
};

}  // namespace lathelier::training_panel

QTEST_MAIN(lathelier::training_panel::TrainingPanelTest)
#include "training_panel_test.moc"
