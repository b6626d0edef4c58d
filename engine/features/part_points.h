// The points that a recognition uses: those of the scan, or drawn on its mesh, without what is left out.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/features/recognition.h"
#include "engine/features/scene/surroundings/left_out.h"
#include "engine/registration/surface/surface_samples.h"

namespace lathelier::features {

/// Points in mm, in the frame of the scan.
struct PartPoints {
    const Scan& scan;
    std::vector<registration::SurfaceSample> samples;  ///< of a mesh
    std::vector<Eigen::Vector3d> own;                  ///< unless the points of the scan are used as they are
    bool is_cut = false;

    const std::vector<Eigen::Vector3d>& all() const { return is_cut || scan.isMesh() ? own : scan.points_mm; }
};

/// All points. Throws an Error when there are too few, Cancelled.
PartPoints pointsOf(const Scan& scan, const Progress& progress);

/// Leaves out what is not the part and the excluded zones; adds the notes sceneCut and zonesExcluded. Throws an Error
/// when too few points are left.
void leaveOut(const LeftOut& left_out, PartPoints& part, Recognition& result, const Progress& progress);

/// Moves the points of a coarse mesh onto the round surface through its vertices; adds the note facetsRounded.
void roundFacets(PartPoints& part, Recognition& result, const Progress& progress);

}  // namespace lathelier::features
