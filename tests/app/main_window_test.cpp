// The window driven as a user does, with panels of the test.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <csignal>

#include "app/gui/arguments.h"
#include "app/gui/command_palette.h"
#include "app/gui/main_window.h"
#include "app/gui/shutdown.h"
#include "tests/widgets/core/fake_panel.h"
#include "widgets/core/number_edit.h"
#include "widgets/core/resources.h"

namespace lathelier {

class MainWindowTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    Languages languages_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<MainWindow> window_;

    static std::vector<PanelFacts> panels()
    {
        PanelFacts round = FakePanel::factsOf("round", "roundness");
        PanelFacts records = FakePanel::factsOf("records", "roundness");
        round.recognises = [](const std::string& path) { return path.ends_with(".profile"); };
        records.recognises = [](const std::string& path) { return path.ends_with(".record"); };
        return {FakePanel::factsOf("one"), FakePanel::factsOf("two"), round, records};
    }
    PanelDock* dock(const std::string& id) const
    {
        for (PanelDock* dock : window_->docks())
            if (dock->facts().id == id) return dock;
        return nullptr;
    }
    QString makeFile(const QString& name, int size = 10)
    {
        QFile file(folder_.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write(QByteArray(size, 'x'));
        return file.fileName();
    }
    void restart()
    {
        if (window_) window_->close();
        window_.reset();
        session_ = std::make_unique<Session>();
        window_ = std::make_unique<MainWindow>(*session_, languages_, panels());
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("LathelierTest");
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
        useResources();
    }
    void init()
    {
        QSettings().clear();
        languages_.use("en");
        restart();
    }
    void cleanup()
    {
        session_->undoStack().setClean();  // no question about unsaved work
        window_->close();
        window_.reset();
    }

    void showsTheWorkspacesThatHavePanels()
    {
        QStringList names;
        auto* bar = window_->findChild<QToolBar*>("workspaceBar");
        for (const QAction* action : bar->actions())
            if (action->isCheckable() && !action->objectName().startsWith("presenter")) names << action->text();
        QCOMPARE(names, QStringList({"Inspection", "Roundness"}));
        QVERIFY(dock("one")->isVisible() || dock("two")->isVisible());
        QVERIFY(!dock("round")->isVisible());
        QVERIFY(!dock("round")->madePanel());  // not made before it is seen
    }

    void switchesWorkspaces()
    {
        window_->enterWorkspace("roundness");
        QVERIFY(dock("round")->isVisible());
        QVERIFY(!dock("one")->isVisible());
        QCOMPARE(session_->project().workspace, std::string("roundness"));
        QVERIFY(!session_->isModified());
        window_->enterWorkspace("inspection");
        QVERIFY(!dock("round")->isVisible());
    }

    void filesGoToTheActivePanel()
    {
        window_->openPaths({makeFile("a.txt")});
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
        window_->openPaths({makeFile("a.record")});
        QCOMPARE(session_->project().workspace, std::string("roundness"));
        QCOMPARE(window_->activeDock(), dock("records"));
        QTRY_VERIFY(dock("records")->panel().isCurrent());
        window_->openPaths({makeFile("a.profile")});
        QCOMPARE(window_->activeDock(), dock("round"));
        QTRY_VERIFY(dock("round")->panel().isCurrent());
        window_->enterWorkspace("inspection");
        window_->openPaths({makeFile("a.txt")});  // nobody's: to the panel in front
        QCOMPARE(session_->project().workspace, std::string("inspection"));
    }

    void undoKeyWorksInsideAField()
    {
        window_->openPaths({makeFile("a.txt")});
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
        window_->resize(780, 790);
        window_->removeDockWidget(dock("two"));  // out of the tabs, or it would become one again
        window_->splitDockWidget(dock("one"), dock("two"), Qt::Vertical);
        dock("two")->show();
        window_->enterWorkspace("roundness");
        window_->enterWorkspace("inspection");
        restart();
        QCOMPARE(window_->size(), QSize(780, 790));
        QVERIFY(dock("one")->isVisible() && dock("two")->isVisible());
        QVERIFY(dock("one")->y() + dock("one")->height() <= dock("two")->y());
        window_->action("resetLayout")->trigger();
        QVERIFY(window_->tabifiedDockWidgets(dock("one")).contains(dock("two")));
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
        window_->enterWorkspace("roundness");
        window_->enterWorkspace("inspection");
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
        window_->applySettings({"pl", 2, 150});
        QCOMPARE(languages_.current(), QString("pl"));
        QTRY_COMPARE(window_->action("save")->text().remove('&'), QString("Zapisz"));
        QCOMPARE(screenNumber(1.5, 2), QString("1,50"));
        window_->applySettings({"en", 2, 150});
        QTRY_COMPARE(window_->action("save")->text().remove('&'), QString("Save"));
        QCOMPARE(screenNumber(1.5, 2), QString("1.50"));
    }

    void nothingOfTheOldLanguageStays()
    {
        const auto widen = [&](double value) {
            session_->edit("Widen",
                           [&](Project& project) { set(project.panels["one"].parameters, "factor_mm", value); });
        };
        const auto words = [&](const char* name) { return window_->action(name)->text().remove('&'); };
        widen(3);
        QCOMPARE(words("undo"), QString("Undo: Widen"));
        window_->applySettings({"pl", 2, 150});
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
        window_->applySettings({"en", 2, 150});
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
        QVERIFY(!window_->findChild<QToolBar*>("workspaceBar")->isVisible());
        window_->action("presenter")->trigger();
        QCOMPARE(QApplication::font().pointSizeF(), before);
        QVERIFY(window_->findChild<QToolBar*>("workspaceBar")->isVisible());
    }

    void projectsAreOpenedSavedAndRemembered()
    {
        window_->openPaths({makeFile("a.txt")});
        const QString path = folder_.filePath("p.lathelier");
        session_->save(path);
        restart();
        window_->openPaths({path});
        QTRY_VERIFY(window_->activeDock()->panel().isCurrent());
        QCOMPARE(recentFiles(), QStringList{path});
        QVERIFY(window_->windowTitle().startsWith("p"));
        QVERIFY(!session_->isModified());
    }

    void whatIsBeingTypedIsSaved()
    {
        const QString path = folder_.filePath("typed.lathelier");
        session_->save(path);
        auto* edit = dock("one")->findChild<NumberEdit*>();
        QVERIFY(edit);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, "7.25");  // no Enter, no pause
        QVERIFY(!session_->isModified());
        QVERIFY(window_->files().save());
        QFile saved(path);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QVERIFY(saved.readAll().contains("7.25"));
        QVERIFY(!session_->isModified());
    }

