// The views of a drawing, linked: the sheet, its meridian with draggable shoulders, the table of its rows, measured
// beside nominal sizes, and the remarks. A row selected in one is highlighted in all, and can be edited in all.
#pragma once

#include <QToolButton>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "engine/cad/task/draw_task.h"
#include "engine/shaft/bore_edit.h"
#include "engine/shaft/shaft_sizes.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/drawing/sheet_view.h"
#include "widgets/part_common/row_chart.h"
#include "widgets/part_common/row_menu.h"

namespace lathelier::drawing_panel {

/// Edit of the rows of the outside; throws Error when it is not possible.
using RowsChange = std::function<ShaftRows(ShaftRows)>;

/// The same of the bores.
using BoresChange = std::function<ShaftBores(ShaftBores)>;

/// A row of a bore.
struct BorePlace {
    std::size_t bore = 0;  ///< index into Shaft::bores
    std::size_t row = 0;   ///< index from the mouth
    QString name;          ///< display name, "B1.2"
};

class DrawingViews : public QWidget {
    Q_OBJECT

public:
    explicit DrawingViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const cad::DrawOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    SheetView* sheet() const { return sheet_; }
    plot::ChartView* meridian() const { return meridian_; }
    const drawing::Drawing& drawing() const { return drawing_; }  ///< drawing on the sheet
    void setPresenting(bool presenting);                          ///< without the buttons
    void retranslate();

    void markRow(std::optional<std::size_t> row);            ///< index into Shaft::segments
    std::optional<std::size_t> row() const { return row_; }  ///< highlighted row
    CopyTable* rows() const { return rows_; }
    /// Adds the commands of a bore's row, in the table's row `at`.
    void addBoreVerbs(QMenu& menu, int at);
    double freeForBores_mm() const;
    void showBoreButton();
    void addBore(ShaftEnd from);                     ///< adds a bore, or a further row to an existing one
    void markStretch(double from_mm, double to_mm);  ///< highlights the row at the middle of the interval
    /// Commands of a row; `z_mm`: position of a split.
    part_common::RowVerbs verbsOf(std::size_t row, std::optional<double> z_mm = {});

signals:
    void shaftRequested();  ///< request to store the shaft in the project
    /// One undo step; edits with an equal non-empty key are merged.
    void editRequested(const QString& step, const lathelier::drawing_panel::RowsChange& change,
                       const QString& merge_key);
    /// request for an edit, one undo step
    void boresEditRequested(const QString& step, const lathelier::drawing_panel::BoresChange& change);
    void notWritten(const QString& path);  ///< the system refused to write this file

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show();
    void showMark();
    void pickAt(double z_mm);
    void edit(const QString& step, const RowsChange& change) { emit editRequested(step, change, {}); }
    void typeDimension(int label, const QString& text);
    void dragShoulder(const QString& key, double z_mm, bool dropped);
    void pressKey(QKeyEvent* event);
    void openTableMenu(int row, const QPoint& global);
    void typeBore(const drawing::DimensionTarget& target, const QString& text);
    void typeBoreCell(const QTableWidgetItem& cell);
    void openBoreCells();
    void deleteBore(const BorePlace& place);
    std::optional<BorePlace> boreAt(int row) const;
    KeepAfter keep() const;

    std::shared_ptr<const cad::DrawOutcome> outcome_;
    drawing::Drawing drawing_;
    std::optional<std::size_t> row_;
    std::optional<ShaftRows> dragged_;  ///< rows at the start of the drag
    int drags_ = 0;                     ///< number of drags, one undo step each
    PrimaryViews* primaryViews_;
    SheetView* sheet_;
    part_common::RowChart* meridian_;
    CopyTable* rows_;
    CopyTable* measured_;
    CopyTable* remarks_;
    QWidget* buttons_;
    QToolButton* shaft_;
    QToolButton* fit_;
    QToolButton* bore_;
};

}  // namespace lathelier::drawing_panel
