// The minimum-zone cylinder.
// Source: ISO 12180-1.
#pragma once

#include <vector>

#include "engine/form/cylinder/cylinder_points.h"

namespace lathelier::form {

struct MinimumZoneCylinder {
    AxisParameters axis = AxisParameters::Zero();  ///< in the coordinates of CylinderPoints
    double inner = 0, outer = 0;                   ///< smallest and largest distance of a point from the axis
    std::vector<std::size_t> contacts;             ///< indices of the contact points, ascending
};

/// Narrowest zone between coaxial cylinders near `start`: the best local optimum of several starts.
MinimumZoneCylinder minimumZoneCylinder(const CylinderPoints& points, const AxisParameters& start,
                                        const Progress& progress);

}  // namespace lathelier::form
