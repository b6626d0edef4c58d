// The comparison panel driven as a user would: files, tolerance, cancel, undo, exports.
#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "engine/cad/step_writer.h"
#include "engine/io/io_codes.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/project/project_codes.h"
#include "engine/report/html.h"
#include "engine/shaft/shaft_item.h"
#include "tests/widgets/compare/compare_fixture.h"
#include "widgets/compare/compare_tables.h"
#include "widgets/compare/compare_views.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/scene/scene_view.h"

using namespace lathelier;

class ComparePanelTest : public QObject, CompareFixture {
    Q_OBJECT

    QString makeBroken()
    {
        QFile file(folder_.filePath("broken.xyz"));
        if (file.open(QIODevice::WriteOnly)) file.write("1 2 no number\n");
        return file.fileName();
    }

    /// The published shaft as a drawing, its first diameter with limits that the copy does not keep.
    Shaft drawing() const
    {
        Shaft shaft;
        shaft.name = "drawing";
        shaft.segments = {{98, 30, 30, 0, {}, ""},
                          {10, 37, 37, 0, {}, ""},
                          {70, 33.8, 33.8, 0, {}, ""},
                          {5, 33.8, 23.8, 0, {}, "chamfer"}};
        shaft.segments[1].tolerance = SizeTolerance{{}, -10, 10};
        return shaft;
    }
    QString drawingFile(const std::string& text, const char* name) const
    {
        const QString path = folder_.filePath(name);
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) file.write(QByteArray::fromStdString(text));
        return path;
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void aChangedFileIsToldAndTakenWhenWanted()
    {
        const QString copy = folder_.filePath("changing.xyz");
        QVERIFY(QFile::copy(copy_, copy));
        drop(panel_.get(), {original_, copy});
        settle();
        const double before_mm = panel_->result()->result->statistics.mean_mm;
        QVERIFY(QFile::remove(copy));
        QVERIFY(QFile::copy(original_, copy));
        session_->watch().look();
        const auto notes = [this] { return part<QLabel>("notes")->text(); };
        QTRY_VERIFY(notes().contains("changing.xyz was changed after it was read"));
        setTolerance(0.2);  // still of the file as it was
        QCOMPARE(panel_->result()->result->statistics.mean_mm, before_mm);
        QVERIFY(notes().contains("was changed after it was read"));
        const report::Document report = *panel_->reportDocument();
        QVERIFY(std::any_of(report.sections.front().blocks.begin(), report.sections.front().blocks.end(),
                            [](const report::Block& block) {
                                const auto* blockNotes = std::get_if<Notes>(&block);
                                return blockNotes && contains(*blockNotes, notes::sourceChangedSince);
                            }));

        panel_->recompute();
        settle();
        QVERIFY(std::abs(panel_->result()->result->statistics.mean_mm) < 1e-3);
        QVERIFY(!notes().contains("was changed after it was read"));
    }

    void aDrawingIsTheReference()
    {
        for (const QString& file : {drawingFile(io::shaftText(drawing()), "nominal.json"),
                                    drawingFile(cad::stepText(drawing(), {}), "nominal.step")}) {
            drop(panel_.get(), {file, copy_});
            settle();
            const auto outcome = panel_->result();
            QVERIFY(outcome->reference.drawn && outcome->sizes);
            QCOMPARE(session_->panel("compare").inputs.at("reference").path, file.toStdString());
            auto* sizes = part<CopyTable>("sizes");
            QCOMPARE(sizes->rowCount(), static_cast<int>(outcome->sizes->rows.size()));
            QVERIFY(sizes->rowCount() >= 8);
            QVERIFY(panel_->views().primaryViews()->keys().contains("sizes"));
            emit sizes->cellClicked(0, 0);  // the first row: z 0-98
            QVERIFY(panel_->views().place());
            QVERIFY(std::abs(*panel_->views().place()->z_mm - 49) < 1);
        }
    }

    void aSizeThatIsOutIsAFinding()
    {
        drop(panel_.get(), {drawingFile(io::shaftText(drawing()), "nominal.json"), copy_});
        settle();
        const report::Answer panelAnswer = features::answer(*panel_->result()->sizes, screenLanguage());
        QVERIFY(panelAnswer.verdict == Verdict::Fail);  // the collar of the copy is 0.1 mm too large
        QVERIFY(!panelAnswer.findings.empty());
        const Interval place = *panelAnswer.findings.front().place.z_mm;
        QVERIFY(std::abs(place.from - 98) < 1 && std::abs(place.to - 108) < 1);
        const auto before = panel_->result();
        setTolerance(0.2);                                        // judged again, nothing recognised again
        QVERIFY(panel_->result()->original == before->original);  // the mesh is the same object
        QVERIFY(panel_->result()->form.local_mean_mm == before->form.local_mean_mm);
        QCOMPARE(panel_->result()->sizes->rows.size(), before->sizes->rows.size());
        panel_->swapInputs();  // a drawing is no copy
        settle();
        QVERIFY(panel_->result()->reference.drawn);
        const report::Document report = *panel_->reportDocument();
        QVERIFY(std::any_of(report.sections.begin(), report.sections.end(), [](const report::Section& section) {
            return report::captionText(section.title, {}) == "Sizes against the drawing";
        }));
    }

