#include "engine/core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace lathelier {

void parallelFor(std::size_t count, std::size_t grain, const Progress& progress,
                 const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    const std::size_t chunks = (count + grain - 1) / grain;
    // An isolated context: in a nested loop an exception of a sibling must not cancel this loop, or the caller would
    // use incomplete results.
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::parallel_for(
        std::size_t{0}, chunks,
        [&](std::size_t chunk) {
            progress.check();
            body(chunk * grain, std::min(count, (chunk + 1) * grain));
        },
        own);
}

// Constructed in place: the destructor of a copied global_control would reset the limit.
struct ThreadLimit::Control {
    explicit Control(std::size_t threads) : control(tbb::global_control::max_allowed_parallelism, threads) {}
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
{
    if (threads > 0) control_ = std::make_unique<Control>(static_cast<std::size_t>(threads));
}

ThreadLimit::~ThreadLimit() = default;

std::size_t threadsAllowed()
{
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

}  // namespace lathelier
