// The form built from fields(), used as a person does, in two locales.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "widgets/core/form/form.h"
#include "widgets/core/form/number_edit.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"

namespace lathelier {
namespace {

enum class Colour { Red, Blue };

struct Shape {
    double size_mm = 1.5;
    std::optional<double> limit_mm;
    int count = 3;
    bool closed = true;
    Colour colour = Colour::Blue;
    std::string name = "x";
    std::vector<Interval> left_out_mm;
};

Field<Shape> withUsual(Field<Shape> field)
{
    field.info.usual = {2.5, 5};
    return field;
}

std::vector<FieldInfo> shapeFields()
{
    const std::vector<Field<Shape>> all{
        field("size_mm", &Shape::size_mm, {0, 1000}, {Text{"Size"}, Text{"How large"}, Text{"mm"}}),
        withUsual(field("limit_mm", &Shape::limit_mm, {0, 10}, {Text{"Limit"}, Text{"How far"}, Text{"mm"}})),
        field("count", &Shape::count, {1, 9}, {Text{"Count"}, Text{"How many"}}),
        field("closed", &Shape::closed, {Text{"Closed"}, Text{"Is it?"}}),
        field("colour", &Shape::colour, {{"red", Text{"Red"}}, {"blue", Text{"Blue"}}},
              {Text{"Colour"}, Text{"Which"}}),
        field("name", &Shape::name, {Text{"Name"}, Text{"What"}, {}, true}),
        field("left_out_mm", &Shape::left_out_mm, {-100, 100},
              {Text{"Left out"}, Text{"Where not"}, Text{"mm"}, true})};
    std::vector<FieldInfo> infos;
    for (const auto& one : all) infos.push_back(one.info);
    return infos;
}

Values someValues()
{
    return {{"size_mm", 2.25},
            {"limit_mm", Value()},
            {"count", std::int64_t{5}},
            {"closed", false},
            {"colour", std::string("red")},
            {"name", std::string("flange")},
            {"left_out_mm", std::vector<Interval>{{0, 5}, {10, 12.5}}}};
}

}  // namespace

class FormTest : public QObject {
    Q_OBJECT

    struct Change {
        std::string key;
        Value value;
        int gesture;
    };
    std::unique_ptr<Form> form_;
    std::vector<Change> changes_;

    template <class T>
    T* editor(const char* key)
    {
        return qobject_cast<T*>(form_->editor(key));
    }
    void type(const char* key, const QString& text, Qt::Key end = Qt::Key_Return)
    {
        auto* edit = editor<QLineEdit>(key);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        if (end) QTest::keyClick(edit, end);
    }

    void makeForm()
    {
        changes_.clear();
        form_ = std::make_unique<Form>(shapeFields());
        connect(form_.get(), &Form::valueChanged, this,
                [this](const std::string& key, const Value& value, int gesture) {
                    changes_.push_back({key, value, gesture});
                });
        form_->show();
        QVERIFY(QTest::qWaitForWindowExposed(form_.get()));
        QApplication::setActiveWindow(form_.get());
    }

private slots:
    void initTestCase() { useResources(); }
    void init()
    {
        QLocale::setDefault(QLocale::c());
        makeForm();
    }
    void setValuesIsShownAndNotAnnounced()
    {
        form_->setValues(someValues());
        QCOMPARE(changes_.size(), std::size_t{0});
        QVERIFY(form_->values() == someValues());
    }

    void whatWasUsedIsTaggedAtItsField()
    {
        const auto label = [this](const char* key) {
            for (const QLabel* each : form_->findChildren<QLabel*>())
                if (each->buddy() && each->buddy() == form_->editor(key)) return each->text();
            return QString();
        };
        UsedValue assumed{"name", Text{"Name"}, std::string("steel"), Text{}, ValueOrigin::Assumed};
        UsedValue read{"limit_mm", Text{"Limit"}, 0.5, Text{"mm"}, ValueOrigin::File};
        UsedValue given{"size_mm", Text{"Size"}, 2.0, Text{"mm"}, ValueOrigin::Given};
        const QString before = label("size_mm");
        form_->setUsed({assumed, read, given});
        QVERIFY2(label("name").contains("assumed: steel"), qPrintable(label("name")));
        QVERIFY2(label("limit_mm").contains("from the file: 0.5"), qPrintable(label("limit_mm")));
        QCOMPARE(label("size_mm"), before);
        QVERIFY(form_->findChild<QToolButton*>("advanced")->text().contains("1"));  // what the fold hides is counted
        form_->setUsed({});
        QVERIFY(!label("name").contains("steel"));
    }

