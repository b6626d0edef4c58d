// A measured closed profile: the points of one section of a part.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace lathelier {

/// Points of one section in mm, in the order of the file, all finite. The angle of a point is that of its place as
/// seen from the centre in question, anticlockwise from x.
struct Profile {
    std::string name;                        ///< name in the file or the record; may be empty
    std::vector<Eigen::Vector2d> points_mm;  ///< x, y of each point
    bool size_is_nominal = false;  ///< deviations laid on a given nominal radius: form is measured, size is not
};

using ProfilePtr = std::shared_ptr<const Profile>;

}  // namespace lathelier
