// The panel "Speed", used as an operator does: values typed on large keys, one speed to read.
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <cmath>

#include "engine/io/file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/resources.h"
#include "widgets/speed/speed_panel.h"
#include "widgets/speed/speed_views.h"

namespace lathelier::speed_panel {

class SpeedPanelTest : public QObject, PanelFixture<SpeedPanel> {
    Q_OBJECT

    QTemporaryDir folder_;

    /// The machine with which the papers' numbers come out.
    void giveSpindle()
    {
        receptance::SpindleReceptance spindle;
        spindle.source = receptance::SpindleSprings{14850, 198.3e6, 0.06};
        const std::string path = folder_.filePath("spindle.json").toStdString();
        io::writeFile(path, receptance::spindleText(spindle));
        session_->edit("Open", [&](project::Project& project) {
            project.panels["speed"].inputs[stability::spindleRole].path = path;
        });
        QTRY_VERIFY_WITH_TIMEOUT(panel_->hasResult() && !panel_->isBusy(), 60000);
    }

    void touch(const QString& keys)
    {
        for (const QChar sign : keys) {
            const QString name = sign.isDigit() ? "key" + QString(sign) : sign == '.' ? "keyPoint" : "keyEnter";
            QTest::mouseClick(panel_->findChild<QPushButton*>(name), Qt::LeftButton);
        }
    }
    QString reading() const { return panel_->findChild<QLabel*>("reading")->text(); }
    QString line() const { return panel_->findChild<QLabel*>("readingLine")->text(); }
    /// D 40, L 250, v_c 200: the rod of dynamics.md, 223.0 Hz.
    void typeTheRod()
    {
        giveSpindle();
        touch("40e250e200e");
        settle();
    }

private slots:
    void initTestCase() { useResources(); }
    void init()
    {
        QLocale::setDefault(QLocale::c());
        begin();
    }
    void cleanup() { end(); }

    void keysAskForWhatIsMissing()
    {
        QVERIFY(!panel_->hasResult());  // no spindle: the empty state
        giveSpindle();
        QVERIFY(panel_->error().has_value());
        QVERIFY(line().contains("Diameter"));
        touch("40e");
        QTRY_VERIFY(line().contains("Overhang"));
        touch("250e");
        QTRY_VERIFY(line().contains("Cutting speed"));
        QCOMPARE(reading(), QString("–"));
        QVERIFY(!panel_->reportDocument().has_value());
    }

    void typedValuesGiveTheSpeedOfThePaper()
    {
        typeTheRod();
        const stability::SpeedOutcome& outcome = *panel_->result();
        const stability::SpeedResult& speed = *outcome.published;
        QVERIFY(std::abs(speed.selected_rpm - 1000 * 200 / (M_PI * 40)) < 1e-6);
        // Equation 24 by hand.
        const double k = std::ceil(60 * speed.frequency_hz / speed.selected_rpm);
        const double low = 60 * speed.frequency_hz / k, high = 60 * speed.frequency_hz / (k - 1);
        QVERIFY(std::abs(speed.recommended_rpm - (low + 0.7 * (high - low))) < 1e-6);
        // Re G of one mode is least at f √(1 + 2ζ); the rod's is 223.0 Hz, its damping about 3 %.
        QVERIFY(std::abs(speed.frequency_hz - 223.0 * std::sqrt(1.06)) < 2);
        QCOMPARE(reading(), QString("%1 1/min").arg(std::round(speed.recommended_rpm)));
        QVERIFY(line().contains("1592"));
        const auto document = panel_->reportDocument();
        QVERIFY(document.has_value());
        QCOMPARE(panel_->result()->response.used.empty(), false);  // steel is assumed, and said
    }

