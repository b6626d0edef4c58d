// A comparison with a drawing: the copy is aligned with its mesh, deviations are measured from its exact meridian.
#pragma once

#include "engine/registration/compare.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::registration {

/// A reference given by its drawing.
struct DrawnReference {
    Scan mesh;         ///< closed, z along the axis: target of the alignment
    Contour meridian;  ///< as closedContour() gives it, in the frame of the mesh: reference of the deviations
};

/// The same against a drawing: deviations are exact distances to its meridian (core/contour_distance.h).
CompareResult compare(const DrawnReference& reference, const Scan& copy, const CompareParameters& parameters = {},
                      const Progress& progress = {}, CompareDetail detail = CompareDetail::Full);

}  // namespace lathelier::registration
