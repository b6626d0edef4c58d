#include "widgets/core/panel/flow_row.h"

#include <QWidget>
#include <algorithm>

namespace lathelier {
namespace {

constexpr int itemGap_px = 6;
constexpr int rowGap_px = 2;

}  // namespace

FlowRow::FlowRow(QWidget* parent) : QLayout(parent)
{
    setContentsMargins(0, 0, 0, 0);
}

FlowRow::~FlowRow()
{
    for (QLayoutItem* item : items_) delete item;
}

void FlowRow::setTrailing(QWidget* widget)
{
    trailing_ = widget;
    addWidget(widget);
}

void FlowRow::addItem(QLayoutItem* item)
{
    items_.push_back(item);
}

QLayoutItem* FlowRow::itemAt(int index) const
{
    return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)] : nullptr;
}

QLayoutItem* FlowRow::takeAt(int index)
{
    if (index < 0 || index >= count()) return nullptr;
    QLayoutItem* item = items_[static_cast<std::size_t>(index)];
    items_.erase(items_.begin() + index);
    return item;
}

QSize FlowRow::sizeHint() const
{
    int width = 0;
    int height = 0;
    for (QLayoutItem* item : items_) {
        if (item->isEmpty()) continue;
        width += item->sizeHint().width() + itemGap_px;
        height = std::max(height, item->sizeHint().height());
    }
    return {width, height};
}

QSize FlowRow::minimumSize() const
{
    QSize least;
    for (QLayoutItem* item : items_)
        if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
    return least;
}

void FlowRow::setGeometry(const QRect& room)
{
    QLayout::setGeometry(room);
    place(room, true);
}

/// Returns the required height.
int FlowRow::place(const QRect& room, bool move) const
{
    struct PlacedRow {
        std::vector<std::pair<QLayoutItem*, int>> items;  ///< items with their left edge relative to the available area
        int width = 0, height = 0;
    };
    std::vector<PlacedRow> rows(1);
    for (QLayoutItem* item : items_) {
        if (item->isEmpty()) continue;
        const QSize size = item->sizeHint().boundedTo({std::max(room.width(), 1), item->sizeHint().height()});
        if (rows.back().width > 0 && rows.back().width + size.width() > room.width()) rows.emplace_back();
        PlacedRow& row = rows.back();
        const bool is_last = item->widget() && item->widget() == trailing_;
        row.items.emplace_back(item, is_last ? room.width() - size.width() : row.width);
        row.width += size.width() + itemGap_px;
        row.height = std::max(row.height, size.height());
    }
    int top = room.top();
    for (const PlacedRow& row : rows) {
        for (const auto& [item, left] : row.items) {
            if (!move) break;
            const QSize size = item->sizeHint().boundedTo({std::max(room.width(), 1), item->sizeHint().height()});
            item->setGeometry(QRect(QPoint(room.left() + left, top + (row.height - size.height()) / 2), size));
        }
        top += row.height + rowGap_px;
    }
    return top - rowGap_px - room.top();
}

}  // namespace lathelier
