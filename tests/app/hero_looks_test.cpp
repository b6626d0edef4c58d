// What each panel of the sample shows first, beside what it looked like when someone last approved it:
// tests/data/baselines/hero_*.png, means over blocks of the window's content at 1280 × 800. 3-D views are drawn, by
// software. LATHELIER_WRITE_BASELINES=1 writes them anew, and the pictures themselves into the folder of temporary
// files; look at those before the baselines are committed. Presenting: the value whole and nothing changed after it.
#include <QDir>
#include <QElapsedTimer>
#include <QFontMetrics>
#include <QLabel>
#include <QScopeGuard>
#include <QSplitter>
#include <QTest>
#include <nlohmann/json.hpp>

#include "app/gui/panels.h"
#include "app/gui/theme.h"

#include "engine/archive/archive.h"
#include "engine/core/json.h"
#include "engine/sample/sample_files.h"
#include "engine/series/series_question.h"
#include "tests/app/window_fixture.h"
#include "tests/widgets/core/picture_difference.h"
#include "widgets/core/panel/primary_views.h"

namespace lathelier {
namespace {

constexpr double largestMean = 2.5;  // of all blocks, in levels of 255
constexpr int patience_ms = 180000;
constexpr int settling_ms = 700;  // a 3-D view draws its full set at rest

}  // namespace

class HeroLooksTest : public QObject, private WindowFixture {
    Q_OBJECT

