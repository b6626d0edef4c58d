// A scan dropped on an empty window walks by itself to drawing, speed and program; what was assumed is said, and
// replacing it changes what rests on it.
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QUndoStack>
#include <array>
#include <fstream>

#include "app/gui/panels.h"
#include "app/gui/shop_choice.h"
#include "engine/sample/sample.h"
#include "tests/app/window_fixture.h"
#include "tests/widgets/core/drop_files.h"
#include "widgets/chain/chain_run_row.h"
#include "widgets/core/shell/question_bar.h"
#include "widgets/core/shell/question_box.h"

namespace lathelier {

class PartWindowTest : public QObject, private WindowFixture {
    Q_OBJECT

    static constexpr int patience_ms = 120000;

    QString scanFile(const char* name, double diameter_mm) const
    {
        sample::ShaftModel shaft;
        for (const auto& [from, to, d] : {std::array{0.0, 20.0, diameter_mm}, std::array{20.0, 50.0, diameter_mm + 10}})
            shaft.push_back({.z_start_mm = from, .z_end_mm = to, .radius_start_mm = d / 2, .radius_end_mm = d / 2});
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.2;
        scanner.angle_step_deg = 1.8;
        scanner.sigma_mm = 0.01;
        const QString path = folder_.filePath(name);
        std::ofstream file(path.toStdString());
        file.precision(9);
        for (const auto& point : sample::scanShaft(shaft, scanner).points_mm)
            file << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
        return path;
    }
    const QuestionAnswer& box(const char* question) const
    {
        return window_->findChild<QuestionBox*>(QString("question_") + question)->answer();
    }
    bool isAnswered(const char* question) const { return box(question).state == QuestionAnswer::State::Answered; }

private slots:
    void initTestCase() { prepareSettings(); }
    void init()
    {
        QSettings().clear();
        languages_.use("en");
        session_ = std::make_unique<Session>();
        window_ = std::make_unique<MainWindow>(*session_, languages_, panelTable());
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanup() { end(); }

    void aScanWalksToTheProgramByItself()
    {
        drop(window_.get(), {scanFile("part.xyz", 30)});
        for (const char* question : {"scan", "drawing", "machine", "speed", "program", "deflection"})
            QTRY_VERIFY2_WITH_TIMEOUT(isAnswered(question), qPrintable(QString(question) + box(question).tooltip),
                                      patience_ms);
        QVERIFY(!box("scan").text.isEmpty());
        QVERIFY(box("program").assumed);  // bar, chuck and tools of the built-in shop
        QVERIFY(box("program").verdict.has_value());
        QCOMPARE(box("copy").state, QuestionAnswer::State::Empty);  // there is no copy yet
    }

    void panelsShowWhatTheBarSays()
    {
        drop(window_.get(), {scanFile("part.xyz", 30)});
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered("program"), patience_ms);
        window_->enterQuestion("program");
        PanelBase& panel = dock("turning")->panel();
        QTRY_VERIFY_WITH_TIMEOUT(panel.isCurrent(), patience_ms);
        QCOMPARE(panel.shownAnswer()->verdict, box("program").verdict);
        auto* input = panel.findChild<QWidget*>("input_job");
        QVERIFY(input);
        bool says = false;
        for (const QLabel* label : input->findChildren<QLabel*>())
            says = says || label->accessibleName().contains("shop");
        QVERIFY(says);
        // Nothing was put into the project but the scan.
        QCOMPARE(session_->project().panels.size(), std::size_t{1});
    }

    void replacingAnAssumptionRecomputes()
    {
        drop(window_.get(), {scanFile("part.xyz", 30)});
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered("machine"), patience_ms);
        const QString before = box("machine").text;
        shop::StatedShop stiff;
        stiff.choice.chuck = "stiff";
        keepShop(*session_, stiff);
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered("machine") && box("machine").text != before, patience_ms);
        session_->undoStack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered("machine") && box("machine").text == before, patience_ms);
    }

    /// From an empty window to the proof: two scans, two clicks, no file of ours.
    void twoScansGoToTheProof()
    {
        drop(window_.get(), {scanFile("part.xyz", 30)});
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered("program"), patience_ms);
        window_->enterQuestion("copy");
        drop(&dock("compare")->panel(), {scanFile("copy.xyz", 30.02)});
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered("copy"), patience_ms);
        const project::PanelState& compare = session_->panel("compare");
        QCOMPARE(compare.inputs.size(), std::size_t{1});  // the original is the drawing
        QCOMPARE(compare.inputs.begin()->first, std::string("copy"));
        window_->enterQuestion("proof");
        auto* run = window_->findChild<QPushButton*>("runChainWanted");
        const auto* row = window_->findChild<chain_panel::ChainRunRow*>();
        QTRY_VERIFY_WITH_TIMEOUT(run->isEnabled() && row->looked() && !row->isLooking(), patience_ms);
        QTest::mouseClick(run, Qt::LeftButton);
        auto* dialog = window_->findChild<QDialog*>("runChain");
        QVERIFY(dialog && dialog->isVisible());
        dialog->findChild<QLineEdit*>("chainFolder")->setText(folder_.filePath("chain"));
        QTest::mouseClick(dialog->findChild<QPushButton*>("runChainNow"), Qt::LeftButton);
        QTRY_VERIFY2_WITH_TIMEOUT(isAnswered("proof"), qPrintable(window_->messages().plainText()), patience_ms);
        QVERIFY(box("proof").verdict.has_value());
        QVERIFY(QFile::exists(folder_.filePath("chain/job.json")));
        QVERIFY(QFile::exists(folder_.filePath("chain/report.html")));
    }

    void anErrorStopsTheWalkWithItsSentence()
    {
        std::ofstream(folder_.filePath("flat.xyz").toStdString()) << "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
        drop(window_.get(), {folder_.filePath("flat.xyz")});
        QTRY_COMPARE_WITH_TIMEOUT(box("drawing").state, QuestionAnswer::State::Failed, patience_ms);
        QVERIFY2(box("drawing").tooltip.startsWith("Recogni"), qPrintable(box("drawing").tooltip));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::PartWindowTest)
#include "part_window_test.moc"
