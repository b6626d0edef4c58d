// A comparison with a drawing: the copy is aligned with its mesh, deviations are measured from its exact meridian.
#pragma once

#include "engine/core/shaft_contour.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {

/// A reference that is known by its drawing.
struct DrawnReference {
    Scan mesh;         ///< closed, z along the axis: what the copy is aligned with
    Contour meridian;  ///< as closedContour() gives it, in the frame of the mesh: what deviations are measured from
};

/// The same against a drawing: deviations are exact distances to its meridian (core/contour_distance.h).
CompareResult compare(const DrawnReference& reference, const Scan& copy, const CompareParameters& parameters = {},
                      const Progress& progress = {}, CompareDetail detail = CompareDetail::Full);

}  // namespace lathelier::registration
