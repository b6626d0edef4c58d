#include "widgets/compare/compare_tables.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "engine/report/compare_report.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

QTableWidgetItem* cell(const QString& text, bool number)
{
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return item;
}

QString screenCaption(const Caption& caption)
{
    if (const auto* text = std::get_if<Text>(&caption)) return screenText(*text);
    return QString::fromStdString(std::get<std::string>(caption));
}

QString screenQuantity(const Value& value, int decimals)
{
    if (const auto* number = std::get_if<double>(&value)) return screenNumber(*number, decimals);
    if (const auto* count = std::get_if<std::int64_t>(&value))
        return QLocale().toString(static_cast<qlonglong>(*count));
    if (std::holds_alternative<std::monostate>(value)) return QStringLiteral("–");
    return screenText(value);
}

QString signedNumber(double value, int decimals)
{
    return (value > 0 ? "+" : "") + screenNumber(value, decimals);
}

}  // namespace

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

StatisticsTable::StatisticsTable(QWidget* parent) : CopyTable(parent)
{
    setColumnCount(3);
    setObjectName("statistics");
    setAccessibleName(tr("Statistics"));
}

void StatisticsTable::setPicture(const ComparePicture& picture)
{
    setHorizontalHeaderLabels({tr("Quantity"), tr("Value"), tr("Unit")});
    setRowCount(0);
    const Document document = compareReport(*picture.result, picture.inputs, screenLanguage());
    for (const Section& section : document.sections)
        for (const Block& block : section.blocks) {
            const auto* table = std::get_if<QuantityTable>(&block);
            if (!table) continue;
            int row = rowCount();
            insertRow(row);
            auto* title = cell(screenCaption(table->title), false);
            QFont bold = font();
            bold.setBold(true);
            title->setFont(bold);
            setItem(row, 0, title);
            setSpan(row, 0, 1, 3);
            for (const Quantity& quantity : table->rows) {
                insertRow(++row);
                setItem(row, 0, cell(screenCaption(quantity.name), false));
                setItem(row, 1, cell(screenQuantity(quantity.value, quantity.decimals), true));
                setItem(row, 2, cell(screenText(quantity.unit), false));
            }
        }
    resizeRowsToContents();
    resizeColumnsToContents();
    horizontalHeader()->setStretchLastSection(true);
}

ZoneTable::ZoneTable(QWidget* parent) : CopyTable(parent)
{
    setObjectName("zones");
    setColumnCount(6);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setAccessibleName(tr("Zones along the axis"));
    connect(this, &QTableWidget::cellClicked, this, [this](int row, int) {
        const Zone& zone = zones_[static_cast<std::size_t>(row)];
        emit zonePicked((zone.z_start_mm + zone.z_end_mm) / 2);
    });
}

void ZoneTable::setResult(const CompareResult& result)
{
    zones_ = result.zones;
    setHorizontalHeaderLabels(
        {tr("From [mm]"), tr("To [mm]"), tr("Mean [mm]"), tr("Scatter [mm]"), tr("Points"), tr("Mean is")});
    horizontalHeaderItem(3)->setToolTip(tr("Standard deviation of the single points in the zone"));
    setRowCount(static_cast<int>(zones_.size()));
    for (int row = 0; row < rowCount(); ++row) {
        const Zone& zone = zones_[static_cast<std::size_t>(row)];
        setItem(row, 0, cell(screenNumber(zone.z_start_mm, 1), true));
        setItem(row, 1, cell(screenNumber(zone.z_end_mm, 1), true));
        setItem(row, 2, cell(signedNumber(zone.mean_mm, 4), true));
        setItem(row, 3, cell(screenNumber(zone.std_mm, 4), true));
        setItem(row, 4, cell(QLocale().toString(static_cast<qlonglong>(zone.points)), true));
        QString word = QStringLiteral("–");
        if (const auto& t = result.parameters.tolerance_mm) {
            if (zone.mean_mm > *t)
                word = tr("▲ above");
            else if (zone.mean_mm < -*t)
                word = tr("▼ below");
            else
                word = tr("✓ within");
        }
        setItem(row, 5, cell(word, false));
    }
    resizeRowsToContents();
    resizeColumnsToContents();
    horizontalHeader()->setStretchLastSection(true);
}

void ZoneTable::markZ(std::optional<double> z_mm)
{
    clearSelection();
    if (!z_mm) return;
    // Zones keep a little away from edges: a place between two of them belongs to the nearer one.
    const auto away = [&](const Zone& zone) { return std::max({zone.z_start_mm - *z_mm, *z_mm - zone.z_end_mm, 0.0}); };
    const auto nearest =
        std::min_element(zones_.begin(), zones_.end(), [&](const Zone& a, const Zone& b) { return away(a) < away(b); });
    if (nearest == zones_.end()) return;
    const int row = static_cast<int>(nearest - zones_.begin());
    selectRow(row);
    scrollToItem(item(row, 0));
}

}  // namespace lathelier
