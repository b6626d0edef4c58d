#include "widgets/core/task/task.h"

namespace lathelier {

Task::Task(QObject* parent) : QObject(parent)
{
    poll_.setInterval(33);
    connect(&poll_, &QTimer::timeout, this, &Task::poll);
}

void Task::start(Worker::Job job, std::function<void(const Worker::Outcome&)> done)
{
    done_ = std::move(done);
    worker_.request(std::move(job));
    poll_.start();
}

void Task::poll()
{
    emit progressed(worker_.state());
    const auto outcome = worker_.take();
    if (!outcome) return;
    poll_.stop();
    const auto done = std::move(done_);  // may start the next job or destroy this object
    done_ = {};
    done(*outcome);
}

}  // namespace lathelier
