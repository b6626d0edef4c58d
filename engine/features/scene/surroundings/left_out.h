// Points of a scan that a recognition leaves out: what is not the part, and the zones that a person excludes.
#pragma once

#include <optional>

#include "engine/features/outline/outline.h"
#include "engine/features/scene/scene.h"
#include "engine/registration/excluded_zones.h"

namespace lathelier::features {

/// Excluded zones on an axis: z counts from the first data of the part along it.
struct ZonesOnAxis {
    Eigen::Isometry3d zones_T_scan = Eigen::Isometry3d::Identity();
    registration::ExcludedZones zones;
};

struct LeftOut {
    Scene scene;                       ///< of all points
    std::optional<ZonesOnAxis> zones;  ///< of the points that the scene keeps
    int searches = 0;                  ///< for surroundings, that found something
    bool is_cut = false;               ///< the groups of the scene were sought as well (SceneUse::Cut)
    int placings = 0;                  ///< of the zones
};

/// The points that are used, their axis and their walls.
struct UsedPoints {
    const std::vector<Eigen::Vector3d>& points;
    const registration::RevolutionFit& fit;
    const MeridianCloud& cloud;
    const Walls& walls;
};

/// What is left out before an axis is known: what lies about a turntable, unless the scene is kept.
LeftOut leftOutFirst(const std::vector<Eigen::Vector3d>& points, const RecognitionParameters& parameters,
                     const Progress& progress = {});

/// What else is to be left out once the axis and the walls of `used` are known: surroundings, as long as any are found,
/// with SceneUse::Cut other groups of the scene, then the excluded zones, these twice, because their points may have
/// deflected the axis on which they were placed first. None: there is nothing else. Throws Cancelled.
std::optional<LeftOut> leftOutNext(const LeftOut& now, const UsedPoints& used, const RecognitionParameters& parameters,
                                   const Progress& progress = {});

/// The groups of the scene that need no axis, once, where they are to be cut and there are any.
std::optional<LeftOut> leftOutWithoutAxis(const LeftOut& now, const std::vector<Eigen::Vector3d>& points,
                                          const RecognitionParameters& parameters, const Progress& progress = {});

/// One per point: 1 where it is used; empty where all are. `excluded`: how many are left out for the zones.
std::vector<std::uint8_t> keptPoints(const LeftOut& left_out, const std::vector<Eigen::Vector3d>& points,
                                     std::int64_t& excluded);

/// What hides a part or was excluded, in the frame of the fit.
std::vector<Cut> cutsOf(const LeftOut& left_out, const registration::RevolutionFit& fit);

/// Ends chains where a cut lies between two of their walls.
void endChainsAt(const std::vector<Cut>& cuts, Walls& walls);

}  // namespace lathelier::features
