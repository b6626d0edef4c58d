// Inside and outside of a scanned surface that carries no normals.
// Sources: H. Hoppe et al., "Surface reconstruction from unorganized points", SIGGRAPH 1992 (propagation along a
// minimum spanning tree); S. König, S. Gumhold, "Consistent propagation of normal orientations in point clouds", VMV
// 2009 (the criterion across sharp edges); G. Barill et al., "Fast winding numbers for soups and clouds", 2018
// (criterion for a closed surface).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

/// A small flat piece of surface with a normal of unknown sense.
struct SurfaceElement {
    Eigen::Vector3d centre_mm;
    Eigen::Vector3d normal;  ///< unit vector
    double radius_mm;        ///< elements overlap: an element's share of the surface is found from its neighbours
};

/// For each element whether its normal has to be turned to point outward. Empty when the surface is not evidently
/// closed: the winding number, made with these normals, has to be near 1 just inside and near 0 just outside almost
/// everywhere. A bore scanned alone cannot be distinguished from a shaft and is oriented as one.
std::vector<bool> findOutside(const std::vector<SurfaceElement>& elements, const Progress& progress);

}  // namespace lathelier::registration
