// The panel "FRF", used as a technologist does: a measured response, its modes, a peak dragged, handed to the lobes.
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <nlohmann/json.hpp>

#include "engine/core/frf_item.h"
#include "engine/core/random.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/io/json/json_fields.h"
#include "engine/receptance/modal/modal_plots.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/task/shaft_task.h"
#include "engine/shaft/shaft_item.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/resources.h"
#include "widgets/frf/frf_panel.h"
#include "widgets/frf/frf_views.h"

namespace lathelier::frf_panel {
namespace {

constexpr double firstHz = 223, secondHz = 600;

io::MeasuredFrf measuredResponse(bool with_coherence)
{
    receptance::ModalModel truth{{{firstHz, .03, 1e4}, {secondHz, .02, 4e4}}, {}, {}};
    std::vector<double> lines;
    for (double f = 40; f <= 1000; f += 1) lines.push_back(f);
    io::MeasuredFrf measured;
    measured.frf = receptance::synthesised(truth, lines);
    for (std::size_t i = 0; i < lines.size(); ++i)
        measured.frf.value[i] *= std::complex<double>(1 + .005 * randomNormal(7, 0, i), .005 * randomNormal(7, 1, i));
    if (with_coherence) measured.frf.coherence.assign(lines.size(), 0.998);
    return measured;
}

}  // namespace

class FrfPanelTest : public QObject, PanelFixture<FrfPanel> {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string pathOf(const char* name) const { return folder_.filePath(name).toStdString(); }
    /// Sets a parameter and waits for the answer.
    void ask(const std::string& key, const Value& value)
    {
        set(key, value);
        settle();
    }
    void read(const std::string& key, const Value& value)
    {
        session_->edit("Read", [&](project::Project& project) {
            lathelier::set(project.panels["frf"].inputs.at(receptance::responseRole).import, key, value);
        });
        settle();
    }
    void take(const char* role, const std::string& path)
    {
        session_->edit("Open", [&](project::Project& project) { project.panels["frf"].inputs[role].path = path; });
    }
    void openResponse(bool with_coherence = true)
    {
        const io::MeasuredFrf response = measuredResponse(with_coherence);
        io::writeFrfCsv(pathOf("response.csv"), response.frf);
        take(receptance::responseRole, pathOf("response.csv"));
        settle();
    }
    const receptance::ResponseStudy& study() const { return panel_->result()->study; }
    QToolButton* button(const char* name) const { return panel_->findChild<QToolButton*>(name); }

private slots:
    void initTestCase() { useResources(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void modesOfAFileAreFound()
    {
        openResponse();
        QCOMPARE(study().model.modes.size(), std::size_t{2});
        QVERIFY(std::abs(study().model.modes[0].frequency_hz / firstHz - 1) < 1e-3);
        QVERIFY(std::abs(study().model.modes[0].stiffness_N_mm / 1e4 - 1) < .01);
        QVERIFY(panel_->findChild<QLabel*>("verdict")->text().contains("fitted"));
        const report::Plot& chart = panel_->views().magnitude()->data();
        QCOMPARE(chart.handles.size(), std::size_t{2});
        QCOMPARE(chart.curves.size(), std::size_t{2});
        QVERIFY(chart.y.scale == report::Axis::Scale::Logarithmic);
        QVERIFY(panel_->views().nyquist()->data().equal_scales);
        QCOMPARE(panel_->views().modes()->rowCount(), 2);
        QVERIFY(panel_->views().primaryViews()->keys().contains("coherence"));
        QVERIFY(panel_->views().primaryViews()->keys().contains("stability"));
        QVERIFY(!panel_->views().primaryViews()->keys().contains("shapes"));
        const auto document = panel_->reportDocument();
        QVERIFY(document.has_value());
        QCOMPARE(document->inputs.size(), std::size_t{1});
    }

    void withoutCoherenceThereIsNoSuchView()
    {
        openResponse(false);
        QVERIFY(!panel_->views().primaryViews()->keys().contains("coherence"));
        QVERIFY(panel_->views().primaryViews()->keys().contains("error"));
        ask("fit", false);
        QVERIFY(!panel_->views().primaryViews()->keys().contains("modes"));
        QVERIFY(panel_->views().magnitude()->data().handles.empty());
        QVERIFY(panel_->reportDocument().has_value());
    }

    void aPeakIsDraggedInOneStepWithoutFittingAgain()
    {
        openResponse();
        const auto fit = study().fit;
        const double before = study().error_rms_percent;
        const report::Handle handle = panel_->views().magnitude()->data().handles[0];
        const int steps = session_->undoStack().count();
        emit panel_->views().modeDragged(0, handle.x, handle.y / 1.5, false);
        settle();
        emit panel_->views().modeDragged(0, handle.x + 10, handle.y / 2, true);
        settle();
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QVERIFY(study().is_changed);
        QVERIFY(study().fit == fit);
        const receptance::ModalMode& mode = study().model.modes[0];
        QCOMPARE(mode.frequency_hz, handle.x + 10);
        QVERIFY(mode.damping_ratio > .055 && mode.damping_ratio < .065);
        QVERIFY(std::abs(std::abs(receptanceOf(study().model, mode.frequency_hz)) / (handle.y / 2) - 1) < 1e-9);
        QVERIFY(study().error_rms_percent > 5 * before);
        QVERIFY(button("backToTheFit")->isEnabled());
        button("backToTheFit")->click();
        settle();
        QVERIFY(!study().is_changed);
        QCOMPARE(study().error_rms_percent, before);
        session_->undoStack().undo();
        session_->undoStack().undo();
        settle();
        QVERIFY(!study().is_changed);
    }

    void theResponseOrItsModelGoesToTheLobes()
    {
        openResponse();
        std::vector<std::pair<std::string, project::Item>> offered;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string& name, const project::Item& item) { offered.emplace_back(name, item); });
        button("useThisResponse")->click();
        ask("handed_on", std::string("model"));
        button("useThisResponse")->click();
        QCOMPARE(offered.size(), std::size_t{2});
        QCOMPARE(offered[0].second.kind, std::string(frfItem));
        QVERIFY(frfOf(offered[0].second.values)->value == study().measured->value);
        QVERIFY(frfOf(offered[1].second.values)->value == study().synthesised.value);
        QVERIFY(offered[0].first != offered[1].first);
    }

