// The cylindricity panel, driven as a user would: a file is dropped, a tolerance given, a place picked, numbers
// written.
#include <QFile>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "engine/core/profile_item.h"
#include "engine/form/roundness/roundness.h"
#include "engine/io/io_codes.h"
#include "engine/sample/cylinder_sample.h"
#include "tests/widgets/core/drop_files.h"
#include "widgets/core/resources.h"
#include "widgets/core/session.h"
#include "widgets/cylindricity/cylindricity_panel.h"
#include "widgets/cylindricity/cylindricity_views.h"

namespace lathelier {

class CylindricityPanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        const SampleContent content = sample::cylinderSample().make(1, {});
        points_ = folder_.filePath("sections.ply");
        QFile file(points_);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content.texts.front().data(), static_cast<qint64>(content.texts.front().size()));
    }
    void init()
    {
        session_ = std::make_unique<Session>();
        panel_ = std::make_unique<cylindricity_panel::CylindricityPanel>(*session_);
        panel_->resize(1280, 760);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
        drop(panel_.get(), {points_});
        settle();
    }
    void cleanup()
    {
        panel_.reset();
        session_.reset();
    }

    void theSampleIsAnsweredWithItsTruth()
    {
        const form::CylindricityResult& result = *panel_->result()->result;
        // Barrel 4 µm, bow 6 µm, lobes ±1.5 µm, noise 0.2 µm: each narrows the zone against their sum.
        QVERIFY(result.MZCY.CYLt_um > 8 && result.MZCY.CYLt_um < 12);
        QCOMPARE(result.sections, std::size_t{25});
        QVERIFY(std::abs(result.axis_straightness_um - 6) < 0.7);
        QVERIFY(!result.verdict);
        QVERIFY(contains(panel_->result()->notes, notes::syntheticData));
        const form::CylinderSurface& surface = *panel_->result()->surface;
        QCOMPARE(surface.z_count, 25);
        const auto centre = [&](std::size_t row) {
            return Eigen::Vector2d(surface.centre_x_um[row], surface.centre_y_um[row]);
        };
        QVERIFY(std::abs((centre(12) - (centre(0) + centre(24)) / 2).norm() - 6) < 0.5);  // the bow
    }

    void aToleranceIsJudgedWithoutFittingAgain()
    {
        const auto before = panel_->result();
        setTolerance(15);
        QVERIFY(panel_->result()->result->verdict == Verdict::Pass);
        QVERIFY(panel_->result()->surface == before->surface);
        setTolerance(5);
        QVERIFY(panel_->result()->result->verdict == Verdict::Fail);
        QVERIFY(panel_->result()->surface == before->surface);
        session_->undoStack().undo();
        settle();
        QVERIFY(panel_->result()->result->verdict == Verdict::Pass);
    }

    void aPlaceIsMarkedInAllViews()
    {
        auto* map = panel_->findChild<plot::MapView*>("map");
        emit map->clicked(60, 90);
        QVERIFY(panel_->views().place() == QPointF(60, 90));
        QVERIFY(map->marker() == QPointF(60, 90));
        QVERIFY(panel_->findChild<plot::ChartView*>("radius")->marker() == 60);
        QVERIFY(panel_->findChild<plot::ChartView*>("axis")->marker() == 60);
        const auto marker = panel_->findChild<scene::SceneView*>("scene")->marker();
        QVERIFY(marker);
        const Eigen::Vector2d back = placeAbout(*panel_->result()->surface, *marker);
        QVERIFY(std::abs(back.x() - 60) < 1e-6 && std::abs(back.y() - 90) < 1e-6);
    }

    void aSectionIsOfferedToTheRoundnessPanel()
    {
        auto* button = panel_->findChild<QToolButton*>("roundnessOfSection");
        QVERIFY(!button->isEnabled());
        panel_->views().markPlace(61, 0);
        std::optional<Profile> offered;
        bool synthetic = false;
        connect(panel_.get(), &PanelBase::itemOffered, this,
                [&](const std::string&, const project::Item& item, bool made) {
                    QCOMPARE(item.kind, std::string(profileItem));
                    QCOMPARE(item.origin.panel, std::string("cylindricity"));
                    offered = profileOf(item.values);
                    synthetic = made;
                });
        button->click();
        QVERIFY(offered && synthetic);
        QCOMPARE(offered->points_mm.size(), std::size_t{180});  // of the section at 60 mm, and of no other
        const form::RoundnessResult roundness = form::roundness(*offered);
        QVERIFY(std::abs(roundness.circles.MZCI.RONt_um - 3) < 1);  // three lobes of 1.5 µm, and some noise
    }

    void theReportHasThePicturesOfTheSurface()
    {
        const auto document = panel_->reportDocument();
        QVERIFY(document);
        int charts = 0;
        for (const report::Section& section : document->sections)
            for (const report::Block& block : section.blocks)
                charts +=
                    std::holds_alternative<report::Plot>(block) || std::holds_alternative<report::ColourMap>(block);
        QCOMPARE(charts, 3);
        QVERIFY(document->synthetic);
    }

    void numbersAreWritten()
    {
        const QString path = folder_.filePath("radius.csv");
        const std::vector<PanelExport> exports = panel_->offeredExports();
        QVERIFY(exports.size() == 3);  // and all numbers as JSON, and the recipe
        exports.front().write(path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().count('\n'), 26);
    }

    void pointsThatAreNoCylinderAreRefused()
    {
        const QString path = folder_.filePath("line.xyz");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        for (int i = 0; i < 20; ++i) file.write(QByteArray::number(i) + " 0 0\n");
        file.close();
        drop(panel_.get(), {path});
        QTRY_VERIFY_WITH_TIMEOUT(panel_->error(), 20000);
        QCOMPARE(QString(panel_->error()->code().key), QString("points_degenerate"));
    }

private:
    void settle()
    {
        QTRY_VERIFY_WITH_TIMEOUT(panel_->isCurrent() || panel_->error(), 30000);
        QVERIFY2(!panel_->error(), panel_->error() ? panel_->error()->what() : "");
    }
    void setTolerance(double value_um)
    {
        session_->edit("tolerance", [&](project::Project& project) {
            lathelier::set(project.panels["cylindricity"].parameters, "tolerance_um", value_um);
        });
        settle();
    }

    QTemporaryDir folder_;
    QString points_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<cylindricity_panel::CylindricityPanel> panel_;
};

}  // namespace lathelier

QTEST_MAIN(lathelier::CylindricityPanelTest)
#include "cylindricity_panel_test.moc"
