#include "app/cli/interruption.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <system_error>

#include "app/cli/run.h"

namespace lathelier::cli {
namespace {

constexpr int wakeSignal = SIGUSR1;  ///< ends the waiting thread only

sigset_t awaitedSignals()
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    sigaddset(&set, wakeSignal);
    return set;
}

}  // namespace

Interruption::Interruption()
{
    const sigset_t set = awaitedSignals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    try {
        waiter_ = std::thread([this] { wait(); });
    } catch (const std::system_error&) {  // no memory for a thread: the signals end the program as they always do
        pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    }
}

Interruption::~Interruption()
{
    if (!waiter_.joinable()) return;
    done_ = true;
    pthread_kill(waiter_.native_handle(), wakeSignal);
    waiter_.join();
}

void Interruption::wait()
{
    const sigset_t set = awaitedSignals();
    while (!done_) {
        int signal = 0;
        if (sigwait(&set, &signal) != 0 || signal == wakeSignal) continue;
        if (source_.stop_requested()) _exit(exitCancelled);
        source_.request_stop();
    }
}

}  // namespace lathelier::cli