    void oneOfSeveralResponsesIsChosen()
    {
        std::vector<io::MeasuredFrf> two{measuredResponse(false), measuredResponse(false)};
        for (auto& value : two[1].frf.value) value *= 3;
        two[0].response_node = 101;
        two[1].response_node = 102;
        for (io::MeasuredFrf& each : two) {
            each.reference_node = 101;
            each.response_direction = each.reference_direction = 1;
        }
        io::writeUff(pathOf("two.uff"), two);
        take(receptance::responseRole, pathOf("two.uff"));
        settle();
        const double first = std::abs(study().measured->value[5]);
        read("response", std::string("102/101"));
        QVERIFY(std::abs(std::abs(study().measured->value[5]) / first - 3) < .1);
        read("response", std::string("1"));
        QCOMPARE(std::abs(study().measured->value[5]), first);
        session_->edit("Set", [](project::Project& project) {
            lathelier::set(project.panels["frf"].inputs.at(receptance::responseRole).import, "response",
                           std::string("9/9"));
        });
        QTRY_VERIFY_WITH_TIMEOUT(panel_->error().has_value(), 20000);
        QVERIFY(std::string(panel_->error()->what()).find("102/101") != std::string::npos);
    }

    void theComputedResponseLiesUnderTheMeasuredOne()
    {
        openResponse();
        Shaft shaft;
        ShaftSegment segment;
        segment.length_mm = 250;
        segment.start_diameter_mm = segment.end_diameter_mm = 40;
        shaft.segments = {segment};
        io::writeFile(pathOf("shaft.json"), io::objectOf(infos<Shaft>(), toValues(shaft)).dump());
        io::writeFile(pathOf("spindle.json"),
                      receptance::spindleText({receptance::SpindleSprings{1.485e4, 1.983e8, .06}}));
        const std::string shaft_path = pathOf("shaft.json"), spindle_path = pathOf("spindle.json");
        panel_->openFiles({QString::fromStdString(shaft_path), QString::fromStdString(spindle_path)});
        QTRY_VERIFY(panel_->result()->study.computed != nullptr);
        settle();
        QCOMPARE(panel_->result()->sources.inputs.size(), std::size_t{3});
        const Frf& computed = *study().computed;
        QCOMPARE(computed.frequency_hz.front(), 40.0);
        const auto& curves = panel_->views().magnitude()->data().curves;
        QCOMPARE(curves.size(), std::size_t{3});
        QCOMPARE(std::get<Text>(curves[0].name), LT_TEXT("Engine", "computed"));
        QCOMPARE(std::get<Text>(curves[1].name), LT_TEXT("Engine", "measured"));
        // Without a measured response the modes are those of the computed one.
        session_->edit("Clear",
                       [](project::Project& project) { project.panels["frf"].inputs.erase(receptance::responseRole); });
        settle();
        QVERIFY(!study().measured);
        QVERIFY(!study().model.modes.empty());
        QVERIFY(std::abs(study().model.modes[0].frequency_hz - 223) < 2);
    }

