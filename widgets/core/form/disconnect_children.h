// What ends the connections from the parts of a composite widget to the widget itself.
#pragma once

#include <QWidget>

namespace lathelier {

/// For the destructor of a widget whose parts are connected to it: while ~QWidget hides them, the part in focus still
/// emits that its editing is finished, and the slot would belong to an object of a class that is destroyed already.
inline void disconnectChildren(QWidget& parent)
{
    for (QWidget* child : parent.findChildren<QWidget*>()) child->disconnect(&parent);
}

}  // namespace lathelier
