// What can be done with a row of a shaft, in a context menu and with keys: the same wherever rows are shown.
#pragma once

#include <QKeyEvent>
#include <QMenu>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "engine/core/shaft_edit.h"

namespace lathelier::part_common {

/// The verbs of one row. Empty ones are shown greyed; those of ties are left out where there are none.
struct RowVerbs {
    std::function<void()> remove;                                 ///< Delete
    std::function<void()> merge;                                  ///< M: with the next one
    std::function<void()> split;                                  ///< S: where the pointer is, else in its middle
    std::function<void(RowForm)> change;                          ///< its kind
    std::vector<RowForm> forms;                                   ///< that it can be made
    std::optional<RowForm> now;                                   ///< what it is; none: something else
    std::vector<std::pair<QString, std::function<void()>>> ties;  ///< rows whose diameter it can share
    std::function<void()> untie;                                  ///< it shares one
};

/// What a row is: none for arcs and cones with a role of their own.
std::optional<RowForm> formOf(const ShaftSegment& row);

QString formName(RowForm form);

/// Adds "Row 3", then its verbs.
void addRowVerbs(QMenu& menu, int number, const RowVerbs& verbs);

/// Does what the key stands for; false: it stands for nothing here.
bool pressRowKey(const QKeyEvent& event, const RowVerbs& verbs);

}  // namespace lathelier::part_common
