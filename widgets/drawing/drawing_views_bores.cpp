// Bores in the views of a drawing: rows of the table that are typed in, their menu, and their dimensions on the sheet.
#include <QSignalBlocker>
#include <cmath>

#include "widgets/core/language.h"
#include "widgets/drawing/dimension_edit.h"
#include "widgets/drawing/drawing_views.h"

namespace lathelier::drawing_panel {
namespace {

constexpr int lengthColumn = 4, startColumn = 5, endColumn = 6;  // columns of rowsTable()
constexpr double leastFreeLength_mm = 1;                         // least unbored length for a new bore
constexpr double newBoreDiameterShare = 0.4, newBoreDepthShare = 1.0 / 3;

}  // namespace

/// Rows of bores follow those of the outside.
std::optional<BorePlace> DrawingViews::boreAt(int row) const
{
    if (!outcome_ || row < 0) return std::nullopt;
    auto index = static_cast<std::size_t>(row);
    if (index < outcome_->shaft.segments.size()) return std::nullopt;
    index -= outcome_->shaft.segments.size();
    const ShaftBores& bores = outcome_->shaft.bores;
    for (std::size_t bore = 0; bore < bores.size(); ++bore) {
        if (index < bores[bore].segments.size())
            return BorePlace{bore, index, QString("B%1.%2").arg(bore + 1).arg(index + 1)};
        index -= bores[bore].segments.size();
    }
    return std::nullopt;
}

void DrawingViews::openBoreCells()
{
    for (int row = 0; row < rows_->rowCount(); ++row)
        for (const int column : {lengthColumn, startColumn, endColumn})
            if (QTableWidgetItem* cell = rows_->item(row, column); cell && boreAt(row))
                cell->setFlags(cell->flags() | Qt::ItemIsEditable);
}

void DrawingViews::typeBoreCell(const QTableWidgetItem& cell)
{
    const auto place = boreAt(cell.row());
    if (!place) return;
    const std::optional<double> typed = typedNumber(cell.text());
    const double value = typed.value_or(0) / screenFactor(millimetre);
    const int column = cell.column();
    // A rejected value is restored after the cell editor is closed.
    QMetaObject::invokeMethod(
        this, [this] { show(); }, Qt::QueuedConnection);
    if (!typed) return;
    const BorePlace& at = *place;
    emit boresEditRequested(tr("Change row %1").arg(at.name), [=](ShaftBores bores) {
        BoreSegment& row = bores.at(at.bore).segments.at(at.row);
        const bool is_cylinder = !row.arc_radius_mm && row.start_diameter_mm == row.end_diameter_mm;
        if (column == lengthColumn)
            row.length_mm = value;
        else if (column == startColumn || is_cylinder)
            row.start_diameter_mm = value;
        if (column == endColumn || (column == startColumn && is_cylinder)) row.end_diameter_mm = value;
        return bores;
    });
}

void DrawingViews::deleteBore(const BorePlace& place)
{
    emit boresEditRequested(tr("Delete row %1").arg(place.name), [place](ShaftBores bores) {
        return deleteBoreRow(std::move(bores), place.bore, place.row);
    });
}

void DrawingViews::addBoreVerbs(QMenu& menu, int at)
{
    const auto found = boreAt(at);
    if (!found) return;
    const BorePlace& place = *found;
    menu.addSection(tr("Row %1").arg(place.name));
    menu.addAction(tr("Delete"), this, [this, place] { deleteBore(place); })->setShortcut(QKeySequence::Delete);
    menu.addAction(tr("Add a row behind it"), this, [this, place] {
        emit boresEditRequested(tr("Add a row behind %1").arg(place.name), [place](ShaftBores bores) {
            return insertBoreRow(std::move(bores), place.bore, place.row);
        });
    });
    QMenu* const kinds = menu.addMenu(tr("Change its kind"));
    for (const RowForm form :
         {RowForm::Cylinder, RowForm::Cone, RowForm::Chamfer, RowForm::Round, RowForm::Fillet, RowForm::Groove})
        kinds->addAction(part_common::formName(form), this, [this, place, form] {
            emit boresEditRequested(tr("Make row %1 a %2").arg(place.name, part_common::formName(form).toLower()),
                                    [place, form](ShaftBores bores) {
                                        return changeBoreForm(std::move(bores), place.bore, place.row, form);
                                    });
        });
}

/// Length of the part that is not bored.
double DrawingViews::freeForBores_mm() const
{
    if (!outcome_ || outcome_->shaft.segments.empty()) return 0;
    double free_mm = outcome_->shaft.length_mm();
    for (const ShaftBore& bore : outcome_->shaft.bores)
        for (const BoreSegment& row : bore.segments) free_mm -= row.length_mm;
    return free_mm;
}

void DrawingViews::showBoreButton()
{
    const bool has_room = freeForBores_mm() >= leastFreeLength_mm;
    bore_->setEnabled(has_room);
    bore_->setToolTip(has_room || !outcome_
                          ? tr("A cylinder from this end, or one more behind the last one. Its row in the table is "
                               "changed by a double click, its kind and its place by the right button.")
                          : tr("The bores already run through the whole part"));
}

/// Two fifths of the diameter of its end, a third of the part deep; initial values.
void DrawingViews::addBore(ShaftEnd from)
{
    if (!outcome_ || outcome_->shaft.segments.empty()) return;
    const ShaftRows& rows = outcome_->shaft.segments;
    double outside_mm = from == ShaftEnd::Free ? rows.front().start_diameter_mm : rows.back().end_diameter_mm;
    for (const ShaftSegment& row : rows)
        if (row.length_mm > 0) outside_mm = std::min({outside_mm, row.start_diameter_mm, row.end_diameter_mm});
    const auto rounded = [](double value) { return std::max(0.5, std::floor(value)); };
    const double diameter_mm = rounded(newBoreDiameterShare * outside_mm);
    const double depth_mm = std::min(rounded(newBoreDepthShare * outcome_->shaft.length_mm()), freeForBores_mm() / 2);
    emit boresEditRequested(
        from == ShaftEnd::Free ? tr("Add a bore from the free end") : tr("Add a bore from the chuck end"),
        [=](ShaftBores bores) { return addBoreRow(std::move(bores), from, diameter_mm, depth_mm); });
}

void DrawingViews::typeBore(const drawing::DimensionTarget& target, const QString& text)
{
    const ShaftBores& now = outcome_->shaft.bores;
    if (*target.bore >= now.size() || typedBoreSize(now, target) == text) return;
    const std::optional<double> typed = typedNumber(text);
    if (!typed) return;
    const double value = *typed;
    const bool is_diameter = target.of == drawing::DimensionTarget::Of::Diameter;
    emit boresEditRequested(
        is_diameter ? tr("Change the diameter of a bore") : tr("Change the depth of a bore"), [=](ShaftBores bores) {
            return is_diameter ? setBoreDiameter(std::move(bores), *target.bore, target.rows.front(), value)
                               : setBoreDepth(std::move(bores), *target.bore, target.rows.back(), value);
        });
}

}  // namespace lathelier::drawing_panel
