// Work in a process of its own that is killed: what a power cut or a person does to a program.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace lathelier {

/// Starts the work in a process of its own. It must not have threads that the work needs: they are not taken over.
inline pid_t beginWork(const std::function<void()>& work)
{
    const pid_t child = ::fork();
    if (child != 0) return child;
    try {
        work();
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);
}

/// Waits. Whether the work ended without an exception.
inline bool endedWell(pid_t child)
{
    int status = 0;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Whether the process was killed; false: its work had ended before. An exception ends it.
inline bool workAndKill(const std::function<void()>& work, std::chrono::milliseconds life)
{
    const pid_t child = beginWork(work);
    std::this_thread::sleep_for(life);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status);
}

}  // namespace lathelier
