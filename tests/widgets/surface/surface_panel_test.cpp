// The panel "Surface", used as a shop does: two photographs dropped, region, scale and direction given in the picture,
// the frequency sent to the lobes, and the report.
#include <QCheckBox>
#include <QLocale>
#include <QRegularExpression>
#include <QToolButton>

#include "engine/report/html.h"
#include "engine/surface/surface_codes.h"
#include "engine/surface/task/surface_answer.h"
#include "tests/widgets/surface/surface_fixture.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"

namespace lathelier::surface_panel {

class SurfacePanelTest : public QObject, SurfaceFixture {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        writePictures();
    }
    void init()
    {
        QLocale::setDefault(QLocale::c());
        begin();
    }
    void cleanup() { end(); }

    void twoPicturesAreComparedAndAnswered()
    {
        openBoth();
        QCOMPARE(found().images.size(), std::size_t{2});
        const auto& chatter = found().images[0].chatter_marks;
        QVERIFY(chatter && chatter->frequency_hz && std::abs(*chatter->frequency_hz - 361) < 0.3);
        QVERIFY(chatter->m_certain && chatter->kind == surface::ChatterKind::Regenerative);
        QVERIFY(!found().images[1].chatter_marks && found().images[1].feed_marks);
        const report::Answer answer = surface::answer(*panel_->result(), {});
        QVERIFY(answer.value && std::abs(*answer.value - 361) < 0.3 && *answer.expanded_uncertainty > 3);
        QCOMPARE(answer.findings.size(), std::size_t{2});  // the other picture, the speed relation check
        QVERIFY(report::findingText(answer.findings[0]).find("no chatter marks above") != std::string::npos);
        QVERIFY(report::findingText(answer.findings[1]).find("speak for the exact relation") != std::string::npos);
        for (const char* view : {"marks", "spectrum", "comparison", "photograph", "unrolled", "words", "tables"})
            QVERIFY2(views().primaryViews()->keys().contains(view), view);
        QVERIFY(!views().primaryViews()->keys().contains("model"));
        QCOMPARE(views().marks()->overlays().size(), std::size_t{2});
        QVERIFY(views().words()->toPlainText().contains("not registered"));
        QVERIFY(views().words()->toPlainText().contains("cannot tell heights"));
    }

    void onePictureIsLookedAtAfterTheOther()
    {
        openBoth();
        panel_->findChild<QToolButton*>("showAfter")->click();
        QCOMPARE(views().chosen(), 1);
        QCOMPARE(views().marks()->overlays().size(), std::size_t{1});  // feed marks alone
        panel_->findChild<QToolButton*>("showBefore")->click();
        panel_->findChild<QToolButton*>("showChatterMarks")->click();
        QCOMPARE(views().marks()->overlays().size(), std::size_t{1});
    }

    void oneMorePictureIsTheNextOneAfter()
    {
        drop(panel_.get(), {before_});
        QTRY_COMPARE(session_->panel("surface").inputs.size(), std::size_t{1});
        drop(panel_.get(), {after_});
        QTRY_COMPARE(session_->panel("surface").inputs.size(), std::size_t{2});
        drop(panel_.get(), {field_});
        QTRY_COMPARE(QString::fromStdString(session_->panel("surface").inputs.at(surface::afterRole).path), field_);
        QCOMPARE(QString::fromStdString(session_->panel("surface").inputs.at(surface::beforeRole).path), before_);
        session_->undoStack().undo();
        QCOMPARE(QString::fromStdString(session_->panel("surface").inputs.at(surface::afterRole).path), after_);
    }

    void theScaleIsSetByTwoClicks()
    {
        drop(panel_.get(), {before_});
        settle();
        QVERIFY(!found().images[0].mm_per_px);
        set("diameter_mm", 30.0);
        settle();
        views().primaryViews()->setPrimary("photograph");
        PictureView* view = views().photograph()->view();
        panel_->findChild<QToolButton*>("toolLength")->click();
        QCOMPARE(view->tool(), PictureView::Tool::Length);
        for (const double y : {40.0, 840.0})
            QTest::mouseClick(view, Qt::LeftButton, {}, view->placeOf({150, y}).toPoint());
        views().photograph()->length()->setNumber(24.0);
        panel_->findChild<QPushButton*>("surfaceSetScale")->setEnabled(true);
        panel_->findChild<QPushButton*>("surfaceSetScale")->click();
        settle();
        QVERIFY(found().images[0].mm_per_px && std::abs(*found().images[0].mm_per_px - 0.03) < 2e-4);
        QCOMPARE(found().images[0].mm_per_px_source, surface::ScaleSource::ScaleBar);
        session_->undoStack().undo();
        settle();
        QVERIFY(!found().images[0].mm_per_px);
    }

