// Chatter marks that the panel "Surface" sent, in the panel "Lobes": a line at their speed, a dot at their frequency,
// and the model's frequency beside.
#include <QLocale>
#include <QTest>

#include "engine/stability/marks_item.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/resources.h"
#include "widgets/lobes/lobes_panel.h"
#include "widgets/lobes/lobes_views.h"

namespace lathelier::lobes_panel {

class MarksInLobesTest : public QObject, PanelFixture<LobesPanel> {
    Q_OBJECT

    bool hasLine(const report::Plot& plot) const
    {
        return std::any_of(plot.limits.begin(), plot.limits.end(),
                           [](const report::Limit& limit) { return limit.place == 2016; });
    }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
    }
    void init() { begin(); }
    void cleanup() { end(); }

    void marksAreDrawnAndTakenBack()
    {
        Rows modes;
        modes.rows.push_back({toValues(stability::Mode{350, 0.03, 1e4})});
        session_->edit("Modes", [&](project::Project& project) {
            Values& p = project.panels["lobes"].parameters;
            lathelier::set(p, stability::modeKey, modes);
            lathelier::set(p, "speed_rpm", std::vector<Interval>{{1500, 3000}});
        });
        settle();
        QVERIFY(!panel_->result()->marks);
        const auto frequencies = [&] { return panel_->findChild<plot::ChartView*>("chatterFrequency"); };
        const std::size_t before = frequencies()->data().marks.size();
        session_->edit("Send", [&](project::Project& project) {
            project.items["Marks of a.png"] = {
                stability::marksItem, toValues(stability::SurfaceMarks{"a.png", 2016, 361, 1.8, {}}), {}};
            project::Source source;
            source.item = "Marks of a.png";
            project.panels["lobes"].inputs[stability::marksRole] = source;
        });
        settle();
        QVERIFY(panel_->result()->marks && panel_->result()->marks->frequency_hz == 361);
        QVERIFY(hasLine(panel_->views().chart()->data()));
        QCOMPARE(frequencies()->data().marks.size(), before + 1);
        QCOMPARE(frequencies()->data().marks.back().y, 361.0);
        const report::Answer panelAnswer = stability::answer(*panel_->result());
        QVERIFY(
            std::any_of(panelAnswer.findings.begin(), panelAnswer.findings.end(), [](const report::Finding& finding) {
                return report::findingText(finding).find("Your marks say 361.0") != std::string::npos;
            }));
        session_->undoStack().undo();
        settle();
        QVERIFY(!panel_->result()->marks && !hasLine(panel_->views().chart()->data()));
    }

    void marksThatAreNoneAreRefused()
    {
        session_->edit("Send", [&](project::Project& project) {
            project.items["x"] = {stability::marksItem, {{"speed_rpm", 2016.0}}, {}};
            Rows modes;
            modes.rows.push_back({toValues(stability::Mode{350, 0.03, 1e4})});
            lathelier::set(project.panels["lobes"].parameters, stability::modeKey, modes);
            project::Source source;
            source.item = "x";
            project.panels["lobes"].inputs[stability::marksRole] = source;
        });
        QTRY_VERIFY(panel_->error().has_value());
        QCOMPARE(std::string(panel_->error()->code().key), std::string("item_not_there"));
    }
};

}  // namespace lathelier::lobes_panel

QTEST_MAIN(lathelier::lobes_panel::MarksInLobesTest)
#include "marks_in_lobes_test.moc"
