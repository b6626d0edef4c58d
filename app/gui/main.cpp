// The desktop application.
#include <QApplication>
#include <QFile>
#include <QIcon>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>
#include <csignal>
#include <iostream>
#include <optional>

#include "app/gui/arguments.h"
#include "app/gui/main_window.h"
#include "app/gui/panels.h"
#include "app/gui/report_command.h"
#include "app/gui/shots.h"
#include "app/gui/shutdown.h"
#include "app/gui/theme.h"
#include "engine/core/error.h"
#include "engine/core/version.h"
#include "engine/io/file.h"
#include "widgets/core/language.h"
#include "widgets/core/resources.h"

using namespace lathelier;

namespace {

QStringList wordsOf(int argc, char** argv)
{
    QStringList words;
    for (int i = 1; i < argc; ++i) words << QString::fromLocal8Bit(argv[i]);
    return words;
}

int runWindow(const Arguments& arguments, Languages& languages)
{
    Session session;
    const bool shots = !arguments.shots.isEmpty();
    const QString recovery =
        shots ? QString() : QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery";
    MainWindow window(session, languages, panelTable(), recovery);
    window.openPaths(arguments.files);
    if (shots) return takeShots(window, arguments.shots);
    window.show();
    const Shutdown shutdown;
    const auto leave = [&window] {
        window.files().leaveWithoutAsking();
        QCoreApplication::exit(0);
    };
    QObject::connect(&shutdown, &Shutdown::requested, &window, leave);
    QObject::connect(qApp, &QGuiApplication::commitDataRequest, &window, [&window] { window.files().keepAside(); });
    QTimer::singleShot(0, &window, [&window] { window.files().offerLostWork(); });
    return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv)
{
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is reported as an error
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is reported as an error
    const Arguments arguments = parseArguments(wordsOf(argc, argv));
    if (!arguments.error.isEmpty()) {
        std::cerr << arguments.error.toStdString() << "\n" << usage().toStdString();
        return 2;
    }
    if (arguments.help || arguments.version) {
        std::cout << (arguments.help ? usage().toStdString() : std::string("lathelier ") + programVersion + "\n");
        return 0;
    }

    // These attributes must be set before the application object is created.
    if (!arguments.report.isEmpty()) qputenv("QT_QPA_PLATFORM", "offscreen");
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    // Integer scale factors, since Qt 5 leaves artefacts at fractional ones. Fonts follow the resolution exactly.
    QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::RoundPreferFloor);
#endif
    QCoreApplication::setOrganizationName("Lathelier");
    QCoreApplication::setApplicationName("Lathelier");
    QCoreApplication::setApplicationVersion(programVersion);
    QGuiApplication::setDesktopFileName("lathelier");
    QApplication application(argc, argv);
    useResources();
    QApplication::setWindowIcon(QIcon(":/icons/lathelier.svg"));
    Theme theme(application);

    // Screenshots and reports neither use nor change the user's own settings.
    const bool apart = !arguments.shots.isEmpty() || !arguments.report.isEmpty();
    std::optional<io::PartFolder> fresh;
    try {
        if (apart) fresh.emplace();
    } catch (const Error& error) {
        std::cerr << screenText(error).toStdString() << '\n';
        return 5;
    }
    if (fresh) {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, QFile::decodeName(fresh->path().c_str()));
        QSettings().setValue("theme", arguments.theme);
    }
    Languages languages;
    const lathelier::Settings settings = lathelier::readSettings();
    languages.use(arguments.language.isEmpty() ? settings.language : arguments.language);
    lathelier::setScreenUnits(settings.units);

    if (!arguments.report.isEmpty()) return runReport(arguments.report, arguments.files.front(), panelTable());
    return runWindow(arguments, languages);
}
