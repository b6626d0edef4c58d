// The panel "Tap test", used as a technologist does: a record is opened, hits are looked at, the response is kept.
#include <fmt/format.h>

#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "engine/core/frf_item.h"
#include "engine/io/file.h"
#include "tests/engine/receptance/tapped_modes.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/resources.h"
#include "widgets/tap/tap_panel.h"
#include "widgets/tap/tap_views.h"

namespace lathelier::tap_panel {

class TapPanelTest : public QObject, PanelFixture<TapPanel> {
    Q_OBJECT

    QTemporaryDir folder_;

    /// Three hits, the second a double one.
    std::string record() const
    {
        lathelier::testing::Tapping tapping;
        tapping.rate_hz = 20000;
        tapping.duration_s = 1.6;
        tapping.pulses = {{0.05, 1e-3, 210}, {0.55, 1e-3, 180}, {0.58, 1e-3, 30}, {1.05, 1e-3, 240}};
        const receptance::TapSignals made = tapping.record();
        std::string text = "t_s,force_N,acc_m_s2\n";
        for (std::size_t i = 0; i < made.force_N.size(); ++i)
            text += fmt::format("{:.5f},{:.6f},{:.6f}\n", static_cast<double>(i) / made.rate_hz, made.force_N[i],
                                made.motion[i] / 1000);
        const std::string path = folder_.filePath("record.csv").toStdString();
        io::writeFile(path, text);
        return path;
    }

    void openRecord()
    {
        const std::string path = record();
        session_->edit("Open", [&](project::Project& project) {
            project.panels["tap"].inputs[receptance::tapRecordRole].path = path;
        });
        settle();
    }

private slots:
    void initTestCase() { useResources(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void theHitsAreShownAndTheDoubleOneIsLeftOut()
    {
        openRecord();
        QVERIFY(panel_->hasResult());
        const receptance::TapResult& result = panel_->result()->study.result;
        QCOMPARE(result.averages, std::size_t{2});
        QCOMPARE(panel_->views().hits()->rowCount(), 3);
        const report::Plot& force = panel_->views().force()->data();
        QCOMPARE(force.regions.size(), std::size_t{3});
        QCOMPARE(force.marks.size(), std::size_t{3});
        set("keep_rejected", true);
        settle();
        QCOMPARE(panel_->result()->study.result.averages, std::size_t{3});
    }

    void theWindowIsDrawnAndItsDecaySaid()
    {
        openRecord();
        const std::size_t curves = panel_->views().force()->data().curves.size();
        set("window", std::string("force_exponential"));
        settle();
        QVERIFY(panel_->views().force()->data().curves.size() > curves);
        QVERIFY(panel_->result()->study.result.window_decay_1_s > 0);
    }

    void theResponseIsKept()
    {
        openRecord();
        std::vector<project::Item> offered;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string&, const project::Item& item) { offered.push_back(item); });
        panel_->findChild<QToolButton*>("useThisResponse")->click();
        QCOMPARE(offered.size(), std::size_t{1});
        QCOMPARE(offered[0].kind, std::string(frfItem));
        const auto kept = frfOf(offered[0].values);
        QVERIFY(kept && kept->value == panel_->result()->study.result.response.value);
        QVERIFY(!kept->coherence.empty());
    }
};

}  // namespace lathelier::tap_panel

QTEST_MAIN(lathelier::tap_panel::TapPanelTest)
#include "tap_panel_test.moc"
