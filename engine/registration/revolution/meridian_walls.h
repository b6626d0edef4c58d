// The sample of a part in the half plane (z, r), and the radius between the two walls of a part that shows a bore and
// the outside.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <vector>

namespace lathelier::registration {

/// A point of the half plane, in mm.
struct MeridianPoint {
    double z;  ///< along the axis
    double r;  ///< from the axis
};

/// The sample in the half plane, and its extent.
struct MeridianSample {
    std::vector<MeridianPoint> points;
    double low_mm = std::numeric_limits<double>::infinity();  ///< in z
    double high_mm = -low_mm;
    double largest_mm = 0;  ///< radius that nearly all points stay within
};

MeridianSample meridianSampleOf(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan);

/// The points of each bin: those of bin b are items[first[b]] … items[first[b + 1] - 1].
struct BinOrder {
    std::vector<std::size_t> first;
    std::vector<std::size_t> items;
};

template <class Key>
BinOrder sortInto(std::size_t bins, std::size_t count, Key key)
{
    BinOrder sorted;
    sorted.first.assign(bins + 1, 0);
    std::vector<int> keys(count);
    for (std::size_t i = 0; i < count; ++i) {
        keys[i] = key(i);
        if (keys[i] >= 0) ++sorted.first[static_cast<std::size_t>(keys[i]) + 1];
    }
    for (std::size_t b = 0; b < bins; ++b) sorted.first[b + 1] += sorted.first[b];
    sorted.items.resize(sorted.first.back());
    std::vector<std::size_t> place(sorted.first.begin(), sorted.first.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
        if (keys[i] >= 0) sorted.items[place[static_cast<std::size_t>(keys[i])]++] = i;
    return sorted;
}

/// For each bin along the part the radius between bore and outside, NaN where there is one wall. Walls are sought in
/// stretches longer than a bin, since a bore has few points. A mark (the floor of a keyway) is no wall: its points lie
/// where those of the other wall are absent. A shoulder is none either: its bins are few, a bore runs on.
/// `places` of `sample`, sorted into bins along the part by `by_z`.
std::vector<double> findSplits(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                               const MeridianSample& places, const BinOrder& by_z);

}  // namespace lathelier::registration
