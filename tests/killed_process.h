// Work in a process of its own that is killed: what a power cut or a person does to a program.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace lathelier {

/// Whether the process was killed; false: its work had ended before. An exception ends it.
inline bool workAndKill(const std::function<void()>& work, std::chrono::milliseconds life)
{
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            work();
        } catch (...) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    std::this_thread::sleep_for(life);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status);
}

}  // namespace lathelier
