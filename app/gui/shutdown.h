// The end that others ask for: logout, shutdown, kill. Unsaved work is kept aside and nobody is asked.
#pragma once

#include <QObject>
#include <memory>

class QSocketNotifier;

namespace lathelier {

/// Tells in the GUI thread that SIGTERM, SIGHUP or SIGINT arrived. One at a time; make it after the application.
class Shutdown : public QObject {
    Q_OBJECT
public:
    explicit Shutdown(QObject* parent = nullptr);
    ~Shutdown() override;

signals:
    void wanted();

private:
    void read();

    std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace lathelier
