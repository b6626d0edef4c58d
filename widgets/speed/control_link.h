// The link of the operator's screen to a control: the loop of engine/link in a thread of its own, told to the window.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "engine/link/link_config.h"
#include "engine/link/link_loop.h"

namespace lathelier::speed_panel {

class ControlLink : public QObject {
    Q_OBJECT

public:
    enum class Status { Off, Connecting, Linked, Lost, Refused };

    explicit ControlLink(QObject* parent = nullptr);
    ~ControlLink() override;

    /// Links to the control; what it asks is answered with the question of the configuration. Ends an earlier link.
    void start(const std::string& kind, const link::LinkConfig& config);
    /// Ends the link; returns at once, while the thread ends by itself.
    void stop();

    Status status() const { return status_; }
    const std::string& kind() const { return kind_; }
    const std::string& peer() const { return peer_; }
    const std::optional<link::Exchange>& last() const { return last_; }
    const std::optional<Error>& error() const { return error_; }  ///< why it is lost or refused

signals:
    void changed();
    void exchanged();  ///< last() is a new one

private:
    void take(std::int64_t run, const link::LogEntry& entry);
    void fail(std::int64_t run, const Error& error);
    void work(const std::stop_token& stop, std::int64_t run, const std::string& kind, const link::LinkConfig& config);

    Status status_ = Status::Off;
    std::string kind_;
    std::string peer_;
    std::optional<link::Exchange> last_;
    std::optional<Error> error_;
    std::int64_t run_ = 0;  ///< number of the link; what an ended one still tells is dropped
    std::jthread thread_;
};

}  // namespace lathelier::speed_panel
