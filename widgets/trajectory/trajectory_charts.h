// Records and trajectories as the values of their plots.
#pragma once

#include "engine/trajectory/trajectory.h"
#include "widgets/plot/plot_data.h"
#include "widgets/plot/polar_data.h"
#include "widgets/plot/xy_view.h"
#include "widgets/scene/scene_data.h"

namespace lathelier {

/// X3/Y3 of the workpiece's axis and Xp/Yp of the tool; with `all` every section faintly behind the chosen one.
XyData axesData(const trajectory::TrajectoryResult& result, std::size_t section, bool all);

/// Means of the four probes and the radius vector's change over the angle, with the confidence of the mean.
PlotData coordinateData(const trajectory::TrajectorySection& section);

/// All revolutions around the workpiece's circle, k = 0 and 1 removed, with the synchronous curve (ISO 230-7).
PolarPicturePtr motionPicture(const trajectory::TrajectorySection& section, trajectory::Probe probe,
                              double workpiece_diameter_mm);

/// "synchronous 2.1 µm · asynchronous 5.3 µm · total 6.7 µm"
QString motionText(const trajectory::ErrorMotion& motion);

/// Signals over time with the revolution marks; as recorded when the channels could not be used yet.
PlotData signalData(const std::vector<trajectory::TimeSignal>& recorded);

/// The trajectories of all sections, one above the other along z, as dense dots; displacements drawn `magnification`
/// times larger.
std::vector<SceneObject> stackedTrajectories(const trajectory::TrajectoryResult& result, double magnification);
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

/// The angle on the part of each sample of a section, 0…360, as the polar plots have it.
std::vector<double> partAngles_deg(const trajectory::TrajectorySection& section);

}  // namespace lathelier
