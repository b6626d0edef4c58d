// Several parts of a project: their list, and that no view shows another part's data.
#include <QAction>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <set>

#include "app/gui/panels.h"
#include "app/gui/parts_box.h"
#include "engine/project/parts.h"
#include "engine/sample/sample.h"
#include "tests/app/window_fixture.h"
#include "widgets/core/panel/answer_strip.h"

namespace lathelier {

class PartsTest : public QObject, private WindowFixture {
    Q_OBJECT

    QListWidget* list() const { return window_->findChild<QListWidget*>("partList"); }
    void press(const char* name) const { QTest::mouseClick(window_->findChild<QToolButton*>(name), Qt::LeftButton); }
    QStringList names() const
    {
        QStringList all;
        for (int i = 0; i < list()->count(); ++i) all << list()->item(i)->text();
        return all;
    }
    void click(int row) const
    {
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualItemRect(list()->item(row)).center());
    }
    void rename(const QString& name) const
    {
        press("renamePart");
        auto* editor = list()->findChild<QLineEdit*>();
        QVERIFY(editor);
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(!list()->findChild<QLineEdit*>());  // taken over, queued
    }
    /// Runs an entry of the menu that the next right click opens.
    void chooseInMenu(int row, const QString& entry)
    {
        QTimer::singleShot(50, this, [entry] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (!menu) return;
            for (QAction* action : menu->actions())
                if (action->text() == entry) menu->setActiveAction(action);
            QTest::keyClick(menu, Qt::Key_Return);
        });
        emit list()->customContextMenuRequested(list()->visualItemRect(list()->item(row)).center());
    }

    /// Points of a stepped shaft, scaled.
    QString writeScan(const QString& name, double scale) const
    {
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.5;
        scanner.angle_step_deg = 3.6;
        QString path = folder_.filePath(name);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) return {};
        for (const Eigen::Vector3d& point : scanShaft(sample::nominalShaft(), scanner).points_mm)
            file.write(QString("%1 %2 %3\n")
                           .arg(scale * point.x(), 0, 'f', 5)
                           .arg(scale * point.y(), 0, 'f', 5)
                           .arg(scale * point.z(), 0, 'f', 5)
                           .toLatin1());
        return path;
    }

private slots:
    void initTestCase() { prepareSettings(); }
    void init()
    {
        begin();
        window_->findChild<QDockWidget*>("dock_data")->toggleViewAction()->trigger();
        QVERIFY(list()->isVisible());
    }
    void cleanup() { end(); }

    void areAddedRenamedAndRemoved()
    {
        QCOMPARE(names(), QStringList{"Part 1"});
        QVERIFY(!window_->findChild<QToolButton*>("removePart")->isEnabled());
        press("addPart");
        QCOMPARE(names(), QStringList({"Part 1", "Part 2"}));
        QCOMPARE(session_->project().place, std::size_t{1});
        rename("Pin");
        QCOMPARE(session_->project().name, std::string("Pin"));
        QCOMPARE(window_->action("undo")->text(), QString::fromUtf8("&Undo: Rename to “Pin”"));
        click(0);
        QCOMPARE(session_->project().place, std::size_t{0});
        QVERIFY(list()->item(0)->font().bold() && !list()->item(1)->font().bold());
        QVERIFY(list()->item(0)->data(Qt::AccessibleTextRole).toString().contains("shown"));
        rename("Pin");  // taken
        QCOMPARE(names(), QStringList({"Pin (2)", "Pin"}));
        chooseInMenu(1, "Show");
        QCOMPARE(session_->project().place, std::size_t{1});
        chooseInMenu(0, "Remove from the project");
        QCOMPARE(names(), QStringList{"Pin"});
        session_->undoStack().undo();
        QCOMPARE(names(), QStringList({"Pin (2)", "Pin"}));
        session_->undoStack().setIndex(0);
        QCOMPARE(names(), QStringList{"Part 1"});
        for (const char* name : {"addPart", "renamePart", "removePart"})
            QVERIFY(!window_->findChild<QToolButton*>(name)->accessibleName().isEmpty());
        QVERIFY(!list()->accessibleName().isEmpty());
    }

    void areSwitchedByKeys()
    {
        press("addPart");
        list()->setFocus();
        QTest::keyClick(list(), Qt::Key_Up);
        QTest::keyClick(list(), Qt::Key_Return);
        QCOMPARE(session_->project().place, std::size_t{0});
    }

    void theColumnListsTheDataOfTheShownOne()
    {
        auto* data = window_->findChild<QTreeWidget*>("data");
        session_->edit("Keep", [](project::Project& project) { project.items["section"].kind = "profile"; });
        QCOMPARE(data->findItems("section", Qt::MatchExactly).size(), 1);
        press("addPart");
        QVERIFY(data->findItems("section", Qt::MatchExactly).isEmpty());
        click(0);
        QCOMPARE(data->findItems("section", Qt::MatchExactly).size(), 1);
    }

    /// Every panel of the program, for two parts with scans of their own.
    void noViewShowsAnotherPartsData()
    {
        const std::string first = writeScan("first.xyz", 1).toStdString();
        const std::string copy = writeScan("copy.xyz", 1.0002).toStdString();
        const std::string second = writeScan("second.xyz", 0.5).toStdString();
        Session session;
        std::vector<std::unique_ptr<PanelBase>> panels;
        for (const PanelFacts& facts : panelTable()) panels.emplace_back(facts.make(session));
        session.edit("Two parts", [&](project::Project& project) {
            project.panels["recognise"].inputs["scan"].path = first;
            project.panels["compare"].inputs["reference"].path = first;
            project.panels["compare"].inputs["copy"].path = copy;
            project::addPart(project, "B");
            project.panels["recognise"].inputs["scan"].path = second;
        });
        const auto settle = [&] {
            QTRY_VERIFY_WITH_TIMEOUT(
                std::none_of(panels.begin(), panels.end(), [](const auto& panel) { return panel->isBusy(); }), 60000);
        };
        const auto panel = [&](const char* id) -> PanelBase& {
            return **std::find_if(panels.begin(), panels.end(), [&](const auto& one) { return one->facts().id == id; });
        };
        const auto showOnly = [&](const std::set<std::string>& names) {
            for (const auto& one : panels) {
                const auto document = one->reportDocument();
                if (session.panel(one->facts().stateKey()).inputs.empty())
                    QVERIFY2(!document || document->inputs.empty(), one->facts().id.c_str());
                if (!document) continue;
                for (const auto& input : document->inputs)
                    QVERIFY2(names.count(input.path) > 0, (one->facts().id + ": " + input.path).c_str());
            }
        };
        settle();
        QVERIFY(panel("recognise").isCurrent());
        QVERIFY(!panel("compare").hasResult());
        showOnly({second});
        session.showPart(0);
        QVERIFY(!panel("recognise").hasResult());  // at once, not only when the other is computed
        settle();
        QVERIFY(panel("recognise").isCurrent() && panel("compare").isCurrent());
        showOnly({first, copy});
        session.showPart(1);
        showOnly({second});
        QVERIFY(!panel("compare").hasResult());
        settle();
        QVERIFY(panel("recognise").isCurrent());
        showOnly({second});
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::PartsTest)
#include "parts_test.moc"
