// Termination by the system: logout, shutdown, kill. Unsaved work is saved for recovery without a question.
#pragma once

#include <QObject>
#include <memory>

class QSocketNotifier;

namespace lathelier {

/// Emits a signal in the GUI thread when SIGTERM, SIGHUP or SIGINT arrives. One at a time; make it after the
/// application.
class Shutdown : public QObject {
    Q_OBJECT
public:
    explicit Shutdown(QObject* parent = nullptr);
    ~Shutdown() override;

signals:
    void requested();

private:
    void read();

    std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace lathelier
