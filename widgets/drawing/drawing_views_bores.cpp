// Bores in the views of a drawing: rows of the table that are typed in, their menu, and their dimensions on the sheet.
#include <QSignalBlocker>
#include <cmath>

#include "widgets/core/language.h"
#include "widgets/drawing/dimension_edit.h"
#include "widgets/drawing/drawing_views.h"

namespace lathelier::drawing_panel {
namespace {

constexpr int kLength = 4, kStart = 5, kEnd = 6;  // columns of rowsTable()
constexpr double kLeastFree_mm = 1;               // that a new bore needs
constexpr double kUsualShare = 0.4, kUsualDepth = 1.0 / 3;

}  // namespace

/// Rows of bores stand behind those of the outside.
std::optional<BorePlace> DrawingViews::boreAt(int row) const
{
    if (!picture_ || row < 0) return std::nullopt;
    auto index = static_cast<std::size_t>(row);
    if (index < picture_->shaft.segments.size()) return std::nullopt;
    index -= picture_->shaft.segments.size();
    const ShaftBores& bores = picture_->shaft.bores;
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
        for (const int column : {kLength, kStart, kEnd})
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
    // What is refused goes back; not before the field over the cell is closed.
    QMetaObject::invokeMethod(
        this, [this] { show(); }, Qt::QueuedConnection);
    if (!typed) return;
    const BorePlace& at = *place;
    emit boresEditWanted(tr("Change row %1").arg(at.name), [=](ShaftBores bores) {
        BoreSegment& row = bores.at(at.bore).segments.at(at.row);
        const bool is_cylinder = !row.arc_radius_mm && row.start_diameter_mm == row.end_diameter_mm;
        if (column == kLength)
            row.length_mm = value;
        else if (column == kStart || is_cylinder)
            row.start_diameter_mm = value;
        if (column == kEnd || (column == kStart && is_cylinder)) row.end_diameter_mm = value;
        return bores;
    });
}

void DrawingViews::deleteBore(const BorePlace& place)
{
    emit boresEditWanted(tr("Delete row %1").arg(place.name),
                         [place](ShaftBores bores) { return deleteBoreRow(std::move(bores), place.bore, place.row); });
}

void DrawingViews::addBoreVerbs(QMenu& menu, int at)
{
    const auto found = boreAt(at);
    if (!found) return;
    const BorePlace& place = *found;
    menu.addSection(tr("Row %1").arg(place.name));
    menu.addAction(tr("Delete"), this, [this, place] { deleteBore(place); })->setShortcut(QKeySequence::Delete);
    menu.addAction(tr("Add a row behind it"), this, [this, place] {
        emit boresEditWanted(tr("Add a row behind %1").arg(place.name), [place](ShaftBores bores) {
            return insertBoreRow(std::move(bores), place.bore, place.row);
        });
    });
    QMenu* const kinds = menu.addMenu(tr("Change its kind"));
    for (const RowForm form :
         {RowForm::Cylinder, RowForm::Cone, RowForm::Chamfer, RowForm::Round, RowForm::Fillet, RowForm::Groove})
        kinds->addAction(part_common::formName(form), this, [this, place, form] {
            emit boresEditWanted(tr("Make row %1 a %2").arg(place.name, part_common::formName(form).toLower()),
                                 [place, form](ShaftBores bores) {
                                     return changeBoreForm(std::move(bores), place.bore, place.row, form);
                                 });
        });
}

/// Of the length, by what is not bored.
double DrawingViews::freeForBores_mm() const
{
    if (!picture_ || picture_->shaft.segments.empty()) return 0;
    double free_mm = picture_->shaft.length_mm();
    for (const ShaftBore& bore : picture_->shaft.bores)
        for (const BoreSegment& row : bore.segments) free_mm -= row.length_mm;
    return free_mm;
}

void DrawingViews::showBoreButton()
{
    const bool has_room = freeForBores_mm() >= kLeastFree_mm;
    bore_->setEnabled(has_room);
    bore_->setToolTip(has_room || !picture_
                          ? tr("A cylinder from this end, or one more behind the last one. Its row in the table is "
                               "changed by a double click, its kind and its place by the right button.")
                          : tr("The bores already run through the whole part"));
}

/// Two fifths of the diameter of its end, a third of the part deep; both are then typed.
void DrawingViews::addBore(ShaftEnd from)
{
    if (!picture_ || picture_->shaft.segments.empty()) return;
    const ShaftRows& rows = picture_->shaft.segments;
    double outside_mm = from == ShaftEnd::Free ? rows.front().start_diameter_mm : rows.back().end_diameter_mm;
    for (const ShaftSegment& row : rows)
        if (row.length_mm > 0) outside_mm = std::min({outside_mm, row.start_diameter_mm, row.end_diameter_mm});
    const auto rounded = [](double value) { return std::max(0.5, std::floor(value)); };
    const double diameter_mm = rounded(kUsualShare * outside_mm);
    const double depth_mm = std::min(rounded(kUsualDepth * picture_->shaft.length_mm()), freeForBores_mm() / 2);
    emit boresEditWanted(
        from == ShaftEnd::Free ? tr("Add a bore from the free end") : tr("Add a bore from the chuck end"),
        [=](ShaftBores bores) { return addBoreRow(std::move(bores), from, diameter_mm, depth_mm); });
}

void DrawingViews::typeBore(const drawing::DimensionTarget& target, const QString& text)
{
    const ShaftBores& now = picture_->shaft.bores;
    if (*target.bore >= now.size() || typedBoreSize(now, target) == text) return;
    const std::optional<double> typed = typedNumber(text);
    if (!typed) return;
    const double value = *typed;
    const bool is_diameter = target.of == drawing::DimensionTarget::Of::Diameter;
    emit boresEditWanted(
        is_diameter ? tr("Change the diameter of a bore") : tr("Change the depth of a bore"), [=](ShaftBores bores) {
            return is_diameter ? setBoreDiameter(std::move(bores), *target.bore, target.rows.front(), value)
                               : setBoreDepth(std::move(bores), *target.bore, target.rows.back(), value);
        });
}

}  // namespace lathelier::drawing_panel
