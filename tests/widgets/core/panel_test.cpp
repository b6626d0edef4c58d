// Panel<Result> driven as a user does: drop, type, cancel, undo.
#include <QDragEnterEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "engine/project/parts.h"
#include "tests/widgets/core/fake_panel.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/resources.h"

namespace lathelier {

class PanelTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<FakePanel> panel_;

    QString makeFile(const QString& name, int size)
    {
        QFile file(folder_.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write(QByteArray(size, 'x'));
        return file.fileName();
    }
    template <class T>
    T* find(const char* name) const
    {
        return panel_->findChild<T*>(name);
    }
    QString label(const char* name) const { return find<QLabel>(name)->text(); }
    void drop(const QStringList& paths)
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
        data.setUrls(urls);
        QDragEnterEvent enter(QPoint(600, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(panel_.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(600, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(panel_.get(), &event);
    }
    void type(const char* field, const QString& text)
    {
        auto* edit = find<QLineEdit>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }

private slots:
    void initTestCase() { useResources(); }

    void panelsThatShareAStateFollowEachOther()
    {
        FakePanel other(*session_, "other", "fake");
        other.show();
        drop({makeFile("shared.txt", 30)});
        QTRY_VERIFY(panel_->isCurrent() && other.isCurrent());
        QCOMPARE(other.shown(), QString("60"));
        QCOMPARE(session_->project().panels.size(), std::size_t{1});
        session_->edit("endless", [](project::Project& project) {
            lathelier::set(project.panels["fake"].parameters, "endless", true);
        });
        QTRY_VERIFY(panel_->isBusy() && other.isBusy());
        other.cancel();
        QTRY_VERIFY(!panel_->isBusy() && !other.isBusy());
        QVERIFY(!panel_->isCurrent());  // what is shown is not what was asked for
        session_->undoStack().undo();
        QTRY_VERIFY(panel_->isCurrent() && other.isCurrent());
    }
    void init()
    {
        session_ = std::make_unique<Session>();
        panel_ = std::make_unique<FakePanel>(*session_);
        panel_->resize(1000, 700);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    }
    void cleanup()
    {
        panel_.reset();
        session_.reset();
    }

    void newEvaluationsBeginWithTheUsersValues()
    {
        session_->setStartingValues({{"factor_mm", 5.0}, {"nobody_knows_it", true}});
        drop({makeFile("start.txt", 3)});
        QTRY_VERIFY(panel_->isCurrent());
        QCOMPARE(panel_->shown(), QString("15"));
        type("factor_mm", "4");
        QTRY_COMPARE(panel_->shown(), QString("12"));
        drop({makeFile("start2.txt", 2)});  // the evaluation has begun: what was chosen stays
        QTRY_COMPARE(panel_->shown(), QString("8"));
        session_->undoStack().setIndex(0);
        QVERIFY(session_->project().panels.empty());
    }

    void emptyStateInvites()
    {
        QVERIFY(find<QPushButton>("open")->isVisible());
        QSignalSpy sample(panel_.get(), &PanelBase::sampleRequested);
        QTest::mouseClick(find<QPushButton>("openSample"), Qt::LeftButton);
        QCOMPARE(sample.count(), 1);
        QVERIFY(!panel_->hasResult());
        QVERIFY(!find<QToolButton>("report")->isEnabled());
    }

    void droppedFileIsComputed()
    {
        drop({makeFile("a.txt", 21)});
        QTRY_VERIFY(panel_->isCurrent());
        QCOMPARE(panel_->shown(), QString("42"));
        QCOMPARE(label("headline"), QString("42\u00A0mm"));
        QVERIFY(label("notes").contains("Roll about the axis"));
        QVERIFY(find<QToolButton>("report")->isEnabled());
        QVERIFY(!find<QPushButton>("open")->isVisible());
    }

    void typingRecomputesAndUndoGoesBack()
    {
        drop({makeFile("a.txt", 10)});
        QTRY_COMPARE(panel_->shown(), QString("20"));
        type("factor_mm", "3");
        QTRY_COMPARE(panel_->shown(), QString("30"));
        type("factor_mm", "3,5");  // a comma is taken whatever the locale
        QTRY_COMPARE(panel_->shown(), QString("35"));
        session_->undoStack().undo();
        QTRY_COMPARE(panel_->shown(), QString("30"));
        QCOMPARE(find<QLineEdit>("factor_mm")->text(), QString("3"));
        session_->undoStack().undo();
        QTRY_COMPARE(panel_->shown(), QString("20"));
        session_->undoStack().undo();
        QTRY_VERIFY(!panel_->hasResult());
        QVERIFY(find<QPushButton>("open")->isVisible());
        session_->undoStack().redo();
        QTRY_COMPARE(panel_->shown(), QString("20"));
    }

    void verdictIsAWordAndASymbol()
    {
        drop({makeFile("a.txt", 1)});
        QTRY_VERIFY(panel_->isCurrent());
        QCOMPARE(label("verdict"), QString("no limit given"));
        type("tolerance_mm", "1");
        QTRY_VERIFY(label("verdict").contains(QString::fromUtf8("✗ out of tolerance")));
        type("tolerance_mm", "5");
        QTRY_VERIFY(label("verdict").contains(QString::fromUtf8("✓ within tolerance")));
        auto* tolerance = find<QLineEdit>("tolerance_mm");
        tolerance->setFocus();
        tolerance->selectAll();
        QTest::keyClick(tolerance, Qt::Key_Delete);
        QTest::keyClick(tolerance, Qt::Key_Return);
        QTRY_COMPARE(label("verdict"), QString("no limit given"));
    }

    void outOfRangeIsMarkedAndNotComputed()
    {
        drop({makeFile("a.txt", 10)});
        QTRY_COMPARE(panel_->shown(), QString("20"));
        const int before = panel_->computed();
        type("factor_mm", "1000");
        QVERIFY(find<QLineEdit>("factor_mm")->toolTip().contains("from 0 to 100"));
        QTest::qWait(100);
        QCOMPARE(panel_->computed(), before);
        QCOMPARE(panel_->shown(), QString("20"));
    }

    void cancelStopsAndKeepsTheOldPicture()
    {
        drop({makeFile("a.txt", 10)});
        QTRY_COMPARE(panel_->shown(), QString("20"));
        session_->edit("endless",
                       [](project::Project& project) { set(project.panels["fake"].parameters, "endless", true); });
        QTRY_VERIFY(find<QPushButton>("cancel")->isVisible());
        QTRY_COMPARE(label("phase"), QString("Multiplying"));
        QVERIFY(panel_->hasResult());  // dimmed
        QVERIFY(!panel_->isCurrent());
        QTest::mouseClick(find<QPushButton>("cancel"), Qt::LeftButton);
        QTRY_VERIFY(!panel_->isBusy());
        QCOMPARE(panel_->shown(), QString("20"));
        QVERIFY(!find<QPushButton>("cancel")->isVisible());
        QVERIFY(label("message").contains("Stopped"));
        session_->undoStack().undo();
        QTRY_VERIFY(panel_->isCurrent());
    }

    void newerInputOvertakesARunningJob()
    {
        session_->edit("endless",
                       [](project::Project& project) { set(project.panels["fake"].parameters, "endless", true); });
        drop({makeFile("a.txt", 10)});
        QTRY_COMPARE(panel_->computed(), 1);
        session_->edit("end",
                       [](project::Project& project) { set(project.panels["fake"].parameters, "endless", false); });
        QTRY_COMPARE(panel_->shown(), QString("20"));
    }

    void errorSaysWhatAndWhere()
    {
        QSignalSpy messages(panel_.get(), &PanelBase::messageRaised);
        drop({folder_.filePath("missing.txt")});
        QTRY_VERIFY(label("message").contains("missing.txt"));
        QVERIFY(label("message").contains("does not exist"));
        QCOMPARE(messages.count(), 1);
        QVERIFY(!session_->isModified());
        drop({makeFile("b.txt", 1)});
        QTRY_VERIFY(panel_->isCurrent());
        QVERIFY(label("message").isEmpty());
    }

    void aRefusedFileTakesNoPlace_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("word");
        QTest::newRow("not there") << "missing.txt"
                                   << "does not exist";
        QTest::newRow("no scan") << "a.dfq"
                                 << "expected Point clouds";
        QTest::newRow("found in reading") << "bad.txt"
                                          << "expected x";
    }
    void aRefusedFileTakesNoPlace()
    {
        QFETCH(QString, name);
        QFETCH(QString, word);
        QFile bad(folder_.filePath("bad.txt"));
        QVERIFY(bad.open(QIODevice::WriteOnly) && bad.write("bad") == 3);
        bad.close();
        makeFile("a.dfq", 5);
        drop({makeFile("a.txt", 10)});
        QTRY_VERIFY(panel_->isCurrent());
        const project::Project before = session_->project();
        QSignalSpy messages(panel_.get(), &PanelBase::messageRaised);
        drop({folder_.filePath(name)});
        QTRY_VERIFY2(label("message").contains(word), qPrintable(label("message")));
        QTRY_VERIFY(panel_->isCurrent());  // not dimmed
        QCOMPARE(panel_->shown(), QString("20"));
        QCOMPARE(session_->project(), before);
        QCOMPARE(session_->undoStack().count(), 1);
        QVERIFY(!session_->undoStack().canRedo());
        QCOMPARE(messages.count(), 1);
        emit find<InputBox>("input_file")->filesDropped({folder_.filePath(name)});  // likewise at its input
        QTRY_COMPARE(messages.count(), 2);
        QTRY_VERIFY(panel_->isCurrent());
        QCOMPARE(session_->project(), before);
        type("factor_mm", "3");
        QTRY_COMPARE(panel_->shown(), QString("30"));
        QVERIFY(label("message").isEmpty());
    }

    /// There is nothing to come back to: reading options may settle it.
    void aFileThatCannotBeReadStaysInAFreePlace()
    {
        QFile bad(folder_.filePath("bad.txt"));
        QVERIFY(bad.open(QIODevice::WriteOnly) && bad.write("bad") == 3);
        bad.close();
        drop({bad.fileName()});
        QTRY_VERIFY(panel_->error().has_value());
        QCOMPARE(session_->panel("fake").inputs.size(), std::size_t{1});
    }

    void anotherPartShowsNothingOfThisOne()
    {
        drop({makeFile("a.txt", 10)});
        QTRY_VERIFY(panel_->isCurrent());
        session_->edit("Add", [](project::Project& project) { project::addPart(project, "B"); });
        QVERIFY(!panel_->hasResult());  // at once
        QVERIFY(find<QPushButton>("open")->isVisible());
        QVERIFY(label("headline").isEmpty());
        QVERIFY(!panel_->reportDocument() && panel_->offeredExports().empty());
        drop({makeFile("b.txt", 7)});
        QTRY_COMPARE(panel_->shown(), QString("14"));
        session_->showPart(0);
        QVERIFY(!panel_->hasResult());  // of B, not even dimmed
        QTRY_VERIFY(panel_->isCurrent());
        QCOMPARE(panel_->shown(), QString("20"));
    }

    void fileCanBeTakenAway()
    {
        drop({makeFile("a.txt", 10)});
        QTRY_VERIFY(panel_->isCurrent());
        QTest::mouseClick(find<QToolButton>("clearInput"), Qt::LeftButton);
        QTRY_VERIFY(!panel_->hasResult());
        QVERIFY(label("headline").isEmpty());
        QVERIFY(find<QPushButton>("open")->isVisible());
    }

    void belongsToTheReportByOneClick()
    {
        drop({makeFile("a.txt", 10)});
        QTRY_VERIFY(panel_->isCurrent());
        QTest::mouseClick(find<QToolButton>("inReport"), Qt::LeftButton);
        QCOMPARE(session_->project().report, std::vector<std::string>{"fake"});
        session_->undoStack().undo();
        QVERIFY(session_->project().report.empty());
        QVERIFY(!find<QToolButton>("inReport")->isChecked());
        QCOMPARE(panel_->reportDocument()->sections.size(), std::size_t{1});
    }

    void everyControlHasANameAndIsReachedByKeyboard()
    {
        for (QWidget* widget : panel_->findChildren<QWidget*>()) {
            if (!qobject_cast<QAbstractButton*>(widget) && !qobject_cast<QLineEdit*>(widget)) continue;
            if (!widget->isVisible() || widget->parent() == find<QLineEdit>("tolerance_mm") ||
                qobject_cast<QLineEdit*>(widget->parentWidget()))
                continue;
            const auto* button = qobject_cast<QAbstractButton*>(widget);
            const QString name =
                widget->accessibleName().isEmpty() && button ? button->text() : widget->accessibleName();
            QVERIFY2(!name.isEmpty(), qPrintable(widget->objectName() + " " + widget->metaObject()->className()));
            QVERIFY2(widget->focusPolicy() & Qt::TabFocus, qPrintable(widget->objectName()));
        }
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::PanelTest)
#include "panel_test.moc"
