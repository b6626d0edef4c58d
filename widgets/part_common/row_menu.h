// Commands of a row of a shaft, as context menu and keys, common to all views of rows.
#pragma once

#include <QKeyEvent>
#include <QMenu>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "engine/shaft/shaft_edit.h"

namespace lathelier::part_common {

/// Commands of a row. Empty ones are disabled; those of ties are omitted where there are none.
struct RowVerbs {
    std::function<void()> remove;                                 ///< key Delete
    std::function<void()> merge;                                  ///< key M: merge with the next row
    std::function<void()> split;                                  ///< key S: split at the pointer, else in the middle
    std::function<void(RowForm)> change;                          ///< changes the kind of the row
    std::vector<RowForm> forms;                                   ///< possible kinds
    std::optional<RowForm> now;                                   ///< present kind; none: another one
    std::vector<std::pair<QString, std::function<void()>>> ties;  ///< rows whose diameter can be shared
    std::function<void()> untie;                                  ///< releases a shared diameter
};

/// Kind of a row; none for arcs and cones with a role.
std::optional<RowForm> formOf(const ShaftSegment& row);

QString formName(RowForm form);

/// Adds the title "Row 3" and its commands.
void addRowVerbs(QMenu& menu, int number, const RowVerbs& verbs);

/// Executes the command of a key; false: not handled.
bool pressRowKey(const QKeyEvent& event, const RowVerbs& verbs);

}  // namespace lathelier::part_common
