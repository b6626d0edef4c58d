#include "app/gui/shutdown.h"

#include <sys/socket.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <array>
#include <cerrno>
#include <csignal>

namespace lathelier {
namespace {

constexpr std::array endings{SIGTERM, SIGHUP, SIGINT};
std::array<int, 2> ends{-1, -1};  ///< a handler may write to the first; the event loop reads the second

void handle(int)
{
    const int before = errno;
    const char byte = 1;
    [[maybe_unused]] const ssize_t written = ::write(ends[0], &byte, 1);
    errno = before;
}

}  // namespace

Shutdown::Shutdown(QObject* parent) : QObject(parent)
{
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends.data()) != 0) return;
    notifier_ = std::make_unique<QSocketNotifier>(ends[1], QSocketNotifier::Read);
    connect(notifier_.get(), &QSocketNotifier::activated, this, &Shutdown::read);
    for (const int signal : endings) std::signal(signal, handle);
}

Shutdown::~Shutdown()
{
    for (const int signal : endings) std::signal(signal, SIG_DFL);
    notifier_.reset();
    for (int& end : ends) {
        if (end >= 0) ::close(end);
        end = -1;
    }
}

void Shutdown::read()
{
    std::array<char, 16> bytes{};
    while (::read(ends[1], bytes.data(), bytes.size()) > 0) continue;
    emit requested();
}

}  // namespace lathelier
