// The shop as it is chosen and changed in its dialog.
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/shop_dialog.h"
#include "engine/io/file.h"
#include "widgets/core/form/form.h"

namespace lathelier {

class ShopDialogTest : public QObject {
    Q_OBJECT

    static void choose(ShopDialog& dialog, const char* table, const QString& key)
    {
        auto* box = dialog.findChild<QComboBox*>(QString("entry_") + table);
        QVERIFY(box);
        const int place = box->findData(key);
        QVERIFY2(place >= 0, qPrintable(key));
        box->setCurrentIndex(place);
        emit box->activated(place);
    }
    static Form* formOf(ShopDialog& dialog, const char* table)
    {
        return dialog.findChild<QWidget*>(QString("page_") + table)->findChild<Form*>();
    }

private slots:
    void choosesByName()
    {
        ShopDialog dialog({});
        QCOMPARE(dialog.findChild<QTabWidget*>()->count(), 5);
        choose(dialog, "chuck", "stiff");
        choose(dialog, "tailstock", "");
        QCOMPARE(dialog.shop().choice.chuck, std::string("stiff"));
        const shop::Shop chosen = dialog.shop().shop();
        QCOMPARE(chosen.chuck.value.springs.radial_N_mm, 60000.0);
        QVERIFY(!chosen.tailstock);
        QVERIFY(chosen.chuck.is_assumed);
        QVERIFY(dialog.shop().own.chucks.empty());
    }

    /// A value that a person states is no longer assumed, and says of whom it is.
    void aChangedEntryIsTheShopsOwn()
    {
        ShopDialog dialog({});
        emit formOf(dialog, "lathe")->valueChanged("max_rpm", 4200.0, 1);
        QCOMPARE(dialog.shop().own.lathes.size(), std::size_t{1});
        const shop::Shop chosen = dialog.shop().shop();
        QCOMPARE(chosen.lathe.value.max_rpm, 4200.0);
        QVERIFY(!chosen.lathe.is_assumed);
        QVERIFY(!chosen.lathe.source.empty());
        auto* source = dialog.findChild<QLineEdit*>("source_lathe");
        QTest::keyClick(source, Qt::Key_End);
        QTest::keyClicks(source, ", name plate");
        QVERIFY(dialog.shop().shop().lathe.source.ends_with(", name plate"));
        emit formOf(dialog, "lathe")->valueChanged("max_rpm", -5.0, 2);  // out of its range: not taken
        QCOMPARE(dialog.shop().shop().lathe.value.max_rpm, 4200.0);
    }

    void ownEntriesComeAndGo()
    {
        ShopDialog dialog({});
        auto* page = dialog.findChild<QWidget*>("page_material");
        QPushButton *add = nullptr, *remove = nullptr;
        for (QPushButton* button : page->findChildren<QPushButton*>()) {
            if (button->text() == "New") add = button;
            if (button->text() == "Remove") remove = button;
        }
        QVERIFY(add && remove && !remove->isEnabled());
        add->click();
        QCOMPARE(dialog.shop().own.materials.size(), std::size_t{1});
        QCOMPARE(dialog.shop().choice.material, dialog.shop().own.materials.front().key);
        QVERIFY(remove->isEnabled());
        remove->click();
        QVERIFY(dialog.shop().own.materials.empty());
        QVERIFY(!dialog.shop().shop().material.key.empty());
    }

    void readsWhatItWrote()
    {
        QTemporaryDir folder;
        ShopDialog first({});
        choose(first, "material", "42crmo4");
        emit formOf(first, "chuck")->valueChanged("grip_length_mm", 31.0, 1);
        const std::string path = folder.filePath("SHOP.json").toStdString();
        io::writeFile(path, shop::shopText(first.shop()));
        ShopDialog second({});
        second.read(QString::fromStdString(path));
        QCOMPARE(second.shop().choice.material, std::string("42crmo4"));
        QCOMPARE(second.shop().shop().chuck.value.grip_length_mm, 31.0);
        QCOMPARE(shop::shopText(second.shop()), shop::shopText(first.shop()));
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::ShopDialogTest)
#include "shop_dialog_test.moc"