    void aShaftOfAnotherPanelIsTheReference()
    {
        session_->edit("item", [&](project::Project& project) {
            project.items["pin"] = {shaftItem, toValues(drawing()), {}};
            project.panels["compare"].inputs["reference"].item = "pin";
        });
        drop(panel_.get(), {copy_});
        settle();
        QVERIFY(panel_->result()->reference.drawn && panel_->result()->sizes);
        QCOMPARE(panel_->result()->sources.inputs.front().path, std::string("pin"));
    }

    void twoDroppedFilesAreAnswered()
    {
        dropBoth();
        const project::PanelState& state = session_->panel("compare");
        QCOMPARE(QString::fromStdString(state.inputs.at("reference").path), original_);
        QCOMPARE(QString::fromStdString(state.inputs.at("copy").path), copy_);
        QVERIFY2(part<QLabel>("headline")->text().contains("mm"), qPrintable(part<QLabel>("headline")->text()));
        QVERIFY(!panel_->result()->result->verdict);
        QVERIFY(part<plot::MapView>("map")->isVisible());
        QVERIFY(!part<plot::MapView>("map")->data().empty());
        QCOMPARE(part<plot::ChartView>("histogram")->data().handles.size(), std::size_t{0});
        QVERIFY(part<compare_panel::ZoneTable>("zones")->rowCount() > 3);
        QVERIFY(part<compare_panel::StatisticsTable>("statistics")->rowCount() > 10);
    }

