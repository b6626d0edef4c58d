#include "engine/registration/surroundings.h"

#include <algorithm>

namespace lathelier::registration {

bool Surroundings::collect(const Box& box, double reach_mm2, std::size_t most_leaves)
{
    leaves_.clear();
    before_ = 0;
    reach_mm2_ = reach_mm2;
    index_->boxes_.visit(box, reach_mm2, [&](std::uint32_t leaf, double& limit) {
        leaves_.push_back(leaf);
        if (leaves_.size() > most_leaves) limit = 0;
    });
    if (leaves_.size() > most_leaves) leaves_.clear();
    std::sort(leaves_.begin(), leaves_.end());
    const auto count = static_cast<Eigen::Index>(leaves_.size());
    if (low_mm_.rows() < count) {
        low_mm_.resize(count + count / 2, 3);
        high_mm_.resize(count + count / 2, 3);
    }
    for (Eigen::Index l = 0; l < count; ++l) {
        const Box side = index_->boxes_.leafBox(leaves_[static_cast<std::size_t>(l)]);
        low_mm_.row(l) = side.low_mm.array();
        high_mm_.row(l) = side.high_mm.array();
    }
    return !leaves_.empty();
}

void Surroundings::improve(const Eigen::Vector3d& query_mm, Neighbours::Found& best)
{
    const std::size_t count = leaves_.size();
    const auto rows = static_cast<Eigen::Index>(count);
    const auto outside = [&](int a) {
        return (low_mm_.col(a).head(rows) - query_mm[a]).max(query_mm[a] - high_mm_.col(a).head(rows)).max(0.0);
    };
    squared_mm2_ = outside(0).square() + outside(1).square() + outside(2).square();
    index_->improve(leaves_[before_], query_mm, best);
    const std::size_t first = before_;
    for (std::size_t l = 0; l < count; ++l) {
        if (!(squared_mm2_[static_cast<Eigen::Index>(l)] < best.squared_mm2) || l == first) continue;
        const std::uint32_t place = best.place;
        index_->improve(leaves_[l], query_mm, best);
        if (best.place != place) before_ = l;
    }
}

bool Surroundings::nearest(const Eigen::Vector3d& query_mm, std::size_t count, std::vector<Neighbours::Found>& found)
{
    constexpr std::size_t leafSize = Neighbours::leafSize;
    inside_.resize(leaves_.size() * leafSize + 1);
    std::size_t inside = 0;
    for (const std::uint32_t leaf : leaves_) {
        alignas(64) double squared[leafSize];
        index_->leafDistances(leaf, query_mm, squared);
        for (std::uint32_t i = 0; i < leafSize; ++i) {
            inside_[inside] = {leaf * Neighbours::leafSize + i, squared[i]};
            inside += squared[i] < reach_mm2_ ? 1 : 0;
        }
    }
    if (inside < count || count == 0) return false;
    sorted_mm2_.clear();
    for (std::size_t k = 0; k < inside; ++k) sorted_mm2_.push_back(inside_[k].squared_mm2);
    const auto last = sorted_mm2_.begin() + static_cast<std::ptrdiff_t>(count - 1);
    std::nth_element(sorted_mm2_.begin(), last, sorted_mm2_.end());
    // Of equally distant points as many as `count` leaves room for.
    auto equal = static_cast<std::ptrdiff_t>(count) -
                 std::count_if(sorted_mm2_.begin(), last, [&](double squared) { return squared < *last; });
    found.clear();
    for (std::size_t k = 0; k < inside; ++k)
        if (inside_[k].squared_mm2 < *last || (inside_[k].squared_mm2 == *last && --equal >= 0))
            found.push_back(inside_[k]);
    return true;
}

}  // namespace lathelier::registration
