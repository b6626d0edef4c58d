// One computation in the background, for opening, reports, verification, the sample.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <utility>

#include "widgets/core/task/worker.h"

namespace lathelier {

/// Runs a job in a separate thread and delivers its outcome in the GUI thread. A newer start() drops the running job.
/// Destroying the task stops the job without a call.
class Task : public QObject {
    Q_OBJECT
public:
    explicit Task(QObject* parent = nullptr);

    void start(Worker::Job job, std::function<void(const Worker::Outcome&)> done);

    /// The same with a value of type T; `failed` is called for errors, nothing for cancellation.
    template <class T>
    void compute(std::function<T(const Progress&)> job, std::function<void(const T&)> done,
                 std::function<void(const Error&)> failed)
    {
        start(
            [job = std::move(job)](const Progress& progress) -> std::shared_ptr<const void> {
                return std::make_shared<const T>(job(progress));
            },
            [done = std::move(done), failed = std::move(failed)](const Worker::Outcome& outcome) {
                if (const auto* value = std::get_if<std::shared_ptr<const void>>(&outcome))
                    done(*static_cast<const T*>(value->get()));
                else if (const auto* error = std::get_if<Error>(&outcome))
                    failed(*error);
            });
    }

    bool isBusy() const { return poll_.isActive(); }
    void cancel() { worker_.cancel(); }

signals:
    void progressed(const lathelier::Worker::State& state);  ///< 30 times a second

private:
    void poll();

    QTimer poll_;
    std::function<void(const Worker::Outcome&)> done_;
    Worker worker_;  ///< last member: stopped before the others are destroyed
};

}  // namespace lathelier
