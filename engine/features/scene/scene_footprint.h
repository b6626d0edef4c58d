// Where on the surface of a turned part something else touches it.
#pragma once

#include <Eigen/Core>
#include <bitset>
#include <map>

namespace lathelier::features {

/// Cells of 1 mm along the axis by 5° around it.
class SceneFootprint {
public:
    /// A point, in the frame of the axis, of what touches the part, near to it.
    void add(const Eigen::Vector3d& on_axis);
    /// Fills up to 60° of the circle between cells, for near a contact no point tells which of the two it is of, and
    /// adds the cells beside.
    void close();
    bool contains(const Eigen::Vector3d& on_axis) const;

private:
    static constexpr std::size_t kSectors = 72;
    using Ring = std::bitset<kSectors>;
    std::map<long, Ring> rings_;  ///< by whole millimetres along the axis
};

}  // namespace lathelier::features
