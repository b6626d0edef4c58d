// Projects in the window: opened, saved, shared with another window, found again after a crash.
#include <QAbstractButton>
#include <QMessageBox>
#include <QTimer>
#include <csignal>

#include "app/gui/recovery.h"
#include "app/gui/shutdown.h"
#include "tests/app/window_fixture.h"
#include "widgets/core/form/number_edit.h"

namespace lathelier {

class ProjectFilesTest : public QObject, WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepareSettings(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void projectsAreOpenedSavedAndRemembered()
    {
        openFiles({makeFile("a.txt")});
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
            session.edit("title", [&](project::Project& project) { project.title = title; });
        };
        const auto titleOnDisk = [&] { return project::readProject(path.toStdString()).project.title; };
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
        session_->edit("a", [](project::Project& project) { project.title = std::string("unsaved"); });
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
        session_->edit("a", [](project::Project& project) { project.title = std::string("x"); });
        mine.keep(*session_);
        QCOMPARE(QDir(recovery.path()).entryList({"*.lathelier"}).size(), 1);
        session_->save(folder_.filePath("s.lathelier"));
        mine.keep(*session_);
        QCOMPARE(QDir(recovery.path()).entryList({"*.lathelier"}).size(), 0);
    }

    void aShutdownKeepsUnsavedWork()
    {
        const QTemporaryDir recovery;
        window_->close();
        window_ = std::make_unique<MainWindow>(*session_, languages_, panels(), recovery.path());
        session_->edit("a", [](project::Project& project) { project.title = std::string("unsaved"); });
        const Shutdown shutdown;
        bool told = false;
        QObject::connect(&shutdown, &Shutdown::requested, window_.get(), [&] {
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

QTEST_MAIN(lathelier::ProjectFilesTest)
#include "project_files_test.moc"
