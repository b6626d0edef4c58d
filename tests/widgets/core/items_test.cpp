// Items of the project between panels: kept by one, used by another, undone, and said to be out of date.
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "engine/shaft/shaft.h"
#include "widgets/core/panel/panel.h"
#include "widgets/core/resources.h"

namespace lathelier {

/// Shows the length of a shaft that another panel has kept; keeps shafts itself.
class LengthPanel : public Panel<double> {
public:
    LengthPanel(Session& owner, const std::string& id) : Panel(owner, factsOf(id), inputs()), view_(new QLabel)
    {
        setViews(view_);
    }
    void keep(const std::string& name, double length_mm)
    {
        Shaft shaft;
        shaft.segments = {{length_mm, 30, 30, 0, {}, ""}};
        keepItem(name, "shaft", toValues(shaft));
    }
    QString shown() const { return view_->text(); }

protected:
    Compute compute(const project::PanelState& state) const override
    {
        const auto shaft = fromValues<Shaft>(state.items.at("shaft").values);
        return [length_mm = shaft.length_mm()](const Progress&) { return std::make_shared<const double>(length_mm); };
    }
    void showResult(const std::shared_ptr<const double>& result) override { view_->setText(QString::number(*result)); }
    report::Answer answer(const double&) const override { return {}; }
    Notes notes(const double&) const override { return {}; }
    report::Document document(const double&) const override { return {}; }

private:
    static PanelFacts factsOf(const std::string& id)
    {
        PanelFacts facts;
        facts.id = id;
        facts.title = Text{"Length"};
        return facts;
    }
    static PanelInputs inputs()
    {
        InputRole role{"shaft", Text{"Shaft"}, Text{"A shaft"}};
        role.item_kind = "shaft";
        return {{role}, {}, {}, Text{"Choose a shaft."}};
    }

    QLabel* view_;
};

class ItemsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<Session> session_;
    std::unique_ptr<LengthPanel> maker_, user_;

    QToolButton* button() const { return user_->findChild<QToolButton*>("itemInput"); }
    bool says(const QString& words) const
    {
        const auto labels = user_->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&words](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }
    void choose(int which) { button()->menu()->actions().at(which)->trigger(); }

private slots:
    void initTestCase() { useResources(); }
    void init()
    {
        session_ = std::make_unique<Session>();
        maker_ = std::make_unique<LengthPanel>(*session_, "drawing");
        user_ = std::make_unique<LengthPanel>(*session_, "lobes");
        user_->resize(1000, 700);
        user_->show();
        QVERIFY(QTest::qWaitForWindowExposed(user_.get()));
    }
    void cleanup()
    {
        user_.reset();
        maker_.reset();
        session_.reset();
    }

    void withoutItemsNothingIsOffered() { QVERIFY(!button()->isVisible()); }

    void whatIsKeptIsOfferedWithItsOriginAndCanBeUndone()
    {
        maker_->keep("journal", 120);
        const project::Item& item = session_->project().items.at("journal");
        QCOMPARE(item.kind, std::string("shaft"));
        QCOMPARE(item.origin.panel, std::string("drawing"));
        QVERIFY(!item.origin.version.empty());
        QVERIFY(button()->isVisible());
        QCOMPARE(button()->menu()->actions().size(), 1);
        session_->undoStack().undo();
        QVERIFY(session_->project().items.empty());
        QVERIFY(!button()->isVisible());
    }

    void anItemIsComputedWithAndFollowed()
    {
        maker_->keep("journal", 120);
        choose(0);
        QTRY_VERIFY(user_->isCurrent());
        QCOMPARE(user_->shown(), QString("120"));
        QVERIFY(says("journal") && says("drawing"));
        maker_->keep("journal", 150);  // another shaft under the same name
        QTRY_COMPARE(user_->shown(), QString("150"));
        session_->undoStack().undo();
        QTRY_COMPARE(user_->shown(), QString("120"));
        session_->undoStack().undo();  // the choice
        QTRY_VERIFY(!user_->hasResult());
    }

    void itemsOfAnotherKindAreNotOffered()
    {
        session_->edit("material", [](project::Project& project) { project.items["brass"] = {"material", {}, {}}; });
        QVERIFY(!button()->isVisible());
    }

    void aChangedOriginIsSaid()
    {
        maker_->keep("journal", 120);
        choose(0);
        QTRY_VERIFY(user_->isCurrent());
        QVERIFY(!says("⚠"));
        session_->edit("other scan", [](project::Project& project) {
            project.panels["drawing"].parameters = {{"bore_mm", 5.0}};
        });
        QVERIFY(says("⚠"));
        QCOMPARE(user_->shown(), QString("120"));  // until it is kept again
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::ItemsTest)
#include "items_test.moc"
