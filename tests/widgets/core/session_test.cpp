// Session: one edit is one undo step; saving, opening, merging.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "engine/io/file.h"
#include "engine/project/parts.h"
#include "engine/project/project_codes.h"
#include "widgets/core/session.h"

namespace lathelier {

/// A store whose files are texts.
class TextStore : public FileCache<std::string> {
public:
    TextStore() : FileCache(4) {}

protected:
    std::string read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override
    {
        return std::string(inputs.open(source.path, progress));
    }
};

class SessionTest : public QObject {
    Q_OBJECT

    static void setTitle(Session& session, const std::string& title, const QString& key = {})
    {
        session.edit(
            "title", [&](project::Project& project) { project.title = title; }, key);
    }

    static void setFactor(Session& session, double factor, const QString& key = {})
    {
        session.edit(
            "factor",
            [&](project::Project& project) { lathelier::set(project.panels["compare"].parameters, "factor", factor); },
            key);
    }
    static Value factor(const Session& session)
    {
        const Value* const found = find(session.panel("compare").parameters, "factor");
        return found ? *found : Value();
    }

private slots:
    void editIsOneUndoStep()
    {
        Session session;
        QSignalSpy changed(&session, &Session::changed);
        session.edit("both", [](project::Project& project) {
            project.title = std::string("a");
            project.report = {"compare"};
        });
        QCOMPARE(changed.count(), 1);
        QVERIFY(session.isModified());
        QCOMPARE(session.undoStack().undoText(), QString("both"));
        session.undoStack().undo();
        QCOMPARE(session.project(), project::Project());
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

    void whatIsLookedAtIsKeptButIsNoStep()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("p.lathelier");
        Session session;
        setTitle(session, "a");
        session.setView("compare", "hero", std::string("map"));
        QCOMPARE(session.undoStack().count(), 1);
        session.undoStack().undo();
        QCOMPARE(session.view("compare", "hero"), Value(std::string("map")));
        QCOMPARE(session.view("compare", "other"), Value());
        session.save(path);
        Session again;
        again.open(path);
        QCOMPARE(again.view("compare", "hero"), Value(std::string("map")));
    }

    void anotherPartIsShownWithoutAStep()
    {
        const QTemporaryDir folder;
        Session session;
        setFactor(session, 1);
        session.setView("compare", "hero", std::string("map"));
        session.edit("Add a part", [](project::Project& project) { project::addPart(project, "B"); });
        QCOMPARE(session.panel("compare"), project::PanelState());
        QCOMPARE(session.view("compare", "hero"), Value());
        session.save(folder.filePath("p.lathelier"));
        QSignalSpy changed(&session, &Session::changed);
        const int steps = session.undoStack().count(), opened = session.projectsOpened();
        session.showPart(0);
        QCOMPARE(changed.count(), 1);
        QVERIFY(!session.isModified());
        QCOMPARE(session.undoStack().count(), steps);
        QVERIFY(session.projectsOpened() > opened);  // views and running work belong to another part
        QCOMPARE(factor(session), Value(1.0));
        QCOMPARE(session.view("compare", "hero"), Value(std::string("map")));
    }

    void undoReturnsToThePartOfItsStepAndChangesNoOther()
    {
        Session session;
        setFactor(session, 1, "slider/0");
        session.edit("Add a part", [](project::Project& project) { project::addPart(project, "B"); });
        setFactor(session, 2, "slider/0");
        session.showPart(0);
        setFactor(session, 3, "slider/0");  // the same gesture, but of another part
        session.showPart(1);
        setFactor(session, 4);
        session.setView("compare", "hero", std::string("b"));
        session.showPart(0);
        session.setView("compare", "hero", std::string("a"));
        session.undoStack().undo();  // 4 of B
        QCOMPARE(session.project().place, std::size_t{1});
        QCOMPARE(factor(session), Value(2.0));
        QCOMPARE(session.view("compare", "hero"), Value(std::string("b")));
        QCOMPARE(*find(session.project().others[0].panels.at("compare").parameters, "factor"), Value(3.0));
        session.undoStack().undo();  // 3 of the first
        QCOMPARE(session.project().place, std::size_t{0});
        QCOMPARE(factor(session), Value(1.0));
        QCOMPARE(session.view("compare", "hero"), Value(std::string("a")));
        QCOMPARE(*find(session.project().others[0].panels.at("compare").parameters, "factor"), Value(2.0));
        session.showPart(1);
        session.undoStack().redo();
        QCOMPARE(session.project().place, std::size_t{0});
        QCOMPARE(factor(session), Value(3.0));
        session.undoStack().setIndex(1);  // before B
        QCOMPARE(session.project().others.size(), std::size_t{0});
        QCOMPARE(session.view("compare", "hero"), Value(std::string("a")));
    }

