#include "engine/batch/ordered_jobs.h"

#include <system_error>
#include <thread>

namespace lathelier::batch {

void onThreads(std::size_t jobs, const std::function<void()>& body)
{
    std::vector<std::jthread> threads;
    threads.reserve(jobs);
    try {
        while (threads.size() + 1 < jobs) threads.emplace_back(body);
    } catch (const std::system_error&) {  // those that there are do the work
    }
    body();
}

}  // namespace lathelier::batch
