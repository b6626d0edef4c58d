#include "app/gui/shots.h"

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <functional>
#include <iostream>

#include "app/gui/help_window.h"
#include "app/gui/verify_dialog.h"
#include "widgets/core/panel/primary_views.h"

namespace lathelier {
namespace {

constexpr int patience_ms = 180 * 1000;
constexpr int settling_ms = 600;  // the 3-D view draws its full set at rest

void pause(int time_ms)
{
    QEventLoop loop;
    QTimer::singleShot(time_ms, &loop, &QEventLoop::quit);
    loop.exec();
}

bool waitForResults(const MainWindow& window)
{
    QElapsedTimer clock;
    clock.start();
    const auto busy = [&] {
        const auto& docks = window.docks();
        return std::any_of(docks.begin(), docks.end(),
                           [](PanelDock* dock) { return dock->madePanel() && dock->madePanel()->isBusy(); });
    };
    do pause(100);
    while (busy() && clock.elapsed() < patience_ms);
    return !busy();
}

bool write(QWidget& widget, const QString& path)
{
    const bool written = widget.grab().save(path);
    std::cerr << path.toStdString() << (written ? "" : ": not written") << '\n';
    return written;
}

/// The active panel: in its window, alone, and each of its further pages.
bool shootPanel(MainWindow& window, PanelDock& dock, const QDir& shots, const QString& suffix)
{
    dock.show();
    dock.raise();
    bool good = waitForResults(window);
    pause(settling_ms);
    const QString id = QString::fromStdString(dock.facts().id);
    // No result without an error is no fault: the chain runs when a person asks for it.
    if (!dock.panel().isCurrent()) std::cerr << dock.facts().id << ": shows no result of its inputs\n";
    good = !dock.panel().error() && good;
    good = write(window, shots.filePath("window_" + id + suffix)) && good;
    good = write(dock.panel(), shots.filePath(id + suffix)) && good;
    auto* primaryViews = dock.panel().findChild<PrimaryViews*>();
    const QStringList keys = primaryViews ? primaryViews->keys() : QStringList();
    for (int view = 1; view < keys.size(); ++view) {
        primaryViews->setPrimary(keys[view]);
        pause(settling_ms);
        good = write(dock.panel(), shots.filePath(QString("%1_%2%3").arg(id, keys[view], suffix))) && good;
    }
    if (!keys.isEmpty()) primaryViews->setPrimary(keys.front());
    return good;
}

bool shootVerification(MainWindow& window, const QDir& shots)
{
    window.action("verify")->trigger();
    auto* dialog = window.findChild<VerifyDialog*>();
    QElapsedTimer clock;
    clock.start();
    while (!dialog->result() && clock.elapsed() < patience_ms) pause(100);
    pause(settling_ms);
    const bool good = write(*dialog, shots.filePath("verify.png")) && dialog->result();
    dialog->close();
    return good;
}

bool shootManual(MainWindow& window, const QDir& shots)
{
    window.action("help")->trigger();
    auto* manual = window.findChild<HelpWindow*>();
    pause(settling_ms);
    const bool good = write(*manual, shots.filePath("manual.png"));
    manual->close();
    return good;
}

}  // namespace

int takeShots(MainWindow& window, const QString& folder)
{
    const QDir shots(folder);
    bool good = shots.mkpath(".");
    const auto inTurn = [&](const std::function<void(PanelDock&)>& shoot) {
        for (PanelDock* dock : window.docks()) {
            window.enterQuestion(dock->facts().question.id);
            shoot(*dock);
        }
    };
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        const QString suffix = QString("_%1x%2.png").arg(size.width()).arg(size.height());
        window.resize(size);
        window.show();
        inTurn([&](PanelDock& dock) { good = shootPanel(window, dock, shots, suffix) && good; });
    }
    good = shootVerification(window, shots) && shootManual(window, shots) && good;
    inTurn([&](PanelDock& dock) {
        dock.show();
        dock.raise();
        pause(settling_ms);
        window.setPresenting(true);
        pause(settling_ms);
        const QString name = QString("presenter_%1_1920x1080.png").arg(QString::fromStdString(dock.facts().id));
        good = write(window, shots.filePath(name)) && good;
        window.setPresenting(false);
    });
    return good ? 0 : 1;
}

}  // namespace lathelier
