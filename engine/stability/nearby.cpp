#include "engine/stability/nearby.h"

#include <cstddef>

namespace lathelier::stability {

std::vector<double> leastNearby(const std::vector<double>& speed_rpm, const std::vector<double>& depth)
{
    std::vector<double> least(depth.size());
    std::size_t from = 0, to = 0;
    std::vector<std::size_t> ascending;  // indices of a window with ascending depths; its first is the least
    std::size_t head = 0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        while (to < depth.size() && speed_rpm[to] <= speed_rpm[i] * (1 + robustShare)) {
            while (ascending.size() > head && depth[ascending.back()] >= depth[to]) ascending.pop_back();
            ascending.push_back(to++);
        }
        while (speed_rpm[from] < speed_rpm[i] * (1 - robustShare)) ++from;
        while (ascending[head] < from) ++head;
        least[i] = depth[ascending[head]];
    }
    return least;
}

}  // namespace lathelier::stability