    void aShaftFromTheProjectIsTaken()
    {
        Shaft shaft;
        shaft.segments.resize(1);
        shaft.segments[0].length_mm = 250;
        shaft.segments[0].start_diameter_mm = shaft.segments[0].end_diameter_mm = 40;
        session_->edit("Keep", [&](project::Project& project) {
            project.items["rod"] = {shaftItem, toValues(shaft), {}};
            project.panels["frf"].inputs[receptance::shaftRole].item = "rod";
        });
        settle();
        QVERIFY(study().computed && !study().measured);
        session_->edit("Drop", [&](project::Project& project) { project.items.clear(); });
        QTRY_VERIFY_WITH_TIMEOUT(panel_->error().has_value(), 20000);
    }

    void aFileThatIsNotWhatItsLabelSaysIsDoubted()
    {
        Frf frf = measuredResponse(false).frf;
        for (std::size_t i = 0; i < frf.value.size(); ++i) {
            const double w = 2 * 3.14159265358979 * frf.frequency_hz[i];
            frf.value[i] *= -w * w;  // an accelerance, written as a receptance
        }
        io::writeFrfCsv(pathOf("wrong.csv"), frf);
        take(receptance::responseRole, pathOf("wrong.csv"));
        settle();
        QVERIFY(contains(panel_->result()->notes, notes::frfSlopeContradictsLabel));
    }

    void aModeWithoutStiffnessIsRefused()
    {
        openResponse();
        receptance::ModesQuestion question;
        question.modes = {{223, .03, 0}};
        session_->edit("Set",
                       [&](project::Project& project) { project.panels["frf"].parameters = toValues(question); });
        QTRY_VERIFY_WITH_TIMEOUT(panel_->error().has_value(), 20000);
    }

    void exportsAreReadAgain()
    {
        openResponse();
        const auto exports = panel_->offeredExports();
        QVERIFY(exports.size() >= 3);
        exports[0].write(folder_.filePath("out.csv"));
        exports[1].write(folder_.filePath("out.uff"));
        exports[2].write(folder_.filePath("modes.csv"));
        for (const char* name : {"out.csv", "out.uff"}) {
            const io::FrfFile file = io::readFrf(pathOf(name));
            QCOMPARE(file.frfs.front().frf.value.size(), study().measured->value.size());
        }
        QFile modes(folder_.filePath("modes.csv"));
        QVERIFY(modes.open(QIODevice::ReadOnly));
        QCOMPARE(modes.readAll().count('\n'), 3);
    }
};

}  // namespace lathelier::frf_panel

QTEST_MAIN(lathelier::frf_panel::FrfPanelTest)
#include "frf_panel_test.moc"