    void lengthsAreTypedInTheUnitOfTheUser()
    {
        form_->setValues(someValues());
        setScreenUnits({ScreenUnits::Length::Inch, ScreenUnits::Form::Micrometre});
        QCoreApplication::processEvents();
        auto* const size = qobject_cast<QLineEdit*>(form_->editor("size_mm"));
        const QString shown = size->text();
        type("size_mm", "2");
        const QString count = qobject_cast<QLineEdit*>(form_->editor("count"))->text();
        setScreenUnits({});
        QCoreApplication::processEvents();
        QCOMPARE(shown, QString("0.08858268"));
        QCOMPARE(count, QString("5"));  // no length
        QCOMPARE(changes_.size(), std::size_t{1});
        QVERIFY(changes_[0].value == Value(50.8));
        QCOMPARE(size->text(), QString("50.8"));
    }

    void typedNumberIsAnnouncedOnce()
    {
        type("size_mm", "12.5");
        QCOMPARE(changes_.size(), std::size_t{1});
        QCOMPARE(changes_[0].key, std::string("size_mm"));
        QVERIFY(changes_[0].value == Value(12.5));
    }

    void typingIsAnnouncedAfterAPause()
    {
        type("size_mm", "0.05", Qt::Key(0));
        QCOMPARE(changes_.size(), std::size_t{0});
        QTRY_COMPARE(changes_.size(), std::size_t{1});
        QVERIFY(changes_[0].value == Value(0.05));
    }

    void usualValuesAreOneClick()
    {
        auto* edit = editor<NumberEdit>("limit_mm");
        auto* offer = edit->findChild<QAction*>("usualValues");
        QVERIFY(offer);
        QVERIFY(!editor<NumberEdit>("size_mm")->findChild<QAction*>("usualValues"));
        const auto pick = [&](int row) {
            QTimer::singleShot(0, [row] {
                auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
                QVERIFY(menu);
                QCOMPARE(menu->actions().size(), 3);  // "not given", 2.5, 5
                menu->actions()[row]->trigger();
                menu->close();
            });
            offer->trigger();
        };
        pick(2);
        QCOMPARE(changes_.size(), std::size_t{1});
        QVERIFY(changes_[0].value == Value(5.0));
        QCOMPARE(edit->text(), QString("5"));
        pick(0);
        QCOMPARE(changes_.size(), std::size_t{2});
        QVERIFY(changes_[1].value == Value());
        QVERIFY(changes_[1].gesture != changes_[0].gesture);
    }

    void polishNumbers()
    {
        QLocale::setDefault(QLocale(QLocale::Polish));
        makeForm();
        form_->setValues({{"size_mm", 2.25}});
        QCOMPARE(editor<QLineEdit>("size_mm")->text(), QString("2,25"));
        type("size_mm", "3,5");
        type("size_mm", "4.5");  // the point is understood too
        QCOMPARE(changes_.size(), std::size_t{2});
        QVERIFY(changes_[0].value == Value(3.5));
        QVERIFY(changes_[1].value == Value(4.5));
    }

    void nonsenseIsMarkedAndPutBackOnLeaving()
    {
        form_->setValues({{"size_mm", 7.0}});
        for (const char* text : {"abc", "-1", "1e9", "nan", "1,2,3", ""}) {
            type("size_mm", text, Qt::Key(0));
            if (*text == '\0') QTest::keyClick(editor<QLineEdit>("size_mm"), Qt::Key_Delete);
            QVERIFY2(!editor<NumberEdit>("size_mm")->isSound(), text);
            QVERIFY(editor<QLineEdit>("size_mm")->toolTip().contains("0 to 1000"));
            editor<QLineEdit>("count")->setFocus();
            QCOMPARE(editor<QLineEdit>("size_mm")->text(), QString("7"));
        }
        QCOMPARE(changes_.size(), std::size_t{0});
        type("count", "2.5", Qt::Key(0));
        QVERIFY(!editor<NumberEdit>("count")->isSound());
    }

