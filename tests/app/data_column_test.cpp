// The column that lists what the project holds: files with their uses, items with their origin.
#include <QMimeData>
#include <QUndoStack>
#include <QUrl>

#include "app/gui/data_column.h"
#include "tests/app/window_fixture.h"

namespace lathelier {

class DataColumnTest : public QObject, private WindowFixture {
    Q_OBJECT

    DataColumn* data() const { return window_->findChild<DataColumn*>("data"); }
    QTreeWidgetItem* row(const QString& words) const
    {
        const QList<QTreeWidgetItem*> found = data()->findItems(words, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
    void useTable()
    {
        std::vector<PanelFacts> table = panels();
        for (PanelFacts& facts : table) facts.roles = {{"file", Text{"Numbers"}, Text{"A file"}}};
        table[2].item_inputs = {{"profile", "file"}};  // "round", of another question
        window_.reset();
        session_ = std::make_unique<Session>();
        window_ = std::make_unique<MainWindow>(*session_, languages_, table);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void give(const std::string& panel, const QString& path)
    {
        session_->edit(
            "give", [&](project::Project& project) { project.panels[panel].inputs["file"].path = path.toStdString(); });
    }

private slots:
    void initTestCase() { prepareSettings(); }
    void init()
    {
        begin();
        useTable();
    }
    void cleanup() { end(); }

    void aFileStandsOnceWithAllItsUses()
    {
        QCOMPARE(data()->topLevelItemCount(), 1);  // that there is nothing yet
        QVERIFY(!(data()->topLevelItem(0)->flags() & Qt::ItemIsEnabled));
        const QString path = makeFile("a.txt");
        give("one", path);
        give("two", path);
        give("round", makeFile("b.profile"));
        QCOMPARE(data()->topLevelItemCount(), 2);
        QVERIFY(row("a.txt"));
        QCOMPARE(row("a.txt")->childCount(), 2);
        QCOMPARE(row("a.txt")->child(0)->text(0), QString("Fake · Numbers"));
        QVERIFY(row("a.txt")->toolTip(0).contains(path));
        session_->undoStack().undo();
        QCOMPARE(data()->topLevelItemCount(), 1);
    }

    void aDoubleClickShowsThePanelThatTakesIt()
    {
        give("round", makeFile("b.profile"));
        QVERIFY(window_->activeDock() != dock("round"));
        emit data()->itemActivated(row("b.profile"), 0);
        QVERIFY(window_->activeDock() == dock("round"));
        QCOMPARE(session_->project().workspace, std::string("roundness"));
    }

    void aFileIsDraggedAsAFile()
    {
        const QString path = makeFile("a.txt");
        give("one", path);
        data()->setCurrentItem(row("a.txt"));
        const QModelIndexList chosen = data()->selectionModel()->selectedIndexes();
        const std::unique_ptr<QMimeData> dragged(data()->model()->mimeData(chosen));
        QVERIFY(dragged);
        QCOMPARE(dragged->urls(), QList<QUrl>{QUrl::fromLocalFile(path)});
    }

    void anItemLeadsToItsPanelAndIsRemovedWithItsUses()
    {
        emit dock("one")->panel().itemOffered("section", {"profile", {{"x_mm", 1.0}}, {"one", "1", "other", {}}}, true);
        QVERIFY(row("section"));
        QVERIFY2(row("section")->toolTip(0).contains("made in Fake"), qPrintable(row("section")->toolTip(0)));
        QVERIFY(row("section")->toolTip(0).contains("changed"));  // its origin is another state by now
        window_->enterQuestion("copy");
        emit data()->itemActivated(row("section"), 0);
        QVERIFY(window_->activeDock() == dock("round"));
        QVERIFY(QMetaObject::invokeMethod(data(), "removeItem", Q_ARG(QString, "section")));
        QVERIFY(session_->project().items.empty());
        QVERIFY(session_->panel("round").inputs.empty());
        session_->undoStack().undo();
        QCOMPARE(session_->panel("round").inputs.at("file").item, std::string("section"));
    }

    void staysAwayUntilItIsWantedAndInPresenterMode()
    {
        auto* column = window_->findChild<QDockWidget*>("dock_data");
        QVERIFY(!column->isVisible());
        column->toggleViewAction()->trigger();
        QVERIFY(column->isVisible());
        QVERIFY(column->height() > dock("one")->height() - 20);  // beside the panels, not under them
        window_->setPresenting(true);
        QVERIFY(!column->isVisible());
        window_->setPresenting(false);
        QVERIFY(column->isVisible());
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::DataColumnTest)
#include "data_column_test.moc"
