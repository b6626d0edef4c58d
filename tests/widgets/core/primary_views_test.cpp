// One view large, the others small: clicks and keys swap, narrow windows get tabs, presenting shows one at a time.
#include <QLabel>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>

#include "widgets/core/panel/flow_row.h"
#include "widgets/core/panel/primary_views.h"

namespace lathelier {

class PrimaryViewsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<PrimaryViews> views_;
    std::array<QLabel*, 3> labels_{};

private slots:
    void init()
    {
        views_ = std::make_unique<PrimaryViews>();
        const char* keys[] = {"part", "map", "table"};
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            labels_[i] = new QLabel(keys[i]);
            views_->add(keys[i], labels_[i]);
            views_->setTitle(keys[i], QString(keys[i]).toUpper());
        }
        views_->resize(1400, 800);
        views_->show();
        QVERIFY(QTest::qWaitForWindowExposed(views_.get()));
    }
    void cleanup() { views_.reset(); }

    void theFirstIsLarge()
    {
        QCOMPARE(views_->primary(), QString("part"));
        QVERIFY(labels_[0]->width() > 2 * labels_[1]->width());
        QVERIFY(labels_[1]->isVisible() && labels_[2]->isVisible());
        QVERIFY(labels_[1]->height() < labels_[0]->height());
    }

    void smallViewsAreToldThatTheyAre()
    {
        for (QLabel* label : labels_) label->setProperty("smallView", false);
        labels_[2]->setProperty("smallView", QVariant());  // does not care
        views_->setPrimary("map");
        QCOMPARE(labels_[0]->property("smallView").toBool(), true);
        QCOMPARE(labels_[1]->property("smallView").toBool(), false);
        QVERIFY(!labels_[2]->property("smallView").isValid());
        views_->setPrimary("part");
        QCOMPARE(labels_[0]->property("smallView").toBool(), false);
    }

    /// Two large views and the rest small; one above the other where there is no room beside.
    void aViewStandsBesideTheLargeOne()
    {
        views_->setPrimary("map");
        views_->setBeside("table");
        const auto frame = [this](std::size_t i) { return labels_[i]->parentWidget()->geometry(); };
        QCOMPARE(frame(2).top(), frame(1).top());
        QVERIFY(frame(2).right() < frame(1).left());
        QVERIFY(std::abs(frame(2).width() - frame(1).width()) <= 1);
        QVERIFY(frame(0).width() < frame(1).width());
        QVERIFY(labels_[0]->isVisible());
        views_->setAvailable("part", false);  // nothing is left for the strip
        QCOMPARE(frame(1).right(), views_->width() - 1);
        views_->setAvailable("part", true);
        views_->resize(500, 800);
        QVERIFY(labels_[2]->isVisible() && labels_[1]->isVisible() && !labels_[0]->isVisible());
        QVERIFY(frame(2).bottom() < frame(1).top());
        views_->setPresenting(true);  // one at a time
        QVERIFY(!labels_[2]->isVisible() && labels_[1]->isVisible());
        views_->setPresenting(false);
        views_->setBeside({});
        QVERIFY(!labels_[2]->isVisible());
    }

    void aBarTakesASecondRowWhereTheFirstIsTooNarrow()
    {
        QWidget bar;
        auto* row = new FlowRow(&bar);
        std::vector<QWidget*> buttons;
        for (int i = 0; i < 4; ++i) {
            auto* button = new QLabel(QString(20, 'x'));
            row->addWidget(button);
            buttons.push_back(button);
        }
        auto* last = new QLabel("at the right");
        row->setTrailing(last);
        const int one = buttons[0]->sizeHint().width();
        bar.resize(6 * one, 100);
        bar.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bar));
        for (const QWidget* button : buttons) QCOMPARE(button->y(), buttons[0]->y());
        QCOMPARE(last->geometry().right(), bar.width() - 1);
        const int flat = row->heightForWidth(bar.width());
        QVERIFY(row->minimumSize().width() <= one);
        bar.resize(5 * one / 2, 100);
        QCoreApplication::processEvents();
        QVERIFY(buttons[2]->y() > buttons[1]->y());
        QVERIFY(row->heightForWidth(bar.width()) > flat);
        buttons[0]->hide();  // takes no room
        QCoreApplication::processEvents();
        QCOMPARE(buttons[2]->y(), buttons[1]->y());
        for (const QWidget* button : buttons) QVERIFY(button->geometry().right() < bar.width());
    }

    void aClickSwapsAndTellsIt()
    {
        QSignalSpy changed(views_.get(), &PrimaryViews::primaryChanged);
        QTest::mouseClick(views_->findChild<QWidget*>("cover_map"), Qt::LeftButton);
        QCOMPARE(views_->primary(), QString("map"));
        QCOMPARE(changed.count(), 1);
        QVERIFY(labels_[1]->width() > 2 * labels_[0]->width());
        QVERIFY(!views_->findChild<QWidget*>("cover_map")->isVisible());
        QVERIFY(views_->findChild<QWidget*>("cover_part")->isVisible());
        QTest::keyClick(views_.get(), Qt::Key_3);
        QCOMPARE(views_->primary(), QString("table"));
        views_->setPrimary("no such view");
        QCOMPARE(views_->primary(), QString("table"));
    }

    void aDoubleClickOnACaptionShowsAll()
    {
        QTest::mouseDClick(views_->findChild<QWidget*>("caption_part"), Qt::LeftButton);
        QVERIFY(views_->showsAll());
        QVERIFY(std::abs(labels_[0]->width() - labels_[1]->width()) < 4);
        QTest::mouseDClick(views_->findChild<QWidget*>("caption_part"), Qt::LeftButton);
        QVERIFY(!views_->showsAll());
    }

    void littleRoomMakesTabs()
    {
        views_->resize(500, 400);
        auto* tabs = views_->findChild<QTabBar*>();
        QTRY_VERIFY(tabs->isVisible());
        QCOMPARE(tabs->count(), 3);
        QCOMPARE(tabs->tabText(1), QString("MAP"));
        QVERIFY(labels_[0]->isVisible() && !labels_[1]->isVisible());
        QCOMPARE(labels_[0]->width(), 500);
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(2).center());
        QCOMPARE(views_->primary(), QString("table"));
        QVERIFY(labels_[2]->isVisible() && !labels_[0]->isVisible());
    }

    void aViewWithNothingToShowTakesNoRoom()
    {
        views_->setPrimary("map");
        views_->setAvailable("map", false);
        QCOMPARE(views_->primary(), QString("part"));
        QCOMPARE(views_->keys(), QStringList({"part", "table"}));
        QVERIFY(!labels_[1]->isVisible());
    }

    void presentingGoesThroughAllByArrows()
    {
        views_->setPresenting(true);
        QCOMPARE(labels_[0]->size(), views_->size());
        QVERIFY(!labels_[1]->isVisible());
        QTest::keyClick(views_.get(), Qt::Key_Right);
        QCOMPARE(views_->primary(), QString("map"));
        QTest::keyClick(views_.get(), Qt::Key_Left);
        QTest::keyClick(views_.get(), Qt::Key_Left);
        QCOMPARE(views_->primary(), QString("table"));
        views_->setPresenting(false);
        QVERIFY(labels_[0]->isVisible() && labels_[1]->isVisible());
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::PrimaryViewsTest)
#include "primary_views_test.moc"
