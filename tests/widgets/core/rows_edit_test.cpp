// The table of rows, used as a person does, in two locales; and groups in the form.
#include "widgets/core/form/rows_edit.h"

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QLocale>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "engine/core/tool.h"
#include "engine/shaft/shaft.h"
#include "widgets/core/form/form.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"

namespace lathelier {

class RowsEditTest : public QObject {
    Q_OBJECT

    std::unique_ptr<Form> form_;
    std::vector<std::pair<std::string, Value>> changes_;

    RowsEdit* segments() const { return qobject_cast<RowsEdit*>(form_->editor("segments")); }
    QTableWidget* table() const { return segments()->table(); }
    void type(int row, int column, const QString& text)
    {
        table()->setCurrentCell(row, column);
        table()->item(row, column)->setText(text);  // what the cell's editor does at Enter
    }
    Shaft shaft() const { return fromValues<Shaft>(form_->values()); }

private slots:
    void initTestCase() { useResources(); }
    void init()
    {
        QLocale::setDefault(QLocale::c());
        changes_.clear();
        form_ = std::make_unique<Form>(infos<Shaft>());
        Shaft given;
        given.segments = {{20, 30, 30, 0, {}, ""}, {50, 40, 35.5, 0, {}, "cone"}};
        form_->setValues(toValues(given));
        connect(form_.get(), &Form::valueChanged, this,
                [this](const std::string& key, const Value& value, int) { changes_.emplace_back(key, value); });
        form_->show();
        QVERIFY(QTest::qWaitForWindowExposed(form_.get()));
    }

    void showsWhatIsSetAndAnnouncesNothing()
    {
        QCOMPARE(table()->rowCount(), 2);
        QCOMPARE(table()->item(1, 2)->text(), QString("35.5"));
        QCOMPARE(table()->horizontalHeaderItem(0)->text(), QString("Length\n(mm)"));
        QVERIFY(changes_.empty());
    }

    void aTypedCellIsOneChange()
    {
        type(0, 1, "31,25");  // either decimal mark, whatever the locale
        QCOMPARE(changes_.size(), std::size_t{1});
        QCOMPARE(changes_[0].first, std::string("segments"));
        QCOMPARE(shaft().segments[0].start_diameter_mm, 31.25);
    }

    void lengthsAreTypedInTheUnitOfTheUser()
    {
        setScreenUnits({ScreenUnits::Length::Inch, ScreenUnits::Form::Micrometre});
        QCoreApplication::processEvents();
        const QString head = table()->horizontalHeaderItem(0)->text(), shown = table()->item(0, 0)->text();
        type(0, 1, "1.5");
        const Shaft typed = shaft();
        setScreenUnits({});
        QCoreApplication::processEvents();
        QCOMPARE(head, QString("Length\n(in)"));
        QCOMPARE(shown, QString("0.7874016"));
        QCOMPARE(changes_.size(), std::size_t{1});
        QCOMPARE(typed.segments[0].start_diameter_mm, 38.1);
        QCOMPARE(typed.segments[0].length_mm, 20.0);  // what was not typed keeps all its digits
        QCOMPARE(table()->item(0, 1)->text(), QString("38.1"));
    }

    void aCellThatDoesNotFitIsMarkedAndKept()
    {
        type(0, 1, "-3");
        QVERIFY(changes_.empty());
        QVERIFY(!table()->item(0, 1)->icon().isNull());
        QVERIFY(!table()->item(0, 1)->toolTip().isEmpty());
        QVERIFY(!segments()->isSound());
        QCOMPARE(shaft().segments[0].start_diameter_mm, 30.0);  // the last sound one
        type(0, 1, "33");
        QVERIFY(table()->item(0, 1)->icon().isNull());
        QCOMPARE(shaft().segments[0].start_diameter_mm, 33.0);
    }

