// Session: one edit is one undo step; saving, opening, merging.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "widgets/core/session.h"

namespace lathelier {

class SessionTest : public QObject {
    Q_OBJECT

    static void setTitle(Session& session, const std::string& title, const QString& key = {})
    {
        session.edit(
            "title", [&](Project& project) { project.title = title; }, key);
    }

private slots:
    void editIsOneUndoStep()
    {
        Session session;
        QSignalSpy changed(&session, &Session::changed);
        session.edit("both", [](Project& project) {
            project.title = std::string("a");
            project.report = {"compare"};
        });
        QCOMPARE(changed.count(), 1);
        QVERIFY(session.isModified());
        QCOMPARE(session.undoStack().undoText(), QString("both"));
        session.undoStack().undo();
        QCOMPARE(session.project(), Project());
        QVERIFY(!session.isModified());
        session.undoStack().redo();
        QCOMPARE(session.project().title, std::string("a"));
    }

    void editThatChangesNothingIsNoStep()
    {
        Session session;
        setTitle(session, "");
        QCOMPARE(session.undoStack().count(), 0);
        QVERIFY(!session.isModified());
    }

    void oneDragIsOneStep()
    {
        Session session;
        setTitle(session, "1", "slider/0");
        setTitle(session, "2", "slider/0");
        setTitle(session, "3", "slider/0");
        QCOMPARE(session.undoStack().count(), 1);
        setTitle(session, "4", "slider/1");  // the next gesture
        setTitle(session, "5");
        setTitle(session, "6");
        QCOMPARE(session.undoStack().count(), 4);
        session.undoStack().setIndex(1);
        QCOMPARE(session.project().title, std::string("3"));
        session.undoStack().undo();
        QCOMPARE(session.project().title, std::string());
    }

    void dragBackToTheStartLeavesNoStep()
    {
        Session session;
        setTitle(session, "1", "slider/0");
        setTitle(session, "", "slider/0");
        QCOMPARE(session.undoStack().count(), 0);
    }

    void undoKeepsTheWorkspace()
    {
        Session session;
        setTitle(session, "a");
        session.setWorkspace("roundness");
        QVERIFY(session.isModified());  // because of the title only
        session.undoStack().undo();
        QCOMPARE(session.project().workspace, std::string("roundness"));
        QVERIFY(!session.isModified());
    }

    void saveAndOpen()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("p.lathelier");
        Session session;
        setTitle(session, "kept");
        session.save(path);
        QVERIFY(!session.isModified());
        QCOMPARE(session.path(), path);
        setTitle(session, "lost");
        Session other;
        other.open(path);
        QCOMPARE(other.project().title, std::string("kept"));
        QVERIFY(!other.isModified());
        QCOMPARE(other.undoStack().count(), 0);
    }

    void failedSaveStaysModified()
    {
        Session session;
        setTitle(session, "a");
        QVERIFY_EXCEPTION_THROWN(session.save("/nowhere/at/all/p.lathelier"), Error);
        QVERIFY(session.isModified());
        QVERIFY(session.path().isEmpty());
    }

    void failedOpenKeepsTheProject()
    {
        const QTemporaryDir folder;
        Session session;
        setTitle(session, "a");
        QVERIFY_EXCEPTION_THROWN(session.open(folder.filePath("missing.lathelier")), Error);
        QCOMPARE(session.project().title, std::string("a"));
    }

    void recoveredWorkIsUnsaved()
    {
        const QTemporaryDir folder;
        Session session;
        setTitle(session, "a");
        session.saveCopy(folder.filePath("copy.lathelier"));
        QVERIFY(session.isModified());
        Session other;
        QSignalSpy modified(&other, &Session::modifiedChanged);
        other.recover(folder.filePath("copy.lathelier"), "/home/me/original.lathelier");
        QCOMPARE(other.project().title, std::string("a"));
        QCOMPARE(other.path(), QString("/home/me/original.lathelier"));
        QVERIFY(other.isModified());
        QCOMPARE(modified.count(), 1);
    }

    void thousandEditsAreCheap()
    {
        Session session;
        for (int i = 0; i < 1000; ++i) setTitle(session, std::to_string(i));
        QCOMPARE(session.undoStack().count(), 1000);
        session.undoStack().setIndex(0);
        QCOMPARE(session.project(), Project());
    }
};

}  // namespace lathelier

QTEST_GUILESS_MAIN(lathelier::SessionTest)
#include "session_test.moc"
