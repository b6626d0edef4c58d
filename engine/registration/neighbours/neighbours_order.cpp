#include "engine/registration/neighbours/neighbours_order.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/core/parallel.h"

namespace lathelier::registration {
namespace {

constexpr int curveLevels = 10;     // bits for each axis
constexpr std::size_t runSize = 8;  // cells with no more points are not refined
constexpr std::size_t entriesPerTask = 1 << 15;

// One level of the curve: for each state (entry corner, direction) and octant, the octant's place and the next state.
struct CurveTable {
    std::array<std::array<std::uint8_t, 8>, 24> place{};
    std::array<std::array<std::uint8_t, 8>, 24> next{};
};

constexpr unsigned rotateLeft(unsigned bits, unsigned by)
{
    by %= 3;
    return ((bits << by) | (bits >> (3 - by))) & 7u;
}

constexpr unsigned gray(unsigned i)
{
    return i ^ (i >> 1);
}

constexpr CurveTable makeCurveTable()
{
    CurveTable table;
    for (unsigned entry = 0; entry < 8; ++entry)
        for (unsigned direction = 0; direction < 3; ++direction)
            for (unsigned octant = 0; octant < 8; ++octant) {
                const unsigned turned = rotateLeft(octant ^ entry, 3 - (direction + 1) % 3);
                unsigned place = 0;
                while (gray(place) != turned) ++place;
                const unsigned corner = place == 0 ? 0 : gray(2 * ((place - 1) / 2));
                const unsigned odd = place % 2 == 1 ? place : (place == 0 ? 0 : place - 1);
                const unsigned step = place == 0 ? 0 : static_cast<unsigned>(std::countr_one(odd)) % 3;
                const unsigned next_entry = entry ^ rotateLeft(corner, direction + 1);
                const unsigned next_direction = (direction + step + 1) % 3;
                table.place[entry * 3 + direction][octant] = static_cast<std::uint8_t>(place);
                table.next[entry * 3 + direction][octant] = static_cast<std::uint8_t>(next_entry * 3 + next_direction);
            }
    return table;
}

constexpr CurveTable curve = makeCurveTable();

struct Bounds {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
};

// Place on the curve in the upper half, index in the lower half.
using Entry = std::uint64_t;
constexpr Entry placeMask = Entry{0xffffffff} << 32;

class Sorter {
public:
    Sorter(const std::vector<Eigen::Vector3d>& points, const Progress& progress)
        : points_(points), progress_(progress), entries_(points.size()), spare_(points.size())
    {
        std::iota(entries_.begin(), entries_.end(), Entry{0});
    }

    std::vector<std::uint32_t> order()
    {
        sort(0, entries_.size());
        std::vector<std::uint32_t> result(entries_.size());
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<std::uint32_t>(entries_[i]);
        return result;
    }

private:
    const Eigen::Vector3d& point(std::size_t i) const { return points_[static_cast<std::uint32_t>(entries_[i])]; }

    Bounds bounds(std::size_t begin, std::size_t end) const
    {
        const auto boundsOf = [&](std::size_t from, std::size_t to) {
            Bounds b;
            for (std::size_t i = begin + from; i < begin + to; ++i) {
                b.low = b.low.cwiseMin(point(i));
                b.high = b.high.cwiseMax(point(i));
            }
            return b;
        };
        if (end - begin <= entriesPerTask) return boundsOf(0, end - begin);
        return parallelReduce(end - begin, entriesPerTask, progress_, Bounds(), boundsOf,
                              [](Bounds a, const Bounds& b) {
                                  a.low = a.low.cwiseMin(b.low);
                                  a.high = a.high.cwiseMax(b.high);
                                  return a;
                              });
    }

    template <class Body>
    void forChunks(std::size_t count, Body body) const
    {
        if (count <= entriesPerTask)
            body(0, count);
        else
            parallelFor(count, entriesPerTask, progress_, body);
    }

