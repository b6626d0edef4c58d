// The views of a drawing, linked: the sheet, its meridian with shoulders to drag, the table of its rows, what was
// measured beside nominal sizes, and what there is to remark. A row pointed at in one is lit in all, and can be edited
// in all.
#pragma once

#include <QToolButton>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "engine/core/bore_edit.h"
#include "engine/core/shaft_sizes.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/drawing/drawing_picture.h"
#include "widgets/drawing/sheet_view.h"
#include "widgets/part_common/row_chart.h"
#include "widgets/part_common/row_menu.h"

namespace lathelier::drawing_panel {

/// What becomes of the rows of the outside; throws Error where that cannot be.
using RowsChange = std::function<ShaftRows(ShaftRows)>;

/// The same of the bores.
using BoresChange = std::function<ShaftBores(ShaftBores)>;

/// A row of a bore.
struct BorePlace {
    std::size_t bore = 0;  ///< of Shaft::bores
    std::size_t row = 0;   ///< from the mouth
    QString name;          ///< "B1.2"
};

class DrawingViews : public QWidget {
    Q_OBJECT

public:
    explicit DrawingViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const DrawingPicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    SheetView* sheet() const { return sheet_; }
    plot::ChartView* meridian() const { return meridian_; }
    const drawing::Drawing& drawing() const { return drawing_; }  ///< on the sheet
    void setPresenting(bool presenting);                          ///< without the buttons
    void retranslate();

    void markRow(std::optional<std::size_t> row);            ///< index into Shaft::segments
    std::optional<std::size_t> row() const { return row_; }  ///< that is lit
    CopyTable* rows() const { return rows_; }
    /// Adds what can be done with a row of a bore, in the table's row `at`.
    void addBoreVerbs(QMenu& menu, int at);
    double freeForBores_mm() const;
    void showBoreButton();
    void addBore(ShaftEnd from);                     ///< or a row more to the one that is there
    void markStretch(double from_mm, double to_mm);  ///< of z: the row in its middle
    /// What can be done with a row; `z_mm`: where it is cut.
    part_common::RowVerbs verbsOf(std::size_t row, std::optional<double> z_mm = {});

signals:
    void shaftWanted();  ///< keep it in the project
    /// One undo step; those with the same key, which is not empty, are one.
    void editWanted(const QString& step, const lathelier::drawing_panel::RowsChange& change, const QString& merge_key);
    void boresEditWanted(const QString& step, const lathelier::drawing_panel::BoresChange& change);  ///< one undo step
    void notWritten(const QString& path);  ///< the system refused to write this file

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show();
    void showMark();
    void pickAt(double z_mm);
    void edit(const QString& step, const RowsChange& change) { emit editWanted(step, change, {}); }
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

    std::shared_ptr<const DrawingPicture> picture_;
    drawing::Drawing drawing_;
    std::optional<std::size_t> row_;
    std::optional<ShaftRows> dragged_;  ///< rows as they were when the shoulder was taken
    int drags_ = 0;                     ///< so far: one undo step each
    HeroViews* heroes_;
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
