// Content of the 3-D view, as values.
#pragma once

#include <Eigen/Geometry>
#include <QColor>
#include <QString>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/mesh_place.h"
#include "engine/core/scan.h"

namespace lathelier::scene {

/// A cloud or mesh in the scene. Equal `scan` and pose are uploaded once, however often the colours change.
struct SceneObject {
    QString name;                                                    ///< shown name
    ScanPtr scan;                                                    ///< never null
    Eigen::Isometry3d scene_T_scan = Eigen::Isometry3d::Identity();  ///< pose of the scan in the scene
    QColor colour;                                                   ///< colour without values
    std::shared_ptr<const std::vector<float>> values;  ///< one for each point, in mm; NaN is drawn grey; null: plain
    /// Outward displacement of each drawn point in mm; null or NaN: none. Magnifies a deviation, or removes it, since
    /// protruding points would hide their neighbours and enlarge the silhouette.
    std::shared_ptr<const std::vector<float>> outward_mm;
    /// Of a cloud without normals: 1 or -1 where outward is along the long axis or against it, as on the faces of a
    /// turned part; 0 or null: away from the axis.
    std::shared_ptr<const std::vector<std::int8_t>> along_axis;
    bool visible = true;  ///< false: not drawn
};

/// The long axis of the part, horizontal in the standard views. Without one the longest extent is horizontal.
struct SceneAxis {
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();    ///< a point of the axis, in the scene
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector in the scene
};

/// A value at a place of the part.
struct SceneFlag {
    Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();  ///< in the scene
    QString words;                                       ///< "+0.050 mm (limit 0.040)"
    QColor colour;                                       ///< of its verdict
};

using PickedPlace = MeshPlace;

/// Standard views of a part whose long axis lies level.
enum class SceneViewpoint { Oblique, Side, Top, End };

}  // namespace lathelier::scene
