#include "widgets/core/resources.h"

#include <QFile>
#include <QResource>
#include <QtGlobal>

// The macro declares a function and must be used in the global namespace.
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

std::string resourceText(const char* path)
{
    QFile file(QString::fromLatin1(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

}  // namespace lathelier
