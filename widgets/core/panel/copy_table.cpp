#include "widgets/core/panel/copy_table.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "engine/report/cells.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

QString screenCaption(const report::Caption& caption)
{
    return QString::fromStdString(report::captionText(caption, screenLanguage()));
}

QString copiedCellText(const Value& value, Text unit, int decimals)
{
    if (const auto* number = std::get_if<double>(&value))
        return std::isfinite(*number) ? screenNumber(*number, unit, decimals) : QStringLiteral("–");
    if (const auto* count = std::get_if<std::int64_t>(&value))
        return QLocale().toString(static_cast<qlonglong>(*count));
    if (std::holds_alternative<std::monostate>(value)) return QStringLiteral("–");
    return screenText(shownValue(value, unit, screenLanguage()));
}

}  // namespace

QTableWidgetItem* tableCell(const QString& text, bool number)
{
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    item->setTextAlignment(static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
    return item;
}

CopyTable::CopyTable(QWidget* parent) : QTableWidget(parent)
{
    setSelectionBehavior(QAbstractItemView::SelectRows);
    verticalHeader()->hide();
    setAlternatingRowColors(true);
    setShowGrid(false);
    setWordWrap(false);
    setFrameShape(QFrame::NoFrame);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

QString CopyTable::text(bool selectedOnly) const
{
    QStringList lines;
    QStringList head;
    for (int column = 0; column < columnCount(); ++column) head << horizontalHeaderItem(column)->text();
    lines << head.join('\t');
    for (int row = 0; row < rowCount(); ++row) {
        if (selectedOnly && !selectionModel()->isRowSelected(row, {})) continue;
        QStringList words;
        for (int column = 0; column < columnCount(); ++column)
            words << (item(row, column) ? item(row, column)->text() : "");
        lines << words.join('\t');
    }
    return lines.join('\n');
}

void CopyTable::copyToClipboard() const
{
    QApplication::clipboard()->setText(text(selectionModel()->hasSelection()));
}

void CopyTable::changeEvent(QEvent* event)
{
    QTableWidget::changeEvent(event);
    if (event->type() != QEvent::FontChange) return;
    for (int row = 0; row < rowCount(); ++row)  // title rows have a separate font
        if (QTableWidgetItem* title = item(row, 0); title && columnSpan(row, 0) > 2) {
            QFont bold = font();
            bold.setBold(true);
            title->setFont(bold);
        }
    fitCells();
}

void CopyTable::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy)) return copyToClipboard();
    QTableWidget::keyPressEvent(event);
}

void CopyTable::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    menu.addAction(tr("Copy"), this, [this] { copyToClipboard(); });
    menu.addAction(tr("Copy all"), this, [this] { QApplication::clipboard()->setText(text(false)); });
    menu.exec(event->globalPos());
}

void CopyTable::setTable(const report::Table& table)
{
    clear();
    clearSpans();
    QStringList head;
    for (const report::Caption& column : table.columns) head << screenCaption(column);
    setColumnCount(head.size());
    setHorizontalHeaderLabels(head);
    setRowCount(static_cast<int>(table.rows.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const std::vector<Value>& values = table.rows[static_cast<std::size_t>(row)];
        for (int column = 0; column < columnCount() && column < static_cast<int>(values.size()); ++column) {
            const Value& value = values[static_cast<std::size_t>(column)];
            const int decimals = table.decimalsOf(static_cast<std::size_t>(column));
            setItem(row, column,
                    tableCell(copiedCellText(value, table.unitOf(static_cast<std::size_t>(column)), decimals),
                              report::isNumeric(value)));
        }
    }
    fitCells();
}

void CopyTable::setQuantities(const report::Document& document)
{
    clear();
    clearSpans();
    setColumnCount(3);
    setHorizontalHeaderLabels({tr("Quantity"), tr("Value"), tr("Unit")});
    setRowCount(0);
    for (const report::Section& section : document.sections)
        for (const report::Block& block : section.blocks) {
            const auto* table = std::get_if<report::QuantityTable>(&block);
            if (!table) continue;
            int row = rowCount();
            insertRow(row);
            auto* title = tableCell(screenCaption(table->title), false);
            QFont bold = font();
            bold.setBold(true);
            title->setFont(bold);
            setItem(row, 0, title);
            setSpan(row, 0, 1, 3);
            for (const report::Quantity& quantity : table->rows) {
                insertRow(++row);
                setItem(row, 0, tableCell(screenCaption(quantity.name), false));
                const bool words = !report::isNumeric(quantity.value) && quantity.unit.empty();
                auto* value = tableCell(copiedCellText(quantity.value, quantity.unit, quantity.decimals), !words);
                setItem(row, 1, value);
                setItem(row, 2, tableCell(screenUnit(quantity.unit), false));
                if (words) {  // a sentence would hide the numbers
                    setSpan(row, 1, 1, 2);
                    value->setToolTip(value->text());
                }
            }
        }
    fitCells();
}

/// Title rows do not widen the first column.
int CopyTable::sizeHintForColumn(int column) const
{
    int widest = 0;
    for (int row = 0; row < rowCount(); ++row)
        if (item(row, column) && columnSpan(row, column) == 1)
            widest = std::max(widest, sizeHintForIndex(model()->index(row, column)).width());
    return widest;
}

void CopyTable::fitCells()
{
    resizeRowsToContents();
    horizontalHeader()->setStretchLastSection(false);  // else the last column stays as wide as its contents
    resizeColumnsToContents();
    horizontalHeader()->setStretchLastSection(true);
}

}  // namespace lathelier