    void anotherCuttingSpeedComputesNoResponseAnew()
    {
        typeTheRod();
        const auto before = panel_->result()->published->frequency_hz;
        auto* keys = panel_->views().keys();
        keys->setFocus();
        QTest::keyClick(keys, Qt::Key_Up);  // from the least cutting speed back to v_c
        QTest::keyClicks(keys, "290");
        QCOMPARE(keys->entry(), QString("290"));
        QTest::keyClick(keys, Qt::Key_Return);
        settle();
        QVERIFY(std::abs(panel_->result()->published->selected_rpm - 1000 * 290 / (M_PI * 40)) < 1e-6);
        QCOMPARE(panel_->result()->published->frequency_hz, before);
        session_->undoStack().undo();
        settle();
        QVERIFY(std::abs(panel_->result()->published->selected_rpm - 1000 * 200 / (M_PI * 40)) < 1e-6);
    }

    void theToolsRangeBinds()
    {
        typeTheRod();
        const double free = panel_->result()->published->recommended_rpm;
        const double most = std::floor(free * M_PI * 40 / 1000) - 1;  // just below the recommended speed
        touch(QString("100e%1e").arg(most));
        settle();
        QVERIFY(panel_->result()->published->recommended_rpm < free);
        touch("e");  // D stays
        QCOMPARE(panel_->views().keys()->chosen(), std::size_t{1});
        QTest::keyClick(panel_->views().keys(), Qt::Key_Down);
        QTest::keyClick(panel_->views().keys(), Qt::Key_Down);
        QTest::keyClick(panel_->views().keys(), Qt::Key_Delete);
        QTest::keyClick(panel_->views().keys(), Qt::Key_Return);  // no least speed any more
        settle();
        const std::vector<Interval>& range = panel_->result()->question.speed.range_m_min;
        QCOMPARE(range.size(), std::size_t{1});
        QVERIFY(range.front().from < 1 && range.front().to == most);
    }

    void withADepthTheSpeedIsStableThere()
    {
        typeTheRod();
        set("depth_mm", 0.05);
        QTRY_VERIFY(line().contains("Cutting coefficient"));
        set("cutting_coefficient_N_mm2", 2000.0);
        QTRY_VERIFY(panel_->result()->safe.has_value());
        const stability::SpeedOutcome& outcome = *panel_->result();
        QVERIFY(outcome.safe && outcome.safe->best.is_stable && *outcome.safe->best.limit > 0.05);
        QCOMPARE(reading(), QString("%1 1/min").arg(std::round(outcome.safe->best.speed_rpm)));
        set("depth_mm", 200.0);  // deeper than any lobe
        QTRY_COMPARE(panel_->result()->safe->question.depth, 200.0);
        QVERIFY(!panel_->result()->recommendedRpm());
        QVERIFY(line().contains("No speed"));
    }

    void noStableSpeedIsSaidAndKeysStay()
    {
        giveSpindle();
        touch("40e250e3000e");  // above the last lobe
        QTRY_VERIFY(panel_->result() && panel_->result()->problem && panel_->result()->response.frf);
        QTRY_VERIFY(line().contains("No stable speed"));  // of the last key
        QCOMPARE(reading(), QString("–"));
        QVERIFY(panel_->result()->near != nullptr);  // where it was looked for
        QTest::keyClick(panel_->views().keys(), Qt::Key_Up);
        touch("200e");
        settle();
        QVERIFY(panel_->result()->published.has_value());
    }

    void aNumberOutOfRangeIsNotTaken()
    {
        typeTheRod();
        const int steps = session_->undoStack().count();
        QTest::keyClick(panel_->views().keys(), Qt::Key_Up);
        QTest::keyClicks(panel_->views().keys(), "0");
        QTest::keyClick(panel_->views().keys(), Qt::Key_Return);
        QVERIFY(line().contains("0.001"));
        QCOMPARE(session_->undoStack().count(), steps);
        QTest::keyClick(panel_->views().keys(), Qt::Key_Delete);
        QVERIFY(line().contains("1592"));
    }

    void theLocalesDecimalMarkIsTyped()
    {
        QLocale::setDefault(QLocale(QLocale::Polish));
        typeTheRod();
        auto* keys = panel_->views().keys();
        QTest::keyClick(keys, Qt::Key_Up);
        QTest::keyClicks(keys, "189.5");
        QCOMPARE(keys->entry(), QString("189,5"));
        QTest::keyClick(keys, Qt::Key_Return);
        settle();
        QCOMPARE(*panel_->result()->question.speed.cutting_speed_m_min, 189.5);
        QLocale::setDefault(QLocale::c());
    }

