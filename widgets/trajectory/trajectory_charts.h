// What the panel shows of trajectories besides the charts of the engine: all sections in space, motions in words.
#pragma once

#include <QString>

#include "engine/trajectory/trajectory.h"
#include "widgets/scene/scene_data.h"

namespace lathelier::trajectory_panel {

/// "synchronous 2.1 µm · asynchronous 5.3 µm · total 6.7 µm"
QString motionText(const trajectory::ErrorMotion& motion);

/// The trajectories of all sections, one above the other along z, as dense dots; displacements drawn `magnification`
/// times larger.
std::vector<scene::SceneObject> stackedTrajectories(const trajectory::TrajectoryResult& result, double magnification);
double stackMagnification(const trajectory::TrajectoryResult& result);

/// Where a dot of these objects belongs, and where the axis stands among them at an angle on the part.
struct StackedPlace {
    std::size_t section = 0;  ///< index
    double angle_deg = 0;
};
StackedPlace stackedPlace(const trajectory::TrajectoryResult& result, std::size_t object, std::int64_t dot);
Eigen::Vector3d placeInStack(const trajectory::TrajectoryResult& result, const StackedPlace& place,
                             double magnification);

/// The sample of a section nearest to an angle on the part.
std::size_t sampleAt(const trajectory::TrajectorySection& section, double angle_deg);

}  // namespace lathelier::trajectory_panel
