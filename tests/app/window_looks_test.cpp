// The whole window beside what it looked like when someone last approved it, at both sizes, light, dark and Polish:
// tests/data/baselines/window_*.png, means over blocks. LATHELIER_WRITE_BASELINES=1 writes them anew; look at the
// window before they are committed.
#include <QDir>
#include <QTest>
#include <array>
#include <fstream>

#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "engine/sample/sample.h"
#include "tests/app/window_fixture.h"
#include "tests/widgets/core/picture_difference.h"
#include "widgets/core/shell/question_bar.h"

namespace lathelier {
namespace {

constexpr double largestMean = 5;  // of all blocks, in levels of 255
constexpr int patience_ms = 180000;

}  // namespace

class WindowLooksTest : public QObject, private WindowFixture {
    Q_OBJECT

    QString scan_;

    bool isSettled() const
    {
        for (const char* question : {"scan", "drawing", "machine", "speed", "program", "deflection"})
            if (window_->questionBar().box(question)->answer().state != QuestionAnswer::State::Answered) return false;
        return dock("turning")->panel().isCurrent();
    }
    QImage picture(const QSize& size)
    {
        window_->resize(size);
        QTest::qWait(300);
        return shrunk(window_->grab().toImage());
    }

private slots:
    void initTestCase()
    {
        prepareSettings();
        new Theme(*qApp);
        QFont font("DejaVu Sans");
        font.setPointSizeF(10);
        QApplication::setFont(font);
        sample::ShaftModel shaft;
        for (const auto& [from, to, d] : {std::array{0.0, 30.0, 24.0}, std::array{30.0, 70.0, 36.0}})
            shaft.push_back({.z_start_mm = from, .z_end_mm = to, .radius_start_mm = d / 2, .radius_end_mm = d / 2});
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.2;
        scanner.angle_step_deg = 1.8;
        scanner.sigma_mm = 0.01;
        scan_ = folder_.filePath("part.xyz");
        std::ofstream file(scan_.toStdString());
        file.precision(9);
        for (const auto& point : sample::scanShaft(shaft, scanner).points_mm)
            file << point.x() << ' ' << point.y() << ' ' << point.z() << '\n';
    }
    void init()
    {
        QSettings().clear();
        languages_.use("en");
        session_ = std::make_unique<Session>();
        window_ = std::make_unique<MainWindow>(*session_, languages_, panelTable());
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanup()
    {
        languages_.use("en");
        end();
    }

    void looksAsApproved_data()
    {
        QTest::addColumn<QString>("theme");
        QTest::addColumn<QString>("language");
        QTest::newRow("light") << "light"
                               << "en";
        QTest::newRow("dark") << "dark"
                              << "en";
        QTest::newRow("polish") << "light"
                                << "pl";
    }
    void looksAsApproved()
    {
        QFETCH(QString, theme);
        QFETCH(QString, language);
        Settings settings;
        settings.theme = theme;
        settings.language = language;
        window_->applySettings(settings);
        window_->openPaths({scan_});
        QTRY_VERIFY(!window_->isOpening());
        window_->enterQuestion("program");
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience_ms);
        for (const QSize& size : {QSize(1280, 800), QSize(1920, 1080)}) {
            const QString name = QString("window_%1_%2").arg(QTest::currentDataTag()).arg(size.width());
            const QString path = QStringLiteral(LATHELIER_SOURCE_DIR "/tests/data/baselines/") + name + ".png";
            const QImage seen = picture(size);
            if (qEnvironmentVariableIsSet("LATHELIER_WRITE_BASELINES")) {
                QVERIFY(seen.save(path));
                window_->grab().save(QDir::tempPath() + "/lathelier_" + name + ".png");
            }
            const QImage approved(path);
            QVERIFY2(!approved.isNull(), qPrintable(path));
            QCOMPARE(seen.size(), approved.size());
            const PictureDifference found = differenceOfShrunk(seen, approved);
            if (found.mean > largestMean) window_->grab().save(QDir::tempPath() + "/lathelier_" + name + ".png");
            QVERIFY2(found.mean <= largestMean, qPrintable(QString("%1: mean %2").arg(name).arg(found.mean)));
            // The tolerance separates it from another question.
            window_->enterQuestion("speed");
            QTRY_VERIFY_WITH_TIMEOUT(dock("lobes")->panel().isCurrent(), patience_ms);
            const PictureDifference other = differenceOfShrunk(picture(size), approved);
            QVERIFY2(other.mean > largestMean, qPrintable(QString("%1 hides another: %2").arg(name).arg(other.mean)));
            window_->enterQuestion("program");
            QTest::qWait(300);
        }
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::WindowLooksTest)
#include "window_looks_test.moc"
