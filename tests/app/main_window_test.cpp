// The window driven as a user does, with panels of the test.
#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QTest>

#include "app/gui/arguments.h"
#include "app/gui/command_palette.h"
#include "app/gui/main_window.h"
#include "app/gui/settings_dialog.h"
#include "tests/app/window_fixture.h"
#include "tests/widgets/core/drop_files.h"

namespace lathelier {

class MainWindowTest : public QObject, WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepareSettings(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void showsTheQuestionsThatHavePanels()
    {
        QStringList names;
        for (const QuestionBox* box : window_->questionBar().findChildren<QuestionBox*>()) names << box->text();
        QCOMPARE(names, QStringList({"Copy", "Roundness"}));
        QVERIFY(window_->questionBar().box("copy")->isChecked());
        QVERIFY(dock("one")->isVisible() || dock("two")->isVisible());
        QVERIFY(!dock("round")->isVisible());
        QVERIFY(!dock("round")->madePanel());  // not made before it is seen
    }

    void filesGoToTheActivePanel()
    {
        openFiles({makeFile("a.txt")});
        PanelBase& panel = window_->activeDock()->panel();
        QTRY_VERIFY(panel.isCurrent());
        QVERIFY(session_->isModified());
        QVERIFY(window_->isWindowModified());
        QCOMPARE(window_->action("undo")->text(), QString("&Undo: Open a.txt"));
        window_->action("undo")->trigger();
        QTRY_VERIFY(!panel.hasResult());
        QVERIFY(!window_->isWindowModified());
    }

    void filesGoWhereTheyCertainlyBelong()
    {
        openFiles({makeFile("a.record")});
        QCOMPARE(session_->project().workspace, std::string("roundness"));
        QCOMPARE(window_->activeDock(), dock("records"));
        QTRY_VERIFY(dock("records")->panel().isCurrent());
        openFiles({makeFile("a.profile")});
        QCOMPARE(window_->activeDock(), dock("round"));
        QTRY_VERIFY(dock("round")->panel().isCurrent());
        window_->enterQuestion("copy");
        openFiles({makeFile("a.txt")});  // of several: to the panel in front
        QCOMPARE(session_->project().workspace, std::string("copy"));
    }

    void aFileOfNobodysKindIsRefused()
    {
        openFiles({makeFile("a.txt")});
        QTRY_VERIFY(window_->activeDock()->panel().isCurrent());
        const project::Project before = session_->project();
        openFiles({makeFile("a.odd")});
        openFiles({folder_.filePath("none.txt")});
        QCOMPARE(session_->project(), before);
        QVERIFY(window_->activeDock()->panel().isCurrent());
        auto* log = window_->findChild<QDockWidget*>("dock_messages");
        QVERIFY(log->isVisible());
        QVERIFY2(window_->messages().plainText().contains("a.odd"), qPrintable(window_->messages().plainText()));
        QVERIFY(window_->messages().plainText().contains("does not exist"));
    }

    void aFileDroppedOnAPanelGoesWhereItBelongs()
    {
        PanelDock* const here = window_->activeDock();
        drop(&here->panel(), {makeFile("a.record")});
        QTRY_VERIFY(!window_->isOpening());
        QCOMPARE(window_->activeDock(), dock("records"));
        QVERIFY(session_->panel(here->facts().id).inputs.empty());
    }

    /// After a session that left another tab of the question in front, files named at the start come before the
    /// window.
    void filesNamedAtTheStartGoWhereTheyBelongWhateverTheLayout_data()
    {
        QTest::addColumn<QString>("left_in_front");
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("taker");
        QTest::newRow("record") << "round"
                                << "a.record"
                                << "records";
        QTest::newRow("profile") << "records"
                                 << "a.profile"
                                 << "round";
    }
    void filesNamedAtTheStartGoWhereTheyBelongWhateverTheLayout()
    {
        QFETCH(QString, left_in_front);
        QFETCH(QString, file);
        QFETCH(QString, taker);
        window_->enterQuestion("roundness");
        dock(left_in_front.toStdString())->raise();
        QTRY_VERIFY(!dock(left_in_front.toStdString())->visibleRegion().isEmpty());
        window_->enterQuestion("copy");
        window_->close();
        window_.reset();
        session_ = std::make_unique<Session>();
        window_ = std::make_unique<MainWindow>(*session_, languages_, panels());
        window_->openPaths({makeFile(file)});
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        QTRY_VERIFY(!window_->isOpening());
        PanelDock* const took = dock(taker.toStdString());
        QTRY_VERIFY(took->madePanel() && took->madePanel()->isCurrent());
        QTRY_VERIFY(!took->visibleRegion().isEmpty());
        QCOMPARE(window_->activeDock(), took);
        QVERIFY(dock(left_in_front.toStdString())->visibleRegion().isEmpty());
    }

    void undoKeyWorksInsideAField()
    {
        openFiles({makeFile("a.txt")});
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        auto* field = window_->activeDock()->panel().findChild<QLineEdit*>("factor_mm");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "7");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(field->text(), QString("7"));
        QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(field->text(), QString("2"));
        QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(field->text(), QString("7"));
    }

