// The list of operations of the panel "Turning program": moved, impossible orders, switched off.
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>

#include "engine/cam/job_file.h"
#include "tests/engine/cam/plan_data.h"
#include "tests/widgets/core/drop_files.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/resources.h"
#include "widgets/program_common/program_editor.h"
#include "widgets/turning/turning_panel.h"
#include "widgets/turning/turning_views.h"

namespace lathelier::turning_panel {

using cam::OperationKind;

class TurningOperationsTest : public QObject, PanelFixture<TurningPanel> {
    Q_OBJECT

    QTemporaryDir folder_;
    QString groove_;

    QString write(const QString& name, const cam::Job& job) const
    {
        const QString path = folder_.filePath(name);
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) file.write(QByteArray::fromStdString(cam::jobText(job)));
        return path;
    }
    void open(const QString& path)
    {
        drop(panel_.get(), {path});
        settle();
    }
    void openOne(const QString& path)
    {
        open(path);
        set("setups", std::string("1"));
        settle();
    }
    const cam::TurningPlan& plan() const { return *panel_->result()->plan; }
    TurningViews& views() const { return panel_->views(); }
    /// Row of the first operation of this kind.
    int rowOf(OperationKind kind) const
    {
        const auto rows = listedOperations(*panel_->result(), 0);
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&](const cam::ListedOperation& each) { return each.which.kind == kind; });
        return row == rows.end() ? -1 : static_cast<int>(row - rows.begin());
    }
    /// As somebody types it: another text in the editor, announced.
    void type(const QByteArray& text)
    {
        views().editor()->selectAll();
        views().editor()->replaceSelectedText(QString::fromUtf8(text));
        views().editor()->takeOver();
        settle();
    }
    QByteArray typed() const { return views().editor()->program(); }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        groove_ = write("groove.json", cam::paperJob({cam::roughC80(), cam::finishC80(), cam::backV35(),
                                                      cam::blade(8, cam::ToolUse::Groove, 3, 0.2, 20)}));
    }
    void init() { begin(); }
    void cleanup() { end(); }

    void anOperationIsMovedAndPutBack()
    {
        openOne(groove_);
        const int finish = rowOf(OperationKind::Finish), groove = rowOf(OperationKind::Groove);
        QVERIFY(finish >= 0 && groove > finish);
        QVERIFY(!views().order()->reset()->isEnabled());
        const int steps = session_->undoStack().count();
        views().operations()->setCurrentCell(groove, 0);
        int moves = 0;
        while (rowOf(OperationKind::Groove) > rowOf(OperationKind::Finish) && moves < 5) {
            QVERIFY(views().order()->up()->isEnabled());
            views().order()->up()->click();
            ++moves;
            settle();
            QVERIFY(views().order()->refusalText().isEmpty());
            // What was moved stays chosen, so that the next click moves it on.
            QCOMPARE(views().operations()->currentRow(), rowOf(OperationKind::Groove));
        }
        QVERIFY(rowOf(OperationKind::Groove) < rowOf(OperationKind::Finish));
        QCOMPARE(session_->undoStack().count(), steps + moves);
        const auto& text = plan().setups[0].text;
        QVERIFY(!text.empty() && !plan().is_refused);
        QVERIFY(views().order()->reset()->isEnabled());
        views().order()->reset()->click();
        settle();
        QCOMPARE(rowOf(OperationKind::Finish), finish);
        QVERIFY(plan().parameters.order.empty());
        session_->undoStack().undo();
        settle();
        QVERIFY(rowOf(OperationKind::Groove) < rowOf(OperationKind::Finish));
    }

    void deepPassesMoveWithTheirFinish()
    {
        open(write("deep.json",
                   cam::jobWith({cam::row(20, 34, 34), cam::row(8, 34, 22), cam::row(25, 22, 22), cam::row(10, 36, 36)},
                                40, 100, {cam::roughC80(), cam::finishD55()})));
        set("setups", std::string("1"));
        settle();
        const auto rows = listedOperations(*panel_->result(), 0);
        const auto is_deep = [](const cam::ListedOperation& each) {
            return each.which.kind == OperationKind::SemiFinish && each.which.tool == 3;
        };
        QVERIFY(std::any_of(rows.begin(), rows.end(), is_deep));
        const auto steps = stepsOf(*panel_->result(), 0);
        QVERIFY(std::none_of(steps.begin(), steps.end(), [](const cam::OperationStep& step) {
            return step.kind == OperationKind::SemiFinish && step.tool == 3;
        }));
        QVERIFY(steps.size() + 1 == rows.size());
    }

    void anOperationWhoseLineIsGoneStaysOn()
    {
        openOne(groove_);
        const int row = rowOf(OperationKind::Finish);
        const int steps = session_->undoStack().count();
        QString text = QString::fromUtf8(typed());
        const std::int64_t line = plan().setups[0].operations[static_cast<std::size_t>(row)].first_line;
        QStringList lines = text.split('\n');
        lines[static_cast<int>(line) - 1] = "(GONE)";
        type(lines.join('\n').toUtf8());
        QCOMPARE(session_->undoStack().count(), steps + 1);
        QCOMPARE(plan().setups[0].operations[static_cast<std::size_t>(row)].first_line, std::int64_t{0});
        QTableWidgetItem* box = views().operations()->item(row, 0);
        QCOMPARE(box->checkState(), Qt::Checked);
        box->setCheckState(Qt::Unchecked);
        settle();
        QCOMPARE(plan().parameters.skipped.size(), std::size_t{1});
    }

    void anImpossibleOrderSaysWhyAndChangesNothing()
    {
        openOne(groove_);
        const int steps = session_->undoStack().count();
        views().operations()->setCurrentCell(rowOf(OperationKind::Finish), 0);
        views().order()->up()->click();  // before the semi-finish
        QVERIFY(views().order()->refusalText().contains("cannot run before"));
        QVERIFY(panel_->findChild<QLabel*>("operationsSaid")->isVisibleTo(views().order()));
        QCOMPARE(session_->undoStack().count(), steps);
        // Dragged to the first place by its number: before roughing.
        views().order()->moveStep(rowOf(OperationKind::Finish), 0);
        QVERIFY(views().order()->refusalText().contains("cannot run before"));
        QCOMPARE(session_->undoStack().count(), steps);
        QVERIFY(plan().parameters.order.empty());
    }
};

}  // namespace lathelier::turning_panel

QTEST_MAIN(lathelier::turning_panel::TurningOperationsTest)
#include "turning_operations_test.moc"
