// A face of a solid in the frame of its part, as far as marks need it: its kind, its line or plane, its extents.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "engine/cad/step_faces.h"

namespace lathelier::cad {

inline constexpr double alignedAngle = 1e-6;  ///< rad; as of equal axes
inline constexpr double samePlace_mm = 1e-4;  ///< as of equal axes
/// Key of a slot across the axis: a mark of MarkKind::Other.
inline constexpr const char* slotKind = "slot";

struct Span {
    double low = 0, high = 0;
};

/// Of a direction across the axis, from x toward y, in [0, 360).
double angleOf_deg(const Eigen::Vector3d& direction);

/// The rest of an angle after whole turns, or whole parts of a turn, in [0, turn).
double restOfTurn_deg(double angle_deg, double turn_deg);

struct FaceShape {
    std::size_t number = 0;  ///< in the list of these
    SurfaceKind kind = SurfaceKind::Other;
    double area_mm2 = 0, radius_mm = 0;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of its axis; of a plane in it
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< of a plane: out of the material
    bool concave = false;                             ///< a cylinder or cone around a void
    std::vector<Eigen::Vector3d> boundary;            ///< points of its edges
    std::vector<int> edge_numbers;
    Span z;  ///< of its boundary

    bool isPlaneAlong() const;   ///< the axis of the part lies in its direction
    bool isPlaneAcross() const;  ///< the axis of the part is its normal
};

using FaceShapes = std::vector<const FaceShape*>;

/// Of the boundary along a direction through the origin.
Span spanOf(const FaceShape& face, const Eigen::Vector3d& direction);

bool areParallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b);
bool arePerpendicular(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Distance of the points of a line from another, parallel one.
double distanceOfLines(const Eigen::Vector3d& point, const Eigen::Vector3d& other, const Eigen::Vector3d& direction);

/// Does the boundary run all round this line? The largest angle without a point of an edge is below 40°.
bool runsAllRound(const FaceShapes& faces, const Eigen::Vector3d& point, const Eigen::Vector3d& direction);

/// Groups of faces that are connected by edges; each in the order of the faces.
std::vector<FaceShapes> connected(const FaceShapes& faces);

}  // namespace lathelier::cad
