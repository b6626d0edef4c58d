// Loops over all cores whose results do not depend on the number of cores.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier {

/// Calls body(begin, end) for consecutive chunks of `grain` items, on all cores, in any order. Chunk limits depend on
/// `count` and `grain` only. Checks `progress` before each chunk (throws Cancelled) but reports nothing; an exception
/// thrown by `body` comes out of this call.
void parallelFor(std::size_t count, std::size_t grain, const Progress& progress,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Maps chunks to T on all cores, then folds them from first to last: the same bits for any number of threads.
template <class T, class Map, class Fold>
T parallelReduce(std::size_t count, std::size_t grain, const Progress& progress, T start, Map map, Fold fold)
{
    struct Part {
        T value;  // a struct, since elements of std::vector<bool> share bytes
    };
    std::vector<Part> parts((count + grain - 1) / grain, Part{start});
    parallelFor(count, grain, progress,
                [&](std::size_t begin, std::size_t end) { parts[begin / grain].value = map(begin, end); });
    for (const Part& part : parts) start = fold(std::move(start), part.value);
    return start;
}

/// While it lives, no more than `threads` cores are used (0: all).
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

/// Threads that loops may use now.
std::size_t threadsAllowed();

}  // namespace lathelier
