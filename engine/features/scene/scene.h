// Objects in a scan besides the part: turntable, jaws or blocks that hold it, loose objects.
//
// The turntable is a plane with all the rest on one side of it, three times as large as what stands on it (convex hulls
// in the plane). The other points are grouped by distance; the part is the largest group that is a body of
// revolution, with those that lie on or inside its surface about the same axis. Clamps touch the part: they are points
// more than 5 mm outside the surface of revolution, down to the contact.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/quantities.h"

namespace lathelier::features {

/// Auto: cut only where a turntable is found; else all points are kept, unless recognize() finds no part among them, or
/// gaps, because of a few flying points.
enum class SceneUse { Auto, Keep, Cut };

/// Points that belong together.
struct SceneGroup {
    std::string kind;                                  ///< part | turntable | clamp | clutter
    std::int64_t points = 0;                           ///< number of points
    Eigen::Vector3d min_mm = Eigen::Vector3d::Zero();  ///< its box in the frame of the scan
    Eigen::Vector3d max_mm = Eigen::Vector3d::Zero();  ///< the other corner of the box
    bool kept = true;                                  ///< input of the recognition
    std::string reason;  ///< of the part: body_of_revolution (the largest one) | largest (none is one); else empty
};

/// The plane that the part stands or lies on: normal·p = distance.
struct SupportPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit vector toward the part
    double distance_mm = 0;                             ///< along the normal
    double sigma_mm = 0;                                ///< robust scatter of its points
    double band_mm = 0;                                 ///< points this near to it belong to it
};

/// A stretch of the axis, in the frame of the scan, in which nothing of the part is seen because of what was cut off.
struct HiddenStretch {
    Eigen::Vector3d from_mm = Eigen::Vector3d::Zero();  ///< on the axis
    Eigen::Vector3d to_mm = Eigen::Vector3d::Zero();    ///< on the axis
    double reach_mm = 0;  ///< data that end this near to either limit are not taken for an end of the part
};

/// Groups and the label of each point. All are empty when there is only the part.
struct Scene {
    std::vector<SceneGroup> groups;       ///< the part first, then by falling number of points
    std::vector<std::uint8_t> kept;       ///< one per point: 1 for the part's
    std::optional<SupportPlane> support;  ///< of the turntable
    std::vector<HiddenStretch> hidden;    ///< by holders of the part
};

/// Deterministic; about 1 s of one core for a million points with a turntable, 0.07 s for 730 000 points where `use` is
/// Auto and there is none. Nothing is sought with SceneUse::Keep. Throws Cancelled.
Scene findScene(const std::vector<Eigen::Vector3d>& points, SceneUse use, const Progress& progress = {});

const std::vector<QuantityOf<SceneGroup>>& quantitiesOf(const SceneGroup*);

}  // namespace lathelier::features
