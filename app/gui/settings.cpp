#include "app/gui/settings.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace lathelier {
namespace {

constexpr int recentCount = 10;

}

Settings readSettings()
{
    const QSettings stored;
    Settings result;
    result.language = stored.value("language").toString();
    result.theme = stored.value("theme").toString();
    result.presenter_percent =
        std::clamp(stored.value("presenter_percent", result.presenter_percent).toInt(), 100, 300);
    result.decision = stored.value("decision").toString();
    return result;
}

void writeSettings(const Settings& settings)
{
    QSettings stored;
    stored.setValue("language", settings.language);
    stored.setValue("theme", settings.theme);
    stored.setValue("presenter_percent", settings.presenter_percent);
    stored.setValue("decision", settings.decision);
}

QStringList recentFiles()
{
    return QSettings().value("recent").toStringList();
}

void addRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    const QString whole = QFileInfo(path).absoluteFilePath();
    files.removeAll(whole);
    files.prepend(whole);
    QSettings().setValue("recent", QStringList(files.mid(0, recentCount)));
}

}  // namespace lathelier