    void arrangementSurvivesARestart()
    {
        window_->resize(780, 840);
        window_->removeDockWidget(dock("two"));  // out of the tabs, or it would become one again
        window_->splitDockWidget(dock("one"), dock("two"), Qt::Vertical);
        dock("two")->show();
        window_->enterQuestion("roundness");
        window_->enterQuestion("copy");
        restart();
        QCOMPARE(window_->size(), QSize(780, 840));
        QVERIFY(dock("one")->isVisible() && dock("two")->isVisible());
        QVERIFY(dock("one")->y() + dock("one")->height() <= dock("two")->y());
        window_->action("resetLayout")->trigger();
        QVERIFY(window_->tabifiedDockWidgets(dock("one")).contains(dock("two")));
    }

    /// Of another version, or damaged.
    void settingsThatAreNotUnderstoodAreNoHindrance()
    {
        window_->close();
        window_.reset();
        QSettings stored;
        for (const char* key : {"geometry", "layouts/copy", "layouts/roundness", "state", "workspace"})
            stored.setValue(key, QByteArray("\x01no layout\xff"));
        for (const char* key : {"language", "theme", "decision", "length_unit", "form_unit", "presenter_percent"})
            stored.setValue(key, QString("furlong"));
        stored.setValue("recent", 7);
        restart();
        QVERIFY(dock("one")->isVisible() || dock("two")->isVisible());
        const Settings read = readSettings();
        QVERIFY(read.decision.isEmpty());
        QVERIFY(read.units == ScreenUnits{});
        QVERIFY(read.presenter_percent >= 100);
        QCOMPARE(window_->action("save")->text().remove('&'), QString("Save"));
        openFiles({makeFile("a.profile")});
        QCOMPARE(window_->activeDock(), dock("round"));
    }

    void restoringNeverHidesTheActiveResult()
    {
        dock("one")->hide();
        dock("two")->hide();
        restart();  // everything was closed
        QVERIFY(dock("one")->isVisible() || dock("two")->isVisible());
        window_->activeDock()->hide();
        window_->action("resetLayout")->trigger();
        QVERIFY(window_->activeDock()->isVisible());
    }

    void floatingDockOnNoScreenComesBack()
    {
        window_->splitDockWidget(dock("one"), dock("two"), Qt::Vertical);
        dock("two")->setFloating(true);
        dock("two")->move(30000, 30000);
        window_->enterQuestion("roundness");
        window_->enterQuestion("copy");
        QVERIFY(!dock("two")->isFloating() || dock("two")->x() < 10000);
    }

    void paletteFindsAndRuns()
    {
        bool run = false;
        window_->action("settings")->disconnect();
        connect(window_->action("settings"), &QAction::triggered, this, [&run] { run = true; });
        window_->action("palette")->trigger();
        auto* palette = window_->findChild<CommandPalette*>("commandPalette");
        QVERIFY(palette && palette->isVisible());
        auto* list = palette->findChild<QListWidget*>();
        const int all = list->count();
        QVERIFY(all > 12);
        QTest::keyClicks(palette->findChild<QLineEdit*>(), "sett edit");  // in any order
        QCOMPARE(list->count(), 1);
        QVERIFY(list->item(0)->text().startsWith(QString::fromUtf8("Edit › Settings")));
        QTest::keyClick(palette->findChild<QLineEdit*>(), Qt::Key_Return);
        QTRY_VERIFY(run);
    }

    void everyCommandIsInAMenu()
    {
        QStringList paths;
        for (const auto& command : commandsOf(window_->menuBar()->actions())) {
            QVERIFY2(!command.path.endsWith(QString::fromUtf8("› ")), qPrintable(command.path));
            paths << command.path;
        }
        for (const QAction* action : window_->actions())
            QVERIFY2(paths.join('\n').contains(action->text().remove('&')), qPrintable(action->objectName()));
    }

    void languageSwitchesAtRunTime()
    {
        window_->applySettings({"pl", {}, 150});
        QCOMPARE(languages_.current(), QString("pl"));
        QTRY_COMPARE(window_->action("save")->text().remove('&'), QString("Zapisz"));
        QCOMPARE(screenNumber(1.5, 2), QString("1,50"));
        window_->applySettings({"en", {}, 150});
        QTRY_COMPARE(window_->action("save")->text().remove('&'), QString("Save"));
        QCOMPARE(screenNumber(1.5, 2), QString("1.50"));
    }