    void aRegionIsDrawnAndTakenBack()
    {
        openBoth();
        views().primaryViews()->setPrimary("photograph");
        panel_->findChild<QToolButton*>("toolRegion")->click();
        dragOver(views().photograph()->view(), {20, 100}, {280, 780});
        settle();
        const auto& roi = panel_->result()->question.surface.roi;
        QCOMPARE(roi.size(), std::size_t{2});
        QVERIFY(std::abs(roi[0].x - 20) < 4 && std::abs(roi[0].height - 680) < 6);
        QCOMPARE(roi[1].height, 880.0);  // the other picture stays whole
        QVERIFY(std::abs(*found().images[0].chatter_marks->frequency_hz - 361) < 0.5);
        panel_->findChild<QPushButton*>("surfaceWhole")->click();
        settle();
        QVERIFY(panel_->result()->question.surface.roi.empty());
        session_->undoStack().undo();
        session_->undoStack().undo();
        settle();
        QVERIFY(panel_->result()->question.surface.roi.empty());
    }

    void theDirectionOfFeedIsDrawn()
    {
        openBoth();
        views().primaryViews()->setPrimary("photograph");
        panel_->findChild<QToolButton*>("toolDirection")->click();
        dragOver(views().photograph()->view(), {250, 400}, {50, 400});
        settle();
        QVERIFY(std::abs(std::abs(std::get<double>(parameter("feed_direction_deg"))) - 180) < 1);
        // "Down" is meant in the picture turned until the feed points right: both ways are turned, and ν is the same.
        QVERIFY(found().images[0].chatter_marks->nu < -0.2);
        set("cut_direction", std::string("up"));
        settle();
        QVERIFY(found().images[0].chatter_marks->nu > 0.2);
    }

    void aWrongScaleLeavesThePhotograph()
    {
        openBoth();
        set("mm_per_px", 0.3);
        QTRY_VERIFY(panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("feed_not_resolved"));
        QTRY_COMPARE(views().primaryViews()->keys(), QStringList{"photograph"});
        QVERIFY(!views().photograph()->view()->image().isNull());
        QVERIFY(!panel_->reportDocument());
        session_->undoStack().undo();
        settle();
        QVERIFY(views().primaryViews()->keys().contains("marks"));
    }

    void aRingDrawsItsStripes()
    {
        openBoth();
        views().primaryViews()->setPrimary("spectrum");
        const surface::SurfaceView& view = found().images[0].view;
        const auto chatter = std::find_if(view.lines.begin(), view.lines.end(),
                                          [](const surface::NamedLine& line) { return !line.is_feed; });
        QVERIFY(chatter != view.lines.end());
        const double pixel = view.px_per_px * 0.03;
        emit views().spectrum()->clicked(chatter->frequency.x / pixel, -chatter->frequency.y / pixel);
        QCOMPARE(views().line(), static_cast<int>(chatter - view.lines.begin()));
        QCOMPARE(views().marks()->overlays().size(), std::size_t{3});
        QVERIFY(!views().marks()->overlays().back().stripes.empty());
        emit views().spectrum()->clicked(0, 0);
        QCOMPARE(views().line(), -1);
    }

