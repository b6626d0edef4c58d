// Disconnects the parts of a composite widget from the widget itself.
#pragma once

#include <QWidget>

namespace lathelier {

/// For the destructor of a widget whose parts are connected to it: while ~QWidget hides them, the focused part still
/// emits editingFinished, whose slot would belong to an already destroyed derived object.
inline void disconnectChildren(QWidget& parent)
{
    for (QWidget* child : parent.findChildren<QWidget*>()) child->disconnect(&parent);
}

}  // namespace lathelier
