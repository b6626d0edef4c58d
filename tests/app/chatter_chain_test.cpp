// From tap tests to lobes through the window: each panel hands its result to the next one.
#include <QPushButton>
#include <QUndoStack>

#include "engine/io/file.h"
#include "engine/sample/chatter_sample.h"
#include "tests/app/window_fixture.h"
#include "widgets/lobes/lobes_panel.h"
#include "widgets/shaft/shaft_panel.h"
#include "widgets/spindle_machine/machine_panel.h"

namespace lathelier {

class ChatterChainTest : public QObject, private WindowFixture {
    Q_OBJECT

    template <class PanelType>
    const PanelType& panel(const std::string& id) const
    {
        return static_cast<const PanelType&>(dock(id)->panel());
    }
    void press(const std::string& id, const char* button)
    {
        QTRY_VERIFY_WITH_TIMEOUT(dock(id)->panel().isCurrent(), 60000);
        QTest::mouseClick(dock(id)->panel().findChild<QPushButton*>(button), Qt::LeftButton);
    }

private slots:
    void initTestCase()
    {
        prepareSettings();
        const SamplePart& part = sample::chatterSample();
        const SampleContent content = part.make(1, {});
        for (std::size_t i = 0; i < part.files.size(); ++i)
            io::writeFile((folder_.path() + "/").toStdString() + part.files[i], content.texts[i]);
    }
    void init()
    {
        session_ = std::make_unique<Session>();
        window_ = std::make_unique<MainWindow>(
            *session_, languages_,
            std::vector<PanelFacts>{shaft_panel::shaftPanelFacts(), machine_panel::machinePanelFacts(),
                                    lobes_panel::lobesPanelFacts()});
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanup() { end(); }

    void goesFromTapTestsToLobes()
    {
        openFiles({folder_.filePath("tap_tests.json")});
        QVERIFY(window_->activeDock() == dock("spindle"));
        press("spindle", "useSpindle");
        QVERIFY(window_->activeDock() == dock("shaft"));
        openFiles({folder_.filePath("shaft.json")});
        QVERIFY(window_->activeDock() == dock("shaft"));
        press("shaft", "useResponse");
        QVERIFY(window_->activeDock() == dock("lobes"));
        QTRY_VERIFY_WITH_TIMEOUT(dock("lobes")->panel().isCurrent(), 60000);
        const auto lobes = panel<lobes_panel::LobesPanel>("lobes").result();
        const auto shaft = panel<shaft_panel::ShaftPanel>("shaft").result();
        QCOMPARE(lobes->response.frf->value, shaft->study.response.frf.value);
        // The machine of the sample: f_m as the paper has it, within what 1 % of noise leaves.
        QVERIFY(std::abs(*lobes->lobes->frequency_of_minimum_hz - 369) < 8);
        QCOMPARE(session_->project().items.size(), std::size_t{2});
        // An item that the lobes are made of and that goes is said to be missing.
        session_->edit("Remove", [](project::Project& project) { project.items.clear(); });
        QTRY_VERIFY(dock("lobes")->panel().error().has_value());
        QCOMPARE(std::string(dock("lobes")->panel().error()->code().key), std::string("item_not_there"));
        session_->undoStack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(dock("lobes")->panel().isCurrent(), 60000);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::ChatterChainTest)
#include "chatter_chain_test.moc"
