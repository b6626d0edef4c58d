// Charts of a cylindricity result: unrolled surface, local radius and axis along the length.
#pragma once

#include "engine/form/cylinder/cylinder_surface.h"
#include "engine/report/document.h"

namespace lathelier::form {

/// Deviation from the cylinder over length and angle.
report::ColourMap unrolledCylinder(const CylinderSurface& surface);

/// Local radius as deviation from the cylinder's, the range of the points about it, the zone and the tolerance.
report::Plot radiusAlongAxis(const CylinderSurface& surface, const CylindricityParameters& parameters);

/// Centres of the local circles relative to the cylinder's axis: bending and tilt of the axis.
report::Plot centresAlongAxis(const CylinderSurface& surface);

/// The limit of the colour scale in µm: readable, nearly all cells of the map within it.
double colourLimit_um(const CylinderSurface& surface);

}  // namespace lathelier::form