    void show(PanelDock& panel)
    {
        panel.showAction().trigger();
        // What one question answers another may begin anew with.
        do {
            QTRY_VERIFY_WITH_TIMEOUT(panel.madePanel() && !panel.madePanel()->isBusy(), patience_ms);
            QTest::qWait(settling_ms);
        } while (panel.madePanel()->isBusy());
    }
    /// The widgets that ask for more than the window has, for the message of a failure.
    static QString widest(const QWidget& window)
    {
        QStringList found;
        for (const QWidget* widget : window.findChildren<QWidget*>())
            if (widget->isVisible() && widget->minimumSizeHint().width() > 700)
                found << QString("%1 %2 %3")
                             .arg(widget->metaObject()->className(), widget->objectName())
                             .arg(widget->minimumSizeHint().width());
        return QString("%1×%2: ").arg(window.width()).arg(window.height()) + found.join(", ");
    }
    /// The sample has no archive: its rows would not be the same bytes again.
    void giveArchive()
    {
        constexpr int parts = 24;
        std::vector<archive::Evaluation> all;
        for (int number = 0; number < parts; ++number) {
            const double seat_mm = number == 15 ? 0.06 : 0.001 * number + 0.004 * (number % 3);
            archive::Evaluation one;
            one.task = "compare";
            one.recipe_sha256 = std::string(64, 'a');
            one.version = "0.2.0";
            one.inputs = {{"copy", {"/parts/part-" + std::to_string(number) + ".ply", 1, std::to_string(number)}}};
            one.verdict = number == 15 ? Verdict::Fail : Verdict::Pass;
            one.characteristics = {{"answer", "mm", seat_mm, 0.003, -0.05, 0.05, one.verdict}};
            one.result = lathelier::Json{{"map",
                                          {{"z_start_mm", 0},
                                           {"z_step_mm", 20},
                                           {"z_count", 3},
                                           {"angle_count", 2},
                                           {"mean_mm", {0.01, 0.0, seat_mm, seat_mm, -0.01, -0.02}}}}}
                             .dump();
            all.push_back(one);
        }
        const std::string path = folder_.filePath("shop.archive").toStdString();
        archive::Archive::open(path, archive::Access::Create).add(all, {"A. Nowak", "Scanner 3", "2026-06-01"});
        session_->edit("Open", [&](project::Project& project) {
            project.panels["series"].inputs[series::archiveRole].path = path;
        });
    }
    static QElapsedTimer started()
    {
        QElapsedTimer clock;
        clock.start();
        return clock;
    }
    static QImage picture(PanelDock& panel) { return panel.panel().grab().toImage(); }

private slots:
    void initTestCase()
    {
        prepareSettings();
        new Theme(*qApp);
        QFont font("DejaVu Sans");
        font.setPointSizeF(10);
        QApplication::setFont(font);
        sample::writeSample(folder_.path().toStdString());
        languages_.use("en");
        session_ = std::make_unique<Session>();
        session_->open(folder_.filePath(QString::fromStdString(sample::sampleFileNames().back())));
        giveArchive();
        window_ = std::make_unique<MainWindow>(*session_, languages_, panelTable());
        window_->resize(1280, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanupTestCase() { end(); }

    void looksAsApproved_data()
    {
        QTest::addColumn<QString>("panel");
        for (const PanelDock* dock : window_->docks())
            QTest::newRow(dock->facts().id.c_str()) << QString::fromStdString(dock->facts().id);
    }
    void looksAsApproved()
    {
        QFETCH(QString, panel);
        PanelDock& shown = *dock(panel.toStdString());
        window_->resize(1280, 800);
        show(shown);
        QCOMPARE(window_->size(), QSize(1280, 800));
        if (panel == "training") shown.panel().findChild<PrimaryViews*>()->setFocus();  // no caret that blinks
        const QString path = QStringLiteral(LATHELIER_SOURCE_DIR "/tests/data/baselines/hero_") + panel + ".png";
        QImage whole = picture(shown), seen = shrunk(whole);
        const QString written = QDir::tempPath() + "/lathelier_hero_" + panel + ".png";
        if (qEnvironmentVariableIsSet("LATHELIER_WRITE_BASELINES")) {
            QVERIFY(seen.save(path));
            whole.save(written);
        }
        const QImage approved(path);
        QVERIFY2(!approved.isNull(), qPrintable(path));
        QCOMPARE(seen.size(), approved.size());
        PictureDifference found = differenceOfShrunk(seen, approved);
        // Views go on after the answer: maps become finer, rows are scrolled to.
        for (QElapsedTimer clock = started(); found.mean > largestMean && !clock.hasExpired(patience_ms / 3);) {
            QTest::qWait(settling_ms);
            whole = picture(shown);
            seen = shrunk(whole);
            found = differenceOfShrunk(seen, approved);
        }
        if (found.mean > largestMean) whole.save(written);
        QVERIFY2(found.mean <= largestMean, qPrintable(QString("mean %1").arg(found.mean)));
        // The tolerance separates it from another view.
        auto* views = shown.findChild<PrimaryViews*>();
        if (!views || views->keys().size() < 2 || !shown.panel().isCurrent()) return;
        const QString first = views->primary();
        views->setPrimary(views->keys()[1] == first ? views->keys()[0] : views->keys()[1]);
        QTest::qWait(settling_ms);
        const PictureDifference other = differenceOfShrunk(shrunk(picture(shown)), approved);
        views->setPrimary(first);
        QVERIFY2(other.mean > largestMean, qPrintable(QString("hides another view: %1").arg(other.mean)));
    }

    void presentsTheValueWholeAndGoesBack_data() { looksAsApproved_data(); }
    void presentsTheValueWholeAndGoesBack()
    {
        QFETCH(QString, panel);
        PanelDock& shown = *dock(panel.toStdString());
        for (const QSize& size : {QSize(1280, 800), QSize(1024, 768)}) {
            // Full screen already, so that it is not made as large as the screen of the test.
            window_->setWindowState(Qt::WindowFullScreen);
            window_->resize(size);
            show(shown);
            QTRY_COMPARE(window_->size(), size);
            const QSize before = window_->size();
            const auto sizes = [&] {
                QStringList found;
                for (const QSplitter* splitter : shown.findChildren<QSplitter*>())
                    for (int i = 0; i < splitter->count() && splitter->isVisible(); ++i)
                        found << QString("%1 %2 %3×%4")
                                     .arg(splitter->objectName(), splitter->widget(i)->metaObject()->className())
                                     .arg(splitter->widget(i)->width())
                                     .arg(splitter->widget(i)->height());
                return found;
            };
            const QStringList parts = sizes();
            auto* views = shown.findChild<PrimaryViews*>();
            const QString first = views ? views->primary() : QString();
            window_->setPresenting(true);
            const auto back = qScopeGuard([this] { window_->setPresenting(false); });
            QTest::qWait(300);
            QVERIFY2(window_->size() == size, qPrintable(widest(*window_)));
            if (const auto* value = shown.findChild<QLabel*>("headline"); value && value->isVisible())
                QVERIFY2(QFontMetrics(value->font()).horizontalAdvance(value->text()) <= value->width(),
                         qPrintable(value->text()));
            if (views && views->keys().size() > 1 && shown.panel().isCurrent()) {
                QTest::keyClick(window_->focusWidget(), Qt::Key_Right);
                QVERIFY(views->primary() != first);
                QTest::keyClick(window_->focusWidget(), Qt::Key_Left);
                QCOMPARE(views->primary(), first);
            }
            if (qEnvironmentVariableIsSet("LATHELIER_WRITE_BASELINES"))
                window_->grab().save(QDir::tempPath() +
                                     QString("/lathelier_presenter_%1_%2.png").arg(panel).arg(size.width()));
            window_->setPresenting(false);
            QTRY_COMPARE(window_->size(), before);
            QTRY_COMPARE(sizes(), parts);
        }
        window_->setWindowState(Qt::WindowNoState);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::HeroLooksTest)
#include "hero_looks_test.moc"
