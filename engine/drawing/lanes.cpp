#include "engine/drawing/lanes.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "engine/core/units.h"

namespace lathelier::drawing {
namespace {

bool reachesOver(const std::vector<LaneSpan>& spans, const LaneSpan& span)
{
    return std::any_of(spans.begin(), spans.end(), [&](const LaneSpan& other) {
        return other.to_mm > span.from_mm + same_mm && other.to_mm < span.to_mm - same_mm;
    });
}

}  // namespace

std::vector<int> lanesOf(const std::vector<LaneSpan>& spans)
{
    std::vector<std::size_t> order(spans.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        const LaneSpan &a = spans[i], &b = spans[j];
        const bool a_over = reachesOver(spans, a), b_over = reachesOver(spans, b);
        if (a_over != b_over) return b_over;
        return a_over ? a.to_mm - a.from_mm < b.to_mm - b.from_mm : a.from_mm < b.from_mm;
    });
    std::vector<int> lanes(spans.size(), 0);
    for (std::size_t at = 0; at < order.size(); ++at) {
        const LaneSpan& span = spans[order[at]];
        int& lane = lanes[order[at]];
        const auto before = [&](const auto& holds) {
            return std::any_of(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(at),
                               [&](std::size_t i) { return holds(spans[i], lanes[i]); });
        };
        before([&](const LaneSpan& other, int other_lane) {
            for (const double x : {other.from_mm, other.to_mm})
                if (x > span.left_mm && x < span.from_mm - same_mm) lane = std::max(lane, other_lane);
            return false;
        });
        while (before([&](const LaneSpan& other, int other_lane) {
            return other_lane == lane && other.left_mm < span.right_mm - same_mm &&
                   other.right_mm > span.left_mm + same_mm;
        }))
            ++lane;
    }
    return lanes;
}

}  // namespace lathelier::drawing
