// The three panels under Roundness driven as a user would: drop, choose, click, type, cancel, undo, export.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "engine/sample/sample_record.h"
#include "engine/trajectory/trajectory_plots.h"
#include "tests/widgets/core/drop_files.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/resources.h"
#include "widgets/core/session.h"
#include "widgets/longitudinal/longitudinal_panel.h"
#include "widgets/longitudinal/longitudinal_views.h"
#include "widgets/longitudinal/section_table.h"
#include "widgets/roundness/roundness_panel.h"
#include "widgets/roundness/roundness_views.h"
#include "widgets/scene/scene_view.h"
#include "widgets/trajectory/channel_table.h"
#include "widgets/trajectory/trajectory_charts.h"
#include "widgets/trajectory/trajectory_panel.h"
#include "widgets/trajectory/trajectory_views.h"

using namespace lathelier;

namespace {

void write(const QString& path, const std::string& text)
{
    std::ofstream(path.toStdString()) << text;
}

/// Three lobes of 6 µm and two of `oval_um` on a radius of 20 mm, turned by `turn_deg`.
std::string profileText(double oval_um, double turn_deg = 0, double x_mm = 0.01)
{
    std::string text = "x_mm,y_mm\n";
    for (int i = 0; i < 720; ++i) {
        const double angle = i * std::numbers::pi / 360, body = angle - turn_deg * std::numbers::pi / 180;
        const double r = 20 + 0.006 * std::cos(3 * body) + oval_um / 1000 * std::cos(2 * body + 0.4);
        text += QString("%1,%2\n")
                    .arg(x_mm + r * std::cos(angle), 0, 'f', 7)
                    .arg(r * std::sin(angle), 0, 'f', 7)
                    .toStdString();
    }
    return text;
}

}  // namespace

class SpindlePanelsTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;
    QString record_, profile_, trace_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<roundness_panel::RoundnessPanel> roundness_;
    std::unique_ptr<trajectory_panel::TrajectoryPanel> trajectory_;
    std::unique_ptr<longitudinal_panel::LongitudinalPanel> longitudinal_;

    std::vector<PanelBase*> panels() const { return {roundness_.get(), trajectory_.get(), longitudinal_.get()}; }

    /// Index of the section that each of them shows.
    std::vector<std::size_t> shownSections() const
    {
        return {*roundness_->result()->section, *trajectory_->result()->section, *longitudinal_->result()->section};
    }

    void settle()
    {
        const auto all = panels();
        const auto are_busy = [&all] {
            return std::any_of(all.begin(), all.end(), [](const PanelBase* panel) { return panel->isBusy(); });
        };
        // A file that one panel has found changes the state of all.
        do {
            QTRY_VERIFY_WITH_TIMEOUT(!are_busy(), 60000);
            QCoreApplication::processEvents();
        } while (are_busy());
        for (const PanelBase* panel : all) QVERIFY2(!panel->error(), panel->error() ? panel->error()->what() : "");
    }
    void set(const char* key, const Value& value)
    {
        session_->edit(key, [&](project::Project& project) {
            lathelier::set(project.panels["roundness"].parameters, key, value);
        });
    }
    QString headline(const PanelBase& panel) const { return panel.findChild<AnswerStrip*>()->text(); }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        sample::SpindleModel model = sample::quietSpindle();
        model.sections = 6;
        model.revolutions = 10;
        record_ = folder_.filePath("record.csv");
        write(record_, sample::toCsv(sample::makeProbeRecord(model)));
        profile_ = folder_.filePath("profile.csv");
        write(profile_, profileText(1));
        trace_ = folder_.filePath("trace.csv");
        write(trace_, profileText(1.5, 40, -0.2));
    }
    void init()
    {
        session_ = std::make_unique<Session>();
        roundness_ = std::make_unique<roundness_panel::RoundnessPanel>(*session_);
        trajectory_ = std::make_unique<trajectory_panel::TrajectoryPanel>(*session_);
        longitudinal_ = std::make_unique<longitudinal_panel::LongitudinalPanel>(*session_);
        for (PanelBase* panel : panels()) {
            panel->resize(1200, 720);
            panel->show();
            QVERIFY(QTest::qWaitForWindowExposed(panel));
        }
        QCoreApplication::processEvents();
    }
    void cleanup()
    {
        longitudinal_.reset();
        trajectory_.reset();
        roundness_.reset();
        session_.reset();
    }

    void oneRecordIsAnsweredInAllPanelsByOneComputation()
    {
        drop(longitudinal_.get(), {record_});
        settle();
        const auto result = longitudinal_->result()->trajectory;
        QVERIFY(result != nullptr);
        QVERIFY(roundness_->result()->trajectory == result);
        QVERIFY(trajectory_->result()->trajectory == result);
        QCOMPARE(result->sections.size(), std::size_t{6});
        QVERIFY2(std::abs(result->longitudinal->taper_diameter_um - 16) < 0.1,
                 qPrintable(QString::number(result->longitudinal->taper_diameter_um)));
        QVERIFY(std::abs(result->longitudinal->barrel_um - 5) < 0.1);
        QVERIFY2(headline(*longitudinal_).contains("Taper +16"), qPrintable(headline(*longitudinal_)));
        QVERIFY2(headline(*roundness_).contains("RONt(MZCI)"), qPrintable(headline(*roundness_)));
        QVERIFY2(headline(*trajectory_).contains("Motion of the workpiece axis"), qPrintable(headline(*trajectory_)));
        QCOMPARE(longitudinal_->findChild<longitudinal_panel::SectionTable*>()->rowCount(), 6);
        QVERIFY(longitudinal_->views().stack().scan != nullptr);
        QCOMPARE(trajectory_->findChild<PrimaryViews*>()->primary(), QString("motion"));
    }

    void allFitTheSmallestWindow()
    {
        drop(longitudinal_.get(), {record_});
        settle();
        for (PanelBase* panel : panels())
            QVERIFY2(
                panel->minimumSizeHint().width() <= 1000,
                qPrintable(QString("%1: %2 px").arg(panel->facts().id.c_str()).arg(panel->minimumSizeHint().width())));
    }

    void theFormIsDrawnAboutThePartsOwnAxisAndPicked()
    {
        drop(longitudinal_.get(), {record_});
        settle();
        const trajectory::StackedSections& stack = longitudinal_->views().stack();
        QCOMPARE(stack.magnification, 1000.0);
        double middle_um = 0;  // nothing is left of where the part sat on the spindle
        for (std::size_t k = 0; k < stack.angles; ++k)
            middle_um += static_cast<double>((*stack.deviation_um)[k]) *
                         std::cos(2 * 3.14159265358979 * static_cast<double>(k) / static_cast<double>(stack.angles));
        QVERIFY(std::abs(middle_um) / static_cast<double>(stack.angles) < 1);
        longitudinal_->findChild<QDoubleSpinBox*>("magnification")->setValue(200);
        QCOMPARE(longitudinal_->views().stack().magnification, 200.0);
        const auto vertex = static_cast<std::uint32_t>(longitudinal_->views().stack().vertexAt(2, 90));
        emit longitudinal_->findChild<scene::SceneView*>("stack")->surfacePicked(
            0, {{vertex, vertex + 1, vertex + 2}, Eigen::Vector3d(1, 0, 0)});
        settle();
        QCOMPARE(*longitudinal_->result()->section, std::size_t{2});
    }

    void whatIsShownComesBackWithTheProject()
    {
        drop(longitudinal_.get(), {record_});
        settle();
        longitudinal_->findChild<QDoubleSpinBox*>("magnification")->setValue(300);
        longitudinal_->findChild<QCheckBox*>("formOnly")->setChecked(true);
        roundness_->views().markHarmonic(3);
        const QString path = QDir(folder_.path()).filePath("views.lathelier");
        session_->save(path);
        longitudinal_->findChild<QDoubleSpinBox*>("magnification")->setValue(50);
        roundness_->views().markHarmonic({});
        session_->open(path);
        settle();
        QTRY_COMPARE(longitudinal_->findChild<QDoubleSpinBox*>("magnification")->value(), 300.0);
        QVERIFY(longitudinal_->findChild<QCheckBox*>("formOnly")->isChecked());
        QCOMPARE(std::get<std::int64_t>(roundness_->views().view()[0].second), std::int64_t{3});
    }

    void worstSectionFirstAndOneChoiceForAll()
    {
        drop(roundness_.get(), {record_});
        settle();
        const std::size_t worst = *longitudinal_->result()->trajectory->worstSection();
        QCOMPARE(shownSections(), std::vector<std::size_t>(3, worst));
        const std::size_t other = worst == 2 ? 3 : 2;
        roundness_->chooseSection(static_cast<int>(other) + 1);
        settle();
        QCOMPARE(shownSections(), std::vector<std::size_t>(3, other));
        for (PanelBase* panel : panels())
            QCOMPARE(panel->findChild<QComboBox*>("section")->currentIndex(), static_cast<int>(other));
        const int steps = session_->undoStack().count();
        trajectory_->findChild<QToolButton*>("sectionAfter")->click();
        settle();
        QCOMPARE(*longitudinal_->result()->section, other + 1);
        QCOMPARE(session_->undoStack().count(), steps);  // a row of choices is one step
        session_->undoStack().undo();
        settle();
        QCOMPARE(*roundness_->result()->section, worst);
    }

    void toleranceJudgesAllSections()
    {
        drop(roundness_.get(), {record_});
        settle();
        const auto& table = *longitudinal_->findChild<longitudinal_panel::SectionTable*>();
        QCOMPARE(table.item(0, 3)->text(), QStringLiteral("–"));
        set("tolerance_um", 0.5);
        settle();
        QVERIFY(table.item(0, 3)->text().contains("✗"));
        QVERIFY(roundness_->findChild<QLabel*>("verdict")->text().contains("✗"));
        set("tolerance_um", 500.0);
        settle();
        QVERIFY(table.item(5, 3)->text().contains("✓"));
        session_->undoStack().undo();
        session_->undoStack().undo();
        settle();
        QCOMPARE(table.item(0, 3)->text(), QStringLiteral("–"));
    }

    void aProfileGoesBeforeTheRecord()
    {
        drop(roundness_.get(), {record_});
        settle();
        drop(roundness_.get(), {profile_});
        settle();
        QVERIFY(roundness_->result()->trajectory == nullptr);
        QVERIFY(std::abs(roundness_->result()->judged().circles.LSCI.centre_mm.x() - 0.01) < 1e-4);
        QVERIFY(longitudinal_->result()->trajectory != nullptr);  // the record is still there for the others
        session_->undoStack().undo();
        settle();
        QVERIFY(roundness_->result()->trajectory != nullptr);
        QVERIFY(roundness_->result()->chosenSection() != nullptr);
    }

    void anotherTraceIsLaidOver()
    {
        drop(roundness_.get(), {profile_, trace_});
        settle();
        const auto laid = roundness_->result()->superimposed;
        QVERIFY(laid != nullptr);
        // Half a µm of ovality more: found although the trace is turned by 40° and lies elsewhere.
        QVERIFY2(std::abs(laid->largest_difference_um - 0.5) < 0.05,
                 qPrintable(QString::number(laid->largest_difference_um)));
        QVERIFY(roundness_->findChild<QToolButton*>("showLaid")->isChecked());
        QVERIFY(roundness_->findChild<QLabel*>("difference")->text().contains("0.5"));
        const auto* polar = roundness_->findChild<plot::PolarView*>("polar");
        QCOMPARE(polar->polar()->plot.traces.size(), std::size_t{3});
        roundness_->findChild<QToolButton*>("showForm")->click();
        QVERIFY(!polar->polar()->plot.circles.empty());
    }

    void oneAngleIsMarkedEverywhere()
    {
        drop(roundness_.get(), {record_});
        settle();
        auto* polar = roundness_->findChild<plot::PolarView*>("polar");
        QTest::mouseClick(polar, Qt::LeftButton, {}, polar->pixelAt(120, 0).toPoint());
        QVERIFY(std::abs(*polar->marker() - 120) < 1);
        QVERIFY(std::abs(*trajectory_->findChild<plot::PolarView*>("motion")->marker() - 120) < 1);
        QVERIFY(trajectory_->findChild<plot::ChartView*>("coordinates")->marker().has_value());
        auto* stack = longitudinal_->findChild<scene::SceneView*>("stack");
        if (stack->canDraw()) {
            const Eigen::Vector3d place = *stack->marker();
            QVERIFY(std::abs(std::atan2(place.y(), place.x()) * 180 / std::numbers::pi - 120) < 1.5);
        }
        // A click beside the path of the axis marks the sample nearest to it.
        auto* axes = trajectory_->findChild<plot::ChartView*>("axes");
        const trajectory::TrajectorySection& section = *trajectory_->result()->chosenSection();
        const std::vector<double> angles = partAngles_deg(section);
        const std::size_t sample = 37;
        const auto& x = section.probes[static_cast<std::size_t>(trajectory::Probe::X3)].mean_um;
        const auto& y = section.probes[static_cast<std::size_t>(trajectory::Probe::Y3)].mean_um;
        emit axes->clicked(x[sample], y[sample]);
        QCOMPARE(*polar->marker(), angles[sample]);
        emit axes->clicked(x[90], y[90]);
        emit axes->clickTakenBack();
        QCOMPARE(*polar->marker(), angles[sample]);
        auto* play = trajectory_->findChild<QToolButton*>("play");
        const double before = *polar->marker();
        play->click();
        QTRY_VERIFY(std::abs(*polar->marker() - before) > 3);
        play->click();
    }

    void anUndulationPickedInTheSpectrumIsDrawn()
    {
        drop(roundness_.get(), {profile_});
        settle();
        const auto* polar = roundness_->findChild<plot::PolarView*>("polar");
        const std::size_t traces = polar->polar()->plot.traces.size();
        roundness_->views().markHarmonic(3);
        QCOMPARE(polar->polar()->plot.traces.size(), traces + 1);
        QVERIFY(std::abs(polar->polar()->plot.traces.back().deviation_um.front()) <= 6.01);
        QCOMPARE(*roundness_->findChild<plot::ChartView*>("spectrum")->marker(), 3.0);
        roundness_->views().markHarmonic({});
        QCOMPARE(polar->polar()->plot.traces.size(), traces);
    }

    void aWrongMarkerIsSaidAndMended()
    {
        drop(trajectory_.get(), {record_});
        settle();
        set("channels", std::string("marker=1,X3=0,Y3=2,Xp=3,Yp=4"));
        QTRY_VERIFY(!trajectory_->isBusy() && trajectory_->error());
        auto* primaryViews = trajectory_->findChild<PrimaryViews*>();
        QVERIFY(trajectory_->findChild<trajectory_panel::ChannelTable*>()->isVisible());  // where it can be mended
        QCOMPARE(primaryViews->primary(), QString("record"));
        QVERIFY(!primaryViews->keys().contains("motion"));
        auto* box =
            qobject_cast<QComboBox*>(trajectory_->findChild<trajectory_panel::ChannelTable*>()->cellWidget(0, 5));
        QVERIFY(box != nullptr);
        box->setCurrentIndex(box->findData("marker"));
        emit box->activated(box->currentIndex());
        settle();
        const std::string map =
            fromValues<trajectory::TrajectoryParameters>(session_->panel("roundness").parameters).channels;
        QVERIFY2(map.find("marker=0") != std::string::npos && map.find("X3=1") != std::string::npos, map.c_str());
        QVERIFY(trajectory_->result()->trajectory != nullptr);
        QCOMPARE(primaryViews->primary(), QString("motion"));
    }

    void aFileOfAnotherKindTakesNoPlace()
    {
        const QString path = folder_.filePath("words.csv");
        write(path, "these are,only words\nand no,numbers\n");
        drop(trajectory_.get(), {path});
        QTRY_VERIFY(trajectory_->findChild<QLabel*>("message")->text().contains("words.csv"));
        QVERIFY(!trajectory_->isBusy() && !trajectory_->hasResult());
        QVERIFY(session_->panel("roundness").inputs.empty());
        QVERIFY(trajectory_->findChild<QLabel*>("headline")->text().isEmpty());
    }

    void cancelStopsThemAll()
    {
        drop(longitudinal_.get(), {record_});
        settle();
        const auto before = longitudinal_->result();
        set("points", std::int64_t{15000});
        for (PanelBase* panel : panels()) QVERIFY(panel->isBusy());
        roundness_->cancel();
        for (PanelBase* panel : panels()) {
            QTRY_VERIFY_WITH_TIMEOUT(!panel->isBusy(), 2000);
            QVERIFY(!panel->isCurrent());
        }
        QVERIFY(longitudinal_->result() == before);
        session_->undoStack().undo();
        settle();
        QVERIFY(longitudinal_->isCurrent());
    }

    void resultsAreReportedAndExported()
    {
        drop(roundness_.get(), {record_});
        settle();
        for (PanelBase* panel : panels()) {
            const auto document = panel->reportDocument();
            QVERIFY(document && document->sections.size() >= 2);
            QCOMPARE(document->inputs.size(), std::size_t{1});
            QCOMPARE(document->inputs.front().sha256.size(), std::size_t{64});
            QCOMPARE(document->results.size(), std::size_t{1});
            for (const PanelExport& one : panel->offeredExports()) {
                const QString path = folder_.filePath(panel->facts().id.c_str() + QString("_out.") + one.suffix);
                one.write(path);
                QVERIFY2(QFileInfo(path).size() > 100, qPrintable(one.label));
            }
        }
        // The report says which section it judges.
        const report::Document judged = *roundness_->reportDocument();
        const auto* sentence = std::get_if<report::Paragraph>(&judged.sections.front().blocks.at(1));
        QVERIFY(sentence);
        QCOMPARE(*find(sentence->values, "section"),
                 Value(std::int64_t{roundness_->result()->chosenSection()->section}));
        session_->save(folder_.filePath("project.lathelier"));
        const project::ProjectFile saved = project::readProject(folder_.filePath("project.lathelier").toStdString());
        QCOMPARE(saved.project.panels.at("roundness").inputs.at("record").sha256.size(), std::size_t{64});
        QVERIFY(project::checkSources(saved.project).empty());
    }

    void theLanguageIsSwitchedAtRunTime()
    {
        drop(roundness_.get(), {record_});
        settle();
        Languages languages;
        languages.use("pl");
        settle();
        QCOMPARE(trajectory_->findChild<PrimaryViews*>()->title("signals"), QStringLiteral("Sygnały"));
        QVERIFY(longitudinal_->findChild<longitudinal_panel::SectionTable*>()->horizontalHeaderItem(0)->text() ==
                "przekrój");
        languages.use("en");
        settle();
        QCOMPARE(trajectory_->findChild<PrimaryViews*>()->title("signals"), QStringLiteral("Signals"));
        QLocale::setDefault(QLocale::c());
    }
};

int main(int argc, char** argv)
{
    QApplication app(argc, argv);
    SpindlePanelsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "spindle_panels_test.moc"