    void filesOfAllPartsAreComparedAndGetTheirDigest()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("a.txt"), path = folder.filePath("p.lathelier");
        io::writeFile(file.toStdString(), "old");
        Session session;
        session.edit("Open", [&](project::Project& project) {
            project.panels["compare"].inputs["copy"].path = file.toStdString();
            project::addPart(project, "B");
        });
        project::Source source;
        source.path = file.toStdString();
        session.stores().of<TextStore>()->load(source);
        session.save(path);
        const project::Project saved = project::readProject(path.toStdString()).project;
        QCOMPARE(saved.others.at(0).panels.at("compare").inputs.at("copy").sha256, io::sha256("old"));
        io::writeFile(file.toStdString(), "another");
        Session again;
        QSignalSpy found(&again.watch(), &SourceWatch::found);
        QSignalSpy compared(&again.watch(), &SourceWatch::savedCompared);
        again.open(path);
        QVERIFY(compared.wait());
        QCOMPARE(found.count(), 1);
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

    void aRecipeBeginsANewProject()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("shafts.lathelier");
        Session session;
        session.edit("open", [](project::Project& project) {
            project.panels["compare"].inputs["reference"].path = "/scans/master.ply";
            project.panels["compare"].inputs["copy"].path = "/scans/part.ply";
        });
        session.saveRecipe(path, {{"compare", {"copy"}}});
        QVERIFY(session.path().isEmpty() && session.isModified());  // it stays what it was
        session.open(path);
        QVERIFY(session.path().isEmpty());  // saving asks for a name: the recipe stays
        QVERIFY(!session.isModified());
        QVERIFY(!session.project().recipe);
        QCOMPARE(session.panel("compare").inputs.size(), std::size_t{1});
    }

    void anotherWindowsSaveIsSeen()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("p.lathelier");
        Session one, two;
        setTitle(one, "first");
        one.save(path);
        two.open(path);
        QVERIFY(!one.isOvertaken() && !two.isOvertaken());
        setTitle(two, "second");
        two.save(path);
        QVERIFY(one.isOvertaken() && !two.isOvertaken());
        one.save(path);  // the user said so
        QVERIFY(!one.isOvertaken() && two.isOvertaken());
        QVERIFY(QFile::remove(path));
        QVERIFY(!two.isOvertaken());  // nothing to lose
    }

    void aFileThatChangesStaysAsItWasRead()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("scan.txt").toStdString();
        io::writeFile(path, "old");
        Session session;
        const auto store = session.stores().of<TextStore>();
        const project::Source source{.path = path, .import = {}, .sha256 = {}};
        project::PanelState state;
        state.inputs["scan"] = source;
        QCOMPARE(store->load(source)->file, std::string("old"));

        QSignalSpy changed(&session.watch(), &SourceWatch::changed);
        QSignalSpy taken(&session, &Session::filesTaken);
        io::writeFile(path, "new");
        session.watch().look();
        QTRY_COMPARE(changed.count(), 1);
        const Notes notes = session.watch().notesOf(state);
        QCOMPARE(notes.size(), std::size_t{1});
        QVERIFY(notes[0].code == notes::sourceChangedSince);
        QCOMPARE(std::get<std::string>(*find(notes[0].values, "read_sha256")), io::sha256("old"));
        QCOMPARE(std::get<std::string>(*find(notes[0].values, "now_sha256")), io::sha256("new"));
        QVERIFY(session.watch().notesOf(project::PanelState()).empty());
        QCOMPARE(store->load(source)->file, std::string("old"));
        project::Source otherwise = source;  // read in another way, it would be another file
        lathelier::set(otherwise.import, "unit", std::string("inch"));
        QVERIFY_EXCEPTION_THROWN(store->load(otherwise), Error);
        session.watch().look();
        QTest::qWait(200);
        QCOMPARE(changed.count(), 1);  // said once

        session.takeNewFiles();
        QCOMPARE(taken.count(), 1);
        QVERIFY(session.watch().notesOf(state).empty());
        QCOMPARE(store->load(source)->file, std::string("new"));
        QCOMPARE(store->load(otherwise)->file, std::string("new"));

        io::writeFile(path, "new");  // touched, not changed
        session.watch().look();
        QTest::qWait(200);
        QVERIFY(session.watch().notesOf(state).empty());
        QVERIFY(QFile::remove(QString::fromStdString(path)));
        session.watch().look();
        QTRY_COMPARE(session.watch().notesOf(state).size(), std::size_t{1});
        QVERIFY(session.watch().notesOf(state)[0].code == notes::sourceGone);
    }

    void openingSaysInTheBackgroundWhatBecameOfTheSources()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("p.lathelier");
        const std::string scan = folder.filePath("scan.txt").toStdString();
        io::writeFile(scan, "old");
        Session session;
        session.edit("a", [&](project::Project& project) {
            project.panels["compare"].inputs["copy"] = {.path = scan, .import = {}, .sha256 = io::sha256("old")};
            project.panels["compare"].inputs["reference"] = {.path = scan + ".none", .import = {}, .sha256 = {}};
        });
        session.save(path);
        io::writeFile(scan, "new");
        Session other;
        std::vector<std::string> found;
        QObject::connect(&other.watch(), &SourceWatch::found,
                         [&found](const Note& note) { found.push_back(note.code.key); });
        QSignalSpy compared(&other.watch(), &SourceWatch::savedCompared);
        other.open(path);
        QTRY_COMPARE(compared.count(), 1);
        QCOMPARE(found, (std::vector<std::string>{"source_changed", "source_missing"}));
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
        QCOMPARE(session.project(), project::Project());
    }
};

}  // namespace lathelier

QTEST_GUILESS_MAIN(lathelier::SessionTest)
#include "session_test.moc"
