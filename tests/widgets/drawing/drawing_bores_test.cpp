// Bores in the panel "Drawing": typed in the table and on the sheet, changed by their menu, refused, no room for more.
#include <QFile>
#include <QLocale>
#include <QMenu>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "engine/io/shaft/shaft_file.h"
#include "tests/widgets/core/drop_files.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/core/resources.h"
#include "widgets/drawing/drawing_panel.h"
#include "widgets/drawing/drawing_views.h"

namespace lathelier::drawing_panel {

/// A stepped shaft with a chamfer and a bore from the chuck.
Shaft samplePart()
{
    Shaft shaft;
    shaft.name = "pin";
    shaft.segments = {{2, 26, 30, 0, {}, "chamfer"}, {60, 30, 30, 0, {}, ""}, {40, 45, 45, 0, {}, ""}};
    shaft.material = Material{};
    shaft.bores = {{ShaftEnd::Chuck, {{25, 20, 20, {}, ""}}}};
    return shaft;
}

class DrawingBoresTest : public QObject, PanelFixture<DrawingPanel> {
    Q_OBJECT

    QTemporaryDir folder_;
    QString file_;

    bool says(const std::string& text) const
    {
        for (const drawing::Label& label : panel_->views().drawing().labels)
            if (label.text.find(text) != std::string::npos) return true;
        return false;
    }
    const ShaftRows& rows() const { return panel_->result()->shaft.segments; }
    int labelOf(const QString& text) const
    {
        const auto& labels = panel_->views().drawing().labels;
        for (std::size_t i = 0; i < labels.size(); ++i)
            if (labels[i].text == text.toStdString()) return static_cast<int>(i);
        return -1;
    }

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        file_ = folder_.filePath("pin.json");
        QFile file(file_);
        if (file.open(QIODevice::WriteOnly)) file.write(QByteArray::fromStdString(io::shaftText(samplePart())));
    }
    void init() { begin(); }
    void cleanup() { end(); }

    void boresAreEditedAsRowsAre()
    {
        drop(panel_.get(), {file_});
        settle();
        const auto bores = [&]() -> const ShaftBores& { return panel_->result()->shaft.bores; };
        auto* table = panel_->views().rows();
        QCOMPARE(bores().size(), std::size_t{1});
        const int outside = static_cast<int>(rows().size());
        QCOMPARE(table->item(outside, 0)->text(), QString("B1.1"));
        // A cell typed in: its diameter.
        table->item(outside, 5)->setText("18");
        QTRY_COMPARE(bores()[0].segments[0].start_diameter_mm, 18.0);
        settle();
        QCOMPARE(bores()[0].segments[0].end_diameter_mm, 18.0);
        QVERIFY(says("⌀18"));
        table->item(outside, 4)->setText("22.5");
        QTRY_COMPARE(bores()[0].segments[0].length_mm, 22.5);
        settle();
        // A row behind it, made a cone, and deleted again.
        const auto pick = [&](const QString& text) {
            QMenu menu;
            panel_->views().addBoreVerbs(menu, outside);
            for (QAction* action : menu.findChildren<QAction*>())
                if (action->text() == text) return action->trigger();
            for (QMenu* sub : menu.findChildren<QMenu*>())
                for (QAction* action : sub->actions())
                    if (action->text() == text) return action->trigger();
            QFAIL("no such verb");
        };
        pick("Add a row behind it");
        QTRY_COMPARE(bores()[0].segments.size(), std::size_t{2});
        settle();
        pick("Chamfer");
        QTRY_COMPARE(bores()[0].segments[0].role, std::string("chamfer"));
        settle();
        session_->undoStack().undo();
        settle();
        pick("Delete");
        QTRY_COMPARE(bores()[0].segments.size(), std::size_t{1});
        settle();
        // On the sheet: the depth under a double click.
        const int depth = labelOf("22.5");
        QVERIFY(depth >= 0);
        emit panel_->views().sheet()->dimensionActivated(depth);
        QCOMPARE(panel_->views().sheet()->field()->text(), QString("22.5"));
        emit panel_->views().sheet()->dimensionTyped(depth, "30");
        QTRY_COMPARE(bores()[0].segments[0].length_mm, 30.0);
        settle();
        // From the other end, and all of it taken back.
        panel_->views().addBore(ShaftEnd::Free);
        QTRY_COMPARE(bores().size(), std::size_t{2});
        settle();
        while (session_->undoStack().index() > 1) session_->undoStack().undo();
        settle();
        QCOMPARE(bores().size(), std::size_t{1});
        QCOMPARE(bores()[0].segments[0].start_diameter_mm, 20.0);
    }

    void aBoreThatCannotBeIsRefused()
    {
        drop(panel_.get(), {file_});
        settle();
        auto* table = panel_->views().rows();
        const int outside = static_cast<int>(rows().size());
        const int steps = session_->undoStack().count();
        table->item(outside, 5)->setText("60");  // wider than the part
        QTRY_COMPARE(table->item(outside, 5)->text(), QString("20.000"));
        QCOMPARE(session_->undoStack().count(), steps);
    }

    void withoutRoomThereIsNoneToAdd()
    {
        drop(panel_.get(), {file_});
        settle();
        auto* add = panel_->findChild<QToolButton*>("addBore");
        QVERIFY(add->isEnabled());
        panel_->views().rows()->item(static_cast<int>(rows().size()), 4)->setText("102");  // through the whole part
        QTRY_COMPARE(panel_->result()->shaft.bores[0].segments[0].length_mm, 102.0);
        settle();
        QVERIFY(!add->isEnabled());
        session_->undoStack().undo();
        settle();
        QVERIFY(add->isEnabled());
    }
};

}  // namespace lathelier::drawing_panel

QTEST_MAIN(lathelier::drawing_panel::DrawingBoresTest)
#include "drawing_bores_test.moc"