    // Each call separates at least the two points furthest apart, so that the recursion ends.
    void sort(std::size_t begin, std::size_t end)
    {
        const Bounds box = bounds(begin, end);
        // Halves: the difference of any two finite coordinates stays finite.
        const double scale = (1 << curveLevels) / ((box.high / 2 - box.low / 2).maxCoeff() * (1 + 1e-12));
        if (!std::isfinite(scale)) return;  // equal points
        forChunks(end - begin, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = begin + from; i < begin + to; ++i) {
                const Eigen::Vector3d t = (point(i) / 2 - box.low / 2) * scale;
                std::array<std::uint32_t, 3> cell;
                for (int a = 0; a < 3; ++a)
                    cell[static_cast<std::size_t>(a)] =
                        static_cast<std::uint32_t>(std::clamp(t[a], 0.0, double{(1 << curveLevels) - 1}));
                entries_[i] = (Entry{hilbertPlace(cell)} << 32) | (entries_[i] & 0xffffffff);
            }
        });
        if (end - begin <= entriesPerTask)
            std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(begin),
                      entries_.begin() + static_cast<std::ptrdiff_t>(end));
        else
            radixSort(begin, end);
        refine(begin, end);
    }

    void radixSort(std::size_t begin, std::size_t end)
    {
        constexpr std::size_t digits = 1 << 10;
        const std::size_t count = end - begin;
        const std::size_t block = std::max(entriesPerTask, (count + 31) / 32);
        const std::size_t blocks = (count + block - 1) / block;
        std::vector<std::array<std::uint32_t, digits>> counts(blocks);
        Entry* from = entries_.data() + begin;
        Entry* to = spare_.data() + begin;
        for (int pass = 0; pass < 3; ++pass) {
            const int shift = 32 + 10 * pass;
            parallelFor(count, block, progress_, [&](std::size_t first, std::size_t last) {
                auto& histogram = counts[first / block];
                histogram.fill(0);
                for (std::size_t i = first; i < last; ++i) ++histogram[(from[i] >> shift) & (digits - 1)];
            });
            std::uint32_t sum = 0;
            for (std::size_t d = 0; d < digits; ++d)
                for (auto& histogram : counts) {
                    const std::uint32_t here = histogram[d];
                    histogram[d] = sum;
                    sum += here;
                }
            parallelFor(count, block, progress_, [&](std::size_t first, std::size_t last) {
                auto& place = counts[first / block];
                for (std::size_t i = first; i < last; ++i) to[place[(from[i] >> shift) & (digits - 1)]++] = from[i];
            });
            std::swap(from, to);
        }
        std::copy(from, from + count, entries_.data() + begin);
    }

    // Cells that hold many points are sorted again on a grid of their own.
    void refine(std::size_t begin, std::size_t end)
    {
        std::vector<std::pair<std::size_t, std::size_t>> runs;
        for (std::size_t i = begin; i < end;) {
            std::size_t j = i + 1;
            while (j < end && ((entries_[i] ^ entries_[j]) & placeMask) == 0) ++j;
            if (j - i > runSize) runs.emplace_back(i, j);
            i = j;
        }
        parallelFor(runs.size(), 64, progress_, [&](std::size_t from, std::size_t to) {
            for (std::size_t r = from; r < to; ++r) sort(runs[r].first, runs[r].second);
        });
    }

    const std::vector<Eigen::Vector3d>& points_;
    const Progress& progress_;
    std::vector<Entry> entries_;
    std::vector<Entry> spare_;
};

}  // namespace

std::uint32_t hilbertPlace(const std::array<std::uint32_t, 3>& cell)
{
    std::uint32_t result = 0;
    unsigned state = 0;
    for (int bit = curveLevels - 1; bit >= 0; --bit) {
        const unsigned octant = ((cell[0] >> bit) & 1u) | ((cell[1] >> bit) & 1u) << 1 | ((cell[2] >> bit) & 1u) << 2;
        result = (result << 3) | curve.place[state][octant];
        state = curve.next[state][octant];
    }
    return result;
}

std::vector<std::uint32_t> hilbertOrder(const std::vector<Eigen::Vector3d>& points_mm, const Progress& progress)
{
    return Sorter(points_mm, progress).order();
}

}  // namespace lathelier::registration
