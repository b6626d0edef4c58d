// The panel "Turning program", used as a technologist does: a job dropped, a field changed, an operation switched off,
// two clampings, findings that lead to their line, programs written.
#include <QFile>
#include <QLocale>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "engine/cam/job_file.h"
#include "tests/engine/cam/plan_data.h"
#include "tests/widgets/core/drop_files.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"
#include "widgets/program_common/program_editor.h"
#include "widgets/turning/turning_panel.h"
#include "widgets/turning/turning_state.h"
#include "widgets/turning/turning_views.h"

namespace lathelier::turning_panel {

class TurningPanelTest : public QObject, PanelFixture<TurningPanel> {
    Q_OBJECT

    QTemporaryDir folder_;
    QString neck_, paper_;

    QString write(const QString& name, const cam::Job& job) const
    {
        const QString path = folder_.filePath(name);
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) file.write(QByteArray::fromStdString(cam::jobText(job)));
        return path;
    }
    void open(const QString& path)
    {
        drop(panel_.get(), {path});
        settle();
    }
    const cam::TurningPlan& plan() const { return *panel_->result()->plan; }
    TurningViews& views() const { return panel_->views(); }
    QByteArray read(const QString& path) const
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    bool says(const char* key) const
    {
        const Notes& notes = panel_->result()->notes;
        return std::any_of(notes.begin(), notes.end(),
                           [&](const Note& note) { return note.code.key == std::string(key); });
    }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        neck_ = write("neck.json", cam::jobWith(cam::neckRows(), 32, 150, {cam::roughD55(), cam::finishD55()}));
        paper_ = write("paper.json", cam::paperJob({cam::roughC80(), cam::finishC80()}));
    }
    void init()
    {
        QLocale::setDefault(QLocale::c());
        begin();
    }
    void cleanup() { end(); }

    void aJobIsPlannedAndItsProgramWritten()
    {
        open(neck_);
        set("setups", std::string("1"));
        settle();
        QCOMPARE(plan().setups.size(), std::size_t{1});
        QVERIFY(!plan().is_refused && plan().left_max_mm > 1);
        QCOMPARE(views().editor()->program(), QByteArray::fromStdString(plan().setups[0].text));
        QVERIFY(!views().editor()->isReadOnly());  // it may be changed by hand
        QCOMPARE(views().rest()->rowCount(), static_cast<int>(plan().rest.size()));
        const PanelExport program = panel_->offeredExports().front();
        const QString path = folder_.filePath("neck.nc");
        program.write(path);
        QCOMPARE(read(path), QByteArray::fromStdString(plan().setups[0].text));
    }

    void aFieldIsChangedAndUndone()
    {
        open(neck_);
        QVERIFY(!panel_->result()->is_changed);
        const double before_s = plan().setups[0].time_s;
        session_->edit("Set", [&](project::Project& project) {
            cam::Job job = plan().job;
            job.cutting.rough.depth_mm = 1;
            setJob(project.panels["turning"], toValues(job));
        });
        settle();
        QVERIFY(panel_->result()->is_changed && says("job_changed"));
        QCOMPARE(plan().job.cutting.rough.depth_mm, 1.0);
        QVERIFY(plan().setups[0].time_s > before_s);
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->is_changed && !says("job_changed"));
        QCOMPARE(plan().job.cutting.rough.depth_mm, 2.0);
    }

    void anotherControlIsChosen()
    {
        open(neck_);
        set("post", std::string("sinumerik"));
        settle();
        QVERIFY(plan().setups[0].text.find("DIAMON") != std::string::npos);
        QCOMPARE(panel_->offeredExports().front().suffix, QString("mpf"));
    }

    void aControlOfOnesOwnIsAFile()
    {
        open(neck_);
        cam::Post post = cam::postNamed("haas");
        post.name = "MINE";
        post.safe_start.push_back("M1099");
        const QString path = folder_.filePath("post.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(cam::postText(post)));
        file.close();
        open(path);
        QVERIFY(panel_->result()->has_own_post);
        QCOMPARE(plan().post, std::string("MINE"));
        QVERIFY(plan().setups[0].text.find("M1099") != std::string::npos);
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->has_own_post);
        QCOMPARE(plan().post, std::string("fanuc_a"));
    }

    void toolsOfAnOlderProjectAreTheSame()
    {
        const auto tools_of = [](const char* name) {
            const QString path = QString(LATHELIER_SOURCE_DIR "/tests/data/projects/") + name;
            const project::Project kept = project::readProject(path.toStdString()).project;
            return fromValues<cam::TurningQuestion>(kept.panels.at("turning").parameters).job.tools;
        };
        const auto tools = tools_of("version_4.lathelier");
        QCOMPARE(tools.size(), std::size_t{4});
        QVERIFY(tools == tools_of("version_5.lathelier"));
        QVERIFY(!tools[0].corner_radius_mm);  // that of the library
        QCOMPARE(tools[1].corner_radius_mm, std::optional<double>(0.4));
        QCOMPARE(tools[2].reach_mm, std::optional<double>(18));
        QCOMPARE(tools[3].diameter_mm, std::optional<double>(4));
    }

    void anotherInsertIsAnotherTool()
    {
        cam::Job job = cam::jobWith({cam::row(30, 20, 20), cam::row(20, 30, 30)}, 34, 90, {});
        for (const auto& [number, use] : {std::pair{1, cam::ToolUse::Rough}, std::pair{2, cam::ToolUse::Finish}}) {
            cam::JobTool& tool = job.tools.emplace_back();
            tool.number = number;
            tool.use = use;
            tool.insert = "CNMG 120408";
            tool.holder_name = "PCLNL 2525M12";
        }
        open(write("library.json", job));
        QCOMPARE(plan().job.tools[1].corner_radius_mm, std::optional<double>(0.8));
        const auto edit = [&](const char* key, const std::string& code) {
            // As the form does it: the table of tools with one cell changed.
            Values values = toValues(plan().stated);
            Rows tools = std::get<Rows>(*lathelier::find(values, cam::toolsKey));
            lathelier::set(tools.rows[1].cells, key, code);
            auto& form = panel_->findChild<InputColumn*>()->form();
            emit form.valueChanged(cam::toolsKey, tools, 0);
            settle();
        };
        edit("insert", "DNMG 150604");
        edit("holder_name", "PDJNL 2525M15");
        QVERIFY(panel_->result()->is_changed);
        QCOMPARE(plan().job.tools[1].corner_radius_mm, std::optional<double>(0.4));
        QCOMPARE(plan().job.tools[1].tip_angle_deg, std::optional<double>(55));
        QCOMPARE(plan().job.tools[1].entering_angle_deg, std::optional<double>(93));
        QVERIFY(!plan().stated.tools[1].corner_radius_mm);
        QVERIFY(!says("insert_not_of_holder"));
    }

    void anOperationIsSwitchedOff()
    {
        open(paper_);
        set("setups", std::string("1"));
        settle();
        const double left_mm = plan().left_max_mm;
        const auto rows = listedOperations(*panel_->result(), 0);
        const auto finish = std::find_if(rows.begin(), rows.end(), [](const cam::ListedOperation& operation) {
            return operation.which.kind == cam::OperationKind::Finish;
        });
        QVERIFY(finish != rows.end());
        const int row = static_cast<int>(finish - rows.begin());
        views().operations()->item(row, 0)->setCheckState(Qt::Unchecked);
        settle();
        QCOMPARE(plan().parameters.skipped.size(), std::size_t{1});
        for (const cam::PlannedOperation& operation : plan().setups[0].operations)
            QVERIFY(operation.kind != cam::OperationKind::Finish);
        QCOMPARE(views().operations()->rowCount(), static_cast<int>(rows.size()));
        QCOMPARE(views().operations()->item(row, 0)->checkState(), Qt::Unchecked);
        QVERIFY(plan().rest.size() > 0 && plan().left_max_mm >= left_mm);
        // The allowance stays on the whole first cylinder.
        QVERIFY(std::any_of(plan().rest.begin(), plan().rest.end(), [](const cam::RestInterval& rest) {
            return rest.z_start_mm < 5 && rest.z_end_mm > 90 && rest.left_mm > 0.295;
        }));
        session_->undoStack().undo();
        settle();
        QVERIFY(plan().parameters.skipped.empty() && plan().left_max_mm == left_mm);
    }

    void bothClampingsAreShownAndWritten()
    {
        open(paper_);
        QCOMPARE(plan().setups.size(), std::size_t{2});
        auto* second = panel_->findChild<QToolButton*>("clamping2");
        QVERIFY(second->isVisible());
        second->click();
        QCOMPARE(views().clamping(), std::size_t{1});
        QCOMPARE(views().editor()->program(), QByteArray::fromStdString(plan().setups[1].text));
        panel_->offeredExports().front().write(folder_.filePath("both.nc"));
        QCOMPARE(read(folder_.filePath("both_1.nc")), QByteArray::fromStdString(plan().setups[0].text));
        QCOMPARE(read(folder_.filePath("both_2.nc")), QByteArray::fromStdString(plan().setups[1].text));
    }

    void theScrubberMovesToolStockAndText()
    {
        open(neck_);
        QSlider* slider = views().scrubber()->slider();
        slider->setValue(0);
        QVERIFY(!views().stock().is_whole && !views().stock().pass);
        slider->setValue(ToolScrubber::places / 2);
        QVERIFY(views().stock().pass.has_value());
        const std::size_t half = *views().stock().pass;
        QCOMPARE(std::int64_t{views().editor()->line()}, views().line());
        QVERIFY(!views().contour()->pointedOut().shapes.empty());
        slider->setValue(ToolScrubber::places * 9 / 10);
        QVERIFY(*views().stock().pass > half);
        slider->setValue(ToolScrubber::places);
        QVERIFY(views().stock().is_whole);
        const stock::DrawnPath& drawn = panel_->result()->clampings[0].drawn;
        const std::int64_t line = drawn.lineOf(drawn.corners() / 3);
        views().editor()->goToLine(line);  // the other way round
        QTRY_COMPARE(views().line(), line);
        QVERIFY(slider->value() < ToolScrubber::places);
    }

    void aRefusedProgramIsShownAndNotWritten()
    {
        // The holder hangs down beside the insert.
        cam::Job job =
            cam::jobWith({cam::row(30, 20, 20), cam::row(20, 30, 30)}, 32, 90, {cam::roughC80(), cam::finishC80()});
        job.tools[1].holder = {{-20, -1}, {-20, 40}, {-12, 40}, {-12, -1}};
        for (HolderCorner& corner : job.tools[1].holder) corner.dz_mm = -corner.dz_mm;
        open(write("holder.json", job));
        QVERIFY(plan().is_refused);
        const auto& found = plan().setups[0].check.findings;
        QVERIFY(!found.empty());
        const QString path = folder_.filePath("refused.nc");
        QVERIFY_EXCEPTION_THROWN(panel_->offeredExports().front().write(path), Error);
        QVERIFY(!QFile::exists(path));
        views().findings()->setCurrentCell(0, 0);
        QCOMPARE(views().line(), found[0].line);
        QCOMPARE(std::int64_t{views().editor()->line()}, found[0].line);
    }

    void itFollowsTheLanguage()
    {
        open(neck_);
        Languages languages;
        languages.use("pl");
        QTRY_COMPARE(views().primaryViews()->title("operations"), QString("Operacje"));
        languages.use("en");
        QTRY_COMPARE(views().primaryViews()->title("operations"), QString("Operations"));
    }
};

}  // namespace lathelier::turning_panel

QTEST_MAIN(lathelier::turning_panel::TurningPanelTest)
#include "turning_panel_test.moc"
