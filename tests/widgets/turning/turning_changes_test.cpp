// The panel "Turning program": programs handed on, taken back corrected, changed by hand and checked
// again; what stays on the contour; courses along the part; places in two clampings.
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <cmath>

#include "engine/cam/job_file.h"
#include "engine/core/frf_item.h"
#include "engine/gcode/program_item.h"
#include "engine/io/file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "tests/engine/cam/plan_data.h"
#include "tests/widgets/core/drop_files.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/resources.h"
#include "widgets/program_common/program_editor.h"
#include "widgets/turning/turning_panel.h"
#include "widgets/turning/turning_views.h"

namespace lathelier::turning_panel {

class TurningChangesTest : public QObject, PanelFixture<TurningPanel> {
    Q_OBJECT

    QTemporaryDir folder_;
    QString paper_;

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
    void openOne(const QString& path)
    {
        open(path);
        set("setups", std::string("1"));
        settle();
    }
    const cam::TurningPlan& plan() const { return *panel_->result()->plan; }
    const cam::ShownProgram& program(std::size_t setup = 0) const { return panel_->result()->programs[setup]; }
    TurningViews& views() const { return panel_->views(); }
    /// As somebody types it: another text in the editor, announced.
    void type(const QByteArray& text)
    {
        views().editor()->selectAll();
        views().editor()->replaceSelectedText(QString::fromUtf8(text));
        views().editor()->takeOver();
        settle();
    }
    QByteArray typed() const { return views().editor()->program(); }
    /// A block more before the finish of the first cylinder.
    static QString changed(const std::string& text, const QString& block)
    {
        QString now = QString::fromStdString(text);
        const int pass = now.indexOf("G1 Z-98.", now.indexOf("(FINISH)"));
        return pass < 0 ? QString() : now.insert(now.lastIndexOf('\n', pass) + 1, block + '\n');
    }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        paper_ = write("paper.json", cam::paperJob({cam::roughC80(), cam::finishC80()}));
    }
    void init() { begin(); }
    void cleanup() { end(); }

    void whatWasTypedLastIsTakenBackToo()
    {
        openOne(paper_);
        const QByteArray planned = typed();
        type(QByteArray(planned).replace("M30", "(BY HAND)\nM30"));
        views().editor()->selectAll();
        views().editor()->replaceSelectedText(QString::fromUtf8(QByteArray(planned).replace("M30", "(MORE)\nM30")));
        QVERIFY(views().editor()->isTyping());
        views().bar()->takeBack()->click();
        settle();
        QTest::qWait(600);
        settle();
        QVERIFY(!program().is_changed);
        QCOMPARE(typed(), planned);
    }

    void aCorrectedProgramOfAClampingThatIsNotThereIsSaid()
    {
        openOne(paper_);
        gcode::ProgramItem corrected;
        corrected.text = plan().setups[0].text;
        corrected.clamping = 2;
        session_->edit("Use", [&](project::Project& project) {
            project.items["corrected"] = {gcode::correctedItem, gcode::toValues(corrected), {}};
            project.panels["turning"].inputs[cam::programRole].item = "corrected";
        });
        settle();
        QCOMPARE(program().origin, cam::ProgramOrigin::Planned);
        const Notes& notes = panel_->result()->notes;
        const auto says = [&](const char* key) {
            return std::any_of(notes.begin(), notes.end(),
                               [&](const Note& note) { return note.code.key == std::string(key); });
        };
        QVERIFY(says("program_not_used") && !says("program_corrected"));
    }

