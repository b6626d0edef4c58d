#include "app/gui/shots.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <iostream>

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

}  // namespace

int takeShots(MainWindow& window, const QString& folder)
{
    const QDir shots(folder);
    bool good = shots.mkpath(".");
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        const QString suffix = QString("_%1x%2.png").arg(size.width()).arg(size.height());
        window.resize(size);
        window.show();
        good = waitForResults(window) && good;
        pause(settling_ms);
        good = write(window, shots.filePath("window" + suffix)) && good;
        for (PanelDock* dock : window.docks()) {
            if (!dock->isVisible()) continue;
            good = dock->panel().isCurrent() && good;
            good = write(dock->panel(), shots.filePath(QString::fromStdString(dock->facts().id) + suffix)) && good;
        }
    }
    window.setPresenting(true);
    pause(settling_ms);
    good = write(window, shots.filePath("presenter_1920x1080.png")) && good;
    window.setPresenting(false);
    return good ? 0 : 1;
}

}  // namespace lathelier