    void theMarksAreSent()
    {
        openBoth();
        std::vector<std::pair<std::string, project::Item>> offered;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string& name, const project::Item& item, bool) { offered.emplace_back(name, item); });
        QVERIFY(views().sendButton()->isVisible());
        views().sendButton()->click();
        QCOMPARE(offered.size(), std::size_t{1});
        QCOMPARE(offered[0].first, std::string("Marks of before.png"));
        QCOMPARE(offered[0].second.kind, std::string(stability::marksItem));
        const auto marks = stability::marksOf(offered[0].second.values);
        QVERIFY(marks && marks->speed_rpm == 2016 && std::abs(marks->frequency_hz - 361) < 0.3);
    }

    void aSmallFieldLeavesCandidates()
    {
        drop(panel_.get(), {field_});
        setCut();
        session_->edit("Set", [&](project::Project& project) {
            Values& p = project.panels["surface"].parameters;
            lathelier::set(p, "feed_mm_rev", 0.1);
            lathelier::set(p, "mm_per_px", 0.006);
        });
        settle();
        const auto& chatter = found().images[0].chatter_marks;
        QVERIFY(chatter && !chatter->m_certain && chatter->candidates_hz.size() > 1);
        QVERIFY(views().words()->toPlainText().contains("is not"));
        auto* chip = panel_->findChild<QToolButton*>("candidate1");
        QVERIFY(chip);
        QTRY_VERIFY(chip->isVisible());  // when the layout has taken it in
        const double other = chatter->candidates_hz[1];
        chip->click();
        settle();
        QVERIFY(std::abs(std::get<double>(parameter("expect_hz")) - other) < 0.06);
        QVERIFY(std::abs(*found().images[0].chatter_marks->frequency_hz - other) < 0.1);
        QVERIFY(contains(panel_->result()->notes, notes::chosenByExpectation));
        session_->undoStack().undo();
        settle();
        QVERIFY(std::abs(*found().images[0].chatter_marks->frequency_hz - other) > 1);
    }

    void reportAndExportsAreWritten()
    {
        openBoth();
        const auto document = panel_->reportDocument();
        QVERIFY(document);
        QString html = QString::fromStdString(report::toHtml(*document));
        html.remove(QRegularExpression("base64,[A-Za-z0-9+/=]*"));
        QVERIFY(html.contains("not registered") && html.contains("exact relation") && html.contains("<image"));
        QVERIFY(html.contains("no roughness"));
        QVERIFY(!html.contains("Ra ") && !html.contains("Rz"));
        QCOMPARE(document->inputs.size(), std::size_t{2});
        QVERIFY(QString::fromStdString(document->results.front()).contains("\"chatter_marks\""));
        int written = 0;
        for (const PanelExport& each : panel_->offeredExports()) {
            const QString path = folder_.filePath(QString("export%1.%2").arg(written++).arg(each.suffix));
            each.write(path);
            const bool is_recipe = each.label.contains("Recipe");
            QVERIFY2(QFile(path).size() > (is_recipe ? 500 : 1000), qPrintable(each.label));
        }
        QVERIFY(written >= 4);
        QVERIFY(views().marks()->savePicture(folder_.filePath("marks.svg")));
        QVERIFY(views().marks()->csv().count('\n') > 10);
    }

    void whatIsShownIsKeptWithTheProject()
    {
        openBoth();
        panel_->findChild<QToolButton*>("showAfter")->click();
        panel_->findChild<QToolButton*>("underSlider")->click();
        views().comparison()->slider()->setValue(250);
        const QString path = folder_.filePath("kept.lathelier");
        session_->collectViews();
        session_->save(path);
        end();
        begin();
        session_->open(path);
        settle();
        QCOMPARE(views().chosen(), 1);
        QVERIFY(views().comparison()->hasSlider());
        QVERIFY(std::abs(views().comparison()->share() - 0.25) < 1e-9);
    }

    /// One picture, and a view that was kept when there were two: nothing is looked for beyond it.
    void aViewOfTwoPicturesIsRestoredOverOne()
    {
        drop(panel_.get(), {before_});
        setCut();
        settle();
        views().restoreView(
            {{"picture", std::int64_t{1}}, {"feed_marks", false}, {"chatter_marks", true}, {"table", std::int64_t{0}}});
        QCOMPARE(views().chosen(), 0);
        QCOMPARE(views().marks()->overlays().size(), std::size_t{1});
    }

    /// A response that nothing can be made of leaves the answer of the photographs.
    void aResponseThatIsRefusedIsNoted()
    {
        openBoth();
        const QString path = folder_.filePath("response.csv");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("frequency_hz,real_mm_N,imag_mm_N\n10,x,y\n20,1,1\n");
        file.close();
        session_->edit("Set", [&](project::Project& project) {
            project::Source source;
            source.path = path.toStdString();
            project.panels["surface"].inputs["frf"] = source;
        });
        settle();
        QVERIFY(!panel_->error());
        QVERIFY(contains(panel_->result()->notes, notes::modelNotUsed));
        QVERIFY(!panel_->result()->model);
        QVERIFY(std::abs(*found().images[0].chatter_marks->frequency_hz - 361) < 0.3);
    }

    void aLengthIsMeasuredAndTheLightIsStated()
    {
        openBoth();
        panel_->findChild<QToolButton*>("measureMarks")->click();
        QCOMPARE(views().marks()->tool(), PictureView::Tool::Length);
        QVERIFY(QString::fromStdString(report::toHtml(*panel_->reportDocument())).contains("is not stated"));
        set("lighting", std::string("ring light, 30 degrees"));
        settle();
        QVERIFY(QString::fromStdString(report::toHtml(*panel_->reportDocument())).contains("ring light, 30 degrees"));
    }

    void itCanBePresentedAndFollowsTheLanguage()
    {
        openBoth();
        panel_->setPresenting(true);
        QVERIFY(!views().sendButton()->isVisible());
        panel_->setPresenting(false);
        QVERIFY(views().sendButton()->isVisible());
        Languages languages;
        languages.use("pl");
        QTRY_COMPARE(views().primaryViews()->title("photograph"), QString("Zdjęcie"));
        languages.use("en");
        QTRY_COMPARE(views().primaryViews()->title("photograph"), QString("Photograph"));
    }

    void aStopLeavesTheLastAnswer()
    {
        openBoth();
        set("alpha", 1e-4);
        panel_->cancel();
        QTRY_VERIFY(!panel_->isBusy());
        panel_->recompute();
        settle();
    }
};

}  // namespace lathelier::surface_panel

QTEST_MAIN(lathelier::surface_panel::SurfacePanelTest)
#include "surface_panel_test.moc"