    void whatStaysIsHatchedWithItsNumberAndCause()
    {
        openOne(paper_);
        QVERIFY(!plan().rest.empty());
        const report::Plot& shown = views().contour()->data();
        std::size_t areas = 0;
        for (const report::Region& region : shown.regions) {
            if (region.colour.role != report::ColourRole::Excess) continue;
            ++areas;
            QVERIFY(region.x.size() > 4);
            const auto finite = [](double value) { return std::isfinite(value); };
            QVERIFY(std::all_of(region.y.begin(), region.y.end(), finite));
        }
        QCOMPARE(areas, plan().rest.size());
        // The back edge leaves 1.6 mm behind the shoulder: the area is as high.
        double highest = 0;
        for (const report::Region& region : shown.regions) {
            if (region.colour.role != report::ColourRole::Excess) continue;
            for (std::size_t i = 0; i < region.x.size(); ++i)
                highest = std::max(highest, region.y[region.x.size() - 1 - i] - region.y[i]);
        }
        QVERIFY(std::abs(highest - plan().left_max_mm) < 0.3 * plan().left_max_mm);
        for (std::size_t i = 0; i < plan().rest.size(); ++i) {
            const std::string number = std::to_string(i + 1) + ":";
            QVERIFY(std::any_of(shown.marks.begin(), shown.marks.end(), [&](const report::Mark& mark) {
                return report::captionText(mark.name).rfind(number, 0) == 0;
            }));
        }
    }

    void allCoursesStandUnderTheContour()
    {
        openOne(paper_);
        CourseCharts& courses = *views().courses();
        QVERIFY(courses.chart(cam::Course::Speed)->isVisible() && courses.chart(cam::Course::Roughness)->isVisible());
        QVERIFY(!courses.chart(cam::Course::CuttingSpeed)->isVisible());
        QVERIFY(!courses.box(cam::Course::Frequency)->isEnabled());  // there is no spindle
        courses.box(cam::Course::CuttingSpeed)->click();
        QVERIFY(courses.chart(cam::Course::CuttingSpeed)->isVisible());
        for (const cam::Course course : {cam::Course::Speed, cam::Course::CuttingSpeed, cam::Course::Roughness}) {
            const QRectF own = courses.chart(course)->visibleRange(), leader = views().contour()->visibleRange();
            QVERIFY(std::abs(own.left() - leader.left()) < 1e-6 && std::abs(own.width() - leader.width()) < 1e-6);
            QVERIFY(!courses.chart(course)->data().curves.empty());
        }
        // The same left edge, so that a place is below itself.
        QTRY_VERIFY(std::abs(courses.chart(cam::Course::Speed)->pixelAt(0, 0).x() -
                             views().contour()->pixelAt(0, 0).x()) < 1.5);
        QVERIFY(std::abs(courses.chart(cam::Course::Roughness)->pixelAt(0, 0).x() -
                         views().contour()->pixelAt(0, 0).x()) < 1.5);
        session_->collectViews();
        QCOMPARE(session_->view("turning", "courses"), Value(std::int64_t{1 | 2 | 8}));
    }

    void aRowOfRestLeadsToItsClampingAndBlock()
    {
        open(paper_);
        QCOMPARE(plan().setups.size(), std::size_t{2});
        QVERIFY(!plan().rest.empty());
        for (int row = static_cast<int>(plan().rest.size()) - 1; row >= 0; --row) {
            const cam::RestInterval& rest = plan().rest[static_cast<std::size_t>(row)];
            views().rest()->setCurrentCell(-1, -1);
            views().rest()->setCurrentCell(row, 0);
            const bool is_first = (rest.z_start_mm + rest.z_end_mm) / 2 <= plan().setups[0].clamping.finished_to_mm;
            QCOMPARE(views().clamping(), std::size_t{is_first ? 0U : 1U});
            QVERIFY(views().line() > 0);
            QCOMPARE(views().rest()->currentRow(), row);
            // The block passes by the stretch.
            const Interval z = inStock(*panel_->result(), views().clamping(), {rest.z_start_mm, rest.z_end_mm});
            const stock::DrawnPath& drawn = panel_->result()->clampings[views().clamping()].drawn;
            bool passes = false;
            for (const std::uint32_t piece : drawn.piecesOf(views().line())) {
                const double a = drawn.corner(piece - 1).z_mm, b = drawn.corner(piece).z_mm;
                passes = passes || (std::min(a, b) < z.to + 2 && std::max(a, b) > z.from - 2);
            }
            QVERIFY(passes);
            QVERIFY(views().contour()->marker().has_value());
        }
        const report::Caption first = views().contour()->data().title;
        views().setClamping(1 - views().clamping());
        QVERIFY(!(views().contour()->data().title == first));  // the contour says which clamping it shows
    }

