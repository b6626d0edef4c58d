// Icons drawn in the text colour of the palette (dark and light).
#pragma once

#include <QIcon>
#include <QString>

namespace lathelier {

/// Icon `name` of resources/icons, sharp at every size, in the palette's text colour; follows a change of the palette.
QIcon icon(const QString& name);

}  // namespace lathelier
