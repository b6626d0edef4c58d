// The closed surface of a body of revolution with a value and a displacement at each vertex: what the views of a part
// draw. Vertices are stations of the meridian times angles, row by row, the angle fast.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <vector>

#include "engine/core/mesh_place.h"
#include "engine/core/scan.h"

namespace lathelier {

/// A vertex of the meridian. The material lies to its right, seen along the line from one station to the next with z to
/// the right and r upward. An edge is two stations at one place, one of each of its sides.
struct SkinStation {
    double z_mm = 0;
    double radius_mm = 0;
    Eigen::Vector2d normal = Eigen::Vector2d::UnitY();  ///< out of the material: components along z and r
    bool isFace() const { return std::abs(normal.x()) > std::abs(normal.y()); }
};

struct Skin {
    std::vector<SkinStation> stations;      ///< from the first end of the line to its last
    int angle_count = 0;                    ///< vertices of a ring, at j · 360°/angle_count
    std::vector<float> values;              ///< one for each vertex; NaN: not known
    std::vector<Eigen::Vector3f> shift_mm;  ///< of each vertex, in the frame of the axis (z along it); empty: none

    double largestRadius() const;  ///< of its stations, mm
    std::size_t vertexCount() const { return stations.size() * static_cast<std::size_t>(angle_count); }
};

/// A polyline (z, r) with its stations at most `step_mm` apart; corners sharper than 20° become two stations.
std::vector<SkinStation> stationsAlong(const std::vector<Eigen::Vector2d>& line_mm, double step_mm);

/// Displacements of a skin whose values are distances along the outward normals in mm. The surface stays closed: sides
/// move across the axis, faces along it, and what is not known moves as its neighbours along the meridian do.
std::vector<Eigen::Vector3f> normalShift_mm(const Skin& skin);

/// The largest readable magnification (1, 2 or 5 times a power of ten) that is at most `most`; 1 where that is less.
double readableFactor(double most);

/// The mesh of the skin displaced by `factor` times its shift, in the frame to which `frame_T_axis` leads, with
/// normals. Its vertices are those of the skin.
Scan meshOf(const Skin& skin, double factor, const Eigen::Isometry3d& frame_T_axis);

/// A place of the undisplaced skin, in the frame of its axis.
Eigen::Vector3d placeOn(const Skin& skin, const MeshPlace& place);

/// Index of the vertex nearest to a place in the frame of the axis. Precondition: there are vertices.
std::size_t nearestVertex(const Skin& skin, const Eigen::Vector3d& axis_place_mm);

/// A place displaced as the vertex nearest to it: the same way across and about the axis at the place's own angle.
Eigen::Vector3d displacedPlace(const Skin& skin, const Eigen::Vector3d& axis_place_mm, double factor);

/// A vertex displaced by `factor` times its shift, in the frame of the axis.
Eigen::Vector3d vertexOf(const Skin& skin, std::size_t vertex, double factor);

}  // namespace lathelier
