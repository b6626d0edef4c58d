// The questions of the window and their panels, driven as a user does: boxes, tabs, floating, closing and coming back;
// what speaks of them.
#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "app/gui/command_palette.h"
#include "app/gui/help_window.h"
#include "app/gui/main_window.h"
#include "app/gui/questions.h"
#include "tests/app/window_fixture.h"

namespace lathelier {

class QuestionWindowTest : public QObject, WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepareSettings(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void aBoxOpensItsQuestion()
    {
        QTest::mouseClick(window_->questionBar().box("roundness"), Qt::LeftButton);
        QVERIFY(dock("round")->isVisible());
        QVERIFY(!dock("one")->isVisible());
        QCOMPARE(session_->project().workspace, std::string("roundness"));
        QVERIFY(!session_->isModified());
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        QTest::keyClick(window_.get(), Qt::Key_1, Qt::ControlModifier);
        QVERIFY(!dock("round")->isVisible());
        QVERIFY(window_->questionBar().box("copy")->isChecked());
        QTest::keyClick(window_.get(), Qt::Key_2, Qt::ControlModifier);
        QVERIFY(dock("round")->isVisible());
        // With the keys of the bar: Tab reaches the open question, the arrows the others.
        window_->questionBar().box("roundness")->setFocus(Qt::TabFocusReason);
        QTest::keyClick(window_->focusWidget(), Qt::Key_Left);
        QTest::keyClick(window_->focusWidget(), Qt::Key_Return);
        QCOMPARE(window_->question(), std::string("copy"));
    }

    void projectsOfWorkspacesOpenAtAQuestion()
    {
        std::vector<Question> all;
        for (const char* id : {"scan", "drawing", "machine", "speed", "program", "deflection", "copy", "proof",
                               "roundness", "photographs", "training", "series"})
            all.push_back(questionOf(id));
        QCOMPARE(questionFor("inspection", all), std::string("copy"));
        QCOMPARE(questionFor("chatter", all), std::string("speed"));
        for (const char* same : {"roundness", "deflection", "training", "copy", "proof"})
            QCOMPARE(questionFor(same, all), std::string(same));
        QCOMPARE(questionFor("nonsense", all), std::string("scan"));
        QCOMPARE(questionFor("scan", {}), std::string());
    }

    void theBoxSaysTheAnswerOfItsPanels()
    {
        const QuestionBox& box = *window_->questionBar().box("copy");
        QTRY_VERIFY(box.answer().state == QuestionAnswer::State::Empty);
        openFiles({makeFile("a.txt")});
        QTRY_VERIFY(window_->activeDock()->panel().isCurrent());
        QVERIFY2(box.answerText().startsWith("20"), qPrintable(box.answerText()));
        const std::string id = window_->activeDock()->facts().id;
        const auto limit = [&](double mm) {
            session_->edit("Limit",
                           [&](project::Project& project) { set(project.panels[id].parameters, "tolerance_mm", mm); });
        };
        limit(5);
        QTRY_VERIFY2(box.answerText().startsWith(QString::fromUtf8("✗ 20")), qPrintable(box.answerText()));
        QVERIFY(box.toolTip().contains("Product"));
        window_->applySettings({"pl", {}, 150});
        QTRY_VERIFY(box.accessibleName().startsWith("Kopia"));
        window_->applySettings({"en", {}, 150});
        session_->edit("Away", [&](project::Project& project) { project.panels.clear(); });
        QTRY_VERIFY(box.answer().state == QuestionAnswer::State::Empty);
    }

    /// A title is written once: in the tab, or in the box where there is one panel.
    void aDockedPanelHasNoTitleBar()
    {
        QVERIFY(dock("one")->titleBarWidget());
        QCOMPARE(dock("one")->titleBarWidget()->height(), 0);
        QVERIFY(window_->tabifiedDockWidgets(dock("one")).contains(dock("two")));
        window_->action("floatPanel")->trigger();
        PanelDock* const floating = window_->activeDock();
        QVERIFY(floating->isFloating() && !floating->titleBarWidget());
        // It is seen to lie over the window.
        QVERIFY(floating->width() < window_->width() && floating->height() < window_->height());
        QVERIFY(floating->geometry().center() != window_->geometry().center());
        QVERIFY(!window_->findChild<EmptyPlace*>()->isVisible());  // the other one is still there
        window_->setFloating(floating, false);
        QVERIFY(!floating->isFloating() && floating->titleBarWidget() && floating->isVisible());
    }

    void aPanelIsFloatedAndClosedFromItsBoxAndItsTab()
    {
        const auto press = [&](const char* menuName, const char* title, const char* verb) {
            QTRY_VERIFY(window_->findChild<QMenu*>(menuName));
            QMenu* menu = window_->findChild<QMenu*>(menuName);
            QAction* found = nullptr;
            for (QAction* action : menu->findChildren<QAction*>(verb))
                if (!*title || static_cast<QMenu*>(action->parent())->title() == title) found = action;
            QVERIFY(found);
            found->trigger();
            menu->close();
            QTRY_VERIFY(!window_->findChild<QMenu*>(menuName));
        };
        PanelDock* const one = dock("one");
        window_->stepPanel(window_->activeDock() == one ? 0 : 1);
        emit window_->questionBar().box("copy")->menuRequested(window_->mapToGlobal(QPoint(50, 50)));
        press("questionMenu", "Fake", "float");
        const bool first = one->isFloating();
        QVERIFY(first || dock("two")->isFloating());
        window_->action("resetLayout")->trigger();
        QVERIFY(!one->isFloating() && !dock("two")->isFloating());
        QTabBar* tabs = nullptr;
        for (QTabBar* bar : window_->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
            if (bar->isVisible() && bar->count() == 2) tabs = bar;
        QVERIFY(tabs);
        const QPoint at = tabs->tabRect(1).center();
        QContextMenuEvent asked(QContextMenuEvent::Mouse, at, tabs->mapToGlobal(at));
        QApplication::sendEvent(tabs, &asked);
        press("tabMenu", "", "close");
        QCOMPARE(int(one->isHidden()) + int(dock("two")->isHidden()), 1);
    }

    void theEmptyWindowOffersTheWayBack()
    {
        auto* empty = window_->findChild<EmptyPlace*>();
        QVERIFY(!empty->isVisible());
        for (int panel = 0; panel < 2; ++panel) {
            QTest::keyClick(window_.get(), Qt::Key_W, Qt::ControlModifier);
            window_->stepPanel(1);
        }
        for (const char* id : {"one", "two"}) dock(id)->close();
        QTRY_VERIFY(empty->isVisible());
        QVERIFY(empty->findChild<QLabel*>("emptyPlaceSentence")->text().contains("Copy"));
        QTest::mouseClick(empty->findChild<QPushButton*>("bringPanelsBack"), Qt::LeftButton);
        QTRY_VERIFY(!empty->isVisible());
        QVERIFY(dock("one")->isVisible() || dock("two")->isVisible());
        window_->enterQuestion("roundness");
        QVERIFY(!empty->isVisible());
    }

    void theStatusLineSpeaksOfThePanelInFront()
    {
        window_.reset();
        session_ = std::make_unique<Session>();
        window_ =
            std::make_unique<MainWindow>(*session_, languages_,
                                         std::vector<PanelFacts>{FakePanel::factsOf("one", "copy", "First"),
                                                                 FakePanel::factsOf("two", "copy", "Second"),
                                                                 FakePanel::factsOf("round", "roundness", "Third")});
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        const auto* status = window_->findChild<QLabel*>("status");
        QVERIFY(status);
        window_->enterQuestion("roundness");
        window_->enterQuestion("copy");
        const auto give = [&](const char* panel) {
            session_->edit("Give", [&](project::Project& project) {
                project.panels[panel].inputs["file"].path = makeFile("a.txt").toStdString();
            });
        };
        give("round");  // made, and not in front: it has a note
        QTRY_VERIFY(dock("round")->panel().isCurrent());
        QVERIFY2(status->text().isEmpty(), qPrintable(status->text()));
        give(window_->activeDock()->facts().id.c_str());
        QTRY_VERIFY(window_->activeDock()->panel().isCurrent());
        QTRY_VERIFY(!status->text().isEmpty());
        window_->stepPanel(1);
        QVERIFY(status->text().isEmpty());
    }

    void paletteFindsFieldsOfPanelsNotMadeAndOffersTheManual()
    {
        const auto ask = [&](const QString& words) {
            window_->action("palette")->trigger();
            auto* palette = window_->findChild<CommandPalette*>("commandPalette");
            QTest::keyClicks(palette->findChild<QLineEdit*>(), words);
            return palette;
        };
        const auto enter = [](CommandPalette* palette) {
            QTest::keyClick(palette->findChild<QLineEdit*>(), Qt::Key_Return);
        };
        window_->enterQuestion("roundness");
        window_->enterQuestion("copy");
        enter(ask("fake factor"));  // of the panel in front first
        QTRY_COMPARE(window_->focusWidget() ? window_->focusWidget()->objectName() : QString(), QString("factor_mm"));
        QTRY_VERIFY(!window_->findChild<CommandPalette*>("commandPalette"));
        CommandPalette* nothing = ask("xyzzy");
        QCOMPARE(nothing->findChild<QListWidget*>()->count(), 1);
        QVERIFY(nothing->findChild<QListWidget*>()->item(0)->text().contains("manual"));
        enter(nothing);
        QTRY_VERIFY(window_->findChild<HelpWindow*>() && window_->findChild<HelpWindow*>()->isVisible());
        window_->findChild<HelpWindow*>()->close();
        QTRY_VERIFY(!window_->findChild<CommandPalette*>("commandPalette"));
        CommandPalette* sample = ask("sample");
        QVERIFY(sample->findChild<QListWidget*>()->item(0)->text().contains("sample"));
        sample->reject();
    }

    void undoAndRedoAreGreyWhenThereIsNothing()
    {
        const auto button = [&](const char* name) { return window_->findChild<QToolButton*>(QString("tool_") + name); };
        QVERIFY(button("undo")->isVisible() && button("save")->isEnabled());
        QVERIFY(!button("undo")->isEnabled() && !button("redo")->isEnabled());
        openFiles({makeFile("a.txt")});
        QVERIFY(button("undo")->isEnabled() && !button("redo")->isEnabled());
        window_->action("undo")->trigger();
        QVERIFY(!button("undo")->isEnabled() && button("redo")->isEnabled());
        // It is seen, too: the picture of a disabled icon is fainter.
        const QIcon icon = window_->action("undo")->icon();
        const auto ink = [&](QIcon::Mode mode) {
            const QImage image = icon.pixmap(QSize(24, 24), mode).toImage();
            int most = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) most = std::max(most, qAlpha(image.pixel(x, y)));
            return most;
        };
        QPalette faint = QApplication::palette();
        const QPalette before = faint;
        QColor half = faint.color(QPalette::Active, QPalette::WindowText);
        half.setAlphaF(0.5);
        faint.setColor(QPalette::Disabled, QPalette::WindowText, half);
        QApplication::setPalette(faint);
        const int enabled = ink(QIcon::Normal), disabled = ink(QIcon::Disabled);
        QApplication::setPalette(before);
        QVERIFY2(disabled < 0.6 * enabled, qPrintable(QString("%1 %2").arg(disabled).arg(enabled)));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::QuestionWindowTest)
#include "question_window_test.moc"
