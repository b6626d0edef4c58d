// The panel "Series", used as a quality engineer does: an archive is opened, a characteristic and a part are chosen,
// the part's evaluation is opened as it was.
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <nlohmann/json.hpp>

#include "engine/archive/archive.h"
#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/project/parts.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/resources.h"
#include "widgets/series/series_panel.h"
#include "widgets/series/series_views.h"

namespace lathelier::series_panel {

class SeriesPanelTest : public QObject, PanelFixture<SeriesPanel> {
    Q_OBJECT

    static constexpr int parts = 12;

    QTemporaryDir folder_;
    std::string archive_;

    std::string partPath(int number) const { return folder_.filePath("part_%1.xyz").arg(number).toStdString(); }

    static std::string mapOf(int number)
    {
        return lathelier::Json{{"map",
                                {{"z_start_mm", 0},
                                 {"z_step_mm", 5},
                                 {"z_count", 3},
                                 {"angle_count", 2},
                                 {"mean_mm", {0.001 * number, 0.01, 0, -0.01, 0.02, 0.001 * number}}}}}
            .dump();
    }

    void makeArchive()
    {
        archive_ = folder_.filePath("shop.archive").toStdString();
        QFile::remove(QString::fromStdString(archive_));
        std::vector<archive::Evaluation> all;
        for (int number = 0; number < parts; ++number) {
            io::writeFile(partPath(number), "0 0 " + std::to_string(number) + "\n");
            archive::Evaluation one;
            one.task = "compare";
            one.recipe_sha256 = std::string(64, 'a');
            one.version = "0";
            one.inputs = {{"copy", {partPath(number), 6, io::fileSha256(partPath(number))}}};
            one.verdict = number == 4 ? Verdict::Fail : Verdict::Pass;
            one.characteristics = {
                {"answer", "mm", number == 4 ? 0.08 : 0.01 * (number % 3), 0.002, -0.05, 0.05, one.verdict},
                {"rmse_mm", "mm", 0.01 + 0.001 * number, {}, {}, {}, {}}};
            one.result = mapOf(number);
            all.push_back(one);
        }
        archive::Archive::open(archive_, archive::Access::Create)
            .add(all, {"A. Nowak", "Scanner 3", "2026-06-01"},
                 {{std::string(64, 'a'), R"({"parameters": {"tolerance_mm": 0.05}, "inputs": {}})"}});
    }

    void openArchive()
    {
        makeArchive();
        panel_->openFiles({QString::fromStdString(archive_)});
        settle();
    }

    std::string keptPart() const
    {
        const Value* const part = find(session_->panel("series").parameters, series::partKey);
        return part ? text(*part) : std::string();
    }

private slots:
    void initTestCase() { useResources(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void theWorstPartIsTheAnswer()
    {
        openArchive();
        const auto answer = panel_->shownAnswer();
        QVERIFY(answer.has_value());
        QCOMPARE(*answer->value, 0.08);
        QVERIFY(answer->verdict == Verdict::Fail);
        QCOMPARE(panel_->result()->chart.out_of_tolerance, std::int64_t{1});
        QCOMPARE(panel_->views().pictures()->count(), std::size_t{parts});
    }

    void aClickOnAPointShowsItsPart()
    {
        openArchive();
        emit panel_->views().chart()->clicked(5.2, 0.08);
        settle();
        QCOMPARE(panel_->result()->part.entry.file, std::string("part_4.xyz"));
        QCOMPARE(*panel_->views().chart()->marker(), 5.0);
        QCOMPARE(panel_->views().pictures()->chosen(), keptPart());
        QCOMPARE(panel_->views().values()->currentRow(), 4);
        session_->undoStack().undo();
        settle();
        QCOMPARE(panel_->result()->part.entry.file, std::string("part_11.xyz"));
    }

    void picturesAreChosenByMouseAndKeys()
    {
        openArchive();
        PicturesView* const pictures = panel_->views().pictures();
        pictures->resize(600, 400);
        QTest::mouseClick(pictures, Qt::LeftButton, {}, pictures->placeOf(2).center().toPoint());
        settle();
        QCOMPARE(panel_->result()->part.entry.file, std::string("part_2.xyz"));
        QTest::keyClick(pictures, Qt::Key_Right);
        settle();
        QCOMPARE(panel_->result()->part.entry.file, std::string("part_3.xyz"));
    }

    void aCharacteristicIsChosenFromTheTable()
    {
        openArchive();
        panel_->views().characteristics()->selectRow(1);
        settle();
        QCOMPARE(panel_->result()->chosen.key, std::string("rmse_mm"));
        QVERIFY(!panel_->shownAnswer()->verdict.has_value());
    }

    void anEvaluationOpensAsItWas()
    {
        openArchive();
        QVERIFY(panel_->views().openButton()->isEnabled());
        std::vector<std::string> asked;
        QObject::connect(panel_.get(), &PanelBase::panelRequested,
                         [&asked](const std::string& id) { asked.push_back(id); });
        panel_->views().openButton()->click();
        QVERIFY(asked == std::vector<std::string>{"compare"});
        const project::PanelState& opened = session_->panel("compare");
        QCOMPARE(opened.inputs.at("copy").path, partPath(parts - 1));
        QVERIFY(find(opened.parameters, "tolerance_mm") && *find(opened.parameters, "tolerance_mm") == Value(0.05));
        QCOMPARE(project::partsOf(session_->project()).size(), std::size_t{2});
    }

    void whatChangedSinceDoesNotOpen()
    {
        makeArchive();
        io::writeFile(partPath(parts - 1), "1 1 1\n");
        panel_->openFiles({QString::fromStdString(archive_)});
        settle();
        QVERIFY(!panel_->views().openButton()->isEnabled());
        QVERIFY(!panel_->views().openButton()->toolTip().isEmpty());
    }

    void aFindingShowsItsPart()
    {
        openArchive();
        QVERIFY(!panel_->shownAnswer()->findings.empty());
        QCOMPARE(*panel_->shownAnswer()->findings.front().place.line, std::int64_t{5});
    }
};

}  // namespace lathelier::series_panel

QTEST_MAIN(lathelier::series_panel::SeriesPanelTest)
#include "series_panel_test.moc"
