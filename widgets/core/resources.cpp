#include "widgets/core/resources.h"

#include <QResource>
#include <QtGlobal>

// The macro declares a function and therefore wants the global namespace.
static void registerResources()
{
    Q_INIT_RESOURCE(lathelier);
    Q_INIT_RESOURCE(translations);
}

namespace lathelier {

void useResources()
{
    registerResources();
}

}  // namespace lathelier
