#include "app/gui/waiting.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>
#include <optional>

#include "widgets/core/task/task.h"

namespace lathelier {

Worker::Outcome waitFor(QWidget* window, const QString& what, Worker::Job job)
{
    QProgressDialog dialog(what, QCoreApplication::translate("lathelier::MainWindow", "Cancel"), 0, 1000, window);
    dialog.setWindowModality(Qt::WindowModal);
    dialog.setMinimumDuration(500);
    dialog.setAutoReset(false);
    dialog.setValue(0);
    Task task;
    QObject::connect(&dialog, &QProgressDialog::canceled, &task, &Task::cancel);
    QObject::connect(&task, &Task::progressed, &dialog, [&dialog](const Worker::State& state) {
        if (!state.stopping) dialog.setValue(static_cast<int>(state.fraction * 999));
    });
    QEventLoop loop;
    std::optional<Worker::Outcome> outcome;
    task.start(std::move(job), [&](const Worker::Outcome& became) {
        outcome = became;
        loop.quit();
    });
    loop.exec();
    return *outcome;
}

}  // namespace lathelier