    void savingOverAnotherWindowsProjectAsks()
    {
        const QString path = folder_.filePath("shared.lathelier");
        const auto setTitle = [](Session& session, const std::string& title) {
            session.edit("title", [&](Project& project) { project.title = title; });
        };
        const auto titleOnDisk = [&] { return readProject(path.toStdString()).project.title; };
        setTitle(*session_, "mine");
        session_->save(path);
        Session other;
        other.open(path);
        setTitle(other, "theirs");
        other.save(path);
        setTitle(*session_, "mine again");

        QString question;
        const auto answer = [&](const QString& button) {
            QTimer::singleShot(0, this, [&question, button] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                if (!box) return;
                question = box->text();
                for (QAbstractButton* one : box->buttons())
                    if (one->text().contains(button)) return one->click();
                box->reject();
            });
        };
        answer("Cancel");
        QVERIFY(!window_->files().save());
        QVERIFY2(question.contains("shared.lathelier was changed by another window"), qPrintable(question));
        QCOMPARE(titleOnDisk(), std::string("theirs"));
        QVERIFY(session_->isModified());
        answer("Replace it");
        QVERIFY(window_->files().save());
        QCOMPARE(titleOnDisk(), std::string("mine again"));
        question.clear();
        setTitle(*session_, "and again");
        answer("Cancel");
        QVERIFY(window_->files().save());  // nobody is asked: it is ours now
        QVERIFY(question.isEmpty());
    }

    void brokenProjectIsSaidInTheLog()
    {
        const QString path = folder_.filePath("broken.lathelier");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{ no json");
        file.close();
        const int before = window_->messages().count();
        window_->openPaths({path});
        QCOMPARE(window_->messages().count(), before + 1);
        QVERIFY(window_->messages().plainText().contains("broken.lathelier"));
        QVERIFY(window_->messages().isVisible());
    }

    void unsavedWorkIsFoundAfterACrash()
    {
        const QTemporaryDir recovery;
        session_->edit("a", [](Project& project) { project.title = std::string("unsaved"); });
        {
            Recovery crashed(recovery.path());
            crashed.keep(*session_);
            // What a crash leaves behind: the files without their owner.
            for (const QString& name : QDir(recovery.path()).entryList({"*.lathelier", "*.path"}, QDir::Files))
                QVERIFY(
                    QFile::copy(recovery.filePath(name), recovery.filePath("crashed" + name.mid(name.indexOf('.')))));
            const Recovery other(recovery.path());
            QCOMPARE(other.lostWork().size(), std::size_t{1});  // the living one is not lost
        }
        const Recovery next(recovery.path());
        const auto lost = next.lostWork();
        QCOMPARE(lost.size(), std::size_t{1});
        Session recovered;
        recovered.recover(lost[0].file, lost[0].original);
        QCOMPARE(recovered.project().title, std::string("unsaved"));
        QVERIFY(recovered.isModified());
        Recovery::discard(lost[0]);
        QVERIFY(next.lostWork().empty());
    }

    void savedWorkIsNotKeptAside()
    {
        const QTemporaryDir recovery;
        Recovery mine(recovery.path());
        session_->edit("a", [](Project& project) { project.title = std::string("x"); });
        mine.keep(*session_);
        QCOMPARE(QDir(recovery.path()).entryList({"*.lathelier"}).size(), 1);
        session_->save(folder_.filePath("s.lathelier"));
        mine.keep(*session_);
        QCOMPARE(QDir(recovery.path()).entryList({"*.lathelier"}).size(), 0);
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

    void aShutdownKeepsUnsavedWork()
    {
        const QTemporaryDir recovery;
        window_->close();
        window_ = std::make_unique<MainWindow>(*session_, languages_, panels(), recovery.path());
        session_->edit("a", [](Project& project) { project.title = std::string("unsaved"); });
        const Shutdown shutdown;
        bool told = false;
        QObject::connect(&shutdown, &Shutdown::wanted, window_.get(), [&] {
            told = true;
            window_->files().leaveWithoutAsking();
        });
        QCOMPARE(::raise(SIGTERM), 0);
        QTRY_VERIFY(told);
        session_->undoStack().setClean();
        window_.reset();
        const Recovery next(recovery.path());
        QCOMPARE(next.lostWork().size(), std::size_t{1});
        window_ = std::make_unique<MainWindow>(*session_, languages_, panels());
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::MainWindowTest)
#include "main_window_test.moc"
