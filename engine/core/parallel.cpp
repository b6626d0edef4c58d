#include "engine/core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace lathelier {

void parallelFor(std::size_t count, std::size_t grain, const Progress& progress,
                 const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    const std::size_t chunks = (count + grain - 1) / grain;
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
        progress.check();
        body(chunk * grain, std::min(count, (chunk + 1) * grain));
    });
}

struct ThreadLimit::Control {
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
{
    if (threads > 0)
        control_ = std::make_unique<Control>(
            Control{tbb::global_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads))});
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace lathelier
