// A fit of the whole part: outside, bores, and what the residuals say of them.
//
// Where the noise is correlated or passes of the scanner differ, jumps between rows may be theirs: the part is then
// fitted again with these errors in the weights of the walls, and what is no longer a row is none.
#pragma once

#include <vector>

#include "engine/core/error.h"
#include "engine/features/outline/outline.h"
#include "engine/features/part_points.h"
#include "engine/features/structure/structure.h"

namespace lathelier::features {

/// The meridian in bins.
struct Meridian {
    MeridianCloud cloud;
    Walls coarse, fine;
    std::optional<registration::ScannerAxis> scanner;
};

Meridian meridianOf(const PartPoints& part, const registration::RevolutionFit& fit, const Progress& progress);

/// Input of fitPart().
struct PartData {
    const std::vector<Eigen::Vector3d>& points_mm;  ///< in the frame of the scan
    const registration::RevolutionFit& fit;         ///< in whose frame the rest is
    const Meridian& meridian;
    const std::vector<Cut>& cuts;
    const std::optional<SupportPlane>& support;  ///< of the turntable
    double form_mm = 0.02;                       ///< form tolerance
};

struct PartFit {
    Outline outside;
    SurfaceTable surface;  ///< of the outside
    std::optional<Outline> bore;
    PartStructure structure;
    Notes notes;
    double form_mm = 0.02;  ///< form tolerance

    double zero_mm() const { return outside.model.planes.front().z_mm; }
    StructureInput seen(const MeridianCloud& cloud) const
    {
        return {cloud, outside, bore ? &*bore : nullptr, surface, form_mm};
    }
};

/// Throws an Error where no outline is found, Cancelled.
PartFit fitPart(const PartData& data, const Progress& progress);

}  // namespace lathelier::features
