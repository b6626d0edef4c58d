#include "engine/drawing/leaders.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace lathelier::drawing {
namespace {

/// Lanes of texts that stand to the right of x[i], widths[i] wide, sorted by x: from the right end on.
std::vector<int> lanesToRight(const std::vector<double>& x, const std::vector<double>& widths, double gap_mm)
{
    std::vector<int> lanes(x.size(), 0);
    for (std::size_t i = x.size(); i-- > 0;)
        for (std::size_t j = i + 1; j < x.size() && x[j] < x[i] + widths[i] + gap_mm; ++j)
            lanes[i] = std::max(lanes[i], lanes[j] + 1);
    return lanes;
}

}  // namespace

std::vector<double> spread(const std::vector<double>& sorted, double spacing_mm)
{
    struct Pool {  // isotonic regression by pooling neighbours
        double sum = 0;
        std::size_t count = 0;
        double mean() const { return sum / static_cast<double>(count); }
    };
    std::vector<Pool> pools;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        pools.push_back({sorted[i] - spacing_mm * static_cast<double>(i), 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
            const Pool last = pools.back();
            pools.pop_back();
            pools.back().sum += last.sum;
            pools.back().count += last.count;
        }
    }
    std::vector<double> result;
    for (const Pool& pool : pools)
        for (std::size_t i = 0; i < pool.count; ++i)
            result.push_back(pool.mean() + spacing_mm * static_cast<double>(result.size()));
    return result;
}

std::vector<LeaderPlace> placeLeaders(const std::vector<LeaderText>& texts, double spacing_mm)
{
    const std::size_t count = texts.size();
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return texts[a].x_mm < texts[b].x_mm; });
    std::vector<double> sorted;
    sorted.reserve(count);
    for (const std::size_t i : order) sorted.push_back(texts[i].x_mm);
    const std::vector<double> x = spread(sorted, spacing_mm);

    std::vector<LeaderPlace> best(count);
    int best_most = -1, best_sum = 0;
    for (std::size_t split = 0; split <= count; ++split) {
        std::vector<double> left_x, left_width, right_x, right_width;
        for (std::size_t i = split; i-- > 0;) {  // mirrored, to use the same function
            left_x.push_back(-x[i]);
            left_width.push_back(texts[order[i]].width_mm);
        }
        for (std::size_t i = split; i < count; ++i) {
            right_x.push_back(x[i]);
            right_width.push_back(texts[order[i]].width_mm);
        }
        const std::vector<int> left = lanesToRight(left_x, left_width, spacing_mm / 2);
        const std::vector<int> right = lanesToRight(right_x, right_width, spacing_mm / 2);
        int most = 0, sum = 0;
        for (const std::vector<int>& lanes : {left, right})
            for (const int lane : lanes) {
                most = std::max(most, lane);
                sum += lane;
            }
        if (best_most >= 0 && (most > best_most || (most == best_most && sum >= best_sum))) continue;
        best_most = most;
        best_sum = sum;
        for (std::size_t i = 0; i < count; ++i)
            best[order[i]] =
                i < split ? LeaderPlace{x[i], left[split - 1 - i], true} : LeaderPlace{x[i], right[i - split], false};
    }
    return best;
}

}  // namespace lathelier::drawing