    void optionalNumberMayBeEmpty()
    {
        type("limit_mm", "3");
        QVERIFY(changes_.back().value == Value(3.0));
        auto* edit = editor<QLineEdit>("limit_mm");
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClick(edit, Qt::Key_Return);
        QVERIFY(changes_.back().value == Value());
        QCOMPARE(edit->placeholderText(), QString("not given"));
    }

    void arrowsStepWithinTheRange()
    {
        form_->setValues({{"count", std::int64_t{8}}, {"size_mm", 0.05}});
        auto* count = editor<QLineEdit>("count");
        count->setFocus();
        QTest::keyClick(count, Qt::Key_Up);
        QTest::keyClick(count, Qt::Key_Up);
        QCOMPARE(changes_.size(), std::size_t{1});  // 9 is the end
        QVERIFY(changes_[0].value == Value(std::int64_t{9}));
        auto* size = editor<QLineEdit>("size_mm");
        size->setFocus();
        QTest::keyClick(size, Qt::Key_Up);
        QCOMPARE(size->text(), QString("0.06"));
        QTest::keyClick(size, Qt::Key_Down);
        QTest::keyClick(size, Qt::Key_Down);
        QCOMPARE(size->text(), QString("0.04"));
    }

    void stepsInOneVisitAreOneGesture()
    {
        auto* size = editor<QLineEdit>("size_mm");
        size->setFocus();
        QTest::keyClick(size, Qt::Key_Up);
        QTest::keyClick(size, Qt::Key_Up);
        editor<QLineEdit>("count")->setFocus();
        size->setFocus();
        QTest::keyClick(size, Qt::Key_Up);
        QCOMPARE(changes_.size(), std::size_t{3});
        QCOMPARE(changes_[0].gesture, changes_[1].gesture);
        QVERIFY(changes_[1].gesture != changes_[2].gesture);
    }

    void flagAndChoice()
    {
        form_->setValues({{"closed", true}, {"colour", std::string("blue")}});
        QTest::mouseClick(editor<QCheckBox>("closed"), Qt::LeftButton, {},
                          QPoint(6, editor<QCheckBox>("closed")->height() / 2));
        QVERIFY(changes_.back().value == Value(false));
        auto* box = editor<QComboBox>("colour");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Up);
        QVERIFY(changes_.back().value == Value(std::string("red")));
    }

    void rangesAreAddedAndRemoved()
    {
        form_->setUnfolded(true);
        form_->setValues(someValues());
        QWidget* list = form_->editor("left_out_mm");
        auto ends = list->findChildren<NumberEdit*>();
        QCOMPARE(ends.size(), 4);
        QTest::mouseClick(list->findChildren<QToolButton*>().front(), Qt::LeftButton);  // "Add a range"
        ends = list->findChildren<NumberEdit*>();
        QCOMPARE(ends.size(), 6);
        QCOMPARE(changes_.size(), std::size_t{0});
        ends[4]->setFocus();
        QTest::keyClicks(ends[4], "20");
        QTest::keyClick(ends[4], Qt::Key_Return);
        QCOMPARE(changes_.size(), std::size_t{0});  // half a range says nothing
        ends[5]->setFocus();
        QTest::keyClicks(ends[5], "30");
        QTest::keyClick(ends[5], Qt::Key_Return);
        QCOMPARE(changes_.size(), std::size_t{1});
        QVERIFY(changes_[0].value == Value(std::vector<Interval>{{0, 5}, {10, 12.5}, {20, 30}}));
    }

    void advancedIsFolded()
    {
        QVERIFY(!form_->editor("name")->isVisible());
        QTest::mouseClick(form_->findChild<QToolButton*>("advanced"), Qt::LeftButton);
        QVERIFY(form_->editor("name")->isVisible());
    }

    void labelsNamesAndHelp()
    {
        QCOMPARE(form_->editor("size_mm")->accessibleName(), QString("Size"));
        QCOMPARE(form_->editor("size_mm")->toolTip(), QString("How large"));
        QStringList labels;
        for (const QLabel* label : form_->findChildren<QLabel*>()) labels << label->text();
        QVERIFY(labels.contains("Size (mm)"));
        QVERIFY(labels.contains("Count"));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::FormTest)
#include "form_test.moc"
