// The real window with the sample: how much of it is not the part. From the top of the client area to the first view,
// the answer strip not counted; where titles stand; the palette over all panels.
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTabBar>

#include "app/gui/command_palette.h"
#include "app/gui/panels.h"
#include "app/gui/questions.h"
#include "app/gui/theme.h"
#include "engine/sample/sample_files.h"
#include "tests/app/window_fixture.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/core/panel/view_frame.h"
#include "widgets/core/task/progress_row.h"

namespace lathelier {

constexpr int most_px = 150;

class ChromeTest : public QObject, private WindowFixture {
    Q_OBJECT

    std::string project_;

    void open(const QString& language)
    {
        window_.reset();
        languages_.use(language);
        session_ = std::make_unique<Session>();
        session_->open(QString::fromStdString(project_));
        window_ = std::make_unique<MainWindow>(*session_, languages_, panelTable());
        window_->resize(1280, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void show(PanelDock& panel)
    {
        panel.showAction().trigger();
        QTRY_VERIFY_WITH_TIMEOUT(panel.madePanel() && !panel.madePanel()->isBusy(), 180000);
        QTest::qWait(50);
    }
    /// Of what a panel shows first: the highest frame of a view, its caption included; without a result the empty
    /// state.
    int topOfViews(const PanelDock& panel) const
    {
        int top = window_->height();
        const auto* empty = panel.findChild<EmptyState*>();
        if (empty && empty->isVisible()) return empty->mapTo(window_.get(), QPoint(0, 0)).y();
        for (const ViewFrame* frame : panel.findChildren<ViewFrame*>())
            if (frame->isVisible()) top = std::min(top, frame->view()->mapTo(window_.get(), QPoint(0, 0)).y());
        return top;
    }

private slots:
    void initTestCase()
    {
        prepareSettings();
        new Theme(*qApp);  // its style is part of what is measured
        sample::writeSample(folder_.path().toStdString());
        project_ = folder_.path().toStdString() + "/" + sample::sampleFileNames().back();
    }
    void cleanup() { end(); }

    void aPanelBeginsWithin150Pixels_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("question");
        for (const char* code : {"en", "pl"})
            for (const Question& question : questionsOf(panelTable()))
                QTest::addRow("%s %s", code, question.id.c_str()) << code << QString::fromStdString(question.id);
    }
    void aPanelBeginsWithin150Pixels()
    {
        QFETCH(QString, language);
        QFETCH(QString, question);
        open(language);
        QCOMPARE(window_->size(), QSize(1280, 800));
        for (PanelDock* panel : window_->docks()) {
            if (panel->facts().question.id != question.toStdString()) continue;
            show(*panel);
            const auto* answer = panel->findChild<AnswerStrip*>();
            QVERIFY(answer && answer->isVisible());
            const int top = topOfViews(*panel) - answer->height();
            QVERIFY2(top <= most_px, qPrintable(QString("%1 %2").arg(panel->windowTitle()).arg(top)));
        }
        QCOMPARE(window_->size(), QSize(1280, 800));  // no panel is too large for it
    }

    /// A tab where a question has several panels, nothing where it has one.
    void titlesStandOnce()
    {
        open("en");
        for (const char* id : {"recognise", "lobes", "compare"}) {
            show(*dock(id));
            QCOMPARE(dock(id)->titleBarWidget()->height(), 0);
            int tabs = 0;
            for (const QTabBar* bar : window_->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
                if (bar->isVisible()) tabs += bar->count();
            QCOMPARE(tabs, std::string(id) == "lobes" ? 3 : 0);
        }
    }

    /// Whatever had the focus: the arrow keys go through the views at once, and the value is whole.
    void presenterGoesThroughTheViewsAtOnce()
    {
        open("en");
        show(*dock("lobes"));
        auto* views = dock("lobes")->findChild<PrimaryViews*>();
        dock("lobes")->findChild<QLineEdit*>()->setFocus();
        window_->setPresenting(true);
        QTest::qWait(200);
        const auto* value = dock("lobes")->findChild<QLabel*>("headline");
        QVERIFY(value->fontMetrics().horizontalAdvance(value->text()) <= value->width());
        QVERIFY(!window_->questionBar().isVisible());
        const QString first = views->primary();
        QVERIFY2(window_->focusWidget() == views,
                 qPrintable(window_->focusWidget()->objectName() + window_->focusWidget()->metaObject()->className()));
        QTest::keyClick(window_->focusWidget(), Qt::Key_Right);
        QVERIFY(views->primary() != first);
        QTest::keyClick(window_->focusWidget(), Qt::Key_Left);
        QCOMPARE(views->primary(), first);
        window_->setPresenting(false);
    }

    void paletteReachesFieldsOfPanelsThatWereNotMade()
    {
        open("en");
        window_->enterQuestion("scan");
        QVERIFY(!dock("cylindricity")->madePanel());
        const auto list = [&](const QString& words) {
            window_->action("palette")->trigger();
            auto* palette = window_->findChild<CommandPalette*>("commandPalette");
            palette->findChild<QLineEdit*>()->setText(words);
            return palette;
        };
        for (const PanelDock* panel : window_->docks()) {
            CommandPalette* palette = list("panels " + panel->windowTitle());
            const QString end = QString::fromUtf8("› ") + panel->windowTitle();
            QVERIFY2(!palette->findChild<QListWidget*>()->findItems(end, Qt::MatchEndsWith).isEmpty(),
                     panel->facts().id.c_str());
            palette->reject();
            QTRY_VERIFY(!window_->findChild<CommandPalette*>("commandPalette"));
        }
        CommandPalette* palette = list("cylindricity input tolerance");
        QVERIFY(palette->findChild<QListWidget*>()->item(0)->text().contains("Cylindricity"));
        QTest::keyClick(palette->findChild<QLineEdit*>(), Qt::Key_Return);
        QTRY_COMPARE(window_->activeDock(), dock("cylindricity"));
        QTRY_VERIFY(window_->focusWidget() && window_->focusWidget()->objectName().contains("tolerance"));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::ChromeTest)
#include "chrome_test.moc"