    void thePlaceOfTheToolIsReadWithTwoClampings()
    {
        panel_->resize(940, 640);
        open(paper_);
        QCOMPARE(plan().setups.size(), std::size_t{2});
        views().scrubber()->slider()->setValue(ToolScrubber::places / 3);
        const auto* where = panel_->findChild<QLabel*>("turningWhere");
        QVERIFY(where->fontMetrics().horizontalAdvance(where->text()) <= where->width());
    }

    void aProgramIsHandedOnWithItsBar()
    {
        openOne(paper_);
        QVERIFY(views().bar()->use()->isEnabled());
        project::Item item;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string&, const project::Item& offered, bool) { item = offered; });
        views().bar()->use()->click();
        QCOMPARE(item.kind, std::string(gcode::programItem));
        const auto handed = gcode::programOf(item.values);
        QVERIFY(handed && handed->stock);
        QCOMPARE(handed->text, plan().setups[0].text);
        QCOMPARE(handed->z_zero_mm, 1.0);
        QVERIFY(std::abs(handed->stock->length_mm() - 201) < 1e-9);  // from the raw end to the chuck's face
    }

    void aChangedTextVoidsTheCheckUntilItIsRunAgain()
    {
        openOne(paper_);
        const QByteArray planned = typed();
        QVERIFY(!views().editor()->isReadOnly());
        QVERIFY(views().bar()->state().contains("checked"));
        type(QByteArray(planned).replace("M30", "(BY HAND)\nM30"));
        QVERIFY(program().is_changed && program().is_void && panel_->result()->isVoid());
        QVERIFY(views().bar()->state().contains("Check void"));
        QVERIFY(views().bar()->check()->isVisibleTo(views().bar()) && !views().bar()->use()->isEnabled());
        const QString path = folder_.filePath("void.nc");
        QVERIFY_EXCEPTION_THROWN(panel_->offeredExports().front().write(path), Error);
        QVERIFY(!QFile::exists(path));
        views().bar()->check()->click();
        settle();
        QVERIFY(program().is_changed && !program().is_void);
        QVERIFY(views().bar()->state().contains("changed by hand, checked"));
        QVERIFY(views().bar()->use()->isEnabled());
        panel_->offeredExports().front().write(path);
        QFile written(path);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll(), typed());
        session_->undoStack().undo();
        settle();
        QVERIFY(program().is_void);
        views().bar()->takeBack()->click();
        settle();
        QVERIFY(!program().is_changed);
        QCOMPARE(typed(), planned);
    }

    void whatAChangeCutsTooDeepIsFound()
    {
        openOne(paper_);
        const QString text = changed(plan().setups[0].text, "G1 X29.5");
        QVERIFY(!text.isEmpty());
        type(text.toUtf8());
        views().bar()->check()->click();
        settle();
        QVERIFY(plan().is_refused);
        QVERIFY(!plan().setups[0].check.findings.empty());
        QVERIFY(views().bar()->state().contains("findings") || views().bar()->state().contains("errors"));
    }

    void changesBelongToTheProgramTheyWereMadeOf()
    {
        openOne(paper_);
        type(typed().replace("M30", "(BY HAND)\nM30"));
        QVERIFY(program().is_changed);
        set("post", std::string("sinumerik"));  // another program
        settle();
        QVERIFY(!program().is_changed && !panel_->result()->isVoid());
        const Notes& notes = panel_->result()->notes;
        QVERIFY(std::any_of(notes.begin(), notes.end(),
                            [](const Note& note) { return note.code.key == std::string("changes_of_other_program"); }));
        session_->undoStack().undo();
        settle();
        QVERIFY(program().is_changed && program().is_void);
    }

    void aCorrectedProgramIsCheckedWithItsCorrection()
    {
        openOne(paper_);
        // The whole program 10 µm deeper on the radius over the first cylinder, and said so.
        gcode::ProgramItem corrected;
        corrected.text = plan().setups[0].text;
        corrected.corrected_from = io::sha256(corrected.text);
        corrected.text = changed(corrected.text, "G1 X29.98").toStdString();
        QVERIFY(!corrected.text.empty());
        corrected.correction.z_mm = {-5, 97.5};
        corrected.correction.radius_mm = {-0.01, -0.01};
        const auto give = [&](const gcode::ProgramItem& item) {
            session_->edit("Use", [&](project::Project& project) {
                project.items["corrected"] = {gcode::correctedItem, gcode::toValues(item), {}};
                project.panels["turning"].inputs[cam::programRole].item = "corrected";
            });
            settle();
        };
        give(corrected);
        QCOMPARE(program().origin, cam::ProgramOrigin::Corrected);
        QCOMPARE(QByteArray::fromStdString(corrected.text), typed());
        QVERIFY(!plan().is_refused);
        QVERIFY(views().bar()->state().contains("compensated, checked"));
        const double with_um = plan().setups[0].check.gouge_um;
        // Without what it says of itself every block would be a gouge.
        corrected.correction.radius_mm = {0, 0};
        give(corrected);
        QVERIFY(plan().is_refused);
        QVERIFY(plan().setups[0].check.gouge_um > with_um + 5);
        QVERIFY(views().bar()->state().contains("findings"));
        // Made of another program than the planned one: remarked.
        corrected.corrected_from = "0000";
        give(corrected);
        const Notes& notes = panel_->result()->notes;
        QVERIFY(std::any_of(notes.begin(), notes.end(),
                            [](const Note& note) { return note.code.key == std::string("corrected_from_other"); }));
        session_->edit("Clear",
                       [](project::Project& project) { project.panels["turning"].inputs.erase(cam::programRole); });
        settle();
        QCOMPARE(program().origin, cam::ProgramOrigin::Planned);
        QCOMPARE(typed(), QByteArray::fromStdString(plan().setups[0].text));
    }

    void withoutASpindleASentenceStandsInPlaceOfSpeeds()
    {
        openOne(paper_);
        views().primaryViews()->setPrimary("sections");
        QVERIFY(views().sentence()->isVisibleTo(views().primaryViews()));
        QVERIFY(!views().sections()->isVisibleTo(views().primaryViews()));
        QVERIFY(views().sentence()->text().contains("spindle"));
    }

    void theLobesOfAMomentAreOpened()
    {
        openOne(paper_);
        receptance::SpindleReceptance spindle;
        spindle.source = receptance::SpindleSprings{};
        session_->edit("Use", [&](project::Project& project) {
            project.items["spindle"] = {receptance::spindleItem, receptance::toValues(spindle), {}};
            project.panels["turning"].inputs["spindle"].item = "spindle";
        });
        settle();
        views().primaryViews()->setPrimary("sections");
        QVERIFY(!plan().sections.empty() && plan().sections[0].receptance);
        QVERIFY(!views().sentence()->isVisibleTo(views().primaryViews()));
        QVERIFY(views().courses()->box(cam::Course::Frequency)->isEnabled());
        views().sections()->setCurrentCell(0, 0);
        QVERIFY(!views().why()->data().curves.empty() || !views().why()->data().regions.empty());
        project::Item item;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string&, const project::Item& offered, bool) { item = offered; });
        views().openLobes()->click();
        QCOMPARE(item.kind, std::string(frfItem));
        const auto frf = frfOf(item.values);
        QVERIFY(frf.has_value());
        QCOMPARE(frf->frequency_hz.size(), plan().sections[0].receptance->frequency_hz.size());
    }
};

}  // namespace lathelier::turning_panel

QTEST_MAIN(lathelier::turning_panel::TurningChangesTest)
#include "turning_changes_test.moc"