    void unitsFollowTheSettings()
    {
        Settings wanted{"en", {}, 150};
        wanted.units = {ScreenUnits::Length::Inch, ScreenUnits::Form::Microinch};
        window_->applySettings(wanted);
        const bool kept = readSettings().units == wanted.units;
        const QString deviationText = screenQuantity(0.0508, millimetre, 3, true),
                      form = screenQuantity(2.54, micrometre, 2);
        SettingsDialog dialog(wanted);
        const bool shown = dialog.settings().units == wanted.units;
        window_->applySettings({"en", {}, 150});
        QVERIFY(kept && shown);
        QCOMPARE(deviationText, QString("+0.00200 in"));
        QCOMPARE(form, QString("100.0 µin"));
        QCOMPARE(screenQuantity(0.0508, millimetre, 3), QString("0.051 mm"));
    }

    void nothingOfTheOldLanguageStays()
    {
        const auto widen = [&](double value) {
            session_->edit(
                "Widen", [&](project::Project& project) { set(project.panels["one"].parameters, "factor_mm", value); });
        };
        const auto words = [&](const char* name) { return window_->action(name)->text().remove('&'); };
        widen(3);
        QCOMPARE(words("undo"), QString("Undo: Widen"));
        window_->applySettings({"pl", {}, 150});
        QTRY_COMPARE(words("undo"), QString("Cofnij"));  // not "Cofnij: Widen"
        for (const QWidget* widget : window_->findChildren<QWidget*>())
            QVERIFY2(widget->locale().decimalPoint() == ',', qPrintable(widget->objectName()));
        widen(4);
        QVERIFY(words("undo").endsWith(": Widen"));
        session_->undoStack().undo();
        QCOMPARE(words("undo"), QString("Cofnij"));
        QVERIFY(words("redo").endsWith(": Widen"));
        session_->undoStack().undo();
        QCOMPARE(words("redo"), QString("Ponów"));
        widen(5);
        QVERIFY(words("undo").endsWith(": Widen"));
        window_->applySettings({"en", {}, 150});
        QTRY_COMPARE(words("undo"), QString("Undo"));
    }

    void presenterModeIsLargerAndBack()
    {
        const double before = QApplication::font().pointSizeF();
        window_->action("presenter")->trigger();
        QVERIFY(QApplication::font().pointSizeF() > before * 1.4);
        for (const QWidget* widget : window_->findChildren<QWidget*>())
            if (widget->isVisible())
                QVERIFY2(widget->font().pointSizeF() > before * 1.2,
                         qPrintable(widget->objectName() + widget->metaObject()->className()));
        QVERIFY(window_->activeDock()->isVisible());
        QVERIFY(!window_->questionBar().isVisible());
        window_->action("presenter")->trigger();
        QCOMPARE(QApplication::font().pointSizeF(), before);
        QVERIFY(window_->questionBar().isVisible());
        window_->action("presenter")->trigger();
        QTRY_VERIFY(!window_->activeDock()->panel().isBusy());
        window_->action("cancel")->trigger();  // Esc
        QCOMPARE(QApplication::font().pointSizeF(), before);
    }

    /// Chart and pages are gone through at once, whatever had the focus before.
    void presenterModeGivesTheKeysToThePanel()
    {
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        window_->activeDock()->panel().findChild<QLineEdit*>("factor_mm")->setFocus();
        window_->setPresenting(true);
        QVERIFY(window_->activeDock()->panel().isAncestorOf(window_->focusWidget()) ||
                window_->focusWidget() == &window_->activeDock()->panel());
        QVERIFY(!qobject_cast<QLineEdit*>(window_->focusWidget()));
        window_->setPresenting(false);
    }

    void panelsAreReachedByKeysAndComeBack()
    {
        PanelDock* first = window_->activeDock();
        window_->stepPanel(1);
        PanelDock* second = window_->activeDock();
        QVERIFY(second != first);
        QCOMPARE(second->facts().question.id, std::string("copy"));
        window_->stepPanel(-1);
        QCOMPARE(window_->activeDock(), first);
        first->close();
        first->showAction().trigger();
        QTRY_VERIFY(first->isVisible());
        first->showAction().trigger();  // a second time closes nothing
        QVERIFY(first->isVisible());
    }

    void argumentsAreUnderstood()
    {
        const Arguments plain = parseArguments({"a.ply", "b.ply", "--language", "pl"});
        QCOMPARE(plain.files, QStringList({"a.ply", "b.ply"}));
        QCOMPARE(plain.language, QString("pl"));
        QVERIFY(plain.error.isEmpty());
        QCOMPARE(parseArguments({"--report", "r.pdf", "p.lathelier"}).report, QString("r.pdf"));
        for (const QStringList& wrong :
             {QStringList{"--report", "r.txt", "p"}, QStringList{"--report", "r.pdf"}, QStringList{"--shots"},
              QStringList{"--nonsense"}, QStringList{"--language", "xx"}, QStringList{"--shots", "d", "a", "b"}})
            QVERIFY2(!parseArguments(wrong).error.isEmpty(), qPrintable(wrong.join(' ')));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::MainWindowTest)
#include "main_window_test.moc"