    void filesCanComeOneByOne()
    {
        drop(panel_.get(), {original_});
        QTRY_VERIFY(!panel_->isBusy());
        QVERIFY(!panel_->hasResult());
        drop(panel_.get(), {copy_});
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("copy").path), copy_);
    }

    void aThirdScanIsTheNextCopy()
    {
        dropBoth();
        QVERIFY2(panel_->minimumSizeHint().width() <= 1000,
                 qPrintable(QString::number(panel_->minimumSizeHint().width())));  // the smallest window
        setTolerance(0.2);
        const QString next = folder_.filePath("next.xyz");
        QVERIFY(QFile::copy(original_, next));
        drop(panel_.get(), {next});
        settle();
        const project::PanelState& state = session_->panel("compare");
        QCOMPARE(QString::fromStdString(state.inputs.at("reference").path), original_);
        QCOMPARE(QString::fromStdString(state.inputs.at("copy").path), next);
        QVERIFY(panel_->result()->result->verdict == Verdict::Pass);  // the limits are those of the part before
        session_->undoStack().undo();
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("copy").path), copy_);
    }

    void theNextCopyCanBecomeTheOriginal()
    {
        dropBoth();
        auto* bar = panel_->findChild<QFrame*>("nextPartBar");
        QVERIFY(bar && !bar->isVisible());
        const QString next = folder_.filePath("next.xyz");
        QVERIFY(QFile::exists(next) || QFile::copy(original_, next));
        drop(panel_.get(), {next});
        settle();
        QVERIFY(bar->isVisible());
        QVERIFY(bar->findChild<QLabel*>("nextPart")->text().contains("next.xyz"));
        bar->findChild<QToolButton*>("useAsOther")->click();
        settle();
        QVERIFY(!bar->isVisible());
        const auto& inputs = session_->panel("compare").inputs;
        QCOMPARE(QString::fromStdString(inputs.at("reference").path), next);
        QCOMPARE(QString::fromStdString(inputs.at("copy").path), copy_);
        session_->undoStack().undo();
        session_->undoStack().undo();
        settle();
        QVERIFY(!bar->isVisible());
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("reference").path), original_);
    }

    void fieldsAndViewsAreCommands()
    {
        dropBoth();
        settle();
        QStringList paths;
        std::function<void()> tolerance, meridian;
        for (const PanelCommand& command : panel_->commands()) {
            paths << command.path;
            if (command.path.contains("Tolerance")) tolerance = command.run;
            if (command.path.endsWith("Meridian")) meridian = command.run;
        }
        QVERIFY2(tolerance && meridian, qPrintable(paths.join('\n')));
        QVERIFY(paths.join('\n').contains("JSON"));  // exports
        QApplication::setActiveWindow(panel_->window());
        tolerance();
        QVERIFY(QApplication::focusWidget() && QApplication::focusWidget()->objectName() == "tolerance_mm");
        meridian();
        QCOMPARE(panel_->findChild<PrimaryViews*>()->primary(), QString("meridian"));
    }

    void severalCopiesMakeATableWithTrend()
    {
        const QString third = folder_.filePath("third.xyz");
        QVERIFY(QFile::copy(original_, third));
        const QString broken = makeBroken();
        drop(panel_.get(), {original_, copy_, third, broken});
        settle();
        setTolerance(0.2);
        const auto* table = part<CopyTable>("copies");
        QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 3, 60000);
        QTRY_VERIFY(table->item(1, 1)->text().contains("within"));
        QVERIFY2(table->item(0, 0)->text().startsWith("copy.xyz"), qPrintable(table->item(0, 0)->text()));
        QCOMPARE(table->item(1, 0)->text(), QString("third.xyz"));
        QCOMPARE(table->item(2, 0)->text(), QString("broken.xyz"));
        QVERIFY(table->item(2, 1)->text().length() > 10);  // why it has no numbers
        const report::Plot& trend = part<plot::ChartView>("trend")->data();
        QCOMPARE(trend.limits.size(), std::size_t{2});
        QCOMPARE(trend.curves.back().y.size(), std::size_t{3});
        QVERIFY(panel_->views().primaryViews()->keys().contains("copies"));
        const auto document = panel_->reportDocument();
        QVERIFY(document && report::toHtml(*document).find("third.xyz") != std::string::npos);
        QCOMPARE(document->inputs.size(), std::size_t{3});  // with its digest; the broken one was not read whole

        emit part<CopyTable>("copies")->cellDoubleClicked(1, 0);
        settle();
        const project::PanelState& state = session_->panel("compare");
        QCOMPARE(QString::fromStdString(state.inputs.at("copy").path), third);
        QCOMPARE(QString::fromStdString(state.inputs.at("copies").path), copy_);
        QTRY_VERIFY(table->item(0, 0)->text().startsWith("third.xyz"));
        part<QToolButton>("swap")->click();  // reference and copy only
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("copies").path), copy_);
        session_->edit("one", [](project::Project& project) {
            project.panels["compare"].inputs.erase("copies");
            project.panels["compare"].inputs.erase("copies.2");
        });
        settle();
        QVERIFY(!panel_->views().primaryViews()->keys().contains("copies"));
    }

    void swapAndUndo()
    {
        dropBoth();
        const double mean = panel_->result()->result->statistics.mean_mm;
        part<QToolButton>("swap")->click();
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("reference").path), copy_);
        QVERIFY(std::abs(panel_->result()->result->statistics.mean_mm + mean) < 0.01);  // excess becomes lack
        session_->undoStack().undo();
        settle();
        QCOMPARE(QString::fromStdString(session_->panel("compare").inputs.at("reference").path), original_);
        QCOMPARE(panel_->result()->result->statistics.mean_mm, mean);
    }

    void toleranceIsJudgedWithoutRegisteringAgain()
    {
        dropBoth();
        const auto before = panel_->result();
        setTolerance(0.1);
        const auto after = panel_->result();
        QVERIFY(after->result->verdict.has_value());
        QVERIFY(after->form.local_mean_mm == before->form.local_mean_mm);  // the same object: taken over, not computed
        QCOMPARE(after->result->deviation_mm.size(), before->result->deviation_mm.size());
        QVERIFY(part<QLabel>("verdict")->isVisible());
        const QString word = part<QLabel>("verdict")->text();
        QVERIFY2(word.contains("tolerance") && (word.startsWith("✓") || word.startsWith("✗")), qPrintable(word));
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->result->verdict);
        QCOMPARE(part<QLabel>("verdict")->text(), QString("no limit given"));
    }

    void cancelStopsAndKeepsTheOldPicture()
    {
        dropBoth();
        const auto before = panel_->result();
        session_->edit("method", [](project::Project& project) {
            lathelier::set(project.panels["compare"].parameters, "max_distance_mm", 2.5);
        });
        QVERIFY(panel_->isBusy());
        panel_->cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!panel_->isBusy(), 2000);
        QVERIFY(panel_->result() == before);
        panel_->recompute();
        settle();
        QVERIFY(panel_->result() != before);
    }

    void aMissingFileIsToldAndTheNextOneHelps()
    {
        drop(panel_.get(), {original_, folder_.filePath("nowhere.ply")});
        QTRY_VERIFY(panel_->findChild<QLabel*>("message")->text().contains("nowhere.ply"));
        QVERIFY(panel_->findChild<QLabel*>("message")->text().contains("does not exist"));
        QCOMPARE(session_->panel("compare").inputs.size(), std::size_t{1});  // it took no place
        session_->undoStack().undo();
        dropBoth();
    }

    void deviationsAreExportedAndReported()
    {
        dropBoth();
        const auto document = panel_->reportDocument();
        QVERIFY(document && document->inputs.size() == 2);
        int pictures = 0;
        for (const report::Section& section : document->sections)
            for (const report::Block& block : section.blocks)
                pictures += std::holds_alternative<report::Picture>(block);
        QCOMPARE(pictures, part<scene::SceneView>("scene")->canDraw() ? 4 : 0);
        QVERIFY(!document->synthetic);
    }

    void syntheticDataAreMarked()
    {
        session_->edit("open", [&](project::Project& project) {
            auto& inputs = project.panels["compare"].inputs;
            inputs["reference"].path = original_.toStdString();
            inputs["reference"].synthetic = true;
            inputs["copy"].path = copy_.toStdString();
        });
        settle();
        QVERIFY(part<QLabel>("synthetic")->isVisible());
        QVERIFY(panel_->reportDocument()->synthetic);
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    ComparePanelTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "compare_panel_test.moc"
