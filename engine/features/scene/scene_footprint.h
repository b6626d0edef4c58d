// Contact area of other objects on the surface of a turned part.
#pragma once

#include <Eigen/Core>
#include <bitset>
#include <map>

namespace lathelier::features {

/// Cells of 1 mm along the axis by 5° around it.
class SceneFootprint {
public:
    /// Adds a point, in the frame of the axis, of an object near its contact with the part.
    void add(const Eigen::Vector3d& on_axis);
    /// Fills gaps of up to 60° between cells, since points near a contact cannot be assigned to either body, and adds
    /// the neighbouring cells.
    void close();
    bool contains(const Eigen::Vector3d& on_axis) const;

private:
    static constexpr std::size_t footprintSectors = 72;
    using Ring = std::bitset<footprintSectors>;
    std::map<long, Ring> rings_;  ///< by whole millimetres along the axis
};

}  // namespace lathelier::features
