// What one panel made goes into another: one undo step, and the other panel is shown.
#include <QUndoStack>

#include "tests/app/window_fixture.h"

namespace lathelier {

class UseItemTest : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepareSettings(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void goesToThePanelThatTakesItsKind()
    {
        std::vector<PanelFacts> table = panels();
        table[2].item_inputs = {{"profile", "file"}};  // "round", of another question
        window_.reset();                               // made by the fixture, with other panels
        session_ = std::make_unique<Session>();
        window_ = std::make_unique<MainWindow>(*session_, languages_, table);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        PanelBase& from = dock("one")->panel();
        emit from.itemOffered("section", {"profile", {{"x_mm", 1.0}}, {}}, true);
        const project::Project& project = session_->project();
        QCOMPARE(project.items.count("section"), std::size_t{1});
        const project::Source& source = project.panels.at("round").inputs.at("file");
        QCOMPARE(source.item, std::string("section"));
        QVERIFY(source.synthetic);
        QVERIFY(window_->activeDock() == dock("round"));
        session_->undoStack().undo();
        QVERIFY(session_->project().items.empty());
        QVERIFY(session_->panel("round").inputs.empty());
    }

    void isKeptWhereNobodyTakesIt()
    {
        emit dock("one")->panel().itemOffered("section", {"profile", {}, {}}, false);
        QCOMPARE(session_->project().items.count("section"), std::size_t{1});
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::UseItemTest)
#include "use_item_test.moc"
