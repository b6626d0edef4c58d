// How a loop over the points of a scan is divided into tasks, and how lists found by the tasks become one. The division
// depends on the number of points only, so that sums have the same bits for any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lathelier::registration {

/// Points of one task: some tens of microseconds of work, far above the cost of a task.
inline constexpr std::size_t taskPoints = 16384;

/// Points of one task whose result is large (a sum for every bin, a list): no more than 24 results are folded.
inline std::size_t largeTaskPoints(std::size_t points)
{
    return std::max<std::size_t>(taskPoints, points / 24);
}

/// Appends each list of `part` to the list of the same number in `all`.
template <class T>
std::vector<std::vector<T>> joinedLists(std::vector<std::vector<T>> all, const std::vector<std::vector<T>>& part)
{
    for (std::size_t k = 0; k < all.size(); ++k) all[k].insert(all[k].end(), part[k].begin(), part[k].end());
    return all;
}

}  // namespace lathelier::registration