    void aRowOfAnOlderFileShowsItsValues()
    {
        FieldInfo info;
        info.kind = FieldInfo::Kind::Rows;
        info.maximum = 10;
        info.columns = infos<Tool>();
        for (FieldInfo& column : info.columns) column.advanced = column.kind == FieldInfo::Kind::Rows;
        RowsEdit edit(info);
        edit.setRows({{Row{{{"nose_radius_mm", 0.8}, {"corner_radius_mm", 0.0}, {"lead_angle_deg", -5.0}}}}});
        const Rows shown = edit.rows();
        QCOMPARE(shown.rows.size(), std::size_t{1});
        QVERIFY(*lathelier::find(shown.rows[0].cells, "corner_radius_mm") == Value(0.8));
        QVERIFY(*lathelier::find(shown.rows[0].cells, "entering_angle_deg") == Value(95.0));
        QVERIFY(!lathelier::find(shown.rows[0].cells, "lead_angle_deg"));
    }

    void rowsAreAddedAndRemoved()
    {
        table()->setCurrentCell(0, 0);
        QTest::mouseClick(segments()->findChild<QToolButton*>("addRow"), Qt::LeftButton);
        QCOMPARE(shaft().segments.size(), std::size_t{3});
        QCOMPARE(shaft().segments[1].length_mm, 20.0);  // a copy of the row before
        table()->setCurrentCell(2, 0);
        QTest::mouseClick(segments()->findChild<QToolButton*>("removeRow"), Qt::LeftButton);
        QCOMPARE(shaft().segments.size(), std::size_t{2});
        table()->setCurrentCell(0, 0);
        QTest::mouseClick(segments()->findChild<QToolButton*>("removeRow"), Qt::LeftButton);
        QVERIFY(!segments()->findChild<QToolButton*>("removeRow")->isEnabled());  // one has to stay
    }

    void rowsArePastedFromASpreadsheet()
    {
        QApplication::clipboard()->setText("10\t20\t20\r\n11\t21\t22\r\n12\t23\t24\r\n");
        table()->setCurrentCell(1, 0);
        QTest::keyClick(table(), Qt::Key_V, Qt::ControlModifier);
        QVERIFY(!segments()->isSound());  // two new rows have no bore yet
        QApplication::clipboard()->setText("0\n0\n0");
        table()->setCurrentCell(1, 3);
        segments()->paste();
        QCOMPARE(shaft().segments.size(), std::size_t{4});
        QCOMPARE(shaft().segments[3].end_diameter_mm, 24.0);
        QCOMPARE(shaft().segments[1].role, std::string("cone"));  // what was not pasted over
    }

    void numbersAreShownInTheLocale()
    {
        QLocale::setDefault(QLocale("pl_PL"));
        form_ = std::make_unique<Form>(infos<Shaft>());
        Shaft given;
        given.segments = {{20.125, 30, 30, 0, {}, ""}};
        form_->setValues(toValues(given));
        QCOMPARE(table()->item(0, 0)->text(), QString("20,125"));
    }

    void aNewLanguageShowsTheSameRows()
    {
        FieldInfo driven;
        driven.key = "driven";
        driven.kind = FieldInfo::Kind::Flag;
        FieldInfo info;
        info.key = "gears";
        info.kind = FieldInfo::Kind::Rows;
        info.maximum = 5;
        info.columns = {driven};
        RowsEdit edit(info);
        const Rows rows{{Row{{{"driven", true}}}, Row{{{"driven", false}}}}};
        edit.setRows(rows);
        QCOMPARE(edit.table()->item(0, 0)->text(), QString("yes"));
        Languages languages;
        languages.use("pl");
        QApplication::sendPostedEvents();
        QCOMPARE(edit.table()->item(0, 0)->text(), QString("tak"));
        QVERIFY(edit.isSound());
        QCOMPARE(edit.rows(), rows);
        languages.use("en");
    }

    void fieldsOfAnAbsentGroupAreDisabled()
    {
        auto* modulus = form_->editor("material.elastic_modulus_MPa");
        QVERIFY(!modulus->isEnabled());
        QVERIFY(!shaft().material);
        QTest::mouseClick(form_->editor("material"), Qt::LeftButton, {},
                          QPoint(8, form_->editor("material")->height() / 2));
        QVERIFY(modulus->isEnabled());
        QCOMPARE(changes_.back().first, std::string("material"));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::RowsEditTest)
#include "rows_edit_test.moc"
