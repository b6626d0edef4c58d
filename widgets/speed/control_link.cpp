#include "widgets/speed/control_link.h"

#include "engine/core/failure.h"
#include "engine/link/transports.h"

namespace lathelier::speed_panel {

ControlLink::ControlLink(QObject* parent) : QObject(parent) {}

ControlLink::~ControlLink() = default;  // the thread is stopped and joined

void ControlLink::start(const std::string& kind, const link::LinkConfig& config)
{
    stop();
    const std::int64_t run = ++run_;
    kind_ = kind;
    status_ = Status::Connecting;
    // The new thread joins that of the earlier link, which was asked to stop: the window does not wait for it.
    thread_ =
        std::jthread([this, run, kind, config, earlier = std::move(thread_)](const std::stop_token& stop) mutable {
            earlier = {};
            work(stop, run, kind, config);
        });
    emit changed();
}

void ControlLink::stop()
{
    if (status_ == Status::Off) return;
    thread_.request_stop();
    ++run_;
    status_ = Status::Off;
    error_.reset();
    emit changed();
}

void ControlLink::work(const std::stop_token& stop_token, std::int64_t run, const std::string& kind,
                       const link::LinkConfig& config)
{
    try {
        const Progress progress(stop_token, {});
        link::Assistant assistant(config.question, config.limits, config.program);
        assistant.prepare(progress);
        const std::unique_ptr<link::Transport> transport = link::transportOf(kind, config);
        link::LinkLoop loop(*transport, assistant, link::loopSettings(config, false), [&](const link::LogEntry& entry) {
            QMetaObject::invokeMethod(
                this, [this, run, entry] { take(run, entry); }, Qt::QueuedConnection);
        });
        loop.run(progress);
    } catch (const Cancelled&) {
        return;
    } catch (const std::exception& failure) {
        const Error error = toError(failure);
        QMetaObject::invokeMethod(
            this, [this, run, error] { fail(run, error); }, Qt::QueuedConnection);
    }
}

void ControlLink::take(std::int64_t run, const link::LogEntry& entry)
{
    if (run != run_) return;
    peer_ = entry.peer;
    if (entry.event == link::LinkEvent::Opened) {
        status_ = Status::Linked;
        error_.reset();
    }
    if (entry.event == link::LinkEvent::Lost) {
        status_ = Status::Lost;
        error_ = entry.error;
    }
    if (entry.event == link::LinkEvent::Refused) error_ = entry.error;
    if (entry.exchange) {
        error_.reset();
        last_ = entry.exchange;
        emit exchanged();
    }
    emit changed();
}

void ControlLink::fail(std::int64_t run, const Error& error)
{
    if (run != run_) return;
    status_ = Status::Refused;
    error_ = error;
    emit changed();
}

}  // namespace lathelier::speed_panel