    void withoutASpindleNothingCanBeLinked()
    {
        QVERIFY(!panel_->findChild<QPushButton*>("linkSwitch")->isEnabled());
        QVERIFY(panel_->views().linkBar()->controlLink().status() == ControlLink::Status::Off);
    }

    void aSimulatedControlAsksAndTheScreenFollows()
    {
        typeTheRod();
        LinkBar* const bar = panel_->views().linkBar();
        QTest::mouseClick(panel_->findChild<QPushButton*>("linkSimulator"), Qt::LeftButton);
        ControlWindow* const control = bar->controlWindow();
        QVERIFY(control != nullptr);
        auto* const linkSwitch = panel_->findChild<QPushButton*>("linkSwitch");
        QVERIFY(!linkSwitch->isChecked());
        linkSwitch->click();
        QTRY_VERIFY(bar->controlLink().status() == ControlLink::Status::Linked);
        control->findChild<QDoubleSpinBox*>("diameter_mm")->setValue(40);
        control->findChild<QDoubleSpinBox*>("length_mm")->setValue(250);
        control->findChild<QDoubleSpinBox*>("cutting_speed_m_min")->setValue(250);
        const int steps = session_->undoStack().count();
        control->findChild<QPushButton*>("controlAsk")->click();
        QTRY_VERIFY(control->control().correctedRpm().has_value());
        QTRY_COMPARE(panel_->result()->question.speed.cutting_speed_m_min.value_or(0), 250.0);
        settle();
        // What the control was told is what the screen says.
        QCOMPARE(*control->control().correctedRpm(), std::round(*panel_->result()->recommendedRpm()));
        QTRY_VERIFY(control->findChild<QLabel*>("controlCorrected")
                        ->text()
                        .contains(QString::number(*control->control().correctedRpm())));
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QVERIFY(panel_->findChild<QLabel*>("linkLine")->text().contains("written"));
    }

    void aMachineThatRunsIsToldSoOnBothSides()
    {
        typeTheRod();
        LinkBar* const bar = panel_->views().linkBar();
        panel_->findChild<QPushButton*>("linkSimulator")->click();
        panel_->findChild<QPushButton*>("linkSwitch")->click();
        ControlWindow* const control = bar->controlWindow();
        control->findChild<QCheckBox*>("controlRunning")->setChecked(true);
        control->findChild<QPushButton*>("controlAsk")->click();
        QTRY_VERIFY(panel_->findChild<QLabel*>("linkLine")->text().contains("the machine runs"));
        QTRY_VERIFY(control->findChild<QLabel*>("controlState")->text().contains("12"));
        QCOMPARE(control->findChild<QLabel*>("controlCorrected")->text(), QString("–"));
        QCOMPARE(*panel_->result()->question.speed.cutting_speed_m_min, 200.0);  // nothing was taken over
    }

    void aControlThatIsClosedIsLostAndTheSwitchEndsTheLink()
    {
        typeTheRod();
        LinkBar* const bar = panel_->views().linkBar();
        panel_->findChild<QPushButton*>("linkSimulator")->click();
        auto* const linkSwitch = panel_->findChild<QPushButton*>("linkSwitch");
        linkSwitch->click();
        QTRY_VERIFY(bar->controlLink().status() == ControlLink::Status::Linked);
        bar->controlWindow()->close();
        QTRY_VERIFY(bar->controlLink().status() == ControlLink::Status::Lost);
        QVERIFY(linkSwitch->isChecked());
        linkSwitch->click();
        QVERIFY(bar->controlLink().status() == ControlLink::Status::Off);
        QVERIFY(panel_->findChild<QLabel*>("linkLine")->text().contains("nothing is written"));
    }
};

}  // namespace lathelier::speed_panel

QTEST_MAIN(lathelier::speed_panel::SpeedPanelTest)
#include "speed_panel_test.moc"
