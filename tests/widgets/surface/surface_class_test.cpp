// Pictures that are made: for a class, with sliders, and as questions.
#include <QCheckBox>
#include <QLocale>
#include <QToolButton>

#include "engine/report/html.h"
#include "engine/surface/task/surface_answer.h"
#include "tests/widgets/surface/surface_fixture.h"
#include "widgets/core/resources.h"

namespace lathelier::surface_panel {

class SurfaceClassTest : public QObject, SurfaceFixture {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        before_ = write("before.png", overview(2016, 18.75));
    }
    void init() { begin(); }
    void cleanup() { end(); }

    void aPictureIsMadeForAClass()
    {
        QVERIFY(!panel_->hasResult());
        set(surface::makeKey, true);
        settle();
        QVERIFY(panel_->result()->sources.synthetic && !panel_->result()->made_png.empty());
        QVERIFY(views().generator()->isVisible());
        const auto& first = panel_->result()->first();
        QVERIFY(first.chatter_marks && std::abs(*first.chatter_marks->frequency_hz - 361) < 1);
        const int steps = session_->undoStack().count();
        QSlider* amplitude = views().generator()->slider("amplitude_um");
        QVERIFY(amplitude && views().generator()->number("frequency_hz"));
        for (const int place : {120, 60, 0}) amplitude->setValue(place);  // one drag
        settle();
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QCOMPARE(std::get<double>(parameter("made.amplitude_um")), 0.0);
        QVERIFY(!panel_->result()->first().chatter_marks);
        session_->undoStack().undo();
        settle();
        QVERIFY(panel_->result()->first().chatter_marks);
        // A dropped photograph takes the place of the picture.
        drop(panel_.get(), {before_});
        QTRY_VERIFY(!surface::makesPicture(session_->panel("surface").parameters));
        settle();
        QVERIFY(!views().generator()->isVisible());
    }

    /// Until the answer is given nothing shows the frequency.
    void aQuestionIsAskedAndChecked()
    {
        set(surface::makeKey, true);
        settle();
        QuizPane* quiz = views().generator()->quiz();
        panel_->findChild<QCheckBox*>("quizAsk")->click();
        settle();
        QVERIFY(panel_->result()->asks());
        const double truth_hz = pictureOf(panel_->result()->question).frequency_hz;
        const report::Answer open = surface::answer(*panel_->result(), {});
        QVERIFY(!open.value && open.findings.empty());
        for (const char* view : {"spectrum", "words", "tables", "model"})
            QVERIFY2(!views().primaryViews()->keys().contains(view), view);
        QVERIFY(views().primaryViews()->keys().contains("marks"));
        QCOMPARE(views().marks()->overlays().size(), std::size_t{1});  // of the feed
        QVERIFY(!views().generator()->slider("frequency_hz")->isVisible());
        QVERIFY(!views().sendButton()->isVisible());
        const QString html = QString::fromStdString(report::toHtml(*panel_->reportDocument()));
        QVERIFY(!html.contains(QString::number(truth_hz, 'f', 1)));
        QCOMPARE(panel_->offeredExports().size(), std::size_t{2});  // the picture, and the numbers, which are none
        QVERIFY(panel_->reportDocument()->results.empty());

        quiz->answer()->setNumber(truth_hz + 1);
        quiz->check()->click();
        settle();
        QVERIFY(!panel_->result()->asks());
        const report::Answer right = surface::answer(*panel_->result(), {});
        QVERIFY(report::findingText(right.findings[0]).find("is right") != std::string::npos);
        QVERIFY(right.value && std::abs(*right.value - truth_hz) < 1);
        QVERIFY(views().primaryViews()->keys().contains("spectrum"));

        panel_->findChild<QPushButton*>("quizNext")->click();
        settle();
        QVERIFY(panel_->result()->asks() && panel_->result()->question.quiz_number == 2);
        QVERIFY(pictureOf(panel_->result()->question).frequency_hz != truth_hz);
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->asks());
    }

    void halvesAreMeans()
    {
        QImage stripes(64, 64, QImage::Format_Grayscale8);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) stripes.scanLine(y)[x] = x % 2 == 0 ? 0 : 200;
        const PicturePyramid pyramid(stripes);
        QCOMPARE(pyramid.forZoom(1).width(), 64);
        QCOMPARE(pyramid.forZoom(0.4).width(), 32);
        QCOMPARE(pyramid.forZoom(0.12).width(), 8);
        QCOMPARE(int(pyramid.forZoom(0.5).constScanLine(3)[5]), 100);
    }
};

}  // namespace lathelier::surface_panel

QTEST_MAIN(lathelier::surface_panel::SurfaceClassTest)
#include "surface_class_test.moc"
