// The left column of every panel: few fields before "More", optional inputs behind one button.
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <memory>

#include "app/gui/panels.h"
#include "tests/app/window_fixture.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_column.h"

namespace lathelier {

class LeftColumnTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static const PanelFacts& factsOf(const std::string& id)
    {
        const std::vector<PanelFacts>& all = panelTable();
        return *std::find_if(all.begin(), all.end(), [&](const PanelFacts& facts) { return facts.id == id; });
    }

private slots:
    void initTestCase() { useSettingsOf(folder_.path()); }

    void hasAtMostSevenFieldsBeforeMore_data()
    {
        QTest::addColumn<QString>("id");
        for (const PanelFacts& facts : panelTable())
            QTest::newRow(facts.id.c_str()) << QString::fromStdString(facts.id);
    }
    void hasAtMostSevenFieldsBeforeMore()
    {
        QFETCH(QString, id);
        Session session;
        const std::unique_ptr<PanelBase> panel(factsOf(id.toStdString()).make(session));
        const auto* column = panel->findChild<InputColumn*>("inputColumn");
        QVERIFY(column);
        QStringList keys;
        for (const std::string& key : column->form().unfolded()) keys << QString::fromStdString(key);
        QVERIFY2(keys.size() <= 7, qPrintable(keys.join(' ')));
    }

    void anOptionalInputHasNoPlaceUntilItIsAdded()
    {
        Session session;
        const std::unique_ptr<PanelBase> panel(factsOf("shaft").make(session));
        panel->resize(1000, 700);
        panel->show();
        auto* column = panel->findChild<InputColumn*>("inputColumn");
        auto* spindle = column->findChild<QWidget*>("input_spindle");
        auto* add = column->findChild<QToolButton*>("addInput");
        QVERIFY(column->findChild<QWidget*>("input_shaft")->isVisible());
        QVERIFY(!spindle->isVisible() && add->isVisible() && !add->accessibleName().isEmpty());
        const auto entry = [&]() -> QAction* {
            emit add->menu()->aboutToShow();
            for (QAction* action : add->menu()->actions())
                if (action->objectName() == "add_spindle") return action;
            return nullptr;
        };
        QVERIFY(entry() && !entry()->menu());  // its file dialog at once
        session.edit("Keep", [](project::Project& project) { project.items["lathe"].kind = "spindle"; });
        QVERIFY(entry()->menu());
        QCOMPARE(entry()->menu()->actions().front()->text(), QString("lathe"));
        entry()->menu()->actions().front()->trigger();
        QCOMPARE(session.panel("shaft").inputs.at("spindle").item, std::string("lathe"));
        QVERIFY(spindle->isVisible() && !add->isVisible());
        session.undoStack().undo();
        QVERIFY(!spindle->isVisible() && add->isVisible());
    }

    void aTableIsHiddenWhereAFileStandsInItsPlace()
    {
        Session session;
        const std::unique_ptr<PanelBase> panel(factsOf("lobes").make(session));
        panel->show();
        QWidget* modes = panel->findChild<InputColumn*>("inputColumn")->form().editor("mode");
        QVERIFY(modes && modes->isVisible());
        session.edit("Open", [](project::Project& project) { project.panels["lobes"].inputs["frf"].path = "/none"; });
        QVERIFY(!modes->isVisible());
        session.edit("State", [](project::Project& project) {
            lathelier::set(project.panels["lobes"].parameters, "mode", Rows{{Row{{{"frequency_hz", 223.0}}}}});
        });
        QVERIFY(modes->isVisible());
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::LeftColumnTest)
#include "left_column_test.moc"
