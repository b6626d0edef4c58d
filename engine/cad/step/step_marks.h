// Marks of a turned part from the exact faces of its solid that are not part of the meridian: cross holes and axial
// holes (full circles), flats, hexagons and squares, keyways, slots across the axis, splines, spherical ends. What is
// none of these is of free form.
//
// Every mark but a spline and a free form comes with the convex bodies that cut it out of the turned body, so that the
// volume cut can be compared with that of the solid (cut_volume.h).
#pragma once

#include <vector>

#include "engine/cad/step/cut_volume.h"
#include "engine/cad/step_faces.h"
#include "engine/cad/step_meridian.h"
#include "engine/core/progress.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// The frame of the shaft: z from its free end toward the chuck, x as near to the x axis of the file as can be (of a
/// part along x, to its y axis). Angles of marks are from x toward y.
struct PartFrame {
    Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();

    Eigen::Vector3d of(const Eigen::Vector3d& point) const;
    Eigen::Vector3d directionOf(const Eigen::Vector3d& direction) const;
};

PartFrame frameOf(const Line3& axis, double free_end_mm);

struct MarkedCuts {
    std::vector<ShaftMark> marks;      ///< in the order of z
    std::vector<ConvexCut> cuts;       ///< of the marks that have them
    bool has_spline = false;           ///< a mark without a cut
    std::vector<std::size_t> unnamed;  ///< faces of free form
};

/// `others`: the faces that are not part of the meridian; `turned`: the body that they cut, without marks. Throws
/// Cancelled.
MarkedCuts marksOf(const std::vector<StepFace>& faces, const std::vector<std::size_t>& others, const PartFrame& frame,
                   const Shaft& turned, const Progress& progress);

/// All of them of free form.
MarkedCuts freeForms(const std::vector<StepFace>& faces, const std::vector<std::size_t>& others, const PartFrame& frame,
                     const Shaft& turned);

/// Is a hexagon or a square among the marks that shows the whole of this stretch?
bool isPrism(const std::vector<ShaftMark>& marks, double z_start_mm, double z_end_mm);

}  // namespace lathelier::cad
