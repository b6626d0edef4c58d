// The faces of the one solid in a STEP file, as a CAD kernel reads them, without its types.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/cad/part21.h"
#include "engine/core/progress.h"

namespace lathelier::cad {

enum class SurfaceKind { Plane, Cylinder, Cone, Torus, Sphere, RevolvedLine, RevolvedArc, Other };

/// A point of a surface and the unit normal there, of either sense.
struct SurfaceSpot {
    Eigen::Vector3d point_mm;
    Eigen::Vector3d normal;
};

/// A face of a solid, lengths in mm in the frame of the file.
struct StepFace {
    SurfaceKind kind = SurfaceKind::Other;
    double area_mm2 = 0;
    /// A point of the surface's axis and its direction; of a plane a point in it and its normal.
    Eigen::Vector3d axis_point_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector
    double radius_mm = 0;  ///< of a cylinder; of the meridian circle of a sphere, torus or revolved arc
    /// Centre of the meridian circle through `inner_mm`.
    Eigen::Vector3d circle_centre_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d inner_mm = Eigen::Vector3d::Zero();  ///< at the middle of the parameter range of the face
    Eigen::Vector3d outward = Eigen::Vector3d::Zero();   ///< unit normal there, out of the material
    std::vector<SurfaceSpot> spots;            ///< of an Other face, over its parameters: what it may be exactly
    std::vector<Eigen::Vector3d> vertices_mm;  ///< in file coordinates
    std::vector<std::vector<Eigen::Vector3d>> edges_mm;  ///< points along each edge
    std::vector<int> edge_numbers;                       ///< of the solid's edges: neighbours share them
};

struct StepSolid {
    std::string product;          ///< name of the product; may be empty
    std::vector<StepFace> faces;  ///< in the order of the file
    double volume_mm3 = 0;
};

/// Reads the bytes of a file that checkPart21() has passed. Errors malformed (`line`) for records unusable by the
/// kernel, noSolid, severalParts. Throws Cancelled.
StepSolid readStepFaces(std::string_view bytes, const Part21& checked, const Progress& progress);

}  // namespace lathelier::cad
